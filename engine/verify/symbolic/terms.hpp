// SPDX-License-Identifier: GPL-3.0-or-later
// Exact polynomials of a ring as sums that are computed term by term, in 50 digits:
//
//   sum_k c_k prod_j x_j^(e_kj)      and beside it its scale      sum_k |c_k| prod_j |x_j|^(e_kj)
//
// Nothing is factored, shared or reordered: emitted code is compared with this.
#pragma once

#include "algebra/ring/ring.hpp"
#include "runtime/math.hpp"
#include "verify/run/real.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

using Wide = boost::multiprecision::cpp_bin_float_50;

// Boost's own works bit by bit, and costs as much as twenty multiplications.
template <class Number> Number square_root(const Number& x) {
    using math::sqrt;
    return sqrt(x);
}
template <> inline Wide square_root(const Wide& x) {
    if (!(x > 0) || !isfinite(x)) return sqrt(x);
    int exponent = 0;
    Wide fraction = frexp(x, &exponent);
    if (exponent % 2 != 0) {
        fraction *= 2;
        --exponent;
    }
    Wide root = std::sqrt(static_cast<double>(fraction));
    for (int digits = 16; digits < 50; digits *= 2) root = (root + fraction / root) / 2;
    return ldexp(root, exponent / 2);
}

template <class Number> struct ComplexNumber {
    Number re = 0, im = 0;

    friend ComplexNumber operator+(const ComplexNumber& a, const ComplexNumber& b) {
        return {a.re + b.re, a.im + b.im};
    }
    friend ComplexNumber operator-(const ComplexNumber& a, const ComplexNumber& b) {
        return {a.re - b.re, a.im - b.im};
    }
    friend ComplexNumber operator*(const ComplexNumber& a, const ComplexNumber& b) {
        return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
    }
    friend ComplexNumber operator*(const Number& a, const ComplexNumber& b) { return {a * b.re, a * b.im}; }
    [[nodiscard]] ComplexNumber conjugate() const { return {re, -im}; }
    [[nodiscard]] Number size() const {
        return im == 0 ? math::magnitude(re) : square_root(Number(re * re + im * im));
    }
};
using WideComplex = ComplexNumber<Wide>;

// e^{i angle}
template <class Number> ComplexNumber<Number> unit(const Number& angle) {
    using math::cos;
    using math::sin;
    return {cos(angle), sin(angle)};
}

// 0 for a number that is 1 up to rounding, so that logarithms vanishing at the start are exactly 0.
template <class Number> Number logarithm(const Number& x) {
    using math::log;
    const Number off = math::magnitude(Number(x - Number(1)));
    return off < Number(16) * math::epsilon<Number>() ? Number(0) : Number(log(x));
}

// From one type to another, beyond the range of double as well.
template <class To> To narrowed(const Wide& x);
template <> inline Wide narrowed(const Wide& x) { return x; }
template <> inline Float128 narrowed(const Wide& x) {
    int exponent = 0;
    const Wide fraction = frexp(x, &exponent);
    return ldexpq(convert<Float128>(fraction), exponent);
}
// No overloads: under clang, boost cannot be asked whether a Float128 converts to a Wide.
template <class From> Wide widened(const From& x);
template <> inline Wide widened(const Wide& x) { return x; }
template <> inline Wide widened(const Float128& x) {
    int exponent = 0;
    const Float128 fraction = frexpq(x, &exponent);
    return ldexp(convert<Wide>(fraction), exponent);
}

struct SymbolicTerm {
    Wide coefficient;
    std::vector<std::pair<GeneratorId, int>> powers;
};
using SymbolicSum = std::vector<SymbolicTerm>;

// A ring with numbers put in for some of its generators: parameters that are fixed, and roots that become
// rational by it.
class FixedRing {
public:
    FixedRing(RingPtr ring, const std::map<std::string, Rational>& fix);

    [[nodiscard]] const Ring& ring() const { return *ring_; }
    [[nodiscard]] bool is_fixed(GeneratorId id) const { return fixed_[static_cast<std::size_t>(id)].known; }
    // Terms as the ring holds them, equal ones added exactly.
    [[nodiscard]] SymbolicSum operator()(const Polynomial& p) const { return sum_of(folded(p)); }
    // The expanded form: radicands of roots stand written out in the numerators (sigma^4 as xi^2 + r^2), over
    // the lowest power of each root that is needed beside one monomial of all other generators; of divisors
    // (roots of index 1) negative powers stay as they are.
    [[nodiscard]] SymbolicSum written_out(const Polynomial& p) const;

private:
    using Exponents = std::vector<int>;
    using Terms = std::map<Exponents, Rational>;
    struct Value {
        bool known = false;
        Rational value = 0;
    };

