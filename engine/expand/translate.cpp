// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/translate.hpp"

#include "model/canonical.hpp"

#include <fmt/format.h>

namespace resonform {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using Node = SeriesProgram::Node;

void Translator::bind(const ex& symbol, Node node) { nodes_[symbol] = node; }

Node Translator::operator()(const ex& e, const Place& place) {
    const auto known = nodes_.find(e);
    if (known != nodes_.end()) return known->second;
    const Node node = coefficients_.has_weight(e) ? translate(e, place)
                                                  : program_.constant(coefficients_.convert(e, place));
    nodes_.emplace(e, node);
    return node;
}

Node Translator::translate(const ex& e, const Place& place) {
    if (is_a<GiNaC::add>(e)) {
        std::vector<std::pair<Rational, Node>> addends;
        for (const ex& term : operands(e)) addends.emplace_back(1, (*this)(term, place));
        return program_.sum(addends);
    }
    if (is_a<GiNaC::mul>(e)) return product(e, place);
    if (is_a<GiNaC::power>(e)) return power(e, place);
    if (is_a<GiNaC::function>(e)) return function(e, place);
    if (holds_angle(e)) return of_angles(e, place);            // refuses the angle itself
    return program_.constant(coefficients_.convert(e, place)); // eps
}

// The factors of weight 0 are multiplied once, in the ring.
Node Translator::product(const ex& e, const Place& place) {
    ex coefficient = 1;
    Node result = -1;
    for (const ex& factor : operands(e)) {
        if (!coefficients_.has_weight(factor)) {
            coefficient *= factor;
        } else {
            const Node node = (*this)(factor, place);
            result = result < 0 ? node : program_.product(result, node);
        }
    }
    if (coefficient.is_equal(1)) return result;
    return program_.product((*this)(coefficient, place), result);
}

Node Translator::power(const ex& e, const Place& place) {
    const Rational exponent = to_rational(e.op(1));
    const bool whole = e.op(1).info(GiNaC::info_flags::nonnegint);
    if (!whole && coefficients_.at_origin(e.op(0), place).is_zero())
        bad_input({"a root or an inverse is taken only of what does not vanish at the origin", spell(e),
                   "remove the singularity, or expand about another point", place});
    return program_.power((*this)(e.op(0), place), exponent);
}

Node Translator::function(const ex& e, const Place& place) {
    if (holds_angle(e)) return of_angles(e, place);
    const std::string name = ex_to<GiNaC::function>(e).get_name();
    const ex& argument = e.op(0);
    const ex origin = coefficients_.at_origin(argument, place) - (name == "log" ? 1 : 0);
    if (!origin.normal().is_zero())
        refuse({name == "log" ? "the argument of log is 1 at the origin"
                              : fmt::format("the argument of {} vanishes at the origin", name),
                spell(e), "expand by an addition theorem so that functions of slow variables stand alone",
                place});
    const Node u = (*this)(argument, place);
    if (name == "sin") return program_.sine(u);
    if (name == "cos") return program_.cosine(u);
    if (name == "tan") return quotient(program_.sine(u), program_.cosine(u));
    if (name == "exp") return program_.exponential(u);
    if (name == "log") return program_.logarithm(u);
    if (name == "sinh") return hyperbolic(u, -1);
    if (name == "cosh") return hyperbolic(u, 1);
    if (name == "tanh") return quotient(hyperbolic(u, -1), hyperbolic(u, 1));
    if (name == "atan") return integral_of(u, 1, -1);
    if (name == "asin") return integral_of(u, -1, Rational(-1) / 2);
    refuse({"functions of fast variables are sin cos tan exp log sqrt sinh cosh tanh asin atan", spell(e),
            "write it with these", place});
}

// f(u) with f(0) = 0 and f'(u) = (1 + sign u^2)^exponent.
Node Translator::integral_of(Node u, const Rational& sign, const Rational& exponent) {
    const Node one = program_.constant(coefficients_.ring()->one());
    const Node slope = program_.power(program_.sum({{1, one}, {sign, program_.product(u, u)}}), exponent);
    return program_.antiderivative(u, slope);
}

// (e^u + sign e^-u)/2
Node Translator::hyperbolic(Node u, const Rational& sign) {
    const Rational half = Rational(1) / 2;
    const Node minus = program_.sum({{-1, u}});
    return program_.sum({{half, program_.exponential(u)}, {sign * half, program_.exponential(minus)}});
}

Node Translator::quotient(Node a, Node b) { return program_.product(a, program_.power(b, -1)); }

} // namespace resonform
