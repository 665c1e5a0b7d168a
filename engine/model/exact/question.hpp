// SPDX-License-Identifier: GPL-3.0-or-later
// Is an expression zero, or positive, in the domain of a system? Asked once more in exact form
// (exact_form.hpp), where two spellings of the same functions and roots become the same polynomial.
//
//   is (1 - w)^(3/2) - (1 - w)^(1/2) + w*(1 - w)^(1/2) zero?           yes
//   is 1 - tau^2*(4*cos(tau)^3 - 3*cos(tau)) positive?                 as 1 - tau^2*cos(3*tau) is, if
//   declared
#pragma once

#include "model/system/system_file.hpp"
#include "model/text/zero_test.hpp"

#include <optional>

namespace resonform {

// In the domain of the system; where vanishes(e) does not know, by the relations of functions and roots.
Zero vanishes(const GiNaC::ex& e, const System& system);

// Something of the same sign as e and a system in whose domain it is asked: what is declared positive is
// written in the same exact form.
struct ExactQuestion {
    System domain;
    GiNaC::ex asked;
};

// nullopt: the exact form tells no more than e does, or there is none.
std::optional<ExactQuestion> exact_question(const GiNaC::ex& e, const System& system);

} // namespace resonform
