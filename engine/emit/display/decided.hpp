// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "normalize/recursion/normal_form.hpp"

namespace resonform {

// Refuses a normal form with a term that is proved neither zero nor nonzero
// (normalize/recursion/undecided_term.hpp); the message shows the term.
void require_decided(const NormalForm& form);

} // namespace resonform
