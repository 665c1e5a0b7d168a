// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/expansion/translate.hpp"

#include "algebra/number/error.hpp"
#include "model/text/canonical.hpp"
#include "model/text/function_call.hpp"
#include "model/text/function_slope.hpp"

#include <optional>

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
    if (e.op(1).info(GiNaC::info_flags::nonnegint)) return program_.power((*this)(e.op(0), place), exponent);
    const ex origin = coefficients_.at_origin(e.op(0), place);
    if (origin.is_zero())
        bad_input({"a root or an inverse is taken only of what does not vanish at the origin", spell(e),
                   "remove the singularity, or expand about another point", place});
    require_small(e, place);
    const Node base = (*this)(e.op(0), place);
    if (coefficients_.ring()->rational_power(coefficients_.convert(origin, place), exponent))
        return program_.power(base, exponent, place);
    // The ring knows the power of the leading part by its factors: u^p = u_0^p (u/u_0)^p.
    const auto leading = [&](const ex& power) {
        return program_.constant(coefficients_.convert(GiNaC::pow(origin, power), place));
    };
    return program_.product(leading(e.op(1)),
                            program_.power(program_.product(leading(-1), base), exponent, place));
}

void Translator::require_small(const ex& function, const Place& place) const {
    if (!coefficients_.is_finite(function.op(0))) return;
    refuse({"functions, roots and inverses are expanded in small variables, not in finite ones (of weight 0)",
            spell(function), "write the equations with polynomials of these, or use weight 1", place});
}

// f(u_0 + r), where u_0 is of weight 0 and r begins at weight 1.
Node Translator::function(const ex& e, const Place& place) {
    require_small(e, place);
    if (holds_angle(e)) return of_angles(e, place);
    const ex u0 = coefficients_.at_origin(e.op(0), place);
    const Node u = (*this)(e.op(0), place);
    const auto at_origin = [&](const ex& f) { return program_.constant(coefficients_.convert(f, place)); };
    const Node rest = u0.is_zero() ? u : program_.sum({{1, u}, {-1, at_origin(u0)}});
    if (is_named(e)) return named(named_call(e), u0, rest, place);
    const auto sine = [&] {
        if (u0.is_zero()) return program_.sine(u);
        return sum(program_.product(at_origin(GiNaC::sin(u0)), program_.cosine(rest)),
                   program_.product(at_origin(GiNaC::cos(u0)), program_.sine(rest)));
    };
    const auto cosine = [&] {
        if (u0.is_zero()) return program_.cosine(u);
        return sum(program_.product(at_origin(GiNaC::cos(u0)), program_.cosine(rest)),
                   program_.product(at_origin(-GiNaC::sin(u0)), program_.sine(rest)));
    };
    const auto exponential = [&](int sign) {
        const Node of_rest = program_.exponential(sign > 0 ? rest : program_.sum({{-1, rest}}));
        return u0.is_zero() ? of_rest : program_.product(at_origin(GiNaC::exp(sign * u0)), of_rest);
    };
    const auto hyperbolic = [&](int sign) { // (e^u + sign e^-u)/2
        const Rational half = Rational(1) / 2;
        return program_.sum({{half, exponential(1)}, {sign * half, exponential(-1)}});
    };
    const std::optional<Function> f = function_of(e);
    if (!f)
        refuse({"unknown function: neither an elementary one nor one under [functions]", spell(e),
                "write it with these", place});
    switch (*f) {
    case Function::sine: return sine();
    case Function::cosine: return cosine();
    case Function::tangent: return quotient(sine(), cosine());
    case Function::exponential: return exponential(1);
    case Function::hyperbolic_sine: return hyperbolic(-1);
    case Function::hyperbolic_cosine: return hyperbolic(1);
    case Function::hyperbolic_tangent: return quotient(hyperbolic(-1), hyperbolic(1));
    default: // f(u_0) and the integral of f'(u) du
        return sum(at_origin(with_argument(e, u0)),
                   program_.antiderivative(u, (*this)(slope_of(*f, e.op(0)), place)));
    }
}

// sum_k f^(k)(u_0) rest^k / k!, as far as the ring has derivatives: through that weight.
Node Translator::named(const NamedCall& call, const ex& u0, Node rest, const Place& place) {
    std::vector<std::pair<Rational, Node>> addends;
    Node power = program_.constant(coefficients_.ring()->one());
    Rational factorial = 1;
    for (int k = 0; k <= coefficients_.derivatives(); ++k) {
        if (k > 0) {
            power = program_.product(power, rest);
            factorial = factorial * k;
        }
        const ex slope = named_function(call.name, call.derivative + k, u0);
        const Node coefficient = program_.constant(coefficients_.convert(slope, place));
        addends.emplace_back(1 / factorial, program_.product(coefficient, power));
    }
    return program_.sum(addends);
}

Node Translator::sum(Node a, Node b) { return program_.sum({{1, a}, {1, b}}); }

Node Translator::quotient(Node a, Node b) { return program_.product(a, program_.power(b, -1)); }

} // namespace resonform
