// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/exact/invertible.hpp"

#include "algebra/number/error.hpp"
#include "model/signs/sign_prover.hpp"

namespace resonform {

GiNaC::ex determinant_of_slopes(const std::vector<GiNaC::ex>& values,
                                const std::vector<GiNaC::symbol>& variables) {
    const auto n = static_cast<unsigned>(values.size());
    GiNaC::matrix slopes(n, n);
    for (unsigned r = 0; r < n; ++r)
        for (unsigned c = 0; c < n; ++c) slopes(r, c) = values[r].diff(variables[c]);
    return slopes.determinant();
}

void require_invertible(const GiNaC::ex& determinant_there, ExactForm& form, const System& domain,
                        const Place& place) {
    const Zero zero = form.vanishes(determinant_there);
    if (zero == Zero::yes)
        bad_input({"a change of variables is invertible where the equations are expanded",
                   "the determinant of its derivatives is zero at the origin of the new variables",
                   "correct it, or choose another origin", place});
    if (zero == Zero::unknown && !provably_nonzero(determinant_there, domain))
        refuse(Reason::undecided,
               {"a change of variables is seen to be invertible",
                "the determinant of its derivatives can be told neither zero nor nonzero",
                "write it in a plainer form, or declare what it is made of nonzero", place});
}

} // namespace resonform
