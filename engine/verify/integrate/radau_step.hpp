// SPDX-License-Identifier: GPL-3.0-or-later
// One step of Radau IIA: the increments Z_i = Y_i - y with
//
//   R_i(Z) = Z_i - h sum_j a_ij f(y + Z_j) = 0
//
// by Newton's method. R is computed in the real type, (I - h a_ij f'(Y_j)) and its decomposition in double:
// an iteration gains up to some 14 digits even where nothing else stops it (iterative refinement), and
// costs little beside a decomposition in the real type. Unknowns and equations are divided by the scales of
// the states.
#pragma once

#include "verify/integrate/dense_lu.hpp"
#include "verify/integrate/radau.hpp"
#include "verify/integrate/tape_jacobian.hpp"

#include <cstddef>
#include <vector>

namespace resonform {

template <class Real> class RadauStep {
public:
    // rule must outlive it. tolerance: of the increments, relative to the scales.
    RadauStep(const Tape& tape, const std::vector<Real>& parameters, const Real& eps,
              const RadauRule<Real>& rule, double tolerance);

    // increments[stage * states + state]: a guess, and the solution after it. scales: of the states, the
    // largest values so far; larger after it where the step has larger values. False if the iteration
    // does not converge or meets NaN or infinity; increments and scales are not to be used then.
    bool solve(const std::vector<Real>& state, const Real& h, std::vector<Real>& increments,
               std::vector<double>& scales);

    // How far the last solution is off by rounding, where that is more than the tolerance: stiff rates are
    // differences of large numbers. Of each state.
    [[nodiscard]] const std::vector<double>& noise() const { return noise_; }
    // f and f' at a state.
    bool rates(const std::vector<Real>& state, std::vector<Real>& rates);
    const std::vector<double>& jacobian(const std::vector<Real>& state);
    [[nodiscard]] std::size_t evaluations() const { return evaluations_; }

private:
    enum class Outcome { go_on, converged, failed };

    bool residuals(const std::vector<Real>& state, const Real& h, const std::vector<Real>& increments);
    bool decompose(const std::vector<Real>& state, double h, const std::vector<Real>& increments,
                   const std::vector<double>& scales);
    void improve(std::vector<Real>& increments, const std::vector<double>& scales);
    void raise(std::vector<double>& scales, const std::vector<Real>& state,
               const std::vector<Real>& increments) const;
    Outcome judge(int iteration, double change, double ratio, double h, const std::vector<double>& scales);
    [[nodiscard]] double rounding(std::size_t a, double h, const std::vector<double>& scales) const;

    BoundTape<Real> tape_;
    TapeJacobian jacobian_;
    const RadauRule<Real>& rule_;
    double tolerance_;
    std::size_t states_;
    DenseLu lu_;
    std::vector<double> matrix_;    // f' at one state
    std::vector<double> steepest_;  // the largest |f'| among the stages, entry by entry
    std::vector<Real> stage_rates_; // [stage * states + state]
    std::vector<Real> residuals_;   // likewise
    std::vector<double> changes_;   // of the last iteration, the largest among the stages, of each state
    std::vector<double> noise_;
    std::size_t evaluations_ = 0;
};

} // namespace resonform
