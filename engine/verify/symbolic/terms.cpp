// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/symbolic/terms.hpp"

#include "algebra/number/number.hpp"

#include <algorithm>
#include <cstdlib>

namespace resonform {

namespace {

using Powers = std::vector<std::pair<GeneratorId, int>>;

// By its digits: not as emitted code forms its constants.
Wide wide_of(const Rational& value) {
    return Wide(to_string(Rational(cln::numerator(value)))) /
           Wide(to_string(Rational(cln::denominator(value))));
}

template <class Number>
const Number& nth_power(std::vector<Number>& known, const Number& base, int exponent) {
    if (known.empty()) known.push_back(base);
    while (known.size() < static_cast<std::size_t>(exponent)) known.push_back(known.back() * base);
    return known[static_cast<std::size_t>(exponent - 1)];
}

template <class Number> ComplexNumber<Number> inverse(const ComplexNumber<Number>& z) {
    if (z.im == 0) return {1 / z.re, 0};
    const Number square = z.re * z.re + z.im * z.im;
    return {z.re / square, -z.im / square};
}

template <class Number>
ComplexNumber<Number> times(ComplexNumber<Number> product, const Powers& powers,
                            const SymbolicValues<Number>& values) {
    for (const auto& [id, exponent] : powers) {
        const ComplexNumber<Number>& factor = values.power(id, exponent);
        product = factor.im == 0 ? factor.re * product : product * factor;
    }
    return product;
}

template <class Number>
Number scaled(Number product, const Powers& powers, const SymbolicValues<Number>& values) {
    for (const auto& [id, exponent] : powers) product *= values.scale_power(id, exponent);
    return product;
}

} // namespace

FixedRing::FixedRing(RingPtr ring, const std::map<std::string, Rational>& fix)
    : ring_(std::move(ring)), fixed_(static_cast<std::size_t>(ring_->size())), outside_(fixed_.size(), true) {
    for (GeneratorId id = 0; id < ring_->size(); ++id) {
        const Generator& g = ring_->generator(id);
        Value& value = fixed_[static_cast<std::size_t>(id)];
        if (g.kind == GeneratorKind::parameter) {
            const auto given = fix.find(g.name);
            if (given != fix.end()) value = {true, given->second};
        }
        if (g.kind != GeneratorKind::root) continue;
        outside_[static_cast<std::size_t>(id)] = false;
        const Terms radicand = folded(g.radicand);
        for (const auto& [exponents, coefficient] : radicand)
            for (std::size_t k = 0; k < exponents.size(); ++k)
                if (exponents[k] != 0) outside_[k] = false;
        if (radicand.size() != 1 || radicand.begin()->first != Exponents(fixed_.size(), 0)) continue;
        Rational root;
        if (radicand.begin()->second > 0 || g.index == 1)
            if (exact_root(radicand.begin()->second, g.index, root)) value = {true, root};
    }
}

FixedRing::Terms FixedRing::folded(const Polynomial& p) const {
    Terms terms;
    for (const Term& t : p.terms()) {
        Exponents exponents = ring_->exponents(t.monomial);
        Rational coefficient = t.coefficient;
        for (std::size_t id = 0; id < exponents.size(); ++id) {
            if (exponents[id] == 0 || !fixed_[id].known) continue;
            coefficient = coefficient * cln::expt(fixed_[id].value, exponents[id]);
            exponents[id] = 0;
        }
        Rational& sum = terms.try_emplace(std::move(exponents), 0).first->second;
        sum = sum + coefficient;
    }
    std::erase_if(terms, [](const auto& term) { return term.second == 0; });
    return terms;
}

SymbolicSum FixedRing::sum_of(const Terms& terms) {
    SymbolicSum sum;
    for (const auto& [exponents, coefficient] : terms) {
        SymbolicTerm term{wide_of(coefficient), {}};
        for (std::size_t id = 0; id < exponents.size(); ++id)
            if (exponents[id] != 0) term.powers.emplace_back(static_cast<GeneratorId>(id), exponents[id]);
        sum.push_back(std::move(term));
    }
    return sum;
}

const std::vector<FixedRing::Terms>& FixedRing::radicand_powers(GeneratorId root, int highest) const {
    std::vector<Terms>& known = powers_[root];
    if (known.empty()) known.push_back({{Exponents(fixed_.size(), 0), 1}});
    const Terms radicand = folded(ring_->generator(root).radicand);
    while (static_cast<int>(known.size()) <= highest) {
        Terms next;
        for (const auto& [a, x] : known.back())
            for (const auto& [b, y] : radicand) {
                Exponents exponents = a;
                for (std::size_t id = 0; id < exponents.size(); ++id) exponents[id] += b[id];
                Rational& sum = next.try_emplace(std::move(exponents), 0).first->second;
                sum = sum + x * y;
            }
        known.push_back(std::move(next));
    }
    return known;
}

// One root written out: terms that differ in generators under roots only, and in this root by powers of its
// radicand, come over one power of it.
FixedRing::Terms FixedRing::without(const Terms& terms, GeneratorId root) const {
    const auto at = static_cast<std::size_t>(root);
    const int k = ring_->generator(root).index;
    const auto class_of = [&](Exponents exponents) {
        const int rest = ((exponents[at] % k) + k) % k;
        for (std::size_t id = 0; id < exponents.size(); ++id)
            if (!outside_[id] && ring_->generator(static_cast<GeneratorId>(id)).kind != GeneratorKind::root)
                exponents[id] = 0;
        exponents[at] = rest;
        return exponents;
    };
    std::map<Exponents, int> lowest;
    for (const auto& term : terms) {
        const Exponents key = class_of(term.first);
        const auto [known, fresh] = lowest.try_emplace(key, key[at]); // at most 0 ... k - 1
        known->second = std::min(known->second, term.first[at]);
    }
    Terms result;
    for (const auto& [exponents, coefficient] : terms) {
        // Negative powers of a divisor are partial fractions already.
        const int low = k == 1 ? std::min(exponents[at], 0) : lowest.at(class_of(exponents));
        const int n = (exponents[at] - low) / k;
        for (const auto& [inner, factor] : radicand_powers(root, n)[static_cast<std::size_t>(n)]) {
            Exponents sum = exponents;
            sum[at] = low;
            for (std::size_t id = 0; id < sum.size(); ++id) sum[id] += inner[id];
            Rational& total = result.try_emplace(std::move(sum), 0).first->second;
            total = total + factor * coefficient;
        }
    }
    std::erase_if(result, [](const auto& term) { return term.second == 0; });
    return result;
}

SymbolicSum FixedRing::written_out(const Polynomial& p) const {
    Terms terms = folded(p);
    for (GeneratorId id = ring_->size() - 1; id >= 0; --id)
        if (ring_->generator(id).kind == GeneratorKind::root && !is_fixed(id)) terms = without(terms, id);
    return sum_of(terms);
}

template <class Number>
const ComplexNumber<Number>& SymbolicValues<Number>::power(GeneratorId id, int exponent) const {
    const Entry& e = at(id);
    if (exponent > 0) return nth_power(e.above, e.value, exponent);
    if (e.below.empty()) e.below.push_back(inverse(e.value));
    return nth_power(e.below, Complex(e.below.front()), -exponent);
}

template <class Number> Number SymbolicValues<Number>::scale_power(GeneratorId id, int exponent) const {
    const Entry& e = at(id);
    if (exponent < 0 && e.scales_below.empty()) e.scales_below.push_back(1 / e.value.size());
    const Number& power = exponent > 0 ? nth_power(e.scales_above, e.scale, exponent)
                                       : nth_power(e.scales_below, Number(e.scales_below.front()), -exponent);
    return e.condition > 1 ? Number(power * (1 + std::abs(exponent) * (e.condition - 1))) : power;
}

template <class Number>
ComplexNumber<Number> value_of(const SymbolicSum& sum, const SymbolicValues<Number>& values) {
    ComplexNumber<Number> total;
    for (const SymbolicTerm& term : sum)
        total =
            total + times(ComplexNumber<Number>{narrowed<Number>(term.coefficient), 0}, term.powers, values);
    return total;
}
template WideComplex value_of(const SymbolicSum&, const SymbolicValues<Wide>&);
template ComplexNumber<Float128> value_of(const SymbolicSum&, const SymbolicValues<Float128>&);

template <class Number> Number scale_of(const SymbolicSum& sum, const SymbolicValues<Number>& values) {
    Number total = 0;
    for (const SymbolicTerm& term : sum)
        total += scaled(narrowed<Number>(Wide(abs(term.coefficient))), term.powers, values);
    return total;
}
template Wide scale_of(const SymbolicSum&, const SymbolicValues<Wide>&);
template Float128 scale_of(const SymbolicSum&, const SymbolicValues<Float128>&);

template <class Number> Number sizes_of_terms(const SymbolicSum& sum, const SymbolicValues<Number>& values) {
    Number total = 0;
    for (const SymbolicTerm& term : sum)
        total +=
            times(ComplexNumber<Number>{narrowed<Number>(term.coefficient), 0}, term.powers, values).size();
    return total;
}
template Wide sizes_of_terms(const SymbolicSum&, const SymbolicValues<Wide>&);
template Float128 sizes_of_terms(const SymbolicSum&, const SymbolicValues<Float128>&);

template <class Number>
MovingSum<Number>::MovingSum(const SymbolicSum& sum, const SymbolicValues<Wide>& constants,
                             const std::vector<bool>& moves) {
    struct Sum {
        WideComplex value;
        Wide scale = 0;
    };
    std::map<Powers, Sum> sums;
    for (const SymbolicTerm& term : sum) {
        Powers fixed, moving;
        for (const auto& power : term.powers)
            (moves[static_cast<std::size_t>(power.first)] ? moving : fixed).push_back(power);
        Sum& into = sums[moving];
        into.value = into.value + times(WideComplex{term.coefficient, 0}, fixed, constants);
        into.scale += scaled(Wide(abs(term.coefficient)), fixed, constants);
    }
    for (const auto& [powers, total] : sums)
        terms_.push_back({{narrowed<Number>(total.value.re), narrowed<Number>(total.value.im)},
                          narrowed<Number>(total.scale),
                          powers});
}

template <class Number>
ComplexNumber<Number> MovingSum<Number>::value(const Term& term, const SymbolicValues<Number>& values) {
    return times(term.coefficient, term.powers, values);
}

template <class Number>
ComplexNumber<Number> MovingSum<Number>::value(const SymbolicValues<Number>& values) const {
    Complex total;
    for (const Term& term : terms_) total = total + value(term, values);
    return total;
}

template <class Number> Number MovingSum<Number>::scale(const SymbolicValues<Number>& values) const {
    Number total = 0;
    for (const Term& term : terms_) total += scaled(term.scale, term.powers, values);
    return total;
}

template class SymbolicValues<Wide>;
template class SymbolicValues<Float128>;
template class MovingSum<Wide>;
template class MovingSum<Float128>;

} // namespace resonform
