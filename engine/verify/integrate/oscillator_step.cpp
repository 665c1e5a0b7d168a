// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/integrate/oscillator_step.hpp"

#include "verify/integrate/dense_lu.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace resonform::oscillator {

namespace {

constexpr std::size_t count = kernel::nodes;
constexpr double unit = std::numeric_limits<double>::epsilon();
constexpr double noise = 1e-14;          // of coefficients, against the largest
constexpr double residual_noise = 1e-13; // of a residual over omega: numerical differentiation
constexpr int most_iterations = 24;
constexpr std::size_t tail = 3; // coefficients that tell whether a function is resolved

template <class Number> using Nodes = Step::Nodes<Number>;
using Complex = Step::Complex;

template <class Number> Nodes<Number> coefficients_of(const Nodes<Number>& values) {
    return kernel::interpolated<double>(values);
}

template <class Number> Number sum_of(const Nodes<Number>& c, std::size_t terms, double x) {
    Number b1{}, b2{}; // Clenshaw's recurrence
    for (std::size_t k = terms; k-- > 1;) {
        const Number b0 = c[k] + 2 * x * b1 - b2;
        b2 = b1;
        b1 = b0;
    }
    return c[0] + x * b1 - b2;
}

template <class Number> Nodes<Number> values_of(const Nodes<Number>& c) {
    const auto& cosines = kernel::cosines<double>();
    Nodes<Number> values;
    for (std::size_t j = 0; j < count / 2; ++j) {
        Number even{}, odd{};
        for (std::size_t k = 0; k < count; k += 2) {
            even += c[k] * cosines[k][j];
            odd += c[k + 1] * cosines[k + 1][j];
        }
        values[j] = even + odd;
        values[count - 1 - j] = even - odd;
    }
    return values;
}

// Of d/dx.
template <class Number> Nodes<Number> derivative(const Nodes<Number>& c) {
    Nodes<Number> d{};
    for (std::size_t k = count - 1; k >= 1; --k)
        d[k - 1] = (k + 1 < count ? d[k + 1] : Number{}) + c[k] * (2.0 * static_cast<double>(k));
    d[0] /= 2;
    return d;
}

// Of the integral from x = -1; what would be a term of T_32 is left out.
template <class Number> Nodes<Number> integral(const Nodes<Number>& c) {
    Nodes<Number> s{};
    for (std::size_t k = 1; k < count; ++k) {
        const Number below = k == 1 ? c[0] * 2.0 : c[k - 1];
        s[k] = (below - (k + 1 < count ? c[k + 1] : Number{})) / (2.0 * static_cast<double>(k));
    }
    for (std::size_t k = 1; k < count; ++k) s[0] += k % 2 == 0 ? -s[k] : s[k];
    return s;
}

template <class Number> double largest(const Nodes<Number>& values, std::size_t from = 0) {
    double most = 0;
    for (std::size_t k = from; k < count; ++k) most = std::max(most, std::abs(values[k]));
    return most;
}

// Terms after which nothing is left that matters.
template <class Number> std::size_t terms_above(const Nodes<Number>& c, double least) {
    std::size_t terms = count;
    while (terms > 1 && std::abs(c[terms - 1]) <= least) --terms;
    return terms;
}

// Differentiation multiplies the last coefficients by up to 32^2.
Nodes<Complex> without_noise(Nodes<Complex> c) {
    const std::size_t terms = terms_above(c, 4 * unit * largest(c));
    std::fill(c.begin() + static_cast<std::ptrdiff_t>(terms), c.end(), Complex{});
    return c;
}

// From values of a function at the nodes to values of its integral from x = -1, row by row.
const std::vector<double>& integration() {
    static const std::vector<double> matrix = [] {
        std::vector<double> m(count * count);
        for (std::size_t k = 0; k < count; ++k) {
            Nodes<double> unit_vector{};
            unit_vector[k] = 1;
            const Nodes<double> column = values_of(integral(coefficients_of(unit_vector)));
            for (std::size_t j = 0; j < count; ++j) m[j * count + k] = column[j];
        }
        return m;
    }();
    return matrix;
}

// From values of a function at the nodes to those of the integral of its integral.
const std::vector<double>& double_integration() {
    static const std::vector<double> matrix = [] {
        const std::vector<double>& s = integration();
        std::vector<double> m(count * count);
        for (std::size_t j = 0; j < count; ++j)
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t k = 0; k < count; ++k)
                    m[j * count + k] += s[j * count + i] * s[i * count + k];
        return m;
    }();
    return matrix;
}

} // namespace

