// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/expansion/graded_field.hpp"

#include "algebra/number/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

namespace resonform {

std::vector<GeneratorId> GradedField::outer() const {
    std::vector<GeneratorId> list;
    for (const Mode& mode : modes) {
        list.push_back(mode.z);
        if (!mode.is_real()) list.push_back(mode.zbar);
    }
    for (const AngleVariable& angle : angles) list.push_back(angle.phase);
    list.push_back(eps);
    return list;
}

Polynomial GradedField::eigenvalue(const Mode& mode) const {
    if (mode.is_real()) return mode.growth;
    return mode.growth + ring->multiply(ring->imaginary(), mode.omega);
}

bool GradedField::is_semisimple() const {
    return std::all_of(basis.modes.begin(), basis.modes.end(),
                       [](const ModeShape& shape) { return shape.couplings.empty(); });
}

Polynomial GradedField::shift(std::size_t variable, int derivative) const {
    const std::size_t state = first_order->index(variable, derivative);
    for (std::size_t s = 0; s < basis.states.size(); ++s)
        if (basis.states[s] == state) return shifts[s];
    return {};
}

std::vector<int> GradedField::mode_weights() const {
    std::set<int, std::greater<>> weights;
    for (const Mode& mode : modes) weights.insert(ring->generator(mode.z).weight);
    return {weights.begin(), weights.end()};
}

Polynomial GradedField::linear_part(std::size_t k) const {
    Polynomial total = ring->multiply(eigenvalue(modes[k]), ring->gen(modes[k].z));
    for (const ModeCoupling& coupling : couplings(k))
        total = total + coupling.factor * ring->gen(modes[coupling.mode].z);
    return total;
}

FieldSeries evaluate_field(const GradedField& field, int through) {
    if (field.coefficients->expands_named() && field.coefficients->derivatives() < through)
        refuse(Reason::size,
               {"a field is expanded as far as its functions can be differentiated",
                fmt::format("weight {}, derivatives through {}", through, field.coefficients->derivatives()),
                "take the field with more derivatives",
                {}});
    SeriesRun run(*field.program);
    const Ring& ring = *field.ring;
    const auto set = [&](SeriesProgram::Node input, GeneratorId id, int weight) {
        run.set_input(input, weight, ring.generator(id).weight == weight ? ring.gen(id) : Polynomial());
    };
    FieldSeries result;
    for (int n = 0; n <= through; ++n) {
        for (const Mode& mode : field.modes) {
            set(mode.input, mode.z, n);
            if (!mode.is_real()) set(mode.input_conjugate, mode.zbar, n);
        }
        for (const SlowVariable& slow : field.slow)
            if (slow.driven) set(slow.input, slow.generator, n);
        run.advance(n);
    }
    for (const Mode& mode : field.modes) result.mode.push_back(run.series(mode.rate));
    for (const DriftVariable& drift : field.drift) result.drift.push_back(run.series(drift.rate));
    return result;
}

} // namespace resonform
