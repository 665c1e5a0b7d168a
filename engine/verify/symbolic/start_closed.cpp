// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/initial_values.hpp"
#include "verify/symbolic/map.hpp"
#include "verify/symbolic/start.hpp"

#include <algorithm>
#include <optional>

namespace resonform {

namespace {

class ClosedStart : public SymbolicStartFinder {
public:
    ClosedStart(const Solution& solution, const Scene& scene, const SymbolicRing& ring)
        : solution_(solution), system_(solution.system()), own_(ring),
          normal_form_(solution.normalization->normal_form.field->ring, ring.fix(), system_),
          map_(solution, normal_form_) {
        const auto physical = [&](std::size_t variable) {
            return scene.start_of(system_.variables[variable].name) != nullptr;
        };
        for (const ModeSolution& mode : solution.modes) oscillator_given_ = !physical(mode.variable);
        bool any = !solution.modes.empty() && !oscillator_given_;
        for (const DriftSolution& drift : solution.drift) {
            physical_drift_.push_back(physical(drift.variable));
            any = any || physical_drift_.back();
        }
        for (const Primitive& p : solution.primitives)
            arguments_.push_back(own_.fixed()(p.argument)); // of quadratures not used
        for (const ModeSolution& mode : solution.modes) {
            envelope_ = own_.fixed()(mode.envelope);
            factor_ = own_.fixed()(mode.factor.total(solution.truncation));
            const GradedField& field = *solution.normalization->normal_form.field;
            frequency_ = normal_form_.fixed()(field.modes.front().omega);
            for (const int derivative : {0, 1})
                shifts_.push_back(normal_form_.fixed()(field.shift(mode.variable, derivative)));
        }
        for (const DriftSolution& drift : solution.drift)
            mean_.push_back(own_.fixed()(drift.value.total(solution.truncation)));
        if (!any) return;
        values_ = initial_values(solution);
        ring_.emplace(values_.ring, own_.fix(), system_);
        const FixedRing& fixed = ring_->fixed();
        if (!solution.modes.empty()) {
            re_ = fixed(values_.w_real);
            im_ = fixed(values_.w_imaginary);
            leading_ = fixed(values_.leading_scale);
            scale_ = fixed(values_.scale);
        }
        for (const Polynomial& p : values_.drift) drift_.push_back(fixed.written_out(p));
        for (const SolutionOutput& state : solution.state)
            state_.push_back(own_.fixed()(state.value.total(state.value.through())));
        const GradedField& field = *solution.normalization->normal_form.field;
        for (const SolutionOutput& output : solution.state) {
            const State& state = field.first_order->state(output.name);
            state_shifts_.push_back(
                own_.fixed()((*solution.from_normal_form)(field.shift(state.variable, state.derivative))));
        }
    }

    [[nodiscard]] SymbolicStart at(const SymbolicInputs& inputs) const override {
        SymbolicValues<Wide> own = own_.constants(inputs);
        SymbolicStart start = found(inputs, own);
        if (start.status != Status::ok || solution_.modes.empty()) return start;
        bool holds = false;
        if (inputs.untaken.empty()) {
            holds = leads_back(inputs, start, own);
        } else {
            const SymbolicInputs blind = inputs.blind();
            own = own_.constants(blind);
            const SymbolicStart unseen = found(blind, own);
            holds = leads_back(blind, unseen, own);
        }
        if (!holds) start.status = Status::outside_domain;
        return start;
    }

private:
    SymbolicStart found(const SymbolicInputs& inputs, SymbolicValues<Wide>& own) const {
        SymbolicStart start;
        for (const SlowLaw& law : solution_.slow) {
            start.slow.push_back(inputs.start_of(name(law.variable)));
            own.set(law.generator, start.slow.back());
        }
        if (oscillator_given_) {
            const std::string& variable = name(solution_.modes.front().variable);
            start.amplitude = inputs.start_of("amplitude." + variable);
            start.angles = {inputs.start_of("phase." + variable)};
        }
        own_.set_roots(own);
        set_primitives(own);
        if (!ring_) {
            for (const DriftSolution& drift : solution_.drift)
                start.drifts.push_back(constant(inputs, name(drift.variable)));
            return start;
        }
        SymbolicValues<Wide> at_start = ring_->constants(inputs);
        for (std::size_t k = 0; k < solution_.slow.size(); ++k)
            at_start.set(twin(solution_.slow[k].generator), start.slow[k]);
        if (!ring_->set_roots(at_start)) start.status = Status::outside_domain;
        for (const Primitive& p : solution_.primitives) at_start.set(twin(p.id), own[p.id].re);
        set_states(inputs, start, own, at_start);
        if (!solution_.modes.empty() && !oscillator_given_) derive_oscillator(start, at_start);
        for (std::size_t k = 0; k < solution_.drift.size(); ++k)
            start.drifts.push_back(physical_drift_[k] ? SymbolicStart::Sum{value_of(drift_[k], at_start).re,
                                                                           scale_of(drift_[k], at_start)}
                                                      : constant(inputs, name(solution_.drift[k].variable)));
        return start;
    }

