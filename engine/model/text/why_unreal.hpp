// SPDX-License-Identifier: GPL-3.0-or-later
// Why an expression has no real value at a point, in words.
#pragma once

#include <ginac/ginac.h>

#include <string>

namespace resonform {

// Which part makes the value no real number there: "-eps is negative" of log(-eps). Empty: none that is
// known.
std::string why_unreal(const GiNaC::ex& e, const GiNaC::exmap& point);

} // namespace resonform
