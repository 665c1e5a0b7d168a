// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/solution.hpp"

#include <algorithm>

namespace resonform {

std::optional<int> first_oscillation(const Solution& solution, const std::string& output) {
    if (solution.flow)
        return first_oscillation(*solution.normalization->normal_form.field, *solution.flow, output);
    if (solution.modes.empty()) return std::nullopt;
    const GeneratorId phase = solution.modes.front().phase;
    for (const SolutionOutput& o : solution.outputs)
        for (int n = 0; o.name == output && n <= o.value.through(); ++n)
            for (const Term& term : o.value.part(n).terms())
                if (solution.ring->exponent(term.monomial, phase) != 0) return n;
    return std::nullopt;
}

} // namespace resonform
