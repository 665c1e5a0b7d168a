// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/text/function_slope.hpp"

#include "model/text/expression.hpp"

namespace resonform {

GiNaC::ex slope_of(Function f, const GiNaC::ex& u) {
    Scope scope;
    scope.define("u", u);
    return read_expression(row_of(f).slope, scope, {});
}

} // namespace resonform
