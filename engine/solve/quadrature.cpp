// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/quadrature.hpp"

#include "algebra/ring/division.hpp"
#include "solve/span.hpp"

#include <algorithm>
#include <set>

namespace resonform {

namespace {

constexpr std::size_t most_candidates = 800; // beyond, a numerical quadrature is the better answer

bool depends_on(const Ring& ring, GeneratorId id, GeneratorId x) {
    return id == x || !ring.derivative(ring.gen(id), x).empty();
}

bool is_free_of(const Ring& ring, const Monomial& m, GeneratorId x) {
    for (GeneratorId id = 0; id < ring.size(); ++id)
        if (ring.exponent(m, id) != 0 && depends_on(ring, id, x)) return false;
    return true;
}

bool lies_in_ring(const Ring& ring, const Monomial& m) {
    for (GeneratorId id = 0; id < ring.size(); ++id)
        if (ring.exponent(m, id) < 0 && !ring.generator(id).invertible) return false;
    return true;
}

void insert_monomials(const Polynomial& p, std::set<Monomial>& monomials) {
    for (const Term& t : p.terms()) monomials.insert(t.monomial);
}

std::vector<GeneratorId> roots_in(const Ring& ring, GeneratorId x) {
    std::vector<GeneratorId> roots;
    for (GeneratorId id = 0; id < ring.size(); ++id)
        if (ring.generator(id).kind == GeneratorKind::root && depends_on(ring, id, x)) roots.push_back(id);
    return roots;
}

// radicand = sum_k result[k] x^k; nullopt if it holds other functions of x.
std::optional<std::vector<Polynomial>> coefficients_in(const Ring& ring, const Polynomial& radicand,
                                                       GeneratorId x) {
    std::vector<std::vector<Term>> parts;
    for (const Term& t : radicand.terms()) {
        const auto power = static_cast<std::size_t>(ring.exponent(t.monomial, x));
        const Monomial rest = t.monomial - ring.monomial(x, static_cast<int>(power));
        if (!is_free_of(ring, rest, x)) return std::nullopt;
        if (parts.size() <= power) parts.resize(power + 1);
        parts[power].push_back({rest, t.coefficient});
    }
    std::vector<Polynomial> result;
    for (auto& part : parts) result.push_back(ring.reduce(Polynomial::from_terms(std::move(part))));
    return result;
}

bool provably_positive(const Ring& ring, const Polynomial& p) {
    if (p.size() != 1 || p.terms().front().coefficient <= 0) return false;
    const auto exponents = ring.exponents(p.terms().front().monomial);
    for (GeneratorId id = 0; id < ring.size(); ++id)
        if (exponents[static_cast<std::size_t>(id)] % 2 != 0 && !ring.generator(id).positive) return false;
    return true;
}

Logarithm normalised(const Ring& ring, const Polynomial& argument, const Polynomial& at_zero,
                     Polynomial derivative) {
    const auto scale = provably_positive(ring, at_zero) ? ring.inverse(at_zero) : std::nullopt;
    return {scale ? ring.multiply(argument, *scale) : argument, std::move(derivative)};
}

// log(2 a x + b + 2 sqrt(a) sqrt(P)) for P = a x^2 + b x + c; its derivative is sqrt(a)/sqrt(P).
std::optional<Logarithm> area_logarithm(const Ring& ring, GeneratorId x, GeneratorId root,
                                        const std::vector<Polynomial>& p) {
    const Generator& g = ring.generator(root);
    const Rational half_power = Rational(1) / 2;
    if (p.size() != 3 || g.index % 2 != 0) return std::nullopt;
    const auto a = ring.rational_power(p[2], half_power);
    if (!a) return std::nullopt;
    const int half = g.index / 2;
    const Polynomial root_p = ring.gen(root, half);
    const Polynomial derivative = ring.multiply(*a, ring.gen(root, -half));
    if (!p[1].empty()) {
        const Polynomial linear = Rational(2) * ring.multiply(p[2], ring.gen(x)) + p[1];
        return Logarithm{linear + Rational(2) * ring.multiply(*a, root_p), derivative};
    }
    const Polynomial argument = ring.multiply(*a, ring.gen(x)) + root_p;
    if (const auto c = ring.rational_power(p[0], half_power))
        return normalised(ring, argument, *c, derivative);
    // sqrt(c) is not in the ring: the logarithm of the square vanishes at x = 0 all the same
    return normalised(ring, ring.multiply(argument, argument), p[0], Rational(2) * derivative);
}

// The terms of a radicand, each written as the ring writes it: where another root has replaced x^2 by
// rho^2 - 1, these two.
std::set<Monomial> radicand_monomials(const Ring& ring, const Generator& root) {
    std::set<Monomial> monomials;
    for (const Term& t : root.radicand.terms())
        insert_monomials(ring.reduce(Polynomial(t.monomial, 1)), monomials);
    return monomials;
}

// Multiplying by x-dependent factors (root^index / unit term of its radicand, of x too where that is one)
// leads to the neighbours of a monomial under the derivation: enough of them to reach exponents of the other
// sign.
void add_neighbours(const Ring& ring, GeneratorId x, std::set<Monomial>& candidates) {
    for (GeneratorId root : roots_in(ring, x)) {
        const Generator& g = ring.generator(root);
        for (const Monomial& term : radicand_monomials(ring, g)) {
            const auto unit = ring.inverse(Polynomial(term, 1));
            if (!unit) continue;
            const Polynomial up = ring.multiply(ring.gen(root, g.index), *unit);
            const Polynomial down = ring.multiply(ring.gen(root, -g.index), Polynomial(term, 1));
            const std::set<Monomial> start = candidates;
            for (const Monomial& m : start) {
                const int distance = ring.exponent(m, root) / g.index;
                for (int k = std::min(-1, -distance - 1); k <= std::max(1, 1 - distance); ++k) {
                    const Polynomial factor = ring.power(k < 0 ? down : up, k < 0 ? -k : k);
                    insert_monomials(ring.multiply(Polynomial(m, 1), factor), candidates);
                }
                if (candidates.size() > most_candidates) return;
            }
        }
    }
}

// For p = x^n e(x) with e' = u e: x^j e and x^j e / u, j = 0 ... n + 1.
void add_exponentials(const Ring& ring, GeneratorId x, const Polynomial& f, std::set<Monomial>& candidates) {
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const Generator& g = ring.generator(id);
        if (g.kind != GeneratorKind::primitive || !g.invertible || !depends_on(ring, id, x)) continue;
        const Polynomial rate = ring.multiply(ring.derivative(ring.gen(id), x), ring.gen(id, -1));
        const auto period = ring.inverse(rate);
        for (const Term& t : f.terms()) {
            if (ring.exponent(t.monomial, id) == 0) continue;
            Polynomial scale = ring.one();
            for (int j = ring.exponent(t.monomial, x); j >= 0; --j) {
                const Polynomial lowered(t.monomial - ring.monomial(x, ring.exponent(t.monomial, x) - j), 1);
                if (period) scale = ring.multiply(scale, *period);
                insert_monomials(ring.multiply(lowered, scale), candidates);
            }
        }
    }
}

// The monomials of x f, each divided by those of the speed.
void add_integrals(const Ring& ring, GeneratorId x, const Polynomial& f, const Polynomial& speed,
                   std::set<Monomial>& candidates) {
    std::set<Monomial> raised;
    insert_monomials(ring.multiply(ring.gen(x), f), raised);
    for (const Monomial& m : raised)
        for (const Term& s : speed.terms())
            if (const Monomial slowed = m - s.monomial; lies_in_ring(ring, slowed))
                insert_monomials(ring.reduce(Polynomial(slowed, 1)), candidates);
}

std::set<Monomial> candidate_monomials(const Ring& ring, GeneratorId x, const Polynomial& f,
                                       const Polynomial& speed) {
    std::set<Monomial> candidates;
    add_integrals(ring, x, f, speed, candidates);
    add_exponentials(ring, x, f, candidates);
    add_neighbours(ring, x, candidates);
    return candidates;
}

// The part of p that is a polynomial in x once powers of roots are expanded, at x = 0: an additive
// constant in disguise (sigma^4 = xi^2 + r^2 carries r^2).
Polynomial hidden_constant(const Ring& ring, GeneratorId x, const Polynomial& p) {
    std::vector<Polynomial> constants;
    for (const Term& t : p.terms()) {
        if (ring.exponent(t.monomial, x) != 0) continue;
        Monomial rest = t.monomial;
        Polynomial value = ring.one();
        for (GeneratorId root : roots_in(ring, x)) {
            const Generator& g = ring.generator(root);
            const int e = ring.exponent(t.monomial, root);
            const auto coefficients = coefficients_in(ring, g.radicand, x);
            if (e < 0 || e % g.index != 0 || !coefficients) continue; // rest keeps the root: no constant
            rest = rest - ring.monomial(root, e);
            value = ring.multiply(value, ring.power(coefficients->front(), e / g.index));
        }
        if (is_free_of(ring, rest, x))
            constants.push_back(ring.multiply(Polynomial(rest, t.coefficient), value));
    }
    return sum(constants);
}

// q log for every monomial q, free of x, by which a derivative of log may meet a term of f or of the
// derivatives of the candidates.
std::vector<std::pair<Polynomial, Logarithm>>
candidate_logarithms(const Ring& ring, GeneratorId x, const Polynomial& f, const Polynomial& speed,
                     const std::vector<Polynomial>& derivatives) {
    std::set<Monomial> reached;
    insert_monomials(f, reached);
    for (const Polynomial& d : derivatives) insert_monomials(d, reached);
    std::vector<std::pair<Polynomial, Logarithm>> result;
    for (const Logarithm& logarithm : logarithms(ring, x)) {
        std::set<Monomial> coefficients;
        const Polynomial rate = ring.multiply(logarithm.derivative, speed);
        for (const Monomial& m : reached)
            for (const Term& t : rate.terms()) {
                const Monomial q = m - t.monomial;
                if (is_free_of(ring, q, x) && lies_in_ring(ring, q)) coefficients.insert(q);
            }
        for (const Monomial& q : coefficients) result.emplace_back(Polynomial(q, 1), logarithm);
    }
    return result;
}

// Powers of roots that leave none in a denominator: where a root was not eliminated, only polynomials without
// denominators have canonical forms.
Monomial common_denominator(const Ring& ring, GeneratorId x, const Polynomial& f,
                            const std::vector<Polynomial>& derivatives) {
    Monomial result;
    for (GeneratorId root : roots_in(ring, x)) {
        int least = 0;
        const auto see = [&](const Polynomial& p) {
            for (const Term& t : p.terms()) least = std::min(least, ring.exponent(t.monomial, root));
        };
        see(f);
        for (const Polynomial& d : derivatives) see(d);
        const int index = ring.generator(root).index;
        result = result + ring.monomial(root, (-least + index - 1) / index * index);
    }
    return result;
}

// The factor by monomials: a product of the ring would replace its roots before they meet those of p.
Polynomial without_denominator(const Ring& ring, const Polynomial& p, const Monomial& denominator) {
    std::vector<Term> terms = p.terms();
    for (Term& t : terms) t.monomial = t.monomial + denominator;
    return ring.reduce(Polynomial::from_terms(std::move(terms)));
}

} // namespace

