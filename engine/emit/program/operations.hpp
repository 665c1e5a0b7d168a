// SPDX-License-Identifier: GPL-3.0-or-later
// Operations of a call: written out in full, every occurrence computed anew; and in each form of many points,
// of which the cheaper one is chosen.
#pragma once

#include "emit/program/program.hpp"

namespace resonform {

// For all outputs, every occurrence computed anew, but for the constants of the solution; a table, a cosine
// or a sine counts as one look-up or one sincos each time.
OperationCount count_written_out(const Program& program);

// Sets operations_by_form and form_reason; where there are to be no tables, drops the rows. Precondition:
// `after` is known. Errors (refused, at `place`): tables are asked for, and would be too large.
void choose_form(Program& program, EmitForm wish, const Place& place);

} // namespace resonform
