// SPDX-License-Identifier: GPL-3.0-or-later
// A tape as C++ text, as one would write it by hand for a direct integration of these equations, so that
// rivals of the emitted evaluators are compiled code, too.
//
//   extern "C" void rf_rates(const double* c, const double* u, double* rates);
//   extern "C" void rf_jacobian(const double* c, const double* u, double* matrix);
//   extern "C" void rf_jet(const double* c, int order, double* rows);
//
// c are the constants of a BoundTape. rf_jacobian writes d(rate i)/d(state k) to matrix[k * rates + i], by
// forward differentiation (verify/integrate/tape_jacobian.hpp). `rows` holds Taylor coefficients in time, a
// row of jet_stride for each value of the tape (states first) and jet_pad zeros before each: rf_jet finds
// coefficient 0 of the states, and fills in 1 ... order. The recurrences are those of
// verify/integrate/taylor_jet.hpp. A value that is a polynomial in t, as all that depends on xi' = eps alone,
// makes its products short sums.
#pragma once

#include "verify/integrate/tape.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <string>

namespace resonform {

constexpr int highest_jet_order = 20;
constexpr int jet_pad = 8; // the highest degree of a polynomial that is treated as one
constexpr std::size_t jet_stride = jet_pad + highest_jet_order + 2;

// How many rows rf_jet wants.
std::size_t jet_rows(const Tape& tape);

std::string emit_tape(const Tape& tape);

// Its parts. The texts of rf_jacobian and rf_jet:
std::string jacobian_text(const Tape& tape);
std::string jet_text(const Tape& tape);
// One step of the tape as an assignment, `value(r)` being the name of register r.
std::string value_line(const Tape::Instruction& step, const std::string& type,
                       const std::function<std::string(int)>& value);
// "c[3]", or the number itself.
std::map<int, std::string> names_of_constants(const Tape& tape);

} // namespace resonform