    [[nodiscard]] Terms folded(const Polynomial& p) const;
    [[nodiscard]] static SymbolicSum sum_of(const Terms& terms);
    [[nodiscard]] Terms without(const Terms& terms, GeneratorId root) const;
    [[nodiscard]] const std::vector<Terms>& radicand_powers(GeneratorId root, int highest) const;

    RingPtr ring_;
    std::vector<Value> fixed_;
    std::vector<bool> outside_; // neither a root nor under one
    mutable std::map<GeneratorId, std::vector<Terms>> powers_;
};

// The generators of a ring as numbers at one moment, with their powers. Number: Wide, Float128.
template <class Number> class SymbolicValues {
public:
    using Complex = ComplexNumber<Number>;
    explicit SymbolicValues(int generators) : entries_(static_cast<std::size_t>(generators)) {}
    template <class Other>
    explicit SymbolicValues(const SymbolicValues<Other>& other) { // of constants: conditions are 1
        for (std::size_t k = 0; k < other.size(); ++k) {
            const auto id = static_cast<GeneratorId>(k);
            entries_.push_back({{narrowed<Number>(other[id].re), narrowed<Number>(other[id].im)},
                                narrowed<Number>(other.scale(id)),
                                {},
                                {},
                                {},
                                {}});
        }
    }

    // scale: the size used in scales, |value| by default.
    void set(GeneratorId id, const Complex& value, const Number& scale) {
        entries_[static_cast<std::size_t>(id)] = {value, scale, {}, {}, {}, {}};
    }
    void set(GeneratorId id, const Number& value) { set(id, {value, 0}, math::magnitude(value)); }
    // A unit in the last place of what the generator is computed from changes it by so many of its own, >= 1.
    void set_condition(GeneratorId id, const Number& condition) {
        entries_[static_cast<std::size_t>(id)].condition = condition;
    }
    [[nodiscard]] std::size_t size() const { return entries_.size(); }
    [[nodiscard]] const Complex& operator[](GeneratorId id) const { return at(id).value; }
    [[nodiscard]] const Number& scale(GeneratorId id) const { return at(id).scale; }
    [[nodiscard]] const Complex& power(GeneratorId id, int exponent) const;
    // In a denominator the value itself is used. Times what its condition makes of the power.
    [[nodiscard]] Number scale_power(GeneratorId id, int exponent) const;

private:
    struct Entry {
        Complex value;
        Number scale = 0;
        mutable std::vector<Complex> above, below; // powers 1, 2, ... and -1, -2, ...
        mutable std::vector<Number> scales_above, scales_below;
        Number condition = 1;
    };
    [[nodiscard]] const Entry& at(GeneratorId id) const { return entries_[static_cast<std::size_t>(id)]; }
    std::vector<Entry> entries_;
};

template <class Number>
ComplexNumber<Number> value_of(const SymbolicSum& sum, const SymbolicValues<Number>& values);
template <class Number> Number scale_of(const SymbolicSum& sum, const SymbolicValues<Number>& values);
// The same of the values of the generators, whatever their scales.
template <class Number> Number sizes_of_terms(const SymbolicSum& sum, const SymbolicValues<Number>& values);

// A sum with the values of constants put in: terms that differ only by constants are merged.
template <class Number> class MovingSum {
public:
    using Complex = ComplexNumber<Number>;
    MovingSum() = default;
    MovingSum(const SymbolicSum& sum, const SymbolicValues<Wide>& constants, const std::vector<bool>& moves);

    struct Term {
        Complex coefficient;
        Number scale; // sum of |terms| that were put together
        std::vector<std::pair<GeneratorId, int>> powers;
    };
    [[nodiscard]] const std::vector<Term>& terms() const { return terms_; }
    [[nodiscard]] static Complex value(const Term& term, const SymbolicValues<Number>& values);
    [[nodiscard]] Complex value(const SymbolicValues<Number>& values) const;
    [[nodiscard]] Number scale(const SymbolicValues<Number>& values) const;

private:
    std::vector<Term> terms_;
};

} // namespace resonform
