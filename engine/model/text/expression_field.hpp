// SPDX-License-Identifier: GPL-3.0-or-later
// The arithmetic of expressions for algebra/number/elimination.hpp. Which zero test chooses the pivots, and
// when a pivot is good enough, is up to whoever derives from it.
#pragma once

#include <ginac/ginac.h>

#include <optional>

namespace resonform {

struct ExpressionField {
    static bool is_zero(const GiNaC::ex& a) { return a.is_zero(); }
    static bool settles(const GiNaC::ex& /*a*/) { return true; }
    static std::optional<GiNaC::ex> divisor(const GiNaC::ex& a) { return a; }
    static GiNaC::ex over(const GiNaC::ex& a, const GiNaC::ex& b) { return (a / b).normal(); }
    static GiNaC::ex without(const GiNaC::ex& a, const GiNaC::ex& factor, const GiNaC::ex& b) {
        return (a - factor * b).normal();
    }
};

} // namespace resonform
