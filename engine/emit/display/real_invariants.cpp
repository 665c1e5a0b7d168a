// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/display/real_invariants.hpp"

#include "emit/display/display.hpp"
#include "emit/display/free_name.hpp"

#include <algorithm>
#include <set>

namespace resonform {

namespace {

// Is a real polynomial of parameters negative term by term, by the signs of its generators?
bool seen_negative(const Ring& ring, const Polynomial& p) {
    return std::all_of(p.terms().begin(), p.terms().end(), [&](const Term& t) {
        for (GeneratorId id = 0; id < ring.size(); ++id)
            if (ring.exponent(t.monomial, id) % 2 != 0 && !ring.generator(id).positive) return false;
        return cln::minusp(t.coefficient);
    });
}

std::vector<Action> actions_of(const NormalForm& normal_form) {
    const GradedField& field = *normal_form.field;
    const Ring& ring = *field.ring;
    std::vector<Action> actions;
    for (const HamiltonianForm::Bracket& b : normal_form.hamiltonian->brackets) {
        const GeneratorId conjugate = ring.generator(b.left).conjugate;
        Polynomial product = b.value;
        if (conjugate >= 0 && conjugate != b.right) continue; // left right is not real
        if (conjugate == b.right) {
            product = -ring.multiply(ring.imaginary(), b.value);
            if (seen_negative(ring, product)) product = -product;
        }
        actions.push_back({free_name(field.system(), "I" + std::to_string(actions.size() + 1)), b.left,
                           b.right, std::move(product)});
    }
    return actions;
}

class Rewriter {
public:
    Rewriter(const GradedField& field, const std::vector<Action>& actions)
        : field_(field), ring_(*field.ring), actions_(actions) {}

    // By weight; in each weight I1 comes before I2, z1^2*z4 before z2^2*z3.
    std::vector<InvariantTerm> operator()(const Polynomial& energy) {
        std::vector<InvariantTerm> terms;
        const auto collected = collect_in_order(ring_, energy, field_.outer());
        for (auto term = collected.rbegin(); term != collected.rend(); ++term)
            append(terms, term->first, term->second);
        std::stable_sort(terms.begin(), terms.end(),
                         [](const InvariantTerm& a, const InvariantTerm& b) { return a.weight < b.weight; });
        return terms;
    }

private:
    void append(std::vector<InvariantTerm>& terms, const Monomial& monomial, const Polynomial& coefficient) {
        if (seen_.count(monomial) != 0) return; // the conjugate of an earlier one
        InvariantTerm term{coefficient,
                           {},
                           ring_.restricted(monomial, modes()),
                           InvariantTerm::Part::whole,
                           ring_.exponent(monomial, field_.eps),
                           ring_.weight(monomial)};
        for (const Action& action : actions_) {
            const int n =
                std::min(ring_.exponent(monomial, action.left), ring_.exponent(monomial, action.right));
            term.powers.push_back(n);
            term.resonant = term.resonant - ring_.monomial(action.left, n) - ring_.monomial(action.right, n);
            term.coefficient = ring_.multiply(term.coefficient, ring_.power(action.product, n));
        }
        const Monomial conjugate = ring_.conjugate(Polynomial(term.resonant, 1)).terms().front().monomial;
        if (conjugate == term.resonant) {
            terms.push_back(std::move(term));
            return;
        }
        seen_.insert(ring_.conjugate(Polynomial(monomial, 1)).terms().front().monomial);
        const Polynomial other = ring_.conjugate(term.coefficient);
        add_part(terms, term, term.coefficient + other, InvariantTerm::Part::real);
        add_part(terms, term, ring_.multiply(ring_.imaginary(), term.coefficient - other),
                 InvariantTerm::Part::imaginary);
    }

    static void add_part(std::vector<InvariantTerm>& terms, InvariantTerm term, Polynomial coefficient,
                         InvariantTerm::Part part) {
        if (coefficient.empty()) return;
        term.coefficient = std::move(coefficient);
        term.part = part;
        terms.push_back(std::move(term));
    }

    [[nodiscard]] std::vector<GeneratorId> modes() const {
        std::vector<GeneratorId> ids = field_.outer();
        ids.erase(std::remove(ids.begin(), ids.end(), field_.eps), ids.end());
        return ids;
    }

    const GradedField& field_;
    const Ring& ring_;
    const std::vector<Action>& actions_;
    std::set<Monomial> seen_;
};

} // namespace

int energy_weight(const GradedField& field, int order) {
    return order + field.ring->generator(field.modes.front().z).weight;
}

RealInvariants real_invariants(const NormalForm& normal_form, int order) {
    const GradedField& field = *normal_form.field;
    RealInvariants result{actions_of(normal_form), {}};
    result.energy =
        Rewriter(field, result.actions)(normal_form.hamiltonian->energy.total(energy_weight(field, order)));
    return result;
}

} // namespace resonform
