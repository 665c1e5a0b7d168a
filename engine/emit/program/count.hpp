// SPDX-License-Identifier: GPL-3.0-or-later
// Operations of an expression written out in full, every occurrence computed anew.
#pragma once

#include "emit/program/program.hpp"

namespace resonform {

// For all outputs, every occurrence computed anew, but for the constants of the solution; a table, a cosine
// or a sine counts as one look-up or one sincos each time.
OperationCount count_written_out(const Program& program);

} // namespace resonform
