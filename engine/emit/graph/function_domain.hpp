// SPDX-License-Identifier: GPL-3.0-or-later
// Where functions of a ring are real and smooth.
#pragma once

#include "algebra/ring/ring.hpp"

#include <optional>

namespace resonform {

// What must be > 0: u of log(u), 1 - u^2 of asin(u), u - 1 of acosh(u). nullopt: nothing must; a pole shows
// as a value that is not finite. Precondition: `of` is of a generator of the ring.
std::optional<Polynomial> positive_for(const Ring& ring, const FunctionOf& of);

} // namespace resonform
