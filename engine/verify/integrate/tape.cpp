// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/integrate/tape.hpp"

#include "algebra/number/functions.hpp"
#include "runtime/math.hpp"
#include "verify/run/spline.hpp"

#include <fmt/format.h>

#include <string_view>

namespace resonform {

namespace {

constexpr std::array<std::string_view, 13> op_names{"add",       "subtract",   "multiply", "scale", "square",
                                                    "divide",    "sqrt",       "power",    "exp",   "sin_cos",
                                                    "sinh_cosh", "tan_secant", "tanh_sech"};

std::string line(const Tape::Instruction& s) {
    if (s.op == Tape::Op::data)
        return fmt::format("data {} {} {} {} {}\n", s.data->name, s.derivative, s.result, s.left, s.right);
    const std::string_view name =
        s.op == Tape::Op::function ? row_of(s.function).name : op_names[static_cast<std::size_t>(s.op)];
    return fmt::format("{} {} {} {}\n", name, s.result, s.left, s.right);
}

} // namespace

std::string Tape::text() const {
    std::string out = fmt::format("tape {} {} {} {}\n", parameters_, constants_, states_, registers_);
    if (eps_root_ != 1) out += fmt::format("root {}\n", eps_root_);
    for (const Number& n : numbers_)
        out += fmt::format("number {} {:a} {:a} {:a}\n", n.target, n.value[0], n.value[1], n.value[2]);
    for (const Instruction& s : prologue_) out += line(s);
    out += "body\n";
    for (const Instruction& s : body_) out += line(s);
    for (int r : outputs_) out += fmt::format("output {}\n", r);
    for (const Data& data : data_) out += fmt::format("state {}\n", data.state) + data.samples->text();
    return out;
}

bool has_two_results(Tape::Op op) {
    using Op = Tape::Op;
    return op == Op::sin_cos || op == Op::sinh_cosh || op == Op::tan_secant || op == Op::tanh_sech;
}

template <class Real> void run(const Tape::Instruction& step, Real* registers) {
    using Op = Tape::Op;
    using M = Math<Real>;
    const Real& left = registers[step.left];
    const Real& right = registers[step.right];
    Real* result = registers + step.result;
    switch (step.op) {
    case Op::add: *result = left + right; break;
    case Op::subtract: *result = left - right; break;
    case Op::multiply:
    case Op::scale: *result = left * right; break;
    case Op::square: *result = left * left; break;
    case Op::divide: *result = left / right; break;
    case Op::sqrt: *result = M::sqrt(left); break;
    case Op::power: *result = M::pow(left, right); break;
    case Op::exp: *result = M::exp(left); break;
    case Op::sin_cos:
        result[0] = M::sin(left);
        result[1] = M::cos(left);
        break;
    case Op::sinh_cosh:
        result[0] = M::sinh(left);
        result[1] = M::cosh(left);
        break;
    case Op::tan_secant:
        result[0] = M::tan(left);
        result[1] = Real(1) + result[0] * result[0];
        break;
    case Op::tanh_sech:
        result[0] = M::tanh(left);
        result[1] = Real(1) - result[0] * result[0];
        break;
    case Op::function: *result = value_of(step.function, left); break;
    case Op::data: *result = spline(spline_of(*step.data), step.derivative, left); break;
    }
}

template <class Real>
BoundTape<Real>::BoundTape(const Tape& tape, const std::vector<Real>& parameters, Real eps)
    : tape_(tape), registers_(static_cast<std::size_t>(tape.size()), Real(0)) {
    for (std::size_t i = 0; i < parameters.size(); ++i) registers_[i] = parameters[i];
    registers_[static_cast<std::size_t>(tape_.parameter_count())] =
        tape_.eps_root() == 1 ? eps : math::root(eps, tape_.eps_root());
    for (const Tape::Number& n : tape_.numbers())
        registers_[static_cast<std::size_t>(n.target)] = from_parts<Real>(n.value);
    for (const Tape::Instruction& step : tape_.prologue()) run(step, registers_.data());
}

template <class Real> void BoundTape<Real>::evaluate(const Real* state, Real* outputs) {
    Real* states = registers_.data() + tape_.constant_count();
    for (int i = 0; i < tape_.state_count(); ++i) states[i] = state[i];
    for (const Tape::Instruction& step : tape_.body()) run(step, registers_.data());
    for (int r : tape_.outputs()) *outputs++ = registers_[static_cast<std::size_t>(r)];
}

template <class Real>
std::vector<Real> evaluate_constants(const Tape& tape, const std::vector<Real>& parameters, Real eps) {
    BoundTape<Real> bound(tape, parameters, eps);
    std::vector<Real> values(tape.outputs().size(), Real(0));
    const std::vector<Real> no_state(static_cast<std::size_t>(tape.state_count()), Real(0));
    bound.evaluate(no_state.data(), values.data());
    return values;
}

template void run(const Tape::Instruction&, double*);
template void run(const Tape::Instruction&, long double*);
template void run(const Tape::Instruction&, Float128*);
template void run(const Tape::Instruction&, DoubleDouble*);
template class BoundTape<double>;
template class BoundTape<long double>;
template class BoundTape<Float128>;
template class BoundTape<DoubleDouble>;
template std::vector<double> evaluate_constants(const Tape&, const std::vector<double>&, double);
template std::vector<long double> evaluate_constants(const Tape&, const std::vector<long double>&,
                                                     long double);
template std::vector<Float128> evaluate_constants(const Tape&, const std::vector<Float128>&, Float128);
template std::vector<DoubleDouble> evaluate_constants(const Tape&, const std::vector<DoubleDouble>&,
                                                      DoubleDouble);

} // namespace resonform
