// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "normalize/recursion/normal_form.hpp"

namespace resonform {

// Refuses a normal form with a term that is neither proved to be zero nor to be there
// (normalize/recursion/undecided_term.hpp); the message shows the term.
void require_decided(const NormalForm& form);

} // namespace resonform
