// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/derive/hamiltonian.hpp"

#include "emit/display/display.hpp"
#include "emit/display/normal_form_parts.hpp"
#include "emit/display/real_invariants.hpp"

namespace resonform {

namespace {

using Part = InvariantTerm::Part;

DisplayTerm product_of(const Ring& ring, const Monomial& monomial, const std::vector<GeneratorId>& ids) {
    DisplayTerm term;
    for (const GeneratorId id : ids)
        if (const int e = ring.exponent(monomial, id); e != 0)
            term.factors.push_back(symbol_factor(ring.generator(id).name, e));
    return term;
}

DisplayTerm written(const GradedField& field, const RealInvariants& invariants, const InvariantTerm& t) {
    DisplayTerm term = factored(display(*field.ring, t.coefficient));
    if (t.eps != 0) term.tail.push_back(symbol_factor("eps", field.system().weight(t.eps)));
    for (std::size_t k = 0; k < invariants.actions.size(); ++k)
        if (t.powers[k] != 0) term.tail.push_back(symbol_factor(invariants.actions[k].name, t.powers[k]));
    DisplayTerm resonant = product_of(*field.ring, t.resonant, field.outer());
    if (t.part == Part::whole) {
        term.tail.insert(term.tail.end(), resonant.factors.begin(), resonant.factors.end());
    } else {
        term.tail.push_back(
            function_factor(t.part == Part::real ? "Re" : "Im", term_sum(std::move(resonant))));
    }
    return term;
}

} // namespace

std::vector<Section> hamiltonian_sections(const NormalForm& normal_form, int order) {
    const GradedField& field = *normal_form.field;
    const RealInvariants invariants = real_invariants(normal_form, order);
    Side energy;
    int weight = -1;
    for (const InvariantTerm& t : invariants.energy) {
        if (t.weight != weight) energy.groups.emplace_back();
        weight = t.weight;
        energy.groups.back().terms.push_back(written(field, invariants, t));
    }
    Section section{"energy in real invariants", {{side(symbol_sum("H")), std::move(energy)}}};
    Section where{"where", {}};
    for (const Action& action : invariants.actions) {
        const Monomial both = field.ring->monomial(action.left) + field.ring->monomial(action.right);
        DisplayTerm value = factored(display(*field.ring, action.product));
        value.tail.push_back(symbol_factor(action.name));
        where.formulas.push_back(
            {side(term_sum(product_of(*field.ring, both, field.outer()))), side(term_sum(std::move(value)))});
    }
    if (where.formulas.empty()) return {std::move(section)};
    return {std::move(section), std::move(where)};
}

namespace {

const char* name_of(Part part) {
    switch (part) {
    case Part::whole: return "whole";
    case Part::real: return "real";
    case Part::imaginary: break;
    }
    return "imaginary";
}

Json invariants_json(const GradedField& field, const RealInvariants& invariants) {
    Json list = Json::array();
    for (const InvariantTerm& t : invariants.energy) {
        Json actions = Json::object();
        for (std::size_t k = 0; k < invariants.actions.size(); ++k)
            if (t.powers[k] != 0) actions[invariants.actions[k].name] = t.powers[k];
        if (t.eps != 0) actions["eps"] = json_rational(field.system().weight(t.eps));
        Json term{{"exponents", std::move(actions)}};
        if (t.resonant != Monomial{}) {
            term["resonant"] = json_exponents(*field.ring, t.resonant, field.outer());
            term["part"] = name_of(t.part);
        }
        term["weight"] = json_rational(field.system().weight(t.weight));
        term["coefficient"] = json_expression(*field.ring, t.coefficient);
        list.push_back(std::move(term));
    }
    return list;
}

} // namespace

Json hamiltonian_json(const NormalForm& normal_form, int order) {
    const GradedField& field = *normal_form.field;
    const Ring& ring = *field.ring;
    const HamiltonianForm& form = *normal_form.hamiltonian;
    const RealInvariants invariants = real_invariants(normal_form, order);
    const int through = energy_weight(field, order);
    Json brackets = Json::array(), actions = Json::array(), energy = Json::array(), generator = Json::array();
    for (const HamiltonianForm::Bracket& b : form.brackets)
        brackets.push_back({{"left", ring.generator(b.left).name},
                            {"right", ring.generator(b.right).name},
                            {"value", json_expression(ring, b.value)}});
    for (const Action& a : invariants.actions)
        actions.push_back({{"name", a.name},
                           {"left", ring.generator(a.left).name},
                           {"right", ring.generator(a.right).name},
                           {"product", json_expression(ring, a.product)}});
    append_json_terms(energy, ring, "H", form.energy.total(through), field.outer());
    append_json_terms(generator, ring, "chi", form.generator.total(through), field.outer());
    return {{"brackets", std::move(brackets)},
            {"actions", std::move(actions)},
            {"energy", std::move(energy)},
            {"invariants", invariants_json(field, invariants)},
            {"generator", std::move(generator)}};
}

} // namespace resonform
