// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/route.hpp"

#include "algebra/ring/constant.hpp"
#include "solve/quadrature.hpp"

#include <algorithm>

namespace resonform {

std::optional<SlowPath> explicit_law(const GradedField& field, const SlowVariable& slow) {
    const Ring& ring = *field.ring;
    const auto rate = quotient_in_ring(ring, slow.rate, ring.gen(field.eps));
    if (slow.driven || !rate) return std::nullopt;
    auto path = slow_path(ring, slow.generator, *rate);
    if (path && !(is_constant(ring, path->drive) && is_constant(ring, path->decline))) path.reset();
    return path;
}

bool solves_by_quadratures(const GradedField& field) {
    const bool small = std::all_of(field.modes.begin(), field.modes.end(), [&](const Mode& mode) {
        return mode.oscillator && field.ring->generator(mode.z).weight == 1;
    });
    bool functions = false;
    for (GeneratorId id = 0; id < field.ring->size(); ++id)
        if (field.ring->generator(id).kind == GeneratorKind::function) functions = true;
    // Closed solutions are power series in eps with coefficients in T = eps t: of whole powers.
    return field.system().eps_root == 1 && field.modes.size() <= 1 && small && !functions &&
           field.angles.empty() && field.slow.size() <= 1 &&
           std::all_of(field.slow.begin(), field.slow.end(),
                       [&](const SlowVariable& slow) { return explicit_law(field, slow).has_value(); }) &&
           field.system().style != Style::hamiltonian &&
           cln::zerop(field.system().near); // a monomial kept by `near` is not resonant, and has a phase
}

} // namespace resonform