// False: not resolved, or no numbers.
bool Step::sample(OscillatorCoefficients& coefficients, const Start& start, double length) {
    for (std::size_t j = 0; j < count; ++j) {
        const auto at = coefficients.at(start.t + length * (1 + kernel::node<double>(j)) / 2);
        square_[j] = at.square;
        damping_[j] = at.damping;
    }
    const double most = largest(square_);
    fastest_ = std::sqrt(most);
    const double radians = std::max(1.0, fastest_ * length);
    const double least = std::max(start.tolerance / radians, noise);
    const auto is_resolved = [&](const Nodes<double>& values, double scale) {
        return largest(coefficients_of(values), count - tail) <= least * scale;
    };
    return std::isfinite(most) && is_resolved(square_, most) &&
           is_resolved(damping_, std::max(fastest_, largest(damping_)));
}

bool Step::by_iterations(OscillatorCoefficients& coefficients, const Start& start, double length) {
    if (!sample(coefficients, start, length)) return false;
    Nodes<Complex> r;
    for (std::size_t j = 0; j < count; ++j) {
        if (!(square_[j] > damping_[j] * damping_[j])) return false;
        r[j] = {0, std::sqrt(square_[j])};
    }
    const double wanted = start.tolerance + residual_noise + 4 * unit * fastest_ * length;
    double before = std::numeric_limits<double>::infinity();
    for (int i = 0;; ++i) {
        const Nodes<Complex> slope = values_of(derivative(without_noise(coefficients_of(r))));
        Nodes<Complex> change;
        for (std::size_t j = 0; j < count; ++j)
            change[j] = (slope[j] * (2 / length) + r[j] * (r[j] + 2 * damping_[j]) + square_[j]) /
                        (2.0 * (r[j] + damping_[j]));
        const double error = largest(change) * length; // of the phase
        if (error <= wanted) break;
        if (!(error < before) || i == most_iterations) return false;
        before = error;
        for (std::size_t j = 0; j < count; ++j) r[j] -= change[j];
    }
    rate_ = coefficients_of(r);
    phase_ = integral(rate_);
    for (Complex& c : phase_) c *= length / 2;
    if (largest(phase_, count - tail) > std::max(wanted, noise * largest(phase_))) return false;
    begin_ = start.t;
    length_ = length;
    oscillates_ = true;
    terms_ = terms_above(phase_, std::max(start.tolerance / 16, unit / 4 * largest(phase_)));
    const Complex r0 = sum_of(rate_, count, -1); // Re a = u, Re a r = v
    amplitude_ = {start.u, (start.u * r0.real() - start.v) / r0.imag()};
    return true;
}

// u'' = w, with u' = v + S w and u = u_0 + v (t - t_0) + S^2 w put into the equation at the nodes.
bool Step::by_collocation(OscillatorCoefficients& coefficients, const Start& start, double length) {
    if (!sample(coefficients, start, length)) return false;
    const double half = length / 2;
    const std::vector<double>&once = integration(), &twice = double_integration();
    std::vector<double> matrix(count * count), w(count);
    for (std::size_t j = 0; j < count; ++j) {
        for (std::size_t k = 0; k < count; ++k)
            matrix[j * count + k] = (j == k ? 1 : 0) + 2 * damping_[j] * half * once[j * count + k] +
                                    square_[j] * half * half * twice[j * count + k];
        const double passed = half * (1 + kernel::node<double>(j));
        w[j] = -2 * damping_[j] * start.v - square_[j] * (start.u + start.v * passed);
    }
    DenseLu lu;
    if (!lu.factor(matrix)) return false;
    lu.solve(w);
    Nodes<double> values;
    std::copy(w.begin(), w.end(), values.begin());
    const Nodes<double> second = coefficients_of(values);
    v_ = integral(second);
    for (double& c : v_) c *= half;
    v_[0] += start.v;
    u_ = integral(v_);
    for (double& c : u_) c *= half;
    u_[0] += start.u;
    const double scale = std::max(largest(u_), std::abs(start.u));
    if (!(largest(second, count - tail) * half * half <= std::max(start.tolerance, noise) * scale))
        return false;
    begin_ = start.t;
    length_ = length;
    oscillates_ = false;
    terms_ = count;
    return true;
}

double Step::u(double t) const {
    const double x = place(t);
    if (!oscillates_) return sum_of(u_, terms_, x);
    return (amplitude_ * std::exp(sum_of(phase_, terms_, x))).real();
}

double Step::v(double t) const {
    const double x = place(t);
    if (!oscillates_) return sum_of(v_, terms_, x);
    return (amplitude_ * sum_of(rate_, count, x) * std::exp(sum_of(phase_, terms_, x))).real();
}

} // namespace resonform::oscillator
