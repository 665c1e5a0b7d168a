// SPDX-License-Identifier: GPL-3.0-or-later
// The derivatives of a tape's outputs with respect to its states, in double: every register carries its
// gradient, which obeys the chain rule (forward differentiation; A. Griewank and A. Walther, Evaluating
// Derivatives, 2008, ch. 3).
//
//   r = a b   ->   dr/du = b da/du + a db/du
#pragma once

#include "verify/integrate/tape.hpp"

#include <cstddef>
#include <vector>

namespace resonform {

class TapeJacobian {
public:
    // parameters: in the order of system.parameters.
    TapeJacobian(const Tape& tape, const std::vector<double>& parameters, double eps);

    // state[state_count] -> matrix[output * state_count + state]. Entries are no numbers where an operation
    // has no derivative, as sqrt at 0.
    void evaluate(const double* state, double* matrix);

private:
    double* gradient(int r) { return gradients_.data() + static_cast<std::size_t>(r) * states_; }
    void differentiate(const Tape::Instruction& step);

    Tape tape_;
    std::size_t states_;
    std::vector<double> values_;    // of all registers
    std::vector<double> gradients_; // [register][state]; zeros for the constants
};

} // namespace resonform
