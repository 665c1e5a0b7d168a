// SPDX-License-Identifier: GPL-3.0-or-later
// Exact expressions as a flat list of operations on registers, shared sub-expressions once, so that
// right-hand sides run in any real type, in any thread, without GiNaC.
//
//   x'' = -sin(x)/m   ->   prologue:  r3 = 1/r1                        parameters and eps only: once
//                          body:      (r7, r8) = sincos r5; r9 = r3*r7; r10 = 0 - r9
//
// Registers: constants (numbers, parameters, eps, prologue results), then states, then body results.
#pragma once

#include "algebra/number/functions.hpp"
#include "model/exact/first_order_system.hpp"
#include "verify/run/real.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace resonform {

class Tape {
public:
    enum class Op : std::uint8_t {
        add,        // left + right
        subtract,   // left - right
        multiply,   // left * right
        scale,      // left * right, left constant
        square,     // left^2
        divide,     // left / right
        sqrt,       // left^(1/2)
        power,      // left^right, right constant
        exp,        // e^left
        sin_cos,    // result = sin(left), result + 1 = cos(left)
        sinh_cosh,  // result = sinh(left), result + 1 = cosh(left)
        tan_secant, // result = tan(left), result + 1 = 1 + tan(left)^2
        tanh_sech,  // result = tanh(left), result + 1 = 1 - tanh(left)^2
        function,   // f(left), known by its slope: b' = left' right
        data,       // likewise, in pieces
    };
    struct Instruction {
        Op op;
        int result;
        int left;
        int right;                                 // unused by unary operations
        Function function = Function::named;       // of Op::function
        const PiecewisePolynomial* data = nullptr; // of Op::data; it lives with the tape
        int derivative = 0;
    };
    struct Number {
        int target;
        Parts value;
    };

    // The rates of the states, in the order of system.states. Errors: refused, a function that no
    // integrator here knows, or a number beyond the range of double.
    static Tape rates(const FirstOrderSystem& system);
    // Expressions in parameters and eps alone (start values, an interval).
    static Tape constants(const System& system, const std::vector<GiNaC::ex>& expressions) {
        return of(system, {}, expressions);
    }
    // In parameters, eps and states.
    static Tape of(const System& system, const std::vector<GiNaC::symbol>& states,
                   const std::vector<GiNaC::ex>& expressions);

    [[nodiscard]] int state_count() const { return states_; }
    [[nodiscard]] int constant_count() const { return constants_; }
    [[nodiscard]] int parameter_count() const { return parameters_; }
    [[nodiscard]] int eps_root() const { return eps_root_; }
    [[nodiscard]] int size() const { return registers_; }
    [[nodiscard]] const std::vector<Number>& numbers() const { return numbers_; }
    [[nodiscard]] const std::vector<Instruction>& prologue() const { return prologue_; }
    [[nodiscard]] const std::vector<Instruction>& body() const { return body_; }
    [[nodiscard]] const std::vector<int>& outputs() const { return outputs_; } // registers
    // States at which data stand: whoever integrates in high order ends steps at their breakpoints.
    struct Data {
        DataPointer samples;
        int state;
    };
    [[nodiscard]] const std::vector<Data>& data() const { return data_; }
    // Every operation and number, one per line: the key of caches, the same in every run.
    [[nodiscard]] std::string text() const;

private:
    friend class TapeBuilder;
    Tape() = default;

    int parameters_ = 0; // registers 0 ... parameters_ - 1; the system's symbol eps follows
    int eps_root_ = 1;   // which stands for this root of eps
    int constants_ = 0;
    int states_ = 0;
    int registers_ = 0;
    std::vector<Number> numbers_;
    std::vector<Instruction> prologue_, body_;
    std::vector<int> outputs_;
    std::vector<Data> data_;
};

// result and result + 1
bool has_two_results(Tape::Op op);

// Runs one step on values; defined for the four real types.
template <class Real> void run(const Tape::Instruction& step, Real* registers);

// A tape with numbers put in for parameters and eps. It owns its registers: one per thread, copy it.
template <class Real> class BoundTape {
public:
    // parameters: in the order of system.parameters.
    BoundTape(const Tape& tape, const std::vector<Real>& parameters, Real eps);

    // state[state_count] -> outputs, one per expression.
    void evaluate(const Real* state, Real* outputs);
    [[nodiscard]] const Tape& tape() const { return tape_; }
    [[nodiscard]] const std::vector<Real>& registers() const { return registers_; }

private:
    Tape tape_;
    std::vector<Real> registers_;
};

// The values of expressions in parameters and eps (a tape made by Tape::constants).
template <class Real>
std::vector<Real> evaluate_constants(const Tape& tape, const std::vector<Real>& parameters, Real eps);

} // namespace resonform
