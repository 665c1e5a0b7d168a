// SPDX-License-Identifier: GPL-3.0-or-later
// Operations of a call: written out in full, every occurrence computed anew; and in each form of many points,
// of which the cheaper one is chosen.
#pragma once

#include "emit/program/program.hpp"

namespace resonform {

// For all outputs, every occurrence computed anew, but for the constants of the solution; a table, a cosine
// or a sine counts as one look-up or one sincos each time.
OperationCount count_written_out(const Program& program);

// Sets operations_by_form, form_reason and from_atoms; where there are to be no sums of rows, drops the rows.
// Precondition: `after` is known. Errors (refused, at `place`): a form is asked for that there cannot be.
void choose_form(Program& program, EmitForm wish, const Place& place);

} // namespace resonform
