// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ginac/ginac.h>

namespace resonform {

// e with every key of `values` replaced by its value, all at once; keys are symbols, not patterns.
inline GiNaC::ex put(const GiNaC::ex& e, const GiNaC::exmap& values) {
    return e.subs(values, GiNaC::subs_options::no_pattern);
}

} // namespace resonform
