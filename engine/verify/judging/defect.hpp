// SPDX-License-Identifier: GPL-3.0-or-later
// The defect of a formula y(t): what remains when it is put into the equations of the system,
//
//   D_k(t) = y_k'(t) - f_k(y(t))
//
// the formula with its map at the full weight. Where a mode grows, direct integration departs from any
// formula as e^{lambda t}; the defect judges the formula over the whole interval all the same.
#pragma once

#include "verify/judging/judge.hpp"
#include "verify/judging/trial.hpp"

#include <string>
#include <vector>

namespace resonform {

// What is told of it where there is none: "" if there is one.
std::string why_no_defect(const System& system);

// max|D| of each equation at this eps, over [0, interval]: of an equation of second order the larger of both
// states'. By names of variables, in the order of the system; y' by central differences of order 8, with
// about 24 digits. Precondition: there is one.
struct EquationDefect {
    std::string variable;
    LadderRung rung;
};
std::vector<EquationDefect> defect_of(const Trial& trial, const TrialPoint& at, double rate);

} // namespace resonform
