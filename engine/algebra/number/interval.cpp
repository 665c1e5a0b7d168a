// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/interval.hpp"

namespace resonform {
namespace {

// The largest integer whose k-th power is at most n >= 0 (k >= 2), by Newton's iteration from above.
Integer integer_root(const Integer& n, int k) {
    if (cln::zerop(n)) return 0;
    const auto length = static_cast<long>(cln::integer_length(n));
    Integer x = cln::ash(Integer(1), Integer(length / k + 1)); // x^k > n
    while (true) {
        const Integer quotient = cln::floor1(n, cln::expt_pos(x, Integer(k - 1)));
        const Integer next = cln::floor1(Integer(k - 1) * x + quotient, Integer(k));
        if (next >= x) return x;
        x = next;
    }
}

} // namespace

Interval operator+(const Interval& a, const Interval& b) { return {a.low + b.low, a.high + b.high}; }

Interval operator*(const Interval& a, const Interval& b) {
    const Rational ends[] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
    Interval hull(ends[0]);
    for (const Rational& end : ends) {
        if (end < hull.low) hull.low = end;
        if (end > hull.high) hull.high = end;
    }
    return hull;
}

Interval reciprocal(const Interval& a) { return {cln::recip(a.high), cln::recip(a.low)}; }

Interval power(const Interval& a, int exponent) {
    if (exponent < 0) return power(reciprocal(a), -exponent);
    Interval result{Rational(1)};
    for (int n = 0; n < exponent; ++n) result = result * a;
    return result;
}

Interval root(const Interval& a, int k, int bits) {
    if (k == 1) return a;
    const Rational scale = cln::expt(Rational(2), Integer(static_cast<long>(k) * bits));
    const Rational unit = cln::expt(Rational(2), Integer(-bits));
    const Integer low = integer_root(cln::floor1(a.low * scale), k);
    const Integer high = integer_root(cln::floor1(a.high * scale), k) + 1;
    return {low * unit, high * unit};
}

} // namespace resonform
