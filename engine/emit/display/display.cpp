// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/display/display.hpp"

#include "algebra/ring/cancellation.hpp"
#include "algebra/ring/fractions.hpp"
#include "algebra/ring/primitive_terms.hpp"

#include <algorithm>
#include <array>
#include <cln/integer.h>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>

namespace resonform {

namespace {

using Exponents = std::vector<int>;

DisplaySum display_radicand(const Ring& ring, const Polynomial& radicand);

DisplayFactor display_function(const Ring& ring, const FunctionOf& f) {
    const std::string name = f.function == Function::named ? f.symbol : std::string(row_of(f.function).name);
    DisplayFactor factor = function_factor(name, display(ring, f.argument));
    factor.primes = f.derivative;
    return factor;
}

// c * x^a * y^b with c > 0 and positive symbols: its root is the product of the roots. (A divisor is no
// root.)
bool splits_under_root(const Ring& ring, const Generator& root) {
    const Polynomial& radicand = root.radicand;
    if (radicand.size() == 1 && root.index == 1) return true;
    if (radicand.size() != 1 || cln::minusp(radicand.terms().front().coefficient)) return false;
    const Exponents exponents = ring.exponents(radicand.terms().front().monomial);
    for (GeneratorId id = 0; id < ring.size(); ++id)
        if (exponents[static_cast<std::size_t>(id)] != 0 && !ring.generator(id).positive) return false;
    return true;
}

// The powers of one monomial, collected by base.
class Powers {
public:
    Powers(const Ring& ring, const Substitutes& substitutes) : ring_(ring), substitutes_(substitutes) {}

    void multiply(GeneratorId id, const Rational& exponent) {
        if (cln::zerop(exponent)) return;
        const Generator& generator = ring_.generator(id);
        if (substitutes_.count(id) == 0 && generator.kind == GeneratorKind::root)
            multiply_root(id, exponent / generator.index);
        else
            symbols_[id] += exponent;
    }

    // Numbers, symbols in the order of the ring, sums, and substitutes such as logarithms.
    [[nodiscard]] std::vector<DisplayFactor> factors() const {
        std::vector<DisplayFactor> result = numbers_, functions;
        for (const auto& [id, exponent] : symbols_) {
            if (cln::zerop(exponent)) continue;
            DisplayFactor factor = symbol(id);
            factor.exponent = factor.exponent * exponent;
            (factor.kind == DisplayFactor::Kind::symbol ? result : functions).push_back(std::move(factor));
        }
        result.insert(result.end(), sums_.begin(), sums_.end());
        std::move(functions.begin(), functions.end(), std::back_inserter(result));
        return result;
    }

private:
    void multiply_root(GeneratorId id, const Rational& exponent) {
        const Polynomial& radicand = ring_.generator(id).radicand;
        if (!splits_under_root(ring_, ring_.generator(id))) {
            sums_.push_back(sum_factor(display_radicand(ring_, radicand), exponent));
            return;
        }
        const Term& term = radicand.terms().front();
        if (term.coefficient != 1) {
            DisplayFactor factor;
            factor.kind = DisplayFactor::Kind::number;
            factor.number = term.coefficient;
            factor.exponent = exponent;
            numbers_.push_back(std::move(factor));
        }
        const Exponents exponents = ring_.exponents(term.monomial);
        for (GeneratorId base = 0; base < ring_.size(); ++base)
            multiply(base, exponent * exponents[static_cast<std::size_t>(base)]);
    }

    [[nodiscard]] DisplayFactor symbol(GeneratorId id) const {
        const auto substitute = substitutes_.find(id);
        if (substitute != substitutes_.end()) return substitute->second;
        const Generator& g = ring_.generator(id);
        if (g.kind == GeneratorKind::small)
            return symbol_factor(g.name, Rational(1) / ring_.weights_in_one());
        return g.kind == GeneratorKind::function ? display_function(ring_, g.of) : symbol_factor(g.name);
    }

