// SPDX-License-Identifier: GPL-3.0-or-later
// The one table of elementary functions: whoever reads, bounds, differentiates, encloses or prints one asks
// it.
#pragma once

#include <arb.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace resonform {

enum class Function {
    exponential, // in this order generators of one argument stand in a ring
    sine,
    cosine,
    logarithm,
    arc_tangent,
    tangent,
    hyperbolic_sine,
    hyperbolic_cosine,
    hyperbolic_tangent,
    arc_sine,
    arc_cosine, // pi/2 - asin(u) from the moment it is read
    inverse_hyperbolic_sine,
    inverse_hyperbolic_cosine,
    inverse_hyperbolic_tangent,
    error_function,
    named // no row: known by its name only, omega(tau)
};

enum class Parity { none, even, odd };

// The real u for which a function is real. On the boundary its slope is infinite.
enum class Argument { any, not_a_pole, positive, within_one, inside_one, at_least_one };

struct FunctionRow {
    Function function;
    std::string_view name;  // in files and answers, in Python and Maxima
    std::string_view latex; // the macro
    Parity parity;
    Argument argument;
    // Rational bounds of its values, as text; empty: none.
    std::string_view low, high;
    bool keeps_sign; // f(u) has the sign of u
    // f'(u), by which the function is expanded; empty: an addition theorem expands it.
    std::string_view slope;
    void (*enclose)(arb_t value, const arb_t argument, slong bits);
};

const std::vector<FunctionRow>& function_rows();
const FunctionRow& row_of(Function function);                   // precondition: not `named`
std::optional<Function> function_called(std::string_view name); // nullopt: there is no row of that name

} // namespace resonform
