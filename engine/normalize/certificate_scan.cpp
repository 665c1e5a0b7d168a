// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/certificate_scan.hpp"

#include "normalize/certificate_inner_product.hpp"
#include "normalize/certificate_resonance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>

namespace resonform {

namespace {

// One series to be looked through.
struct Item {
    const Series* series;
    std::string what; // "normal form of z1"
    int from, to;     // weights that may occur
    int mode;         // index of the mode whose equation it belongs to, -1 for slow, drift and energy
    bool in_kernel;   // normal form; else: map, or generator
    bool scanned = true;
};

// A canonical map may hold resonant monomials: those of its generator are looked at.
std::vector<Item> items(const NormalForm& normal_form, const NearIdentityMap& map) {
    const GradedField& field = *normal_form.field;
    const int through = normal_form.through;
    const bool scan_map = !normal_form.hamiltonian;
    std::vector<Item> result;
    for (std::size_t k = 0; k < field.modes.size(); ++k) {
        const Mode& mode = field.modes[k];
        result.push_back({&normal_form.mode[k], "normal form of " + mode.name,
                          field.ring->generator(mode.z).weight, through, static_cast<int>(k), true});
        result.push_back(
            {&map.mode[k], "map of " + mode.name, 1, through, static_cast<int>(k), false, scan_map});
    }
    const auto add = [&](const std::string& name, const Series& rate, const Series& shift, int from) {
        result.push_back({&rate, "normal form of " + name, from, through, -1, true});
        result.push_back({&shift, "map of " + name, 1, through, -1, false});
    };
    if (normal_form.hamiltonian) {
        const int weight = field.ring->generator(field.modes.front().z).weight;
        result.push_back(
            {&normal_form.hamiltonian->energy, "energy of the normal form", 0, through + weight, -1, true});
        result.push_back({&normal_form.hamiltonian->generator, "generator of the map", 2 * weight + 1,
                          through + weight, -1, false});
    }
    for (std::size_t k = 0; k < field.angles.size(); ++k)
        add(field.angles[k].name, normal_form.angle[k], map.angle[k], 0);
    for (std::size_t k = 0; k < field.slow.size(); ++k)
        add(field.slow[k].name, normal_form.slow[k], map.slow[k], 1);
    for (std::size_t k = 0; k < field.drift.size(); ++k)
        add(field.drift[k].name, normal_form.drift[k], map.drift[k], 1);
    return result;
}

// The powers of modes and eps, "z1^2*z2*eps"; the coefficient is left out.
std::string spell_monomial(const Ring& ring, const std::vector<int>& exponents) {
    std::string text;
    for (std::size_t k = 0; k < exponents.size(); ++k) {
        const Generator& g = ring.generator(static_cast<GeneratorId>(k));
        if (exponents[k] == 0 || (g.kind != GeneratorKind::fast && g.kind != GeneratorKind::small &&
                                  g.kind != GeneratorKind::phase))
            continue;
        const Rational exponent =
            Rational(exponents[k]) / (g.kind == GeneratorKind::small ? ring.weights_in_one() : 1);
        text += (text.empty() ? "" : "*") + g.name;
        const std::string power = to_string(exponent);
        if (cln::denominator(exponent) != 1)
            text += "^(" + power + ")";
        else if (exponent != 1)
            text += "^" + power;
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

using Judge = std::function<const char*(int weight, const std::vector<int>& exponents)>;

// The first term, by weight, that `wrong` calls wrong: its sentence. It is asked once for neighbours that
// agree in what `shown` leaves of a monomial.
template <class Shown>
std::string first_complaint(const Ring& ring, const Item& item, Shown shown, const Judge& wrong) {
    for (int n = 0; n <= item.series->through(); ++n) {
        std::optional<Monomial> last;
        for (const Monomial& whole : item.series->part(n).fractions().monomials) {
            const Monomial monomial = shown(whole);
            if (last == monomial) continue;
            last = monomial;
            const std::vector<int> exponents = ring.exponents(monomial);
            if (const char* complaint = wrong(n, exponents); complaint != nullptr)
                return fmt::format("{}, weight {}: {} {}", item.what,
                                   to_string(Rational(n) / ring.weights_in_one()),
                                   spell_monomial(ring, exponents), complaint);
        }
    }
    return "";
}

// In the style hamiltonian each modal coordinate has one partner.
std::string brackets_complaint(const NormalForm& normal_form) {
    if ((normal_form.style == Style::hamiltonian) != normal_form.hamiltonian.has_value())
        return "energy and generator go with the style hamiltonian";
    if (!normal_form.hamiltonian) return "";
    if (!normal_form.field->system().hamiltonian) return "the system is not given by an energy";
    std::vector<GeneratorId> found, wanted;
    for (const HamiltonianForm::Bracket& b : normal_form.hamiltonian->brackets)
        for (const GeneratorId id : {b.left, b.right}) found.push_back(id);
    for (const Mode& mode : normal_form.field->modes) {
        wanted.push_back(mode.z);
        if (!mode.is_real()) wanted.push_back(mode.zbar);
    }
    std::sort(found.begin(), found.end());
    std::sort(wanted.begin(), wanted.end());
    return found == wanted ? "" : "the brackets are not those of the modes, each with one partner";
}

} // namespace

std::string shape_complaint(const NormalForm& normal_form, const NearIdentityMap& map) {
    const GradedField& field = *normal_form.field;
    const Ring& ring = *field.ring;
    if (normal_form.through < 1 || map.through != normal_form.through)
        return fmt::format("the normal form goes through weight {}, the map through {}",
                           to_string(field.system().weight(normal_form.through)),
                           to_string(field.system().weight(map.through)));
    const auto complete = [&](const auto& n) {
        return n.mode.size() == field.modes.size() && n.angle.size() == field.angles.size() &&
               n.slow.size() == field.slow.size() && n.drift.size() == field.drift.size();
    };
    if (!complete(normal_form) || !complete(map))
        return "normal form and map do not have one series for each variable";
    if (std::string complaint = brackets_complaint(normal_form); !complaint.empty()) return complaint;
    for (const Item& item : items(normal_form, map)) {
        const auto wrong = [&](int n, const std::vector<int>& exponents) -> const char* {
            if (n < item.from || n > item.to) return "stands outside the weights of the series";
            if (weight_of(ring, exponents) != n) return "has another weight";
            if (!powers_allowed(ring, exponents)) return "has a negative power of what may vanish";
            return nullptr;
        };
        const auto all = [](const Monomial& m) { return m; };
        if (std::string complaint = first_complaint(ring, item, all, wrong); !complaint.empty())
            return complaint;
    }
    return "";
}

std::string scan_complaint(const NormalForm& normal_form, const NearIdentityMap& map,
                           const std::vector<FrequencySample>& samples) {
    const GradedField& field = *normal_form.field;
    const Resonance resonance(field, samples);
    // In a linear part that is not semisimple, monomials with D = 0 stand in both
    // (certificate_inner_product).
    const bool shared = normal_form.style == Style::inner_product && !field.is_semisimple();
    const std::vector<GeneratorId> outer = field.outer();
    const auto shown = [&](const Monomial& m) { return field.ring->restricted(m, outer); };
    for (const Item& item : items(normal_form, map)) {
        if (!item.scanned) continue;
        const auto wrong = [&](int /*weight*/, const std::vector<int>& exponents) -> const char* {
            if (resonance.is_exact(exponents, item.mode))
                return item.in_kernel || shared ? nullptr : "is resonant";
            if (resonance.is_near(exponents, item.mode)) return item.in_kernel ? nullptr : "is resonant";
            return item.in_kernel ? "is not resonant" : nullptr;
        };
        std::string complaint = first_complaint(*field.ring, item, shown, wrong);
        if (!complaint.empty()) return complaint;
    }
    return shared ? inner_product_complaint(normal_form, map, samples, resonance) : "";
}

} // namespace resonform
