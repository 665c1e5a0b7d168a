// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/interval_functions.hpp"

#include <utility>

namespace resonform {
namespace {

constexpr int largest_argument = 4096;
constexpr int guard_bits = 40; // what twelve doublings of an angle, or squarings, may cost

// The ends are moved outwards to multiples of 2^-bits, which keeps numbers short.
Interval rounded(const Interval& a, int bits) {
    const Rational scale = cln::expt(Rational(2), Integer(bits));
    return {Rational(cln::floor1(a.low * scale)) / scale, Rational(cln::ceiling1(a.high * scale)) / scale};
}

Interval scaled(const Rational& c, const Interval& a) { return Interval(c) * a; }
Interval middle(const Interval& a) { return Interval(Rational((a.low + a.high) / 2)); }

// sum_k c_k x^k for |x| <= 1/2 and |c_k| <= 1: the rest from k on is at most 2 |x|^k.
template <class Coefficient> Interval taylor(const Interval& x, int bits, const Coefficient& c) {
    Interval total{Rational(0)}, power{Rational(1)};
    for (int k = 0; k <= bits; ++k) {
        total = rounded(total + scaled(c(k), power), bits + 16);
        power = rounded(power * x, bits + 8);
    }
    const Rational rest = cln::expt(Rational(2), Integer(-bits));
    return rounded({total.low - rest, total.high + rest}, bits);
}

// x/2^n with |x/2^n| <= 1/2, and n.
std::pair<Interval, int> halved(const Interval& x) {
    Rational factor = 1;
    int n = 0;
    const auto size = [&] {
        const Rational low = cln::abs(x.low), high = cln::abs(x.high);
        return low > high ? low : high;
    }();
    for (; size * factor > Rational(1) / 2; ++n) factor = factor / 2;
    return {scaled(factor, x), n};
}

Interval exponential(const Interval& u, int bits) {
    const auto [x, n] = halved(u);
    Rational factorial = 1;
    Interval result = taylor(x, bits, [&](int k) {
        if (k > 0) factorial = factorial * k;
        return Rational(1) / factorial;
    });
    for (int k = 0; k < n; ++k) result = rounded(result * result, bits);
    return result;
}

// The sine and the cosine of a number, as intervals.
std::pair<Interval, Interval> circle(const Interval& u, int bits) {
    const auto [x, n] = halved(u);
    const auto sum = [bits](const Interval& small, int first) { // of the terms k = first, first + 2, ...
        Rational factorial = 1;
        return taylor(small, bits, [&](int k) {
            if (k > 0) factorial = factorial * k;
            if (k % 2 != first) return Rational(0);
            return Rational(k % 4 >= 2 ? -1 : 1) / factorial;
        });
    };
    Interval sine = sum(x, 1), cosine = sum(x, 0);
    for (int k = 0; k < n; ++k) {
        const Interval doubled = rounded(scaled(2, sine * cosine), bits);
        cosine = rounded(Interval(Rational(1)) + scaled(-2, sine * sine), bits);
        sine = doubled;
    }
    return {sine, cosine};
}

// A function whose slope is at most 1 in size, from its value at the middle.
Interval widened(const Interval& at_middle, const Interval& u) {
    const Rational half = (u.high - u.low) / 2;
    return {at_middle.low - half, at_middle.high + half};
}

// atan x = 2 atan(x/(1 + sqrt(1 + x^2))), three times: then |x| < 1/4.
Interval arc_tangent(Interval x, int bits) {
    const Interval one{Rational(1)};
    for (int k = 0; k < 3; ++k) {
        const Interval square = x * x;
        const Interval above{cln::minusp(square.low) ? Rational(0) : square.low, square.high};
        x = rounded(x * reciprocal(one + root(one + above, 2, bits)), bits);
    }
    return scaled(8, taylor(x, bits, [](int k) {
                      return k % 2 == 0 ? Rational(0) : Rational(k % 4 == 1 ? 1 : -1) / k;
                  }));
}

// log x = 2 atanh((x - 1)/(x + 1)) for 1 <= x <= 2, else with multiples of log 2.
Interval atanh_twice(const Interval& z, int bits) {
    return scaled(2, taylor(z, bits, [](int k) { return k % 2 == 0 ? Rational(0) : Rational(1) / k; }));
}

Interval logarithm(const Rational& x, int bits) {
    Rational m = x;
    int twos = 0;
    for (; m > 2; ++twos) m = m / 2;
    for (; m < 1; --twos) m = m * 2;
    const Interval two = atanh_twice(Interval(Rational(1) / 3), bits);
    return atanh_twice(Interval(Rational((m - 1) / (m + 1))), bits) + scaled(twos, two);
}

} // namespace

std::optional<Interval> function(Function f, const Interval& u, int wanted) {
    const int bits = wanted + guard_bits;
    if (u.low < -largest_argument || u.high > largest_argument) return std::nullopt;
    const Interval x = rounded(u, bits);
    switch (f) {
    case Function::exponential: {
        const Interval low = exponential(Interval(x.low), bits), high = exponential(Interval(x.high), bits);
        return Interval(low.low, high.high);
    }
    case Function::sine: return widened(circle(middle(x), bits).first, x);
    case Function::cosine: return widened(circle(middle(x), bits).second, x);
    case Function::logarithm:
        if (!x.positive()) return std::nullopt;
        return Interval(logarithm(x.low, bits).low, logarithm(x.high, bits).high);
    case Function::arc_tangent: return widened(arc_tangent(middle(x), bits), x);
    case Function::named: break;
    }
    return std::nullopt;
}

} // namespace resonform
