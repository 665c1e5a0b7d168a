// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/flow_start.hpp"
#include "normalize/recursion/inverse_map.hpp"
#include "solve/first_correction.hpp"
#include "solve/small_divisors.hpp"
#include "verify/symbolic/map.hpp"
#include "verify/symbolic/margins.hpp"
#include "verify/symbolic/start.hpp"

#include <algorithm>
#include <optional>

namespace resonform {

namespace {

class FlowStart : public SymbolicStartFinder {
public:
    FlowStart(const Solution& solution, const Scene& scene, const SymbolicRing& ring)
        : field_(*solution.normalization->normal_form.field), ring_(ring), map_(solution, ring) {
        const Normalization& normalization = *solution.normalization;
        const System& system = solution.system();
        for (const std::size_t s : field_.basis.states)
            if (scene.start_of(name(field_.first_order->states[s].variable)) != nullptr) physical_ = true;
        physical_ = physical_ || field_.basis.states.empty() || scene.at_zero;
        for (const MovingDivisor& moving : moving_divisors_at_start(normalization))
            layers_.push_back({ring_.fixed()(moving.divisor), ring_.fixed()(moving.rate)});
        for (FirstCorrection& correction : transient_corrections(solution)) {
            std::vector<SymbolicSum> polynomials;
            for (const Polynomial& p : correction.polynomials()) polynomials.push_back(ring_.fixed()(p));
            corrections_.push_back({std::move(correction), std::move(polynomials)});
        }
        for (const DriftVariable& drift : field_.drift)
            physical_drift_.push_back(scene.start_of(drift.name) != nullptr);
        inverts_ = physical_ && !scene.at_zero && starts_by_inverse_map(solution);
        if (!inverts_)
            for (const SubstitutionStep& step : start_substitutions(solution, physical_))
                substitutions_.push_back(map_.shifts(normalization.map, step));
        if (!physical_) return;
        if (scene.at_zero) {
            const auto& states = field_.basis.states;
            for (std::size_t k = 0; k < field_.modes.size(); ++k)
                for (std::size_t s = 0; solution.flow->modes[k].is_at_zero && s < states.size(); ++s)
                    if (field_.first_order->states[states[s]].name == scene.at_zero->state) solved_ = {k, s};
        }
        if (inverts_) inverse_ = map_.shifts(invert(normalization.normal_form, normalization.map));
        for (const Polynomial& shift : field_.shifts) shifts_.push_back(ring_.fixed()(shift));
        for (std::size_t k = 0; k < field_.modes.size(); ++k) {
            const Place place = place_of(system.equations[field_.modes[k].variable].source);
            rows_.emplace_back();
            for (const Complex& entry : field_.basis.modes[k].row)
                rows_.back().push_back(entry.is_zero()
                                           ? SymbolicSum{}
                                           : ring_.fixed()(field_.coefficients->convert(entry, place)));
        }
    }

    [[nodiscard]] SymbolicStart at(const SymbolicInputs& inputs) const override {
        SymbolicMap::Pair pair, blind;
        SymbolicStart start = found(inputs, pair);
        if (start.status != Status::ok) return start;
        if (!inputs.untaken.empty()) found(inputs.blind(), blind);
        if (!map_.leads_back(inputs.untaken.empty() ? pair : blind, inputs))
            start.status = Status::outside_domain;
        return start;
    }

private:
    SymbolicStart found(const SymbolicInputs& inputs, SymbolicMap::Pair& pair) const {
        SymbolicStart start;
        SymbolicValues<Wide> values = ring_.constants(inputs);
        SymbolicStartValues &old = pair.old, &now = pair.now;
        pair.from_constants = !physical_;
        for (const SlowVariable& slow : field_.slow) old.slow.push_back(inputs.start_of(slow.name));
        for (const AngleVariable& angle : field_.angles) old.angles.push_back(inputs.start_of(angle.name));
        const auto put = [&](const SymbolicStartValues& at) {
            if (!map_.set(values, ring_.small(inputs), at)) start.status = Status::outside_domain;
        };
        if (physical_) {
            old.modes.resize(field_.modes.size());
            put(old);
            for (std::size_t k = 0; k < field_.modes.size(); ++k) old.modes[k] = mode(k, inputs, values);
            if (solved_) settle(old, 0, values);
            put(old);
        } else {
            for (const Mode& mode : field_.modes) {
                const std::string& variable = name(mode.variable);
                old.modes.push_back(inputs.start_of("amplitude." + variable) *
                                    unit(inputs.start_of("phase." + variable)));
            }
        }
        if (inverts_) {
            now = map_.moved(old, inverse_, values, ring_.small(inputs), 1);
        } else {
            now = old;
            if (solved_) now.modes[solved_->mode] = {};
            for (const SymbolicMap::Shifts& by : substitutions_)
                substitute(old, by, values, inputs, now, put);
        }
        put(now);
        for (const SymbolicLayer& layer : layers_)
            for (const Wide& margin : layer.margins(values))
                if (!(margin > 0)) start.status = Status::outside_domain;
        if (!corrects_little(now.modes, values, ring_.small(inputs))) start.status = Status::outside_domain;
        start.modes = now.modes;
        for (std::size_t k = 0; k < now.modes.size(); ++k)
            start.mode_spreads.push_back(physical_ ? spread(k, pair, inputs, values) : Wide(1));
        start.angles = now.angles;
        start.slow = now.slow;
        for (std::size_t k = 0; k < field_.drift.size(); ++k)
            start.drifts.push_back(drift(k, inputs, values));
        return start;
    }

