// SPDX-License-Identifier: GPL-3.0-or-later
// Sums that are not negative since a^2 + b^2 >= 2*a*b: every negative term lies between two positive ones.
//
//   x^2 + y^2 - 2*x*y          m + c*cos(u)^2 + c*cos(v)^2 - 2*c*cos(u)^2*cos(v)^2 -
//   2*c*sin(u)*cos(u)*sin(v)*cos(v)
#pragma once

#include <ginac/ginac.h>

#include <functional>

namespace resonform {

using ProvedOf = std::function<bool(const GiNaC::ex&)>;

// true: e >= 0 is proved; false: it is not. `positive` and `real` say what is known of the factors of its
// terms. Sines and cosines of the same argument are brought to one degree by sin^2 + cos^2 = 1.
bool nonnegative_by_pairs(const GiNaC::ex& e, const ProvedOf& positive, const ProvedOf& real);

} // namespace resonform
