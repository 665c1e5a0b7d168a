// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/modes/modes.hpp"

namespace resonform {

bool ModalBasis::is_oscillator(std::size_t mode, const FirstOrderSystem& system) const {
    const ModeShape& shape = modes[mode];
    const State& pivot = system.states[shape.pivot];
    if (numeric || shape.is_real() || !shape.eigenvalue.re.is_zero() ||
        system.system->variables[pivot.variable].order != 2)
        return false;
    for (std::size_t s = 0; s < states.size(); ++s) {
        Complex rest = shape.row[s];
        if (states[s] == shape.pivot) {
            rest.re -= 1;
        } else if (system.states[states[s]].variable == pivot.variable) {
            rest.im = rest.im * shape.eigenvalue.im + 1;
        } else if (!shape.column[s].is_zero()) {
            return false;
        }
        if (!rest.is_zero()) return false;
    }
    return true;
}

} // namespace resonform
