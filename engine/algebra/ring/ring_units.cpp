// SPDX-License-Identifier: GPL-3.0-or-later
// The units of a Ring: elements with an inverse, and those with roots in the ring.
#include "algebra/number/number.hpp"
#include "algebra/ring/division.hpp"
#include "algebra/ring/number_field.hpp"
#include "algebra/ring/ring.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace resonform {
namespace {

// number * monomial, the monomial invertible. The number is rational or a sum over numeric roots.
struct Unit {
    Polynomial number, inverse_number;
    Monomial monomial;
};

bool is_invertible(const Ring& ring, const Monomial& m) {
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        if (ring.exponent(m, id) != 0 && !ring.generator(id).invertible) return false;
    }
    return true;
}

// 1/p for a sum over numeric roots, or a single one.
std::optional<Polynomial> inverse_of_number(const Ring& ring, const Polynomial& p) {
    if (p.size() > 1) return inverse_in_number_field(ring, p);
    const Term& t = p.terms().front();
    return ring.reduce(Polynomial(ring.packing().scaled(t.monomial, -1), cln::recip(t.coefficient)));
}

// p/q where it is such a number times a monomial: (1 + a + sqrt(2)*a)/(sqrt(2) - 1 + a) = 1 + sqrt(2).
std::optional<Polynomial> numeric_quotient(const Ring& ring, const Polynomial& p, const Polynomial& q) {
    std::vector<GeneratorId> outer; // all but numbers
    for (GeneratorId id = 0; id < ring.size(); ++id)
        if (id != Ring::imaginary_unit && !is_numeric_root(ring, id)) outer.push_back(id);
    if (static_cast<int>(outer.size()) + 1 == ring.size()) return std::nullopt;
    const auto above = ring.collect(p, outer), below = ring.collect(q, outer);
    if (below.size() < 2 || above.size() != below.size()) return std::nullopt; // a number times a monomial
    const auto leading = [&](const auto& terms) {
        return *std::max_element(terms.begin(), terms.end(), [&](const auto& left, const auto& right) {
            return ring.exponents(left.first) < ring.exponents(right.first);
        });
    };
    const auto first = leading(above), by = leading(below);
    const std::optional<Polynomial> inverse = inverse_of_number(ring, by.second);
    if (!inverse) return std::nullopt;
    const Polynomial quotient =
        ring.multiply(ring.multiply(first.second, *inverse), Polynomial(first.first - by.first, Rational(1)));
    return ring.multiply(quotient, q) == p ? std::optional(quotient) : std::nullopt;
}

// Divides p by a radicand of several terms; the root whose radicand it was, or -1.
GeneratorId divide_by_radicand(const Ring& ring, Polynomial& p) {
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        if (ring.generator(id).kind != GeneratorKind::root) continue;
        const Polynomial radicand = ring.reduce(ring.generator(id).radicand);
        if (radicand.size() < 2) continue;
        std::optional<Polynomial> quotient = divide_exactly(ring, p, radicand);
        if (!quotient) quotient = numeric_quotient(ring, p, radicand);
        // A radicand that is a sum of numbers divides every other such sum, without end.
        if (quotient && (quotient->size() == 1 || !is_numeric_root(ring, id))) {
            p = *quotient;
            return id;
        }
    }
    return -1;
}

// Of a reduced p that is not zero.
std::optional<Unit> as_product(const Ring& ring, Polynomial p) {
    Monomial roots;
    while (p.size() > 1) {
        const GeneratorId id = divide_by_radicand(ring, p);
        if (id < 0) break;
        roots = roots + ring.monomial(id, ring.generator(id).index);
        ring.packing().require_safe(roots);
    }
    if (p.size() > 1) {
        const std::optional<Polynomial> inverse = inverse_in_number_field(ring, p);
        return inverse ? std::optional(Unit{p, *inverse, roots}) : std::nullopt;
    }
    const Term& t = p.terms().front();
    if (!is_invertible(ring, t.monomial)) return std::nullopt;
    return Unit{Polynomial(t.coefficient), Polynomial(cln::recip(t.coefficient)), t.monomial + roots};
}

// A product of generators that brings p to whole powers of all roots, so that their relations apply:
// 2 + rho^-2 becomes 2 rho^2 + 1 = 2 a + 3, where rho^2 = 1 + a.
Monomial denominator_of_roots(const Ring& ring, const Polynomial& p) {
    Monomial denominator;
    for (GeneratorId id = 0; id < ring.size(); ++id)
        if (ring.generator(id).kind == GeneratorKind::root)
            denominator = denominator + ring.monomial(id, std::max(0, -ring.lowest_exponent(p, id)));
    return denominator;
}

