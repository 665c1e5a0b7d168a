// SPDX-License-Identifier: GPL-3.0-or-later
// Every function and operation that a tape knows, each once.
#pragma once

#include "model/text/function_call.hpp"

#include <ginac/ginac.h>

#include <vector>

namespace resonform::test {

struct FunctionCase {
    const char* name;
    GiNaC::ex (*make)(const GiNaC::ex& u);
};

// u runs through 0.3 + t: inside every domain, and no function is at a special point.
inline const std::vector<FunctionCase>& function_cases() {
    static const std::vector<FunctionCase> cases{
        {"sum and product",
         [](const GiNaC::ex& u) -> GiNaC::ex { return (3 * u - 2) * (1 - 5 * u * u) + u; }},
        {"quotient", [](const GiNaC::ex& u) -> GiNaC::ex { return (1 - u) / (2 + u * u); }},
        {"integer power", [](const GiNaC::ex& u) -> GiNaC::ex { return pow(u - 2, 7) + pow(u, -3); }},
        {"square root", [](const GiNaC::ex& u) -> GiNaC::ex { return sqrt(1 + u * u); }},
        {"rational power", [](const GiNaC::ex& u) -> GiNaC::ex { return pow(1 + u, GiNaC::numeric(-5, 3)); }},
        {"general power", [](const GiNaC::ex& u) -> GiNaC::ex { return pow(1 + u, sin(u)); }},
        {"sin", [](const GiNaC::ex& u) -> GiNaC::ex { return sin(2 * u); }},
        {"cos", [](const GiNaC::ex& u) -> GiNaC::ex { return cos(u * u); }},
        {"tan", [](const GiNaC::ex& u) -> GiNaC::ex { return tan(u); }},
        {"exp", [](const GiNaC::ex& u) -> GiNaC::ex { return exp(-u * u); }},
        {"log", [](const GiNaC::ex& u) -> GiNaC::ex { return log(1 + 3 * u); }},
        {"sinh", [](const GiNaC::ex& u) -> GiNaC::ex { return sinh(u); }},
        {"cosh", [](const GiNaC::ex& u) -> GiNaC::ex { return cosh(2 * u); }},
        {"tanh", [](const GiNaC::ex& u) -> GiNaC::ex { return tanh(u); }},
        {"asin", [](const GiNaC::ex& u) -> GiNaC::ex { return asin(u); }},
        {"acos", [](const GiNaC::ex& u) -> GiNaC::ex { return acos(u / 2); }},
        {"atan", [](const GiNaC::ex& u) -> GiNaC::ex { return atan(3 * u); }},
        {"asinh", [](const GiNaC::ex& u) -> GiNaC::ex { return asinh(2 * u); }},
        {"acosh", [](const GiNaC::ex& u) -> GiNaC::ex { return acosh(1 + u); }},
        {"atanh", [](const GiNaC::ex& u) -> GiNaC::ex { return atanh(u); }},
        {"erf", [](const GiNaC::ex& u) -> GiNaC::ex { return call(Function::error_function, 2 * u); }},
        {"pi and a large rational",
         [](const GiNaC::ex& u) -> GiNaC::ex {
             return GiNaC::Pi * u + GiNaC::numeric("123456789123456789/7");
         }},
    };
    return cases;
}

} // namespace resonform::test
