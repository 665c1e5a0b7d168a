// SPDX-License-Identifier: MIT
// A number of twice the precision of Real as an unevaluated sum high + low, |low| <= ulp(high)/2, with
// the error-free sum of Knuth and product of Dekker (T. J. Dekker, Numer. Math. 18, 1971). Correct for
// binary types that round to nearest; not under -ffast-math.
//
// It serves where doubling is cheap and single precision is not enough: phases of many turns.
#ifndef RESONFORM_RUNTIME_TWICE
#define RESONFORM_RUNTIME_TWICE

#include "runtime/math.hpp"

#include <limits>
#include <type_traits>

namespace resonform {

template <class Real> struct Twice {
    Real high{}, low{};

    Twice() = default;
    Twice(Real h, Real l) : high(h), low(l) {}
    explicit Twice(const Real& x) : high(x), low(Real(0)) {}
    template <class Number>
    requires(std::is_arithmetic_v<Number> && !std::is_same_v<Number, Real>) explicit Twice(Number x)
        : high(static_cast<Real>(x)), low(Real(0)) {} // exact up to 2^53
    explicit operator Real() const { return high + low; }

    // a + b with |a| >= |b|. Brackets are Real(...): expression templates take others away.
    static Twice sorted_sum(Real a, Real b) {
        const Real s = a + b;
        return {s, b - Real(s - a)};
    }
    static Twice sum(Real a, Real b) {
        const Real s = a + b, part = s - a;
        return {s, Real(a - Real(s - part)) + Real(b - part)};
    }
    static Twice product(Real a, Real b) {
        const Real p = rounded_product(a, b);
#ifdef FP_FAST_FMA
        if constexpr (std::is_same_v<Real, double>) return {p, std::fma(a, b, -p)};
#endif
        const auto [a1, a0] = split(a);
        const auto [b1, b0] = split(b);
        return {p, ((a1 * b1 - p) + a1 * b0 + a0 * b1) + a0 * b0};
    }
    // a b + c, where the low parts of the sum need not be exact: for |a b| not far above |c|.
    static Twice multiply_add(const Twice& a, const Twice& b, const Twice& c) {
        const Twice p = product(a.high, b.high), s = sum(p.high, c.high);
        return sorted_sum(s.high, s.low + ((p.low + (a.high * b.low + a.low * b.high)) + c.low));
    }

    friend Twice operator-(const Twice& a) { return {-a.high, -a.low}; }
    friend Twice operator+(const Twice& a, const Twice& b) {
        const Twice s = sum(a.high, b.high), t = sum(a.low, b.low);
        const Twice u = sorted_sum(s.high, s.low + t.high);
        return sorted_sum(u.high, u.low + t.low);
    }
    friend Twice operator-(const Twice& a, const Twice& b) { return a + (-b); }
    friend Twice operator*(const Twice& a, const Twice& b) {
        const Twice p = product(a.high, b.high);
        return sorted_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
    }
    friend Twice operator/(const Twice& a, const Twice& b) {
        const Real q1 = a.high / b.high;
        const Twice r1 = a - b * Twice(q1);
        const Real q2 = r1.high / b.high;
        const Twice r2 = r1 - b * Twice(q2);
        return sorted_sum(q1, q2) + Twice(r2.high / b.high);
    }
    // By a number that is exact in Real: a third of a division.
    friend Twice divided(const Twice& a, const Real& b) {
        const Real q = a.high / b;
        const Twice p = product(q, b);
        return sorted_sum(q, (((a.high - p.high) - p.low) + a.low) / b);
    }
    // A product would have to be split into halves, beyond the range.
    friend Twice scaled_by(const Twice& a, double power_of_two) {
        return {a.high * Real(power_of_two), a.low * Real(power_of_two)};
    }
    friend bool operator==(const Twice& a, const Twice& b) { return a.high == b.high && a.low == b.low; }
    friend bool operator<(const Twice& a, const Twice& b) {
        return a.high < b.high || (a.high == b.high && a.low < b.low);
    }
    friend bool operator>(const Twice& a, const Twice& b) { return b < a; }

private:
    // A compiler may fuse a product with the sum that follows, and then its error is another one.
    static Real rounded_product(Real a, Real b) {
        Real p = a * b;
#if defined(__FMA__) && defined(__GNUC__)
        if constexpr (std::is_same_v<Real, double>) __asm__("" : "+x"(p));
#endif
        return p;
    }
    struct Halves {
        Real upper, lower;
    };
    static Halves split(Real a) {
        constexpr int half = (math::digits<Real> + 1) / 2;
        const Real factor = math::power(Real(2), half) + Real(1);
        const Real scaled = factor * a;
        const Real upper = scaled - Real(scaled - a);
        return {upper, a - upper};
    }
};

namespace math {
template <class Real> inline constexpr int digits<Twice<Real>> = 2 * digits<Real>;
} // namespace math

// Sums and products leave an error that is a number of Real, so that Twice has all its digits. The decimal
// types of Boost have some to spare instead.
template <class Real>
inline constexpr bool rounds_to_nearest =
    std::numeric_limits<Real>::radix == 2 && std::numeric_limits<Real>::round_style == std::round_to_nearest;

// The number for phases and times that must not be rounded to Real.
template <class Real> struct WideNumberOf {
    using type = std::conditional_t<rounds_to_nearest<Real>, Twice<Real>, Real>;
};
#ifdef RESONFORM_FLOAT128
template <> struct WideNumberOf<Float128> { using type = Twice<Float128>; };
#endif
template <class Real> using WideNumber = typename WideNumberOf<Real>::type;

// That for phases of few turns: a type of the processor with some more digits, if there is one.
template <class Real>
using QuickNumber =
    std::conditional_t<std::is_same_v<math::Fine<Real>, Real>, WideNumber<Real>, math::Fine<Real>>;

// Elementary functions: a result of Real, corrected by Newton's method in twice the precision.

template <class Real> Twice<Real> sqrt(const Twice<Real>& x) {
    using math::sqrt;
    if (!(x.high > Real(0))) return Twice<Real>(sqrt(x.high));
    const Twice<Real> guess(sqrt(x.high));
    return (guess + x / guess) * Twice<Real>(Real(1) / Real(2));
}

// Only as the first guess of math::root.
template <class Real> Twice<Real> pow(const Twice<Real>& x, const Twice<Real>& y) {
    using math::pow;
    return Twice<Real>(pow(x.high, y.high));
}

// exp(x) - 1 = (1 + s)^(2^m) - 1 of x >= 0, s = exp(x/2^m) - 1 by its series.
template <class Real> Twice<Real> exp_less_one(const Twice<Real>& x) {
    int halvings = 3;
    for (Real size = x.high; size > Real(1); size = size / Real(2)) ++halvings;
    const Twice<Real> small = divided(x, math::power(Real(2), halvings));
    Twice<Real> less_one(Real(0)), term(Real(1)); // keeps its leading digits
    for (int n = 1; n <= math::digits<Real> / 3 + 6; ++n) {
        term = divided(term * small, Real(n));
        less_one = less_one + term;
    }
    for (int i = 0; i < halvings; ++i) less_one = less_one * (less_one + Twice<Real>(2));
    return less_one;
}

// Products of e^|x| in twice the precision stay in range.
template <class Real> bool has_moderate_exponential(const Real& x) {
    using math::exp;
    return math::finite(x) &&
           math::finite(Real(exp(math::magnitude(x)) * math::power(Real(2), math::digits<Real>)));
}

template <class Real> Twice<Real> exp(const Twice<Real>& x) {
    using math::exp;
    if (!has_moderate_exponential(x.high)) return Twice<Real>(exp(x.high));
    if (x.high < Real(0)) return Twice<Real>(1) / exp(-x);
    return exp_less_one(x) + Twice<Real>(1);
}

template <class Real> Twice<Real> expm1(const Twice<Real>& x) {
    using math::expm1;
    if (!has_moderate_exponential(x.high)) return Twice<Real>(expm1(x.high));
    if (!(x.high < Real(0))) return exp_less_one(x);
    const Twice<Real> up = exp_less_one(-x);
    return -up / (up + Twice<Real>(1));
}

template <class Real> Twice<Real> log(const Twice<Real>& x) {
    using math::log;
    const Twice<Real> guess(log(x.high));
    if (!math::finite(guess.high)) return guess;
    return guess + (x * exp(-guess) - Twice<Real>(1));
}

// log(1 + x), by one Newton step from a guess g: its error is (1 + x) e^-g - 1 = x + (1 + x) (e^-g - 1).
template <class Real> Twice<Real> log1p(const Twice<Real>& x) {
    using math::log1p;
    const Twice<Real> guess(log1p(x.high));
    if (!math::finite(guess.high)) return guess;
    return guess + (x + (x + Twice<Real>(1)) * expm1(-guess));
}

template <class Real> Twice<Real> asinh(const Twice<Real>& x) {
    const Twice<Real> size = math::magnitude(x);
    const Twice<Real> result = log(size + sqrt(size * size + Twice<Real>(1)));
    return x < Twice<Real>(0) ? -result : result;
}

// By its series where exp(x) - exp(-x) would lose digits.
template <class Real> Twice<Real> sinh(const Twice<Real>& x) {
    using Number = Twice<Real>;
    if (math::magnitude(x.high) > Real(1)) {
        const Number e = exp(math::magnitude(x)), result = (e - Number(1) / e) * Number(Real(1) / Real(2));
        return x < Number(0) ? -result : result;
    }
    Number term = x, sum = x;
    for (int n = 2; n <= math::digits<Real> / 2 + 10; n += 2) {
        term = divided(term * x * x, Real(n * (n + 1)));
        sum = sum + term;
    }
    return sum;
}

template <class Real> Twice<Real> hypot(const Twice<Real>& x, const Twice<Real>& y) {
    return sqrt(x * x + y * y);
}

// {sin x, cos x} by series at x/2^m and m doublings that keep cos - 1; meant for |x| of a few turns.
template <class Real> std::array<Twice<Real>, 2> sine_and_cosine(const Twice<Real>& x) {
    using Number = Twice<Real>;
    int halvings = 6;
    for (Real size = math::magnitude(x.high); size > Real(1); size = size / Real(2)) ++halvings;
    const Number small = divided(x, math::power(Real(2), halvings));
    Number term = small, sine = small, cosine_less_one(Real(0));
    for (int n = 2; n <= math::digits<Real> / 3 + 4; n += 2) {
        term = -divided(term * small, Real(n));
        cosine_less_one = cosine_less_one + term;
        term = divided(term * small, Real(n + 1));
        sine = sine + term;
    }
    for (int i = 0; i < halvings; ++i) {
        sine = scaled_by(sine * (Number(1) + cosine_less_one), 2);
        cosine_less_one = scaled_by(cosine_less_one * (Number(2) + cosine_less_one), 2);
    }
    return {sine, Number(1) + cosine_less_one};
}

template <class Real> Twice<Real> sin(const Twice<Real>& x) { return sine_and_cosine(x)[0]; }
template <class Real> Twice<Real> cos(const Twice<Real>& x) { return sine_and_cosine(x)[1]; }

// One Newton step for the angle whose direction is (x, y).
template <class Real> Twice<Real> atan2(const Twice<Real>& y, const Twice<Real>& x) {
    using math::atan2;
    const Twice<Real> guess(atan2(y.high, x.high));
    const Twice<Real> radius = hypot(x, y);
    if (!(radius > Twice<Real>(0)) || !math::finite(radius.high)) return guess;
    const auto [sine, cosine] = sine_and_cosine(guess);
    return guess + (y * cosine - x * sine) / radius;
}

} // namespace resonform

#endif