    // Whether the first corrections in which modes decay are as small at the start as the others are for
    // ever.
    [[nodiscard]] bool corrects_little(const std::vector<WideComplex>& modes,
                                       const SymbolicValues<Wide>& values, const Wide& eps) const {
        std::vector<Wide> moduli;
        for (const WideComplex& mode : modes) moduli.push_back(mode.size());
        return std::all_of(corrections_.begin(), corrections_.end(), [&](const auto& entry) {
            return margin_of(entry.first, entry.second, values, eps, moduli) > 0;
        });
    }

    // Of modes those of lower weight first, as in emitted code: products of them may be as heavy as a mode in
    // whose map they stand. Slow variables and angles go with the first.
    template <class Put>
    void substitute(SymbolicStartValues& old, const SymbolicMap::Shifts& by,
                    const SymbolicValues<Wide>& values, const SymbolicInputs& inputs,
                    SymbolicStartValues& now, const Put& put) const {
        std::vector<int> weights = field_.mode_weights();
        if (weights.empty() || !physical_) weights = {0};
        for (auto weight = weights.rbegin(); weight != weights.rend(); ++weight) {
            put(now);
            SymbolicStartValues next = map_.moved(old, by, values, ring_.small(inputs), -1);
            if (solved_ && weight_of(solved_->mode) == *weight) {
                settle(old, (old.modes[solved_->mode] - next.modes[solved_->mode]).re, values);
                next = map_.moved(old, by, values, ring_.small(inputs), -1);
                next.modes[solved_->mode] = {};
            }
            for (std::size_t k = 0; physical_ && k < now.modes.size(); ++k)
                if (weight_of(k) == *weight) now.modes[k] = next.modes[k];
            if (weight != weights.rbegin()) continue;
            now.angles = std::move(next.angles);
            now.slow = std::move(next.slow);
        }
    }

    // Moves the state that is not given until the old mode has this value.
    void settle(SymbolicStartValues& old, const Wide& wanted, const SymbolicValues<Wide>& values) const {
        const auto entry = [&](std::size_t k) { return value_of(rows_[k][solved_->state], values); };
        const Wide by = (wanted - old.modes[solved_->mode].re) / entry(solved_->mode).re;
        for (std::size_t k = 0; k < old.modes.size(); ++k)
            if (!rows_[k][solved_->state].empty()) old.modes[k] = old.modes[k] + by * entry(k);
    }

    [[nodiscard]] int weight_of(std::size_t mode) const {
        return field_.ring->generator(field_.modes[mode].z).weight;
    }
    [[nodiscard]] const std::string& name(std::size_t variable) const {
        return field_.system().variables[variable].name;
    }

    // row * state, over eps^weight: the terms of a mode.
    [[nodiscard]] std::vector<WideComplex> terms_of(std::size_t k, const SymbolicInputs& inputs,
                                                    const SymbolicValues<Wide>& values) const {
        std::vector<WideComplex> terms;
        for (std::size_t s = 0; s < rows_[k].size(); ++s) {
            if (rows_[k][s].empty() || (solved_ && s == solved_->state)) continue;
            const std::string& state = field_.first_order->states[field_.basis.states[s]].name;
            const Wide measured = inputs.start_of(state) - value_of(shifts_[s], values).re;
            terms.push_back((measured / map_.scale_of_mode(k, ring_.small(inputs))) *
                            value_of(rows_[k][s], values));
        }
        return terms;
    }

    [[nodiscard]] WideComplex mode(std::size_t k, const SymbolicInputs& inputs,
                                   const SymbolicValues<Wide>& values) const {
        WideComplex sum;
        for (const WideComplex& term : terms_of(k, inputs, values)) sum = sum + term;
        return sum;
    }

    [[nodiscard]] Wide spread(std::size_t k, const SymbolicMap::Pair& pair, const SymbolicInputs& inputs,
                              const SymbolicValues<Wide>& values) const {
        Wide squares = 0;
        WideComplex left = pair.old.modes[k]; // of the state that is not given
        for (const WideComplex& term : terms_of(k, inputs, values)) {
            squares += term.size() * term.size();
            left = left - term;
        }
        if (solved_) squares += left.size() * left.size();
        const Wide norm = sqrt(squares), size = pair.now.modes[k].size();
        return size > 0 && norm > size ? Wide(norm / size) : Wide(1);
    }

    [[nodiscard]] SymbolicStart::Sum drift(std::size_t k, const SymbolicInputs& inputs,
                                           const SymbolicValues<Wide>& values) const {
        const std::string& variable = field_.drift[k].name;
        const Wide begin = inputs.start_of(physical_drift_[k] ? variable : "constant." + variable);
        if (!physical_drift_[k]) return {begin, abs(begin)};
        return {begin - value_of(map_.map().drift[k], values).re,
                abs(begin) + scale_of(map_.map().drift[k], values)};
    }

    const GradedField& field_;
    const SymbolicRing& ring_;
    bool physical_ = false, inverts_ = false;
    struct Solved {
        std::size_t mode, state;
    };
    std::optional<Solved> solved_; // the mode that is 0, and the state that is not given
    std::vector<bool> physical_drift_;
    std::vector<SymbolicLayer> layers_;                                             // of transients
    std::vector<std::pair<FirstCorrection, std::vector<SymbolicSum>>> corrections_; // and theirs
    SymbolicMap map_;
    SymbolicMap::Shifts inverse_;
    std::vector<SymbolicMap::Shifts> substitutions_;
    std::vector<std::vector<SymbolicSum>> rows_;
    std::vector<SymbolicSum> shifts_; // of the states
};

} // namespace

std::unique_ptr<SymbolicStartFinder> flow_start_finder(const Solution& solution, const Scene& scene,
                                                       const SymbolicRing& ring) {
    return std::make_unique<FlowStart>(solution, scene, ring);
}

} // namespace resonform
