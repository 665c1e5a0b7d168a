// SPDX-License-Identifier: GPL-3.0-or-later
// Which part of an output loses the digits: the program's graph in double beside 50 digits, node by node.
//
//   output sqrt(1 - cos(tau)) at tau = 1e-6, off by 1e8 ulp   ->   1 - cos(tau), of operands 1 and 0.9999...
//
// The error of a node is passed on to the output times d output/d node. The part that is told is the first
// (before its users) through which most of the error passes, and which would pass on less if it had only the
// relative error of its operands, or a rounding.
#pragma once

#include "verify/evaluate/interpretation.hpp"
#include "verify/stability/points.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

struct LostDigits {
    struct Operand {
        std::string expression;
        double value = 0;
    };
    std::string expression;        // as in the program's graph (spelled.hpp)
    double value = 0;              // of it, exact
    std::vector<Operand> operands; // the largest three
    double cancellation = 1;       // of a sum: its largest operand over itself
    double growth = 1;             // its relative error over that of its operands, or a rounding
    double share = 0;              // of the output's error that passes through it
    double ulp = 0;                // the output's error in this walk, in the unit
};

class DigitTracer {
public:
    explicit DigitTracer(std::shared_ptr<const Interpretation> shared) : shared_(std::move(shared)) {}

    // Of an output at t, evaluators being made with `end`; unit: one ulp of its scale. Nothing: there are no
    // numbers, the graph is not off by as much as half an ulp, or no part of it has most of the error.
    [[nodiscard]] std::optional<LostDigits> operator()(const SweepPoint& at, double end, double t,
                                                       std::size_t output, double unit) const;

private:
    std::shared_ptr<const Interpretation> shared_;
};

} // namespace resonform
