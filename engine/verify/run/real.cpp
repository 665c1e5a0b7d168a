// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/run/real.hpp"

#include "algebra/number/error.hpp"

#include <cln/rational_io.h>

namespace resonform {

Parts to_parts(const Rational& value) {
    constexpr double least = 1e-270; // the third part is a double still
    Parts parts{};
    Rational rest = value;
    for (double& part : parts) {
        part = cln::double_approx(rest);
        rest = rest - (std::isfinite(part) ? exact_rational(part) : 0);
    }
    const bool large = !std::isfinite(parts[0]);
    if (large || (!cln::zerop(value) && std::abs(parts[0]) < least))
        refuse(Reason::size, {"a number of the equations lies within the range of double precision",
                              large ? "a number beyond 1e308" : "a number below 1e-270",
                              "rescale the equations",
                              {}});
    return parts;
}

} // namespace resonform
