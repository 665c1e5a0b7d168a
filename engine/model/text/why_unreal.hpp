// SPDX-License-Identifier: GPL-3.0-or-later
// Why an expression has no real value at a point, in words.
#pragma once

#include <ginac/ginac.h>

#include <string>

namespace resonform {

// The part by which the value is not real there: "-eps is negative" for log(-eps). Empty: none is found.
std::string why_unreal(const GiNaC::ex& e, const GiNaC::exmap& point);

} // namespace resonform
