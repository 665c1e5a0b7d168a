// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/certificate_scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace resonform {

namespace {

// One series to be looked through.
struct Item {
    const Series* series;
    std::string what; // "normal form of z1"
    int from;         // the first weight that may occur
    int mode;         // index of the mode whose equation it belongs to, -1 for slow and drift
    bool is_map;
};

std::vector<Item> items(const NormalForm& normal_form, const NearIdentityMap& map) {
    const GradedField& field = *normal_form.field;
    std::vector<Item> result;
    for (std::size_t k = 0; k < field.modes.size(); ++k) {
        const std::string& name = field.modes[k].name;
        result.push_back({&normal_form.mode[k], "normal form of " + name, 1, static_cast<int>(k), false});
        result.push_back({&map.mode[k], "map of " + name, 1, static_cast<int>(k), true});
    }
    for (std::size_t k = 0; k < field.slow.size(); ++k)
        result.push_back({&normal_form.slow[k], "rate of " + field.slow[k].name, 1, -1, false});
    for (std::size_t k = 0; k < field.drift.size(); ++k) {
        const std::string& name = field.drift[k].name;
        result.push_back({&normal_form.drift[k], "normal form of " + name, 1, -1, false});
        result.push_back({&map.drift[k], "map of " + name, 1, -1, true});
    }
    return result;
}

// The powers of modes and eps, "z1^2*z2*eps"; the coefficient is left out.
std::string spell_monomial(const Ring& ring, const std::vector<int>& exponents) {
    std::string text;
    for (std::size_t k = 0; k < exponents.size(); ++k) {
        const Generator& g = ring.generator(static_cast<GeneratorId>(k));
        if (exponents[k] == 0 || (g.kind != GeneratorKind::fast && g.kind != GeneratorKind::small)) continue;
        text += (text.empty() ? "" : "*") + g.name;
        if (exponents[k] != 1) text += fmt::format("^{}", exponents[k]);
    }
    return text.empty() ? "1" : text;
}

bool powers_allowed(const Ring& ring, const std::vector<int>& exponents) {
    for (std::size_t k = 0; k < exponents.size(); ++k)
        if (exponents[k] < 0 && !ring.generator(static_cast<GeneratorId>(k)).invertible) return false;
    return true;
}

int weight_of(const Ring& ring, const std::vector<int>& exponents) {
    int weight = 0;
    for (std::size_t k = 0; k < exponents.size(); ++k)
        weight += exponents[k] * ring.generator(static_cast<GeneratorId>(k)).weight;
    return weight;
}

// The first term, by weight, that `wrong` calls wrong: its sentence.
std::string first_complaint(const Ring& ring, const Item& item,
                            const std::function<const char*(int, const std::vector<int>&)>& wrong) {
    for (int n = 0; n <= item.series->through(); ++n) {
        for (const Term& term : item.series->part(n).terms()) {
            const std::vector<int> exponents = ring.exponents(term.monomial);
            if (const char* complaint = wrong(n, exponents); complaint != nullptr)
                return fmt::format("{}, weight {}: {} {}", item.what, n, spell_monomial(ring, exponents),
                                   complaint);
        }
    }
    return "";
}

// <alpha, lambda> - lambda_mode, divided by i.
class Resonance {
public:
    Resonance(const GradedField& field, const std::vector<FrequencySample>& samples)
        : field_(field), samples_(samples) {}

    [[nodiscard]] bool resonant(const std::vector<int>& exponents, int mode) const {
        std::vector<int> multiples;
        for (const Mode& m : field_.modes)
            multiples.push_back(exponents[static_cast<std::size_t>(m.z)] -
                                exponents[static_cast<std::size_t>(m.zbar)]);
        if (mode >= 0) --multiples[static_cast<std::size_t>(mode)];
        if (std::all_of(multiples.begin(), multiples.end(), [](int m) { return m == 0; })) return true;
        if (multiples.size() == 1) return false; // omega is a unit
        return std::all_of(samples_.begin(), samples_.end(), [&](const FrequencySample& sample) {
            const PrimeField& f = sample.field;
            Residue sum = 0;
            for (std::size_t k = 0; k < multiples.size(); ++k)
                sum = f.add(sum, f.multiply(f.from(multiples[k]), sample.omega[k]));
            return sum == 0;
        });
    }

private:
    const GradedField& field_;
    const std::vector<FrequencySample>& samples_;
};

} // namespace

std::string shape_complaint(const NormalForm& normal_form, const NearIdentityMap& map) {
    const GradedField& field = *normal_form.field;
    const Ring& ring = *field.ring;
    if (normal_form.through < 1 || map.through != normal_form.through)
        return fmt::format("the normal form goes through weight {}, the map through {}", normal_form.through,
                           map.through);
    if (normal_form.mode.size() != field.modes.size() || map.mode.size() != field.modes.size() ||
        normal_form.slow.size() != field.slow.size() || normal_form.drift.size() != field.drift.size() ||
        map.drift.size() != field.drift.size())
        return "normal form and map do not have one series for each variable";
    for (const Item& item : items(normal_form, map)) {
        const auto wrong = [&](int n, const std::vector<int>& exponents) -> const char* {
            if (n < item.from || n > normal_form.through) return "stands outside the weights of the series";
            if (weight_of(ring, exponents) != n) return "has another weight";
            if (!powers_allowed(ring, exponents)) return "has a negative power of what may vanish";
            return nullptr;
        };
        if (std::string complaint = first_complaint(ring, item, wrong); !complaint.empty()) return complaint;
    }
    return "";
}

std::string scan_complaint(const NormalForm& normal_form, const NearIdentityMap& map,
                           const std::vector<FrequencySample>& samples) {
    const Resonance resonance(*normal_form.field, samples);
    for (const Item& item : items(normal_form, map)) {
        const auto wrong = [&](int /*weight*/, const std::vector<int>& exponents) -> const char* {
            if (resonance.resonant(exponents, item.mode) != item.is_map) return nullptr;
            return item.is_map ? "is resonant" : "is not resonant";
        };
        std::string complaint = first_complaint(*normal_form.field->ring, item, wrong);
        if (!complaint.empty()) return complaint;
    }
    return "";
}

} // namespace resonform
