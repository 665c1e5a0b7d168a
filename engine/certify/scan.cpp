// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/scan.hpp"

#include "certify/inner_product.hpp"
#include "certify/points/reader.hpp"
#include "certify/resonance.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

namespace {

// One series to be looked through.
struct Item {
    const Series* series;
    const char* what; // "normal form of "
    const std::string* name = nullptr;
    int from, to;   // weights that may occur
    int mode;       // index of the mode whose equation it belongs to, -1 for slow, drift and energy
    bool in_kernel; // normal form; else: map, or generator
    bool scanned = true;
};

// All series to be scanned. A canonical map may hold resonant monomials: its generator is scanned instead.
std::vector<Item> items(const NormalForm& normal_form, const NearIdentityMap& map) {
    const GradedField& field = *normal_form.field;
    const int through = normal_form.through;
    const bool scan_map = !normal_form.hamiltonian;
    std::vector<Item> result;
    result.reserve(2 *
                   (field.modes.size() + field.angles.size() + field.slow.size() + field.drift.size() + 1));
    for (std::size_t k = 0; k < field.modes.size(); ++k) {
        const Mode& mode = field.modes[k];
        result.push_back({&normal_form.mode[k], "normal form of ", &mode.name,
                          field.ring->generator(mode.z).weight, through, static_cast<int>(k), true});
        result.push_back(
            {&map.mode[k], "map of ", &mode.name, 1, through, static_cast<int>(k), false, scan_map});
    }
    const auto add = [&](const std::string& name, const Series& rate, const Series& shift, int from) {
        result.push_back({&rate, "normal form of ", &name, from, through, -1, true});
        result.push_back({&shift, "map of ", &name, 1, through, -1, false});
    };
    if (normal_form.hamiltonian) {
        const int weight = field.ring->generator(field.modes.front().z).weight;
        result.push_back({&normal_form.hamiltonian->energy, "energy of the normal form", nullptr, 0,
                          through + weight, -1, true});
        result.push_back({&normal_form.hamiltonian->generator, "generator of the map", nullptr,
                          2 * weight + 1, through + weight, -1, false});
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
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const auto k = static_cast<std::size_t>(id);
        const Generator& g = ring.generator(id);
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

// The complaint about the first term, by weight, that `wrong` rejects. `wrong` gets the first word in which a
// monomial differs from the one before.
template <class Judge>
std::string first_complaint(const Ring& ring, const Item& item, ExponentReader& reader, Judge wrong) {
    for (int n = 0; n <= item.series->through(); ++n)
        for (const Monomial& monomial : item.series->part(n).fractions().monomials)
            if (const char* complaint = wrong(n, reader.read(monomial)); complaint != nullptr)
                return fmt::format("{}{}, weight {}: {} {}", item.what,
                                   item.name == nullptr ? "" : *item.name,
                                   to_string(Rational(n) / ring.weights_in_one()),
                                   spell_monomial(ring, reader.exponents()), complaint);
    return "";
}

bool has_shape(const Ring& ring, const Item& item, const Survey& survey) {
    if (survey.is_empty()) return true;
    if (!survey.homogeneous || survey.first < item.from || survey.last > item.to) return false;
    for (GeneratorId id = 0; id < ring.size(); ++id)
        if (survey.exponents[static_cast<std::size_t>(id)].lowest < 0 && !ring.generator(id).invertible)
            return false;
    return true;
}

// The complaint about a series that has_shape() rejects.
std::string misshapen_term(const Ring& ring, const Item& item) {
    ExponentReader reader(ring);
    return first_complaint(ring, item, reader, [&](int n, int /*word*/) -> const char* {
        if (n < item.from || n > item.to) return "stands outside the weights of the series";
        int weight = 0;
        bool forbidden = false;
        for (GeneratorId id = 0; id < ring.size(); ++id) {
            const Generator& g = ring.generator(id);
            const int exponent = reader.exponents()[static_cast<std::size_t>(id)];
            weight += exponent * g.weight;
            forbidden = forbidden || (exponent < 0 && !g.invertible);
        }
        if (weight != n) return "has another weight";
        return forbidden ? "has a negative power of what may vanish" : nullptr;
    });
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

std::string shape_complaint(const NormalForm& normal_form, const NearIdentityMap& map, Surveyor& surveys) {
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
    for (const Item& item : items(normal_form, map))
        if (!has_shape(ring, item, surveys(*item.series)))
            if (std::string complaint = misshapen_term(ring, item); !complaint.empty()) return complaint;
    return "";
}

std::string scan_complaint(const NormalForm& normal_form, const NearIdentityMap& map,
                           const std::vector<FrequencySample>& samples) {
    const GradedField& field = *normal_form.field;
    const Resonance resonance(field, samples);
    // If the linear part is not semisimple, both normal form and map hold monomials with D = 0
    // (inner_product.hpp).
    const bool shared = normal_form.style == Style::inner_product && !field.is_semisimple();
    const std::vector<GeneratorId> outer = field.outer();
    ExponentReader reader(*field.ring, outer); // no other exponents are asked for
    std::vector<int> powers, last;             // of the outer generators
    for (const Item& item : items(normal_form, map)) {
        if (!item.scanned) continue;
        last.clear();
        // Asked once for neighbours that agree in their outer generators.
        const auto wrong = [&](int /*weight*/, int from) -> const char* {
            if (from == reader.words() && !last.empty()) return nullptr;
            const std::vector<int>& exponents = reader.exponents();
            powers.clear();
            for (const GeneratorId id : outer) powers.push_back(exponents[static_cast<std::size_t>(id)]);
            if (powers == last) return nullptr;
            last = powers;
            if (resonance.is_exact(exponents, item.mode))
                return item.in_kernel || shared ? nullptr : "is resonant";
            if (resonance.is_near(exponents, item.mode)) return item.in_kernel ? nullptr : "is resonant";
            return item.in_kernel ? "is not resonant" : nullptr;
        };
        if (std::string complaint = first_complaint(*field.ring, item, reader, wrong); !complaint.empty())
            return complaint;
    }
    return shared ? inner_product_complaint(normal_form, map, samples, resonance) : "";
}

void conclude(Certificate& certificate, const std::string& residual, const std::string& scan) {
    certificate.residual_zero = residual.empty();
    certificate.normal_form_scan = scan.empty();
    certificate.holds = certificate.residual_zero && certificate.normal_form_scan;
    certificate.complaint = residual + (residual.empty() || scan.empty() ? "" : "; ") + scan;
}

} // namespace resonform
