// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of expand() for numeric modes, which the ring has no exact values of.
#include "algebra/number/error.hpp"
#include "expand/expansion/expansion.hpp"
#include "expand/modes/number_fit.hpp"
#include "expand/modes/number_index.hpp"
#include "expand/modes/numeric_modes.hpp"

#include <fmt/format.h>

namespace resonform {

using Node = SeriesProgram::Node;

namespace {

Node entry_of(SeriesProgram& program, const ModalBasis& basis, std::size_t mode, std::size_t state,
              NumberOf what) {
    return program.number(number_index(mode, state, basis.states.size(), what));
}

} // namespace

void Expansion::check_numbers() const {
    if (system_.digits == 0) return;
    if (!system_.parameters.empty()) {
        const Parameter& first = system_.parameters.front();
        bad_input({"with --digits every parameter has a number", first.name,
                   fmt::format("give --set {}=NUMBER, or leave out --digits", first.name), first.place});
    }
    if (const auto hindrance = hindrance_to_numbers(system_)) refuse(*hindrance);
}

// u_s = sum column z + conj
Node Expansion::numeric_state(std::size_t s) {
    Addends addends;
    for (std::size_t k = 0; k < field_.modes.size(); ++k) {
        const Mode& mode = field_.modes[k];
        const Node column = entry_of(*program_, field_.basis, k, s, NumberOf::column);
        addends.emplace_back(1, program_->product(column, mode.input));
        if (mode.is_real()) continue;
        const Node conjugate = entry_of(*program_, field_.basis, k, s, NumberOf::conjugate_column);
        addends.emplace_back(1, program_->product(conjugate, mode.input_conjugate));
    }
    return program_->sum(addends);
}

// z' - lambda z with z' = sum_s row_s u_s'
Node Expansion::numeric_rate(std::size_t k) {
    Addends addends;
    for (std::size_t s = 0; s < field_.basis.states.size(); ++s) {
        const State& state = first_order_->states[field_.basis.states[s]];
        const Node row = entry_of(*program_, field_.basis, k, s, NumberOf::row);
        addends.emplace_back(
            1, program_->product(row, (*translate_)(state.rate, place_of_equation(state.variable))));
    }
    const Mode& mode = field_.modes[k];
    addends.emplace_back(-1, program_->product(program_->constant(field_.eigenvalue(mode)), mode.input));
    return program_->sum(addends);
}

std::optional<GivenNumbers> given_numbers(const GradedField& field, std::int64_t bits) {
    GivenNumbers given;
    if (!field.basis.numeric) return given;
    const auto values = field.basis.numeric->at(bits);
    if (!values) return std::nullopt;
    for (std::size_t n = 0; n < field.basis.numbers.size(); ++n) {
        const NumberSymbol& number = field.basis.numbers[n];
        const ComplexBall& eigenvalue = values->eigenvalues[number.mode];
        given.generators[field.coefficients->number(n)] = number.growth ? eigenvalue.re() : eigenvalue.im();
    }
    for (std::size_t k = 0; k < field.modes.size(); ++k)
        for (std::size_t s = 0; s < field.basis.states.size(); ++s) {
            given.numbers.push_back(values->columns[k][s]);
            given.numbers.push_back(values->columns[k][s].conjugate());
            given.numbers.push_back(values->rows[k][s]);
        }
    return given;
}

} // namespace resonform
