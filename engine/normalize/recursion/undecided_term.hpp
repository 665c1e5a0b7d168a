// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the terms of a normal form are nonzero: over a ring without unique forms (Ring::is_canonical) a
// coefficient may be zero by an identity that no relation of the ring shows, atan(a) + atan(1/a) - pi/2.
#pragma once

#include "normalize/recursion/normal_form.hpp"

#include <optional>

namespace resonform {

struct UndecidedTerm {
    std::string rate; // "z1'"
    Monomial monomial;
    Polynomial coefficient; // neither proved to be zero nor to be different from zero somewhere
};

// The first one, by variables and by weight; nullopt: every term is proved nonzero.
std::optional<UndecidedTerm> undecided_term(const NormalForm& form);

} // namespace resonform
