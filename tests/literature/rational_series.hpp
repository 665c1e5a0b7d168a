// SPDX-License-Identifier: GPL-3.0-or-later
// Power series with rational coefficients, for expectations that are computed another way.
#pragma once

#include "algebra/number/number.hpp"

#include <vector>

namespace resonform::test {

class RationalSeries {
public:
    explicit RationalSeries(int through, const Rational& constant = 0)
        : c_(static_cast<std::size_t>(through) + 1, 0) {
        c_[0] = constant;
    }
    static RationalSeries variable(int through) {
        RationalSeries s(through);
        s.c_[1] = 1;
        return s;
    }

    Rational& operator[](int k) { return c_[static_cast<std::size_t>(k)]; }
    const Rational& operator[](int k) const { return c_[static_cast<std::size_t>(k)]; }
    [[nodiscard]] int through() const { return static_cast<int>(c_.size()) - 1; }

    friend RationalSeries operator+(RationalSeries a, const RationalSeries& b) {
        for (int k = 0; k <= a.through(); ++k) a[k] = a[k] + b[k];
        return a;
    }
    friend RationalSeries operator-(RationalSeries a, const RationalSeries& b) {
        for (int k = 0; k <= a.through(); ++k) a[k] = a[k] - b[k];
        return a;
    }
    friend RationalSeries operator*(const RationalSeries& a, const RationalSeries& b) {
        RationalSeries c(a.through());
        for (int i = 0; i <= a.through(); ++i)
            for (int j = 0; i + j <= a.through(); ++j) c[i + j] = c[i + j] + a[i] * b[j];
        return c;
    }
    friend bool operator==(const RationalSeries& a, const RationalSeries& b) { return a.c_ == b.c_; }

    // s^e for s_0 = 1: e n s' p = n p' s, coefficient by coefficient.
    [[nodiscard]] RationalSeries power(const Rational& e) const {
        RationalSeries p(through(), 1);
        for (int n = 1; n <= through(); ++n)
            for (int j = 1; j <= n; ++j)
                p[n] = p[n] + (e * Rational(j) - Rational(n - j)) / Rational(n) * (*this)[j] * p[n - j];
        return p;
    }
    // sum_k coefficients[k] s^k for s_0 = 0.
    [[nodiscard]] static RationalSeries composed(const RationalSeries& coefficients,
                                                 const RationalSeries& s) {
        RationalSeries result(s.through()), power(s.through(), 1);
        for (int k = 0; k <= s.through(); ++k) {
            for (int n = 0; n <= s.through(); ++n) result[n] = result[n] + coefficients[k] * power[n];
            power = power * s;
        }
        return result;
    }

private:
    std::vector<Rational> c_;
};

// 2/pi K(m) = sum_n ((2n)!/(4^n n!^2))^2 m^n
inline RationalSeries elliptic(const RationalSeries& m) {
    RationalSeries c(m.through(), 1);
    Rational ratio = 1;
    for (int n = 1; n <= m.through(); ++n) {
        ratio = ratio * Rational(2 * n - 1) / Rational(2 * n);
        c[n] = ratio * ratio;
    }
    return RationalSeries::composed(c, m);
}

} // namespace resonform::test
