// SPDX-License-Identifier: GPL-3.0-or-later
// Operations of an expression as it would be written out, every occurrence computed anew.
#pragma once

#include "emit/program.hpp"

namespace resonform {

// The operations that change from call to call and what they need of constants, for all outputs; every
// occurrence of a table, a cosine or a sine counts as one look-up or one sincos.
OperationCount count_written_out(const Program& program);

} // namespace resonform
