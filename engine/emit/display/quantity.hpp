// SPDX-License-Identifier: GPL-3.0-or-later
// The text that why(status) of an evaluator gives, such as "r^2 - xi^2": at most a line, and the same in
// emitted code and in the interpreter.
#pragma once

#include "algebra/ring/ring.hpp"

#include <string>

namespace resonform {

// "r^2 - xi^2"; for a purely imaginary polynomial, such as a divisor i (w1 - 2 w2), its real factor.
std::string quantity(const Ring& ring, const Polynomial& p);

// The text itself, or its beginning and "..." where it is longer than 80 characters.
std::string short_quantity(const std::string& text);

} // namespace resonform
