// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/functions.hpp"

#include <arb_hypgeom.h>

#include <algorithm>

namespace resonform {

const std::vector<FunctionRow>& function_rows() {
    using F = Function;
    using P = Parity;
    using A = Argument;
    static const std::vector<FunctionRow> rows = {
        // 11/7 is a little more than pi/2
        {F::sine, "sin", "\\sin", P::odd, A::any, "-1", "1", false, "", arb_sin},
        {F::cosine, "cos", "\\cos", P::even, A::any, "-1", "1", false, "", arb_cos},
        {F::tangent, "tan", "\\tan", P::odd, A::not_a_pole, "", "", false, "", arb_tan},
        {F::exponential, "exp", "\\exp", P::none, A::any, "0", "", false, "", arb_exp},
        {F::logarithm, "log", "\\ln", P::none, A::positive, "", "", false, "1/u", arb_log},
        {F::hyperbolic_sine, "sinh", "\\sinh", P::odd, A::any, "", "", true, "", arb_sinh},
        {F::hyperbolic_cosine, "cosh", "\\cosh", P::even, A::any, "1", "", false, "", arb_cosh},
        {F::hyperbolic_tangent, "tanh", "\\tanh", P::odd, A::any, "-1", "1", true, "", arb_tanh},
        {F::arc_sine, "asin", "\\arcsin", P::odd, A::within_one, "-11/7", "11/7", true, "(1 - u^2)^(-1/2)",
         arb_asin},
        {F::arc_cosine, "acos", "\\arccos", P::none, A::within_one, "0", "22/7", false, "-(1 - u^2)^(-1/2)",
         arb_acos},
        {F::arc_tangent, "atan", "\\arctan", P::odd, A::any, "-11/7", "11/7", true, "1/(1 + u^2)", arb_atan},
        {F::inverse_hyperbolic_sine, "asinh", "\\operatorname{arsinh}", P::odd, A::any, "", "", true,
         "(1 + u^2)^(-1/2)", arb_asinh},
        {F::inverse_hyperbolic_cosine, "acosh", "\\operatorname{arcosh}", P::none, A::at_least_one, "0", "",
         false, "(u^2 - 1)^(-1/2)", arb_acosh},
        {F::inverse_hyperbolic_tangent, "atanh", "\\operatorname{artanh}", P::odd, A::inside_one, "", "",
         true, "1/(1 - u^2)", arb_atanh},
        {F::error_function, "erf", "\\operatorname{erf}", P::odd, A::any, "-1", "1", true,
         "2*pi^(-1/2)*exp(-u^2)", arb_hypgeom_erf},
    };
    return rows;
}

const FunctionRow& row_of(Function function) {
    const std::vector<FunctionRow>& rows = function_rows();
    return *std::find_if(rows.begin(), rows.end(),
                         [&](const FunctionRow& row) { return row.function == function; });
}

std::optional<Function> function_called(std::string_view name) {
    for (const FunctionRow& row : function_rows())
        if (row.name == name) return row.function;
    return std::nullopt;
}

} // namespace resonform
