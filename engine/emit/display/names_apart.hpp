// SPDX-License-Identifier: GPL-3.0-or-later
// Names that LaTeX would print alike get subscripts that differ:
//
//   x2, x_2   ->   x_{2}, x_{(2)}
//
// Only where both stand on one page; alone, x_2 is x_{2}.
#pragma once

#include "emit/display/page.hpp"

namespace resonform {

Page with_names_apart(Page page);

} // namespace resonform
