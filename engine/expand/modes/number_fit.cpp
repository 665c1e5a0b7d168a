// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/modes/number_fit.hpp"

#include "model/text/diagnostic.hpp"

namespace resonform {

std::optional<Diagnostic> hindrance_to_numbers(const System& system) {
    const Place file = whole_file(system.file);
    if (!system.functions.empty())
        return Diagnostic{"with --digits every function has values", system.functions.front().name,
                          "leave out --digits", file};
    for (const Variable& v : system.variables)
        if (v.role == Role::slow)
            return Diagnostic{
                "with --digits coefficients are numbers, and do not depend on slow variables", v.name,
                "leave out --digits, or freeze the variable: make it a parameter and set it", v.place};
    if (system.style != Style::poincare)
        return Diagnostic{"coefficients in numbers go with style poincare", to_string(system.style),
                          "leave out --digits", file};
    return std::nullopt;
}

} // namespace resonform