std::vector<Logarithm> logarithms(const Ring& ring, GeneratorId x) {
    std::vector<Logarithm> result;
    for (GeneratorId root : roots_in(ring, x)) {
        const Generator& g = ring.generator(root);
        const auto coefficients = coefficients_in(ring, g.radicand, x);
        if (!g.positive || !coefficients) continue;
        const Polynomial radicand = ring.gen(root, g.index);
        const Polynomial slope = ring.multiply(ring.derivative(radicand, x), ring.gen(root, -g.index));
        result.push_back(normalised(ring, radicand, coefficients->front(), slope));
        if (auto area = area_logarithm(ring, x, root, *coefficients)) result.push_back(std::move(*area));
    }
    if (ring.generator(x).positive) result.push_back({ring.gen(x), ring.power(ring.gen(x), -1)});
    return result;
}

std::optional<ClosedForm> close_primitive(const Ring& ring, GeneratorId x, const Polynomial& f,
                                          const Polynomial& speed) {
    const auto candidates = candidate_monomials(ring, x, f, speed);
    if (candidates.size() > most_candidates) return std::nullopt;

    std::vector<Polynomial> derivatives;
    for (const Monomial& m : candidates)
        derivatives.push_back(ring.multiply(speed, ring.derivative(Polynomial(m, 1), x)));
    const auto logarithmic = candidate_logarithms(ring, x, f, speed, derivatives);
    for (const auto& [q, logarithm] : logarithmic)
        derivatives.push_back(ring.multiply(q, ring.multiply(speed, logarithm.derivative)));

    const Monomial denominator = common_denominator(ring, x, f, derivatives);
    Span span;
    for (const Polynomial& d : derivatives) span.add(without_denominator(ring, d, denominator));
    const auto solved = span.decompose(without_denominator(ring, f, denominator));
    if (!solved.remainder.empty()) return std::nullopt;

    ClosedForm result;
    std::vector<Term> terms;
    std::size_t k = 0;
    for (const Monomial& m : candidates) terms.push_back({m, solved.coordinates[k++]});
    result.algebraic = ring.reduce(Polynomial::from_terms(std::move(terms)));
    result.algebraic = result.algebraic - hidden_constant(ring, x, result.algebraic);
    for (const auto& [coefficient, logarithm] : logarithmic) {
        const Rational& c = solved.coordinates[k++];
        if (c != 0) result.logarithmic.emplace_back(c * coefficient, logarithm);
    }
    return result;
}

std::optional<Polynomial> quotient_in_ring(const Ring& ring, const Polynomial& p, const Polynomial& divisor) {
    if (const auto inverse = ring.inverse(divisor)) return ring.multiply(p, *inverse);
    const auto quotient = divide_exactly(ring, p, divisor);
    if (!quotient) return std::nullopt;
    for (const Term& t : quotient->terms())
        if (!lies_in_ring(ring, t.monomial)) return std::nullopt;
    return ring.reduce(*quotient);
}

} // namespace resonform
