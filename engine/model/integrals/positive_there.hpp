// SPDX-License-Identifier: GPL-3.0-or-later
// How integrals ask for signs.
#pragma once

#include <ginac/ginac.h>

#include <functional>

namespace resonform {

// e > 0 is proved where the integral is used.
using PositiveThere = std::function<bool(const GiNaC::ex&)>;

} // namespace resonform
