// SPDX-License-Identifier: GPL-3.0-or-later
// Operations of a call: written out in full, every occurrence computed anew; and in each form of many points,
// of which the cheaper one is chosen.
#pragma once

#include "emit/program/program.hpp"

namespace resonform {

// For all outputs, every occurrence computed anew, but for the constants of the solution; a table, a cosine
// or a sine counts as one look-up or one sincos each time.
OperationCount count_written_out(const Program& program);

// Sets operations_by_form, form_reason, many_points and sums_rows, with which `after` becomes that of the
// sums; where there are to be none, drops the rows. longest: ProgramOptions::longest_formula. Precondition:
// `after` is that of the formulas. Errors (refused, at `place`): a form is asked for that there cannot be.
void choose_form(Program& program, EmitForm wish, const Place& place, int longest);

} // namespace resonform
