// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/integrate/radau.hpp"

#include "verify/run/real.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace resonform {

namespace {

// n is small: exact.
template <class Real> Real integer(std::size_t n) { return Real(static_cast<double>(n)); }

// The zero of P_{s-1} - P_s near x, x < 1, by Newton's method with (x^2 - 1) P_n' = n (x P_n - P_{n-1}).
template <class Real> Real zero_near(Real x, std::size_t s) {
    constexpr int most_iterations = 20; // from four digits on they double
    for (int k = 0; k < most_iterations; ++k) {
        const std::vector<Real> p = legendre(x, s + 1);
        const Real slope =
            (integer<Real>(s - 1) * (x * p[s - 1] - p[s - 2]) - integer<Real>(s) * (x * p[s] - p[s - 1])) /
            (x * x - Real(1));
        const Real change = (p[s - 1] - p[s]) / slope;
        x -= change;
        if (std::abs(to_double_value(change)) < 4 * RealTraits<Real>::roundoff()) break;
    }
    return x;
}

// Zeros in [-1, 1], ascending.
template <class Real> std::vector<Real> zeros(std::size_t s) {
    std::vector<Real> x(s, Real(1));
    for (std::size_t i = 0; i + 1 < s; ++i) {
        const double angle =
            2 * std::numbers::pi * static_cast<double>(s - 1 - i) / static_cast<double>(2 * s - 1);
        x[i] = zero_near(Real(std::cos(angle)), s);
    }
    return x;
}

// int_{-1}^x P_k for k < s, from P_0 ... P_s at x.
template <class Real> std::vector<Real> integrals(const std::vector<Real>& p, const Real& x) {
    std::vector<Real> sums{x + Real(1)};
    for (std::size_t k = 1; k + 1 < p.size(); ++k)
        sums.push_back((p[k + 1] - p[k - 1]) / integer<Real>(2 * k + 1));
    return sums;
}

} // namespace

template <class Real> std::vector<Real> legendre(const Real& x, std::size_t count) {
    std::vector<Real> p{Real(1), x};
    for (std::size_t k = 2; k < count; ++k)
        p.push_back((integer<Real>(2 * k - 1) * (x * p[k - 1]) - integer<Real>(k - 1) * p[k - 2]) /
                    integer<Real>(k));
    p.resize(count, Real(0));
    return p;
}

template <class Real>
RadauRule<Real>::RadauRule(int stages_)
    : stages(static_cast<std::size_t>(stages_)), matrix(stages * stages, Real(0)),
      spectrum(stages * stages, Real(0)) {
    const std::vector<Real> x = zeros<Real>(stages);
    std::vector<std::vector<Real>> p, integral;
    for (std::size_t i = 0; i < stages; ++i) {
        nodes.push_back((Real(1) + x[i]) / Real(2));
        p.push_back(legendre(x[i], stages + 1));
        integral.push_back(integrals(p[i], x[i]));
    }
    for (std::size_t j = 0; j < stages; ++j) {
        const Real root = integer<Real>(stages) * p[j][stages - 1];
        const Real weight = (Real(1) + x[j]) / (root * root);
        for (std::size_t k = 0; k < stages; ++k) {
            const Real coefficient = integer<Real>(2 * k + 1) / Real(2) * weight * p[j][k];
            spectrum[k * stages + j] = coefficient / nodes[j];
            for (std::size_t i = 0; i < stages; ++i)
                matrix[i * stages + j] += coefficient * integral[i][k] / Real(2);
        }
    }
}

template struct RadauRule<double>;
template struct RadauRule<Float128>;
template struct RadauRule<DoubleDouble>;
template std::vector<double> legendre(const double&, std::size_t);
template std::vector<Float128> legendre(const Float128&, std::size_t);
template std::vector<DoubleDouble> legendre(const DoubleDouble&, std::size_t);

} // namespace resonform
