// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/initial_values.hpp"

#include "algebra/ring/ring_copy.hpp"
#include "normalize/recursion/inverse_map.hpp"

#include <algorithm>
#include <utility>

namespace resonform {

namespace {

void build_ring(const Solution& solution, InitialValues& values) {
    RingBuilder builder(solution.ring->size() + static_cast<int>(solution.state.size()));
    RingCopy(*solution.ring, builder).copy_all();
    for (const SolutionOutput& state : solution.state) {
        Generator g;
        g.kind = GeneratorKind::constant;
        g.name = fresh_name(builder, state.name + "_0");
        values.start.push_back(builder.add(std::move(g)));
    }
    values.ring = builder.freeze();
}

// The solution at the start: T = 0, quadratures 0, the slow variable is its start value.
RingMap at_start(const Solution& solution, const RingPtr& ring) {
    std::vector<std::pair<GeneratorId, Polynomial>> zeros;
    if (solution.slow_time) zeros.emplace_back(*solution.slow_time, Polynomial());
    for (const Primitive& p : solution.primitives)
        if (p.kind == PrimitiveKind::quadrature) zeros.emplace_back(p.id, Polynomial());
    return RingMap::by_name(solution.ring, ring, std::move(zeros));
}

// Puts z = z_0, zbar = zbar_0 into polynomials of the normal form's ring.
class AtOldVariables {
public:
    AtOldVariables(const Solution& solution, const InitialValues& values)
        : solution_(solution), ring_(*values.ring), map_(RingMap::by_name(solution.ring, values.ring)) {
        const GradedField& field = *solution.normalization->normal_form.field;
        if (field.modes.empty()) return;
        const Mode& mode = field.modes.front();
        outer_ = {mode.z, mode.zbar};
        const auto start_of = [&](int derivative) {
            std::size_t k = 0;
            const std::string& name =
                field.first_order->states[field.first_order->index(mode.variable, derivative)].name;
            while (solution.state[k].name != name) ++k;
            return ring_.gen(values.start[k]);
        };
        const Polynomial period = ring_.power(map_((*solution.from_normal_form)(mode.omega)), -1);
        z_ = start_of(0) - ring_.multiply(ring_.imaginary(), ring_.multiply(period, start_of(1)));
        zbar_ = ring_.conjugate(z_);
    }

    [[nodiscard]] const Polynomial& z() const { return z_; }

    [[nodiscard]] Polynomial operator()(const Polynomial& p) const {
        const Ring& old = *solution_.normalization->normal_form.field->ring;
        std::vector<Polynomial> parts;
        for (const auto& [monomial, coefficient] : old.collect(p, outer_)) {
            Polynomial part = map_((*solution_.from_normal_form)(coefficient));
            if (!outer_.empty()) {
                part = ring_.multiply(part, ring_.power(z_, old.exponent(monomial, outer_[0])));
                part = ring_.multiply(part, ring_.power(zbar_, old.exponent(monomial, outer_[1])));
            }
            parts.push_back(std::move(part));
        }
        return sum(parts);
    }

private:
    const Solution& solution_;
    const Ring& ring_;
    RingMap map_;
    std::vector<GeneratorId> outer_;
    Polynomial z_, zbar_;
};

void fill_oscillator(const Solution& solution, const Polynomial& w, InitialValues& values) {
    const Ring& ring = *values.ring;
    const ModeSolution& mode = solution.modes.front();
    values.w_real = Rational(1) / 2 * (w + ring.conjugate(w));
    values.w_imaginary = ring.multiply(Rational(-1) / 2 * ring.imaginary(), w - ring.conjugate(w));
    const RingMap start = at_start(solution, values.ring);
    values.leading_scale = ring.multiply(start(solution.ring->gen(solution.eps)), start(mode.envelope));
    values.scale = ring.multiply(values.leading_scale, start(mode.factor.total(solution.truncation)));
    const GeneratorId c = *ring.find(solution.ring->generator(mode.amplitude).name);
    values.implicit = std::any_of(values.scale.terms().begin(), values.scale.terms().end(),
                                  [&](const Term& t) { return ring.exponent(t.monomial, c) != 0; });
}

} // namespace

InitialValues initial_values(const Solution& solution) {
    InitialValues values;
    build_ring(solution, values);
    const Normalization& normalization = *solution.normalization;
    const NearIdentityMap inverse = invert(normalization.normal_form, normalization.map);
    const AtOldVariables put(solution, values);
    if (!solution.modes.empty())
        fill_oscillator(solution, put.z() + put(inverse.mode.front().total(solution.truncation)), values);

    const RingMap start = at_start(solution, values.ring);
    for (std::size_t d = 0; d < solution.drift.size(); ++d) {
        const DriftSolution& drift = solution.drift[d];
        std::size_t k = 0;
        while (solution.state[k].name != solution.system().variables[drift.variable].name) ++k;
        const Polynomial without_constant =
            start(drift.value.total(solution.truncation) - solution.ring->gen(drift.constant));
        values.drift.push_back(values.ring->gen(values.start[k]) +
                               put(inverse.drift[d].total(solution.truncation)) - without_constant);
    }
    return values;
}

} // namespace resonform