std::optional<Unit> as_unit(const Ring& ring, Polynomial p) {
    p = ring.reduce(std::move(p));
    if (p.empty()) return std::nullopt;
    if (std::optional<Unit> unit = as_product(ring, p)) return unit;
    const Monomial denominator = denominator_of_roots(ring, p);
    if (denominator == Monomial{}) return std::nullopt;
    const Polynomial whole = ring.multiply(p, Polynomial(denominator, Rational(1)));
    std::optional<Unit> unit = whole.empty() ? std::nullopt : as_product(ring, whole);
    if (unit) unit->monomial = unit->monomial - denominator;
    return unit;
}

// m^exponent for a positive real m, if all exponents are integers again. (v^4)^(1/2) = v^2 for a real
// v of any sign, (v^2)^(1/2) = v for a positive one.
std::optional<Monomial> monomial_power(const Ring& ring, const Monomial& m, const Rational& exponent) {
    Monomial result;
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const int e = ring.exponent(m, id);
        if (e == 0) continue;
        const Generator& g = ring.generator(id);
        const bool real = g.kind != GeneratorKind::imaginary && g.kind != GeneratorKind::fast &&
                          g.kind != GeneratorKind::phase;
        const Rational product = exponent * Rational(e);
        if (!real || cln::denominator(product) != 1) return std::nullopt;
        const Integer n = cln::numerator(product);
        if (cln::abs(n) > ring.packing().largest()) return std::nullopt;
        if (!g.positive && (e % 2 != 0 || cln::oddp(n))) return std::nullopt;
        result = result + ring.monomial(id, cln::cl_I_to_int(n));
    }
    return result;
}

// The positive root of a positive number, with the help of numeric roots of the ring from `from` on:
// value = tau^(e index) y^index, where tau^k is a number.
std::optional<Polynomial> number_root(const Ring& ring, const Rational& value, int index, GeneratorId from) {
    Rational root;
    if (exact_root(value, index, root)) return Polynomial(root);
    for (GeneratorId id = from; id < ring.size(); ++id) {
        const Generator& g = ring.generator(id);
        if (g.kind != GeneratorKind::root || g.radicand.size() != 1) continue;
        const Term& radicand = g.radicand.terms().front();
        if (radicand.monomial != Monomial{}) continue;
        for (int e = 1; e < g.index; ++e) {
            if (e * index % g.index != 0) continue;
            const Rational rest = value / cln::expt(radicand.coefficient, Integer(e * index / g.index));
            const std::optional<Polynomial> other = number_root(ring, rest, index, id + 1);
            if (other) return ring.multiply(*other, ring.gen(id, e));
        }
    }
    return std::nullopt;
}

} // namespace

std::optional<Polynomial> Ring::inverse(const Polynomial& p) const {
    const std::optional<Unit> unit = as_unit(*this, p);
    if (!unit) return std::nullopt;
    return multiply(unit->inverse_number, Polynomial(packing_.scaled(unit->monomial, -1), Rational(1)));
}

std::optional<Polynomial> Ring::rational_power(const Polynomial& p, const Rational& exponent) const {
    const Integer numerator = cln::numerator(exponent), index = cln::denominator(exponent);
    if (cln::abs(numerator) > packing_.largest() || index > packing_.largest()) return std::nullopt;
    const int n = cln::cl_I_to_int(numerator), k = cln::cl_I_to_int(index);
    if (k == 1 && n >= 0) return power(p, n);
    const std::optional<Unit> unit = as_unit(*this, p);
    if (!unit) return std::nullopt;
    if (k == 1) return power(*inverse(p), -n);
    if (unit->number.size() > 1) return std::nullopt;
    const Term& coefficient = unit->number.terms().front();
    if (!cln::plusp(coefficient.coefficient)) return std::nullopt;
    const std::optional<Monomial> monomial = monomial_power(*this, unit->monomial, exponent);
    const std::optional<Polynomial> number = number_root(*this, coefficient.coefficient, k, 0);
    if (!monomial || !number) return std::nullopt;
    return multiply(Polynomial(*monomial, Rational(1)), power(*number, n));
}

} // namespace resonform
