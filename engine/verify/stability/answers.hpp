// SPDX-License-Identifier: GPL-3.0-or-later
// What the emitted evaluator answers from one start, beside the exact solution.
#pragma once

#include "verify/evaluate/evaluator.hpp"
#include "verify/stability/reference.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

struct StabilityAnswer { // at one time
    double t = 0;
    Status status = Status::ok;
    std::string why;           // the cause of the status, as the evaluator names it
    bool known = false;        // the exact solution is computed so far
    bool explained = true;     // the status, if it is not ok
    std::vector<double> ulp;   // of each output; empty without numbers
    std::vector<double> units; // one ulp of each output's scale
    Conditioning conditioning; // of the outputs, if an error is above the threshold
};

class StabilityTrial {
public:
    // threshold: in ulp. All references must outlive it; library: of the program, in double. exponent: of
    // which the evaluator says low_precision where the formulas neglect too much beside its mode, which is
    // not for their rounding to judge; "" if there is none.
    StabilityTrial(const Program& program, std::shared_ptr<const EvaluatorLibrary> library,
                   const StabilityReference& reference, double threshold, std::string exponent)
        : program_(program), library_(std::move(library)), reference_(reference), threshold_(threshold),
          exponent_(std::move(exponent)) {}

    // The end of slow time with which evaluators are made: a little longer than the interval, for
    // t = end/eps is rounded.
    [[nodiscard]] double end() const { return program_.interval_slow_time * (1 + 0x1p-40); }
    // At the first `times` of shares_of_interval. Thread-safe.
    [[nodiscard]] std::vector<StabilityAnswer> operator()(const SweepPoint& at, std::size_t times) const;

private:
    [[nodiscard]] bool explains(const StabilityAnswer& answer, const SymbolicPoint& exact,
                                StabilityReference::From& from) const;
    void judge(StabilityAnswer& answer, const std::vector<double>& values,
               StabilityReference::From& from) const;

    const Program& program_;
    std::shared_ptr<const EvaluatorLibrary> library_;
    const StabilityReference& reference_;
    double threshold_;
    std::string exponent_;
};

} // namespace resonform
