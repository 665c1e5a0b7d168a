// SPDX-License-Identifier: GPL-3.0-or-later
// Exponentials as a reader writes them:
//
//   exp(T/2)^3 * exp(-T)     ->   exp(T/2)
//   exp(-a*log(tau)/2 + T)   ->   tau^(-a/2) * exp(T)
#pragma once

#include "emit/display/display.hpp"

namespace resonform {

// The term with its exponentials made one, and those of logarithms made powers. The tail stays.
DisplayTerm with_powers(const DisplayTerm& term);

} // namespace resonform
