// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that have a value, f(x) = sqrt(1 + x^2), where others are known by their names only
// (model/text/named_function.hpp).
#pragma once

#include <ginac/ginac.h>

namespace resonform {

struct FunctionValue {
    GiNaC::symbol argument; // x, of the function alone
    GiNaC::ex value;        // in x and parameters

    // f(argument). GiNaC throws where it divides by zero.
    [[nodiscard]] GiNaC::ex at(const GiNaC::ex& of) const;
    // f'
    [[nodiscard]] FunctionValue slope() const;
};

} // namespace resonform
