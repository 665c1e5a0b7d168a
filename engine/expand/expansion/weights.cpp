// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the equations against the weights of the variables: at the weight of a fast variable, its rate may
// contain only its linear part and terms in variables of lower weight.
#include "algebra/number/error.hpp"
#include "expand/expansion/expansion.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

using GiNaC::ex;
using GiNaC::is_a;

// Fast variables of weight 0 are not small: at eps = 0 their rates must be linear.
void Expansion::check_finite() const {
    GiNaC::exmap rest_of_motion{{system_.eps, 0}};
    std::vector<const State*> finite;
    for (const State& state : first_order_->states) {
        if (variable_of(state).role != Role::fast) continue;
        if (variable_of(state).weight == 0)
            finite.push_back(&state);
        else
            rest_of_motion[state.symbol] = 0;
    }
    if (finite.empty()) return;
    for (const State& state : first_order_->states) {
        const bool fast = variable_of(state).role == Role::fast;
        if (fast && variable_of(state).weight > 0) continue;
        const Place place = place_of_equation(state.variable);
        const ex at_rest = state.rate.subs(rest_of_motion, GiNaC::subs_options::no_pattern);
        ex rest = at_rest;
        for (const State* of : finite)
            if (fast && at_rest.has(of->symbol))
                rest -= coefficients_.at_origin(at_rest.diff(of->symbol), place) * of->symbol;
        rest = rest.normal();
        if (std::any_of(finite.begin(), finite.end(), [&](const State* of) { return rest.has(of->symbol); }))
            refuse(Reason::nonlinear_layer,
                   {"with fast variables of weight 0 the equations are linear in them at eps = 0 "
                    "(and rates of other variables are free of them)",
                    fmt::format("the rest for {} is {}", state.name, spell(rest)),
                    "write the rest with a factor eps, or use weight 1", place});
    }
}

bool Expansion::holds_mode(const Polynomial& p, int weight) const {
    const Ring& ring = *field_.ring;
    const auto holds = [&](const Term& t) {
        return std::any_of(field_.modes.begin(), field_.modes.end(), [&](const Mode& m) {
            return ring.generator(m.z).weight == weight &&
                   (ring.exponent(t.monomial, m.z) != 0 || ring.exponent(t.monomial, m.zbar) != 0);
        });
    };
    return std::any_of(p.terms().begin(), p.terms().end(), holds);
}

const State& Expansion::last_state(std::size_t variable) const {
    return first_order_->states[first_order_->index(variable, system_.variables[variable].order - 1)];
}

// Not needed if all fast variables are finite, or all of the weight of eps.
void Expansion::check_leading_terms() const {
    const Ring& ring = *field_.ring;
    const std::vector<int> weights = field_.mode_weights();
    if (weights.empty() || (weights.size() == 1 && weights.front() <= 1)) return;
    if (field_.basis.numeric)
        refuse(Reason::eigenvalues,
               {"modes without closed form go with fast variables of weight 1 (or 0) and whole powers of eps",
                fmt::format("weight {}", to_string(system_.weight(weights.front()))),
                "leave out the weights, or give the modes in [modes]", whole_file(system_.file)});
    SeriesRun run(*program_);
    for (int n = 0; n <= weights.front(); ++n) {
        const auto set = [&](SeriesProgram::Node input, GeneratorId id) {
            run.set_input(input, n, ring.generator(id).weight == n ? ring.gen(id) : Polynomial());
        };
        for (const Mode& mode : field_.modes) {
            set(mode.input, mode.z);
            if (!mode.is_real()) set(mode.input_conjugate, mode.zbar);
        }
        for (const SlowVariable& slow : field_.slow)
            if (slow.driven) set(slow.input, slow.generator);
        for (const AngleVariable& angle : field_.angles) run.set_input(angle.input, n, {});
        run.advance(n);
        for (const Mode& mode : field_.modes) {
            const int own = ring.generator(mode.z).weight;
            const Polynomial part =
                RingDomain(field_.ring).without_vanishing(run.part(mode.rate, n), field_.outer());
            const bool wrong = n < own ? !part.empty() : n == own && holds_mode(part, own);
            if (wrong) refuse_leading_term(last_state(mode.variable), n);
        }
    }
}

// Shows a term of that weight as the file writes it, if one is found.
void Expansion::refuse_leading_term(const State& state, int weight) const {
    const Variable& variable = variable_of(state);
    const auto offends = [&](const ex& term) {
        if (lowest_weight(term) != weight) return false;
        if (weight < variable.weight) return true;
        const auto& states = first_order_->states;
        return std::any_of(states.begin(), states.end(), [&](const State& own) {
            return variable_of(own).role == Role::fast && variable_of(own).weight == weight &&
                   occurs(Role::fast, term.diff(own.symbol));
        });
    };
    const ex rate = state.rate.expand();
    const std::vector<ex> terms = terms_of(rate);
    const auto term = std::find_if(terms.begin(), terms.end(), offends);
    refuse(weight < variable.weight ? Reason::too_fast : Reason::nonlinear_layer,
           {weight < variable.weight
                ? "a term in the rate of a fast variable has its weight at least"
                : "in the rate of a fast variable stand at its own weight its linear part and terms without "
                  "variables of this weight",
            fmt::format("{} of weight {} in the rate of {}, which has weight {}",
                        term == terms.end() ? "a term" : spell(*term), to_string(system_.weight(weight)),
                        state.name, to_string(system_.weight(variable.weight))),
            fmt::format("give {} a lower weight, or what drives it a higher one, or write the term with a "
                        "power of eps",
                        variable.name),
            place_of_equation(state.variable)});
}

// A lower bound of the weights of e; a function that vanishes with its argument has the weight of that.
int Expansion::lowest_weight(const ex& e) const {
    if (e.is_equal(system_.eps)) return 1;
    if (is_a<GiNaC::symbol>(e)) {
        for (const State& state : first_order_->states)
            if (variable_of(state).role == Role::fast && e.is_equal(state.symbol))
                return variable_of(state).weight;
        return 0;
    }
    if (is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::nonnegint))
        return lowest_weight(e.op(0)) * GiNaC::ex_to<GiNaC::numeric>(e.op(1)).to_int();
    if (is_a<GiNaC::mul>(e)) {
        int sum = 0;
        for (const ex& factor : e) sum += lowest_weight(factor);
        return sum;
    }
    if (is_a<GiNaC::add>(e)) {
        int lowest = lowest_weight(e.op(0));
        for (const ex& term : e) lowest = std::min(lowest, lowest_weight(term));
        return lowest;
    }
    if (!is_a<GiNaC::function>(e)) return 0;
    const int inside = lowest_weight(e.op(0));
    return inside > 0 && with_argument(e, 0).is_zero() ? inside : 0; // log(0) is refused before
}

} // namespace resonform