    // The conditions of emit/program/start_constants.cpp; own: all but the constants is set.
    [[nodiscard]] bool leads_back(const SymbolicInputs& inputs, const SymbolicStart& start,
                                  SymbolicValues<Wide>& own) const {
        own.set(solution_.modes.front().amplitude, start.amplitude);
        for (std::size_t k = 0; k < solution_.drift.size(); ++k)
            own.set(solution_.drift[k].constant, start.drifts[k].value);
        const Wide factor = value_of(factor_, own).re;
        SymbolicMap::Pair pair;
        pair.from_constants = oscillator_given_;
        pair.old.slow = pair.now.slow = start.slow;
        pair.now.modes = {(start.amplitude * value_of(envelope_, own).re * factor) *
                          unit(start.angles.front())};
        if (!oscillator_given_) pair.old.modes = {old_mode(inputs, pair.now)};
        for (std::size_t k = 0; k < solution_.drift.size(); ++k) {
            pair.drift.push_back({physical_drift_[k], inputs.start_of(name(solution_.drift[k].variable)),
                                  value_of(mean_[k], own).re});
            for (const SymbolicTerm& term : mean_[k])
                pair.drift.back().terms.push_back(value_of({term}, own).re);
        }
        return SymbolicMap::is_close_to_one(factor, inputs) && map_.leads_back(pair, inputs);
    }

    // (psi_0 - i psi'_0/omega)/eps
    [[nodiscard]] WideComplex old_mode(const SymbolicInputs& inputs, const SymbolicStartValues& now) const {
        SymbolicValues<Wide> values = normal_form_.constants(inputs);
        map_.set(values, inputs.eps, now);
        const std::string& variable = name(solution_.modes.front().variable);
        return {(inputs.start_of(variable) - value_of(shifts_[0], values).re) / inputs.eps,
                -(inputs.start_of(variable + "'") - value_of(shifts_[1], values).re) /
                    (inputs.eps * value_of(frequency_, values).re)};
    }

    [[nodiscard]] const std::string& name(std::size_t variable) const {
        return system_.variables[variable].name;
    }
    static SymbolicStart::Sum constant(const SymbolicInputs& inputs, const std::string& variable) {
        const Wide value = inputs.start_of("constant." + variable);
        return {value, abs(value)};
    }
    // A generator of the solution's ring in that of the start values.
    [[nodiscard]] GeneratorId twin(GeneratorId id) const {
        return *ring_->ring().find(own_.ring().generator(id).name);
    }

    // At T = 0 quadratures vanish.
    void set_primitives(SymbolicValues<Wide>& own) const {
        if (solution_.slow_time) own.set(*solution_.slow_time, 0);
        for (std::size_t k = 0; k < solution_.primitives.size(); ++k) {
            const Primitive& p = solution_.primitives[k];
            Wide value = 0;
            if (p.kind != PrimitiveKind::quadrature) {
                const Wide argument = value_of(arguments_[k], own).re;
                value = p.kind == PrimitiveKind::logarithm ? logarithm(argument) : Wide(exp(argument));
            }
            own.set(p.id, value);
        }
    }

    // Those of an oscillator that is given by its constants are the solution at t = 0.
    void set_states(const SymbolicInputs& inputs, const SymbolicStart& start, SymbolicValues<Wide>& own,
                    SymbolicValues<Wide>& at_start) const {
        const FirstOrderSystem& system = *solution_.normalization->normal_form.field->first_order;
        if (oscillator_given_) {
            const ModeSolution& mode = solution_.modes.front();
            own.set(mode.amplitude, start.amplitude);
            own.set(mode.phase, unit(start.angles.front()), 1);
            at_start.set(twin(mode.amplitude), start.amplitude);
        }
        for (std::size_t k = 0; k < solution_.state.size(); ++k) {
            const std::size_t variable = system.state(solution_.state[k].name).variable;
            const bool from_constants = oscillator_given_ && variable == solution_.modes.front().variable;
            const Wide value =
                from_constants ? value_of(state_[k], own).re : inputs.start_of(solution_.state[k].name);
            at_start.set(values_.start[k], value - value_of(state_shifts_[k], own).re);
        }
    }

    // M + 1 substitutions, each of which gains a power of eps.
    void derive_oscillator(SymbolicStart& start, SymbolicValues<Wide>& at_start) const {
        const Wide re = value_of(re_, at_start).re, im = value_of(im_, at_start).re;
        start.angles = {atan2(im, re)};
        const Wide radius = sqrt(re * re + im * im);
        const GeneratorId c = twin(solution_.modes.front().amplitude);
        start.amplitude = radius / value_of(leading_, at_start).re;
        const int substitutions = values_.implicit ? solution_.truncation + 1 : 1;
        for (int step = 0; step < substitutions; ++step) {
            at_start.set(c, start.amplitude);
            start.amplitude = radius / value_of(scale_, at_start).re;
        }
        at_start.set(c, start.amplitude);
    }

    const Solution& solution_;
    const System& system_;
    const SymbolicRing& own_;
    SymbolicRing normal_form_;
    SymbolicMap map_;
    std::optional<SymbolicRing> ring_; // with start values; none: everything is given by constants
    InitialValues values_;
    bool oscillator_given_ = false;
    std::vector<bool> physical_drift_;
    SymbolicSum re_, im_, leading_, scale_;
    std::vector<SymbolicSum> drift_, state_, arguments_;
    SymbolicSum envelope_, factor_, frequency_;
    std::vector<SymbolicSum> shifts_;       // of position and velocity of the oscillator, by its equilibrium
    std::vector<SymbolicSum> state_shifts_; // of all states, in the ring of the solution
    std::vector<SymbolicSum> mean_;         // of drifts
};

} // namespace

std::unique_ptr<SymbolicStartFinder> closed_start(const Solution& solution, const Scene& scene,
                                                  const SymbolicRing& ring) {
    return std::make_unique<ClosedStart>(solution, scene, ring);
}

} // namespace resonform
