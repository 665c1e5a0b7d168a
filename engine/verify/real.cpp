// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/real.hpp"

#include "algebra/error.hpp"

#include <cln/dfloat.h>
#include <cln/rational_io.h>

namespace resonform {

Parts to_parts(const Rational& value) {
    Parts parts{};
    Rational rest = value;
    for (double& part : parts) {
        part = cln::double_approx(rest);
        if (!std::isfinite(part))
            refuse({"a number of the equations lies within the range of double precision",
                    "a number beyond 1e308",
                    "rescale the equations",
                    {}});
        rest = rest - cln::rational(cln::cl_DF(part));
    }
    return parts;
}

} // namespace resonform
