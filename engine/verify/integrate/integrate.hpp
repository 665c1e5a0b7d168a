// SPDX-License-Identifier: GPL-3.0-or-later
// Direct integration of the ORIGINAL first-order system: the judge of every formula.
#pragma once

#include "model/exact/first_order_system.hpp"
#include "verify/integrate/integrator.hpp"
#include "verify/integrate/tape.hpp"

#include <memory>
#include <string>
#include <vector>

namespace resonform {

// values[state][point] at ascending times; the first time is the start or later.
template <class Real> struct Integration {
    std::vector<std::vector<Real>> values;
    std::size_t steps = 0, evaluations = 0;
    double seconds = 0;
    std::string failure;  // empty if the method reached the last time
    bool too_far = false; // the failure is that it takes too many steps
};
using IntegrationResult = Integration<double>;
template <class Real> using TaylorResult = Integration<Real>;

// Taylor-series integrator, Real = double, long double, Float128, DoubleDouble. It starts at t = 0.
// Each step expands the solution to `order` (0: ceil(1 - ln(tolerance)/2), which makes the cost least)
// and is as long as the last two coefficients allow: |c_k| h^k <= tolerance * scale of the state, the
// scale being the largest value so far (Jorba and Zou, Experimental Mathematics 14 (2005) 99-117).
// A solution that leaves the domain of the equations is a failure, not an exception; so is one that needs
// more than most_steps, which is estimated from the first 10^4 of them. The default is about a million
// periods, minutes in double-double.
constexpr std::size_t most_taylor_steps = 5'000'000;
template <class Real>
Integration<Real> integrate_taylor(const Tape& tape, const std::vector<Real>& parameters, const Real& eps,
                                   const std::vector<Real>& start, const std::vector<Real>& times,
                                   double tolerance, int order = 0,
                                   std::size_t most_steps = most_taylor_steps);

// The same from a system; parameters in the order of system.system->parameters.
template <class Real>
Integration<Real> integrate_taylor(const FirstOrderSystem& system, const std::vector<Real>& parameters,
                                   const Real& eps, const std::vector<Real>& start,
                                   const std::vector<Real>& times, double tolerance, int order = 0) {
    return integrate_taylor(Tape::rates(system), parameters, eps, start, times, tolerance, order);
}

// Radau IIA (verify/integrate/radau.hpp) from t = 0, Real = double, Float128, DoubleDouble: for systems with
// rates far above those of their solutions, where the steps of a Taylor series are of the length of the
// fastest rate. Radau, not Gauss: R(infinity) = 0, so that a layer that a step passes over is gone after it,
// where Gauss's methods, |R(infinity)| = 1, leave it ringing. The number of stages follows from the tolerance
// (15 at 1e-14, 26 at 1e-28), and the collocation polynomial serves as dense output: a step is as long as
// its last two Legendre coefficients allow, |q_k| <= tolerance * scale of the state, the rule of the Taylor
// series. At the ends of steps the order is 2s - 1, and errors are rounding errors where nothing is stiff.
// Where rates of size K cancel, rounding leaves an error of K t units in the last place, with any method.
// Tolerances below that are not met, as a second run shows; those below 1000 units in the last place are
// raised to that. Failures are those of integrate_taylor; `steps` counts rejected ones, too. A step in
// double-double takes 0.2 ms for three states, 20 ms for seventeen.
constexpr std::size_t most_implicit_steps = 200'000;
template <class Real>
Integration<Real> integrate_implicit(const Tape& tape, const std::vector<Real>& parameters, const Real& eps,
                                     const std::vector<Real>& start, const std::vector<Real>& times,
                                     double tolerance, std::size_t most_steps = most_implicit_steps);

const char* to_string(Method method);
// Whether its times cost no steps: fehlberg78 steps to each.
bool has_dense_output(Method method);
// Whether a time costs little beside a step. ARKODE's explicit methods take thirty times as long as others.
bool has_cheap_output(Method method);

// Any method but taylor and riccati (verify/integrate/riccati.hpp) in double, dense output through the
// method's own interpolation where it has one. Messages of the libraries go to `failure`.
std::unique_ptr<Integrator> make_integrator(Method method, RightHandSide rates, const Start& start);

// One run over a tape that is interpreted, by any method but riccati.
IntegrationResult integrate(Method method, const Tape& tape, const std::vector<double>& parameters,
                            double eps, const std::vector<double>& start, const std::vector<double>& times,
                            double tolerance);

} // namespace resonform
