// SPDX-License-Identifier: GPL-3.0-or-later
// The error of a scene's formula from the first weight that it leaves out. With y[N, M] the outputs through
// eps^N, normal form and map through weight M,
//
//   flow = y[N, M'] - y[N, M]       through phases, exponents, amplitudes, slow variables, drifts, the start
//   map  = y[N', M'] - y[N, M']     by what the map adds to the outputs
//
//   formula - exact = -(flow + map) (1 + O(eps)),    N' = N + 1,  M' as the count asks for N', M + 1 at least
//
// or N' = N + 2 where all that is next vanishes identically. Both are differences of solutions, not of
// series: an error of a phase is never larger than the oscillation, however long it has grown. Of a mean
// motion y[N', M'] has the oscillation that it leaves out. No direct integration is read.
#pragma once

#include "verify/estimate/next_weight.hpp"
#include "verify/evaluate/interpretation.hpp"
#include "verify/evaluate/program_defaults.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace resonform {

// [output][time]; NaN where one of the formulas has no numbers.
struct ErrorParts {
    std::vector<std::vector<double>> map, flow;
};

class ErrorEstimator {
public:
    struct Output {
        std::string name;
        int next_order = 0; // N'; 0: nothing is left out through N + 2, or it is not known
        std::string reason; // why there is none
    };

    // given: names of parameters without a value in [fix] that every call of parts() gives. Errors: those of
    // derive and build_program for the first weight; of the second they are a reason.
    ErrorEstimator(const Scene& scene, const Solution& solution, const Derive& derive,
                   std::vector<std::string> given = {});

    struct Further { // the formulas of one N', of the outputs that it is the first to move
        std::vector<std::size_t> outputs;
        std::shared_ptr<const Interpretation> flow, whole; // y[N, M'], y[N', M']
        int order, truncation;                             // N', M'
    };

    [[nodiscard]] const std::vector<Output>& outputs() const { return outputs_; } // in the scene's order
    [[nodiscard]] const std::vector<Further>& further() const { return further_; }

    // y[order, truncation] of all outputs; null: it is none of those that are made here.
    [[nodiscard]] std::shared_ptr<const Interpretation> formula(int order, int truncation) const;

    // Real: double, long double, Float128. Precondition: [fix] or `arguments` gives every parameter of the
    // outputs.
    template <class Real>
    [[nodiscard]] ErrorParts parts(Real eps, Real slow_time_end, const std::vector<double>& times,
                                   const GivenArguments& arguments = {}) const;

private:
    void compare_with(const Solution& richer, const Scene& fixed, const std::vector<std::size_t>& moved);

    std::shared_ptr<const Interpretation> formula_;
    std::vector<Output> outputs_;
    std::vector<Further> further_;
    int order_, truncation_;
    std::vector<std::string> given_;
};

} // namespace resonform
