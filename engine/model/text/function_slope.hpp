// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algebra/number/functions.hpp"

#include <ginac/ginac.h>

namespace resonform {

// f'(u) as the table of functions has it. Precondition: it has one.
GiNaC::ex slope_of(Function f, const GiNaC::ex& u);

} // namespace resonform
