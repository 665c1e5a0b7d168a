// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/integrate/tape_jacobian.hpp"

#include <algorithm>
#include <cmath>

namespace resonform {

TapeJacobian::TapeJacobian(const Tape& tape, const std::vector<double>& parameters, double eps)
    : tape_(tape), states_(static_cast<std::size_t>(tape.state_count())),
      values_(BoundTape<double>(tape, parameters, eps).registers()),
      gradients_(static_cast<std::size_t>(tape.size()) * states_, 0.0) {
    for (int i = 0; i < tape_.state_count(); ++i) gradient(tape_.constant_count() + i)[i] = 1;
}

void TapeJacobian::evaluate(const double* state, double* matrix) {
    std::copy(state, state + states_, values_.data() + tape_.constant_count());
    for (const Tape::Instruction& step : tape_.body()) {
        run(step, values_.data());
        differentiate(step);
    }
    for (const int r : tape_.outputs()) matrix = std::copy(gradient(r), gradient(r) + states_, matrix);
}

void TapeJacobian::differentiate(const Tape::Instruction& step) {
    using Op = Tape::Op;
    const double left = values_[static_cast<std::size_t>(step.left)];
    const double right = values_[static_cast<std::size_t>(step.right)];
    const double* result = values_.data() + step.result;
    const double *a = gradient(step.left), *b = gradient(step.right);
    double *out = gradient(step.result), *out2 = out + states_; // the second result, where there is one
    // d result = of_left da + of_right db
    const auto chain = [&](double* to, double of_left, double of_right = 0) {
        for (std::size_t k = 0; k < states_; ++k)
            to[k] = of_right == 0 ? of_left * a[k] : of_left * a[k] + of_right * b[k];
    };
    switch (step.op) {
    case Op::add: chain(out, 1, 1); break;
    case Op::subtract: chain(out, 1, -1); break;
    case Op::multiply:
    case Op::scale: chain(out, right, left); break;
    case Op::square: chain(out, 2 * left); break;
    case Op::divide: chain(out, 1 / right, -result[0] / right); break;
    case Op::sqrt: chain(out, 0.5 / result[0]); break;
    case Op::power: chain(out, right * std::pow(left, right - 1)); break;
    case Op::exp: chain(out, result[0]); break;
    case Op::sin_cos:
        chain(out, result[1]);
        chain(out2, -result[0]);
        break;
    case Op::sinh_cosh:
        chain(out, result[1]);
        chain(out2, result[0]);
        break;
    case Op::tan_secant:
        chain(out, result[1]);
        chain(out2, 2 * result[0] * result[1]);
        break;
    case Op::tanh_sech:
        chain(out, result[1]);
        chain(out2, -2 * result[0] * result[1]);
        break;
    case Op::function:
    case Op::data: chain(out, right); break;
    }
}

} // namespace resonform