    const Ring& ring_;
    const Substitutes& substitutes_;
    std::vector<DisplayFactor> numbers_, sums_;
    std::map<GeneratorId, Rational> symbols_;
};

DisplayTerm monomial_term(const Ring& ring, const Exponents& exponents, const Rational& coefficient,
                          const Substitutes& substitutes) {
    DisplayTerm term;
    term.coefficient = coefficient;
    term.digits = ring.digits();
    term.imaginary = exponents[Ring::imaginary_unit] != 0;
    Powers powers(ring, substitutes);
    for (GeneratorId id = Ring::imaginary_unit + 1; id < ring.size(); ++id)
        powers.multiply(id, exponents[static_cast<std::size_t>(id)]);
    term.factors = powers.factors();
    return term;
}

struct PlainTerm {
    Exponents exponents;
    Rational coefficient;
};

// Falling total degree, then falling powers of the first symbols: r^2 + r*xi + xi^2 + r + 1.
bool before_in_polynomial(const Exponents& a, const Exponents& b) {
    const int degree_a = std::accumulate(a.begin(), a.end(), 0);
    const int degree_b = std::accumulate(b.begin(), b.end(), 0);
    return degree_a != degree_b ? degree_a > degree_b : a > b;
}

std::vector<PlainTerm> ordered_terms(const Ring& ring, const std::vector<Term>& list) {
    std::vector<PlainTerm> terms;
    for (const Term& term : list) terms.push_back({ring.exponents(term.monomial), term.coefficient});
    std::sort(terms.begin(), terms.end(), [](const PlainTerm& a, const PlainTerm& b) {
        return before_in_polynomial(a.exponents, b.exponents);
    });
    return terms;
}

DisplaySum display_radicand(const Ring& ring, const Polynomial& radicand) {
    DisplaySum sum;
    for (const PlainTerm& term : ordered_terms(ring, radicand.terms()))
        sum.terms.push_back(monomial_term(ring, term.exponents, term.coefficient, {}));
    return sum;
}

// Takes common powers and the sign of the first out of a list of terms.
PlainTerm take_powers(std::vector<PlainTerm>& terms) {
    PlainTerm common{terms.front().exponents, 1};
    for (const PlainTerm& term : terms)
        for (std::size_t i = 0; i < common.exponents.size(); ++i)
            common.exponents[i] = std::min(common.exponents[i], term.exponents[i]);
    const bool negative = cln::minusp(terms.front().coefficient);
    if (negative) common.coefficient = -1;
    for (PlainTerm& term : terms) {
        for (std::size_t i = 0; i < common.exponents.size(); ++i) term.exponents[i] -= common.exponents[i];
        if (negative) term.coefficient = -term.coefficient;
    }
    return common;
}

struct Element {
    Exponents order; // by which elements are put in order
    DisplayTerm term;
};

// Below the fraction bar: the same one again as a power.
void divide_by(DisplayTerm& term, DisplaySum divisor) {
    if (cln::minusp(divisor.terms.front().coefficient)) {
        divisor = -std::move(divisor);
        term.coefficient = -term.coefficient;
    }
    DisplayFactor factor = sum_factor(std::move(divisor), -1);
    const auto same = std::find_if(term.factors.begin(), term.factors.end(), [&](const DisplayFactor& f) {
        return f.exponent < 0 && same_base(f, factor);
    });
    if (same == term.factors.end())
        term.factors.push_back(std::move(factor));
    else
        same->exponent = same->exponent - 1;
}

// number * outer * numerator: coprime integers, the terms either all real or all imaginary.
Element element(const Ring& ring, const Rational& number, const Exponents& outer,
                std::vector<PlainTerm> numerator, const Substitutes& substitutes) {
    PlainTerm common = take_powers(numerator);
    for (std::size_t i = 0; i < outer.size(); ++i) common.exponents[i] += outer[i];
    Element result;
    result.order = common.exponents;
    result.term = monomial_term(ring, common.exponents, common.coefficient * number, substitutes);
    if (numerator.size() == 1) return result;
    DisplaySum sum;
    sum.terms.reserve(numerator.size());
    for (const PlainTerm& term : numerator)
        sum.terms.push_back(monomial_term(ring, term.exponents, term.coefficient, substitutes));
    insert_sum(result.term.factors, std::move(sum));
    return result;
}

// The same of a part that is real or imaginary.
Element element(const Ring& ring, const Monomial& outer, Polynomial part, const Substitutes& substitutes) {
    const Fraction f = cancelled(ring, outer, std::move(part));
    Element result = element(ring, content(f.numerator), ring.exponents(f.factor),
                             ordered_terms(ring, primitive_terms(f.numerator)), substitutes);
    for (const Polynomial& divisor : f.divisors) divide_by(result.term, display_radicand(ring, divisor));
    return result;
}

// Real and imaginary part.
std::array<Polynomial, 2> parts_of(const Ring& ring, const Polynomial& p) {
    std::array<Fractions, 2> parts;
    const Fractions& f = p.fractions();
    for (std::size_t k = 0; k < f.size(); ++k)
        parts[ring.exponent(f.monomials[k], Ring::imaginary_unit) != 0 ? 1 : 0].append(f.monomials[k], f, k);
    return {Polynomial::from_fractions(std::move(parts[0])), Polynomial::from_fractions(std::move(parts[1]))};
}

} // namespace

DisplaySum display(const Ring& ring, const Polynomial& p, const Substitutes& substitutes) {
    std::vector<Element> elements;
    for (const auto& [outer, numerator] : ring.expanded_form(p)) {
        for (const Polynomial& part : parts_of(ring, numerator)) {
            if (part.empty()) continue;
            if (ring.digits() == 0) {
                elements.push_back(element(ring, outer, part, substitutes));
                continue;
            }
            for (const PlainTerm& term : ordered_terms(ring, part.terms())) // rounded: no common factors
                elements.push_back(element(ring, term.coefficient, ring.exponents(outer),
                                           {{term.exponents, 1}}, substitutes));
        }
    }
    std::sort(elements.begin(), elements.end(), [](const Element& a, const Element& b) {
        const bool imaginary_a = a.term.imaginary, imaginary_b = b.term.imaginary;
        return imaginary_a != imaginary_b ? imaginary_b : a.order > b.order;
    });
    DisplaySum sum;
    sum.terms.reserve(elements.size()); // or all are copied where it grows: numbers have no move
    for (Element& e : elements) sum.terms.push_back(std::move(e.term));
    return sum;
}

std::vector<std::pair<Monomial, Polynomial>> collect_in_order(const Ring& ring, const Polynomial& p,
                                                              const std::vector<GeneratorId>& outer) {
    auto collected = ring.collect(p, outer);
    std::vector<std::pair<Exponents, std::size_t>> keys;
    for (const auto& [monomial, coefficient] : collected) {
        Exponents exponents{ring.weight(monomial)};
        for (GeneratorId id : outer) exponents.push_back(ring.exponent(monomial, id));
        keys.emplace_back(std::move(exponents), keys.size());
    }
    std::sort(keys.begin(), keys.end()); // the exponents differ
    std::vector<std::pair<Monomial, Polynomial>> result;
    result.reserve(collected.size());
    for (const auto& [exponents, k] : keys) result.push_back(std::move(collected[k]));
    return result;
}

namespace {

// exp(u)^k as exp(k*u).
DisplayFactor with_power_inside(DisplayFactor factor) {
    if (factor.kind != DisplayFactor::Kind::function || factor.name != "exp") return factor;
    for (DisplayTerm& term : factor.arguments.front().terms)
        term.coefficient = term.coefficient * factor.exponent;
    factor.exponent = 1;
    return factor;
}

} // namespace

DisplaySum display_collected(const Ring& ring, const Polynomial& p, const std::vector<GeneratorId>& outer,
                             const Substitutes& substitutes) {
    DisplaySum sum;
    const auto collected = collect_in_order(ring, p, outer);
    sum.terms.reserve(collected.size());
    for (const auto& [monomial, coefficient] : collected) {
        DisplayTerm term = factored(display(ring, coefficient, substitutes));
        for (DisplayFactor& factor : monomial_term(ring, ring.exponents(monomial), 1, substitutes).factors)
            term.tail.push_back(with_power_inside(std::move(factor)));
        sum.terms.push_back(std::move(term));
    }
    return sum;
}

} // namespace resonform
