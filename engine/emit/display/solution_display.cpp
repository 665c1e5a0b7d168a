// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/display/solution_display.hpp"

#include "emit/display/free_name.hpp"
#include "solve/quadrature.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace resonform {

namespace {

DisplayFactor primitive_factor(const Solution& solution, const Primitive& primitive, DisplaySum integrand) {
    if (primitive.over_slow_time || solution.slow.empty())
        return integral_factor(
            {std::move(integrand), symbol_sum(slow_time_name(solution)), DisplaySum{}, slow_time_sum()});
    const std::string& slow = solution.system().variables[solution.slow.front().variable].name;
    return integral_factor(
        {std::move(integrand), symbol_sum(slow), symbol_sum(slow + "_0"), symbol_sum(slow)});
}

// The real or the imaginary part of p, both real. Phases are absent.
Polynomial part(const Ring& ring, const Polynomial& p, bool imaginary) {
    std::vector<Term> terms;
    for (const Term& term : p.terms()) {
        const int exponent = ring.exponent(term.monomial, Ring::imaginary_unit);
        if ((exponent != 0) != imaginary) continue;
        terms.push_back({term.monomial - ring.monomial(Ring::imaginary_unit, exponent), term.coefficient});
    }
    return Polynomial::from_terms(std::move(terms));
}

void add_harmonic(std::vector<Harmonic>& list, int multiple, bool sine, Polynomial coefficient) {
    if (!coefficient.empty()) list.push_back({multiple, sine, std::move(coefficient)});
}

DisplayFactor trigonometric(const Solution& solution, const Harmonic& harmonic) {
    DisplaySum angle = symbol_sum(phase_name(solution));
    angle.terms.front().coefficient = harmonic.multiple;
    return function_factor(harmonic.sine ? "sin" : "cos", std::move(angle));
}

// p*t
DisplayTerm over_time(const Ring& ring, const Polynomial& p) {
    DisplayTerm motion = factored(display(ring, p));
    motion.tail.push_back(symbol_factor("t"));
    return motion;
}

} // namespace

Substitutes solution_substitutes(const Solution& solution) {
    Substitutes substitutes;
    for (const Primitive& primitive : solution.primitives) {
        DisplaySum argument = display(*solution.ring, primitive.argument, substitutes);
        DisplayFactor factor;
        switch (primitive.kind) {
        case PrimitiveKind::logarithm: factor = function_factor("log", term_sum(factored(argument))); break;
        case PrimitiveKind::exponential: factor = function_factor("exp", std::move(argument)); break;
        case PrimitiveKind::quadrature:
            factor = primitive_factor(solution, primitive, std::move(argument));
            break;
        }
        substitutes.emplace(primitive.id, std::move(factor));
    }
    return substitutes;
}

DisplaySum slow_time_sum() {
    DisplaySum sum = factor_sum(symbol_factor("eps"));
    sum.terms.front().factors.push_back(symbol_factor("t"));
    return sum;
}

DisplaySum path_sum(const Ring& ring, const std::string& name, const SlowPath& path) {
    DisplaySum sum = symbol_sum(name + "_0");
    if (!path.relaxes()) return path.drive.empty() ? sum : sum + term_sum(over_time(ring, path.drive));
    const DisplayFactor left = function_factor("exp", term_sum(over_time(ring, -path.decline)));
    sum.terms.front().tail.push_back(left);
    if (path.drive.empty()) return sum;
    const auto rest = quotient_in_ring(ring, path.drive, path.decline);
    if (!rest) return {};
    sum.terms.push_back(factored(display(ring, *rest)));
    sum.terms.back().tail.push_back(sum_factor(number_sum(1) + -factor_sum(left)));
    return sum;
}

std::string slow_time_name(const Solution& solution) {
    return solution.slow_time ? solution.ring->generator(*solution.slow_time).name
                              : free_name(solution.system(), "T");
}

bool mentions(const DisplaySum& sum, const std::string& name) {
    const auto in_factor = [&](const DisplayFactor& factor) {
        return (factor.kind == DisplayFactor::Kind::symbol && factor.name == name) ||
               std::any_of(factor.arguments.begin(), factor.arguments.end(),
                           [&](const DisplaySum& argument) { return mentions(argument, name); });
    };
    return std::any_of(sum.terms.begin(), sum.terms.end(), [&](const DisplayTerm& term) {
        return std::any_of(term.factors.begin(), term.factors.end(), in_factor) ||
               std::any_of(term.tail.begin(), term.tail.end(), in_factor);
    });
}

std::string phase_name(const Solution& solution) { return free_name(solution.system(), "theta"); }

std::vector<Harmonic> harmonics(const Solution& solution, const Polynomial& p) {
    const Ring& ring = *solution.ring;
    if (solution.ring->conjugate(p) != p) throw std::logic_error("an output of a solution is not real");
    std::vector<Harmonic> list;
    if (solution.modes.empty()) {
        add_harmonic(list, 0, false, p);
        return list;
    }
    const GeneratorId phase = solution.modes.front().phase;
    std::map<int, Polynomial> by_multiple;
    for (const auto& [monomial, coefficient] : ring.collect(p, {phase}))
        by_multiple[ring.exponent(monomial, phase)] = coefficient;
    for (const auto& [multiple, coefficient] : by_multiple) {
        if (multiple < 0) continue;
        const Rational twice = multiple == 0 ? 1 : 2;
        add_harmonic(list, multiple, false, twice * part(ring, coefficient, false));
        add_harmonic(list, multiple, true, -(twice * part(ring, coefficient, true)));
    }
    return list;
}

DisplaySum display_harmonics(const Solution& solution, const std::vector<Harmonic>& list) {
    const Substitutes substitutes = solution_substitutes(solution);
    DisplaySum sum;
    for (const Harmonic& harmonic : list) {
        const DisplaySum coefficient = display(*solution.ring, harmonic.coefficient, substitutes);
        if (harmonic.multiple == 0) {
            sum = sum + coefficient;
            continue;
        }
        DisplayTerm term = factored(coefficient);
        term.tail.push_back(trigonometric(solution, harmonic));
        sum.terms.push_back(std::move(term));
    }
    return sum;
}

} // namespace resonform
