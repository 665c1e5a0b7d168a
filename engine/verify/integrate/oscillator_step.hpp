// SPDX-License-Identifier: GPL-3.0-or-later
// One step of
//
//   u'' + 2 gamma(t) u' + omega(t)^2 u = 0
//
// on Chebyshev nodes, in one of two ways (F. Agocs and A. Barnett, SIAM J. Numer. Anal. 62 (2024) 295-321):
//
//   where it oscillates   u = Re a exp(phi),  phi' = r,  r' + r^2 + 2 gamma r + omega^2 = 0,  by iterations
//                         r <- r - R(r)/(2 (r + gamma)) from r = i omega, R the left side
//   elsewhere             collocation of u''
#pragma once

#include "runtime/kernel/chebyshev.hpp"
#include "verify/integrate/linear_oscillator.hpp"

#include <array>
#include <complex>

namespace resonform::oscillator {

class Step {
public:
    template <class Number> using Nodes = std::array<Number, kernel::nodes>; // values there, or coefficients
    using Complex = std::complex<double>;

    // Where the step begins, and how exact it is to be, relative to u and u'.
    struct Start {
        double t, u, v, tolerance;
    };

    // False: the coefficients or the solution are not resolved on so long an interval, omega^2 is not
    // positive on it, or the iterations do not reach the tolerance, which is no matter of length where omega
    // changes about as fast as u.
    bool by_iterations(OscillatorCoefficients& coefficients, const Start& start, double length);
    bool by_collocation(OscillatorCoefficients& coefficients, const Start& start, double length);

    // Within the last step that was made; v = u'.
    [[nodiscard]] double u(double t) const;
    [[nodiscard]] double v(double t) const;

private:
    [[nodiscard]] double place(double t) const { return 2 * (t - begin_) / length_ - 1; }
    [[nodiscard]] bool sample(OscillatorCoefficients& coefficients, const Start& start, double length);

    double begin_ = 0, length_ = 0;
    Nodes<double> square_, damping_;
    double fastest_ = 0; // sqrt of the largest |omega^2|
    bool oscillates_ = false;
    Complex amplitude_;
    Nodes<Complex> phase_, rate_; // coefficients of phi and r
    Nodes<double> u_, v_;         // coefficients
    std::size_t terms_ = 0;       // of u_ or phase_ that matter
};

} // namespace resonform::oscillator
