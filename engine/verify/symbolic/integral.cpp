// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/symbolic/integral.hpp"

#include "runtime/flow.hpp"
#include "verify/run/spline.hpp"
#include "verify/symbolic/propagation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace resonform {

namespace {

using Of = SymbolicVariable::Kind;

bool is_complex(const SymbolicVariable& v) { return v.kind == Of::mode; }

template <class Number> class Integral : public SymbolicIntegral {
public:
    using Values = std::vector<Number>;

    Integral(const SymbolicFrame& frame, std::size_t most_panels)
        : frame_(frame), most_panels_(most_panels), rates_(frame.variables.size()),
          factors_(frame.variables.size()) {
        for (const auto* stage : {&frame.flow, &frame.along})
            for (const std::size_t k : *stage) {
                const SymbolicVariable& v = variable(k);
                rates_[k] = MovingSum<Number>(v.rate, frame.constants, frame.moves);
                factors_[k] = narrowed<Number>(Wide(1 / math::power(frame.small, v.power)));
            }
    }

    Status build_flow(const GoesOn& goes_on, Wide& reach) override {
        return build(frame_.flow, flow_, goes_on, reach);
    }
    Status build_along(Wide& reach) override { return build(frame_.along, along_, nullptr, reach); }

    void move_to(const Wide& T, SymbolicMoment<Wide>& moment) const override {
        const Number at = narrowed<Number>(T);
        if (flow_) take(frame_.flow, (*flow_)(at), moment);
        if (along_) take(frame_.along, (*along_)(at), moment);
        moment.move_to(frame_, T);
    }

    void propagate(const Wide& reach) override {
        if constexpr (std::is_same_v<Number, Float128>) { // else there is no flow
            if (!flow_) return;
            const Rates rates{*this, frame_.flow, SymbolicMoment<Number>(frame_)};
            propagation_.emplace(SymbolicPropagation::Flow{[this](const Float128& T) { return (*flow_)(T); },
                                                           rates,
                                                           [rates](const Float128& T, const Values& y) {
                                                               return rates.scale(T, y);
                                                           }},
                                 narrowed<Float128>(reach));
        }
    }

    [[nodiscard]] std::vector<Beyond> beyond(const SymbolicMoment<Wide>& at, const Wide& T) const override {
        std::vector<Beyond> result;
        if (!propagation_) return result;
        const std::vector<long double> scales = (*propagation_)(narrowed<Float128>(T));
        auto part = scales.begin();
        for (const std::size_t k : frame_.flow) {
            const bool both = is_complex(variable(k));
            const long double re = *part++, im = both ? *part++ : 0, whole = std::hypot(re, im);
            const Wide size = at.now[k].size();
            if (!(Wide(whole) > size)) continue;
            const Wide share = 1 - size / Wide(whole);
            result.push_back({k, false, share * Wide(re)});
            if (both) result.push_back({k, true, share * Wide(im)});
        }
        return result;
    }

private:
    using Table = std::optional<FlowTable<Values>>;

    [[nodiscard]] const SymbolicVariable& variable(std::size_t k) const {
        return frame_.solution->variables()[k];
    }

    template <class Other>
    void take(const std::vector<std::size_t>& stage, const Values& y, SymbolicMoment<Other>& at) const {
        const auto as_other = [](const Number& x) {
            if constexpr (std::is_same_v<Other, Number>)
                return x;
            else
                return widened(x);
        };
        std::size_t next = 0;
        for (const std::size_t k : stage) {
            at.now[k].re = as_other(y[next++]);
            if (is_complex(variable(k))) at.now[k].im = as_other(y[next++]);
        }
    }

    // Of the variables of a stage, in slow time.
    struct Rates {
        const Integral& integral;
        const std::vector<std::size_t>& stage;
        mutable SymbolicMoment<Number> at;

        void move_to(const Number& T, const Values& y) const {
            const SymbolicFrame& frame = integral.frame_;
            if (&stage == &frame.along && integral.flow_) integral.take(frame.flow, (*integral.flow_)(T), at);
            integral.take(stage, y, at);
            at.move_to(frame, T);
        }
        Values operator()(const Number& T, const Values& y) const {
            move_to(T, y);
            Values rates;
            for (const std::size_t k : stage) {
                const ComplexNumber<Number> rate = integral.factors_[k] * integral.rates_[k].value(at.values);
                rates.push_back(rate.re);
                if (is_complex(integral.variable(k))) rates.push_back(rate.im);
            }
            return rates;
        }
        [[nodiscard]] Values scale(const Number& T, const Values& y) const {
            move_to(T, y);
            Values scales;
            for (const std::size_t k : stage) {
                scales.push_back(integral.factors_[k] * integral.rates_[k].scale(at.values));
                if (is_complex(integral.variable(k))) scales.push_back(scales.back());
            }
            return scales;
        }
    };

    struct RatesInPieces : Rates {
        std::vector<Number> edges;
    };
    // The slow times at which pieces of data end: they stand at a variable that moves evenly.
    [[nodiscard]] std::vector<Number> edges() const {
        std::vector<Number> all;
        std::set<DataPointer> seen;
        SymbolicMoment<Number> at(frame_);
        for (const SymbolicRing::Root& root : frame_.solution->ring().roots()) {
            if (root.data == nullptr || !seen.insert(root.data).second) continue;
            const auto argument = [&](int T) {
                at.move_to(frame_, Number(T));
                return value_of(root.radicand, at.values).re;
            };
            append_edges(*root.data, argument, all);
        }
        return all;
    }

    Status build(const std::vector<std::size_t>& stage, Table& table, const GoesOn& goes_on, Wide& reach) {
        if (stage.empty()) return Status::ok;
        Values begin;
        for (const std::size_t k : stage) {
            begin.push_back(narrowed<Number>(frame_.variables[k].start.re));
            if (is_complex(variable(k))) begin.push_back(narrowed<Number>(frame_.variables[k].start.im));
        }
        FlowTable<Values> built;
        Number end = narrowed<Number>(reach);
        const auto goes_on_at = [&](const Number& T, const Values& y) {
            if (!goes_on) return true;
            SymbolicMoment<Wide> at(frame_);
            take(stage, y, at);
            at.move_to(frame_, widened(T));
            return goes_on(at);
        };
        const Status status =
            built.build_while(RatesInPieces{{*this, stage, SymbolicMoment<Number>(frame_)}, edges()},
                              goes_on_at, begin, end, most_panels_);
        if (status != Status::ok) reach = widened(end);
        if (status == Status::ok || end > 0) table.emplace(std::move(built));
        return status;
    }

    const SymbolicFrame& frame_;
    std::size_t most_panels_;
    std::vector<MovingSum<Number>> rates_;
    std::vector<Number> factors_;
    Table flow_, along_;
    std::optional<SymbolicPropagation> propagation_;
};

} // namespace

SymbolicFrame::SymbolicFrame(std::shared_ptr<const SymbolicSolution> s, const SymbolicInputs& inputs)
    : solution(std::move(s)), small(solution->ring().small(inputs)), start(solution->start().at(inputs)),
      constants(solution->ring().constants(inputs)),
      moves(static_cast<std::size_t>(solution->ring().ring().size()), false),
      variables(solution->variables().size()) {
    for (const SymbolicSolution::Constant& c : solution->constants()) {
        if (!c.drift)
            constants.set(c.id, start.amplitude);
        else
            constants.set(c.id, {start.drifts[*c.drift].value, 0}, start.drifts[*c.drift].scale);
    }
    if (const auto T = solution->slow_time()) {
        constants.set(*T, Wide(0));
        moves[static_cast<std::size_t>(*T)] = true;
    }
    for (std::size_t k = 0; k < variables.size(); ++k) {
        const SymbolicVariable& v = solution->variables()[k];
        if (v.kind == Of::slow) variables[k].start = {start.slow[v.start], 0};
        if (v.kind == Of::mode) variables[k].start = start.modes[v.start];
        if (v.id < 0 || v.rate.empty()) continue;
        moves[static_cast<std::size_t>(v.id)] = true;
        if (v.conjugate >= 0) moves[static_cast<std::size_t>(v.conjugate)] = true;
    }
    for (std::size_t round = 0; round <= moves.size(); ++round) {
        for (const SymbolicRing::Root& root : solution->ring().roots())
            if (any_moves(root.radicand)) moves[static_cast<std::size_t>(root.id)] = true;
        for (const SymbolicPrimitive& p : solution->primitives())
            if (any_moves(p.argument)) moves[static_cast<std::size_t>(p.id)] = true;
    }
    const std::vector<bool> found = moves;
    moves.assign(moves.size(), true); // everything has a value at T = 0
    for (Variable& v : variables) v.motion = SymbolicMotion::computed;
    SymbolicMoment<Wide> beginning(*this);
    beginning.move_to(*this, Wide(0));
    constants = beginning.values;
    moves = found;
    for (std::size_t k = 0; k < variables.size(); ++k) {
        const SymbolicVariable& v = solution->variables()[k];
        variables[k].motion = SymbolicMotion::rests;
        if (!v.needed || v.rate.empty()) continue;
        const auto per_slow_time = [&](const SymbolicSum& rate) {
            return (1 / math::power(small, v.power)) * value_of(rate, constants);
        };
        if (!v.decline.empty()) {
            variables[k].motion = SymbolicMotion::relaxes;
            variables[k].speed = per_slow_time(v.drive);
            variables[k].decline = per_slow_time(v.decline).re;
        } else if (any_moves(v.rate)) {
            variables[k].motion = SymbolicMotion::computed;
            const bool in_flow = v.kind == Of::slow || v.kind == Of::mode || v.kind == Of::angle;
            (in_flow ? flow : along).push_back(k);
        } else {
            variables[k].motion = SymbolicMotion::uniform;
            variables[k].speed = per_slow_time(v.rate);
        }
    }
}

bool SymbolicFrame::any_moves(const SymbolicSum& sum) const {
    return std::any_of(sum.begin(), sum.end(), [&](const SymbolicTerm& term) {
        return std::any_of(term.powers.begin(), term.powers.end(),
                           [&](const auto& power) { return moves[static_cast<std::size_t>(power.first)]; });
    });
}

template <class Number>
SymbolicMoment<Number>::SymbolicMoment(const SymbolicFrame& frame) : values(frame.constants) {
    for (const SymbolicFrame::Variable& v : frame.variables)
        now.push_back({narrowed<Number>(v.start.re), narrowed<Number>(v.start.im)});
}

template <class Number>
void SymbolicMoment<Number>::put_mode(const SymbolicFrame& frame, const SymbolicVariable& variable,
                                      const Complex& a) {
    const Complex z = narrowed<Number>(math::power(frame.small, variable.weight)) * a;
    const Number size = z.size() * narrowed<Number>(frame.start.mode_spreads[variable.start]);
    values.set(variable.id, z, size);
    values.set(variable.conjugate, z.conjugate(), size);
}

template <class Number>
Number SymbolicMoment<Number>::move_along_path(const SymbolicFrame& frame, std::size_t k, const Number& T) {
    using math::exp;
    using math::expm1;
    const SymbolicFrame::Variable& v = frame.variables[k];
    const Number begin = narrowed<Number>(v.start.re), speed = narrowed<Number>(v.speed.re);
    if (v.motion == SymbolicMotion::uniform) {
        const Number way = T * speed;
        now[k] = {begin + way, narrowed<Number>(v.start.im) + T * narrowed<Number>(v.speed.im)};
        return math::magnitude(begin) + math::magnitude(way);
    }
    const Number b = narrowed<Number>(v.decline), left = exp(Number(-b * T)) * begin,
                 way = -(speed / b) * expm1(Number(-b * T));
    now[k] = {left + way, Number(0)};
    return math::magnitude(left) + math::magnitude(way);
}

template <class Number> void SymbolicMoment<Number>::move_to(const SymbolicFrame& frame, const Number& T) {
    using math::exp;
    const SymbolicSolution& solution = *frame.solution;
    if (const auto id = solution.slow_time()) values.set(*id, T);
    for (std::size_t k = 0; k < now.size(); ++k) {
        const SymbolicFrame::Variable& v = frame.variables[k];
        if (v.motion == SymbolicMotion::rests) continue;
        const Number size =
            v.motion == SymbolicMotion::computed ? math::magnitude(now[k].re) : move_along_path(frame, k, T);
        const SymbolicVariable& variable = solution.variables()[k];
        switch (variable.kind) {
        case Of::slow:
        case Of::quadrature: values.set(variable.id, {now[k].re, Number(0)}, size); break;
        case Of::mode: put_mode(frame, variable, now[k]); break;
        case Of::angle:
            values.set(variable.id,
                       unit(Number(narrowed<Number>(frame.start.angles[variable.start]) + now[k].re)),
                       Number(1));
            break;
        case Of::drift:
        case Of::phase:
        case Of::exponent: break;
        }
    }
    for (const SymbolicRing::Root& root : solution.ring().roots())
        if (frame.moves[static_cast<std::size_t>(root.id)]) SymbolicRing::set_moving_root(root, values);
    for (const SymbolicPrimitive& p : solution.primitives()) {
        if (!frame.moves[static_cast<std::size_t>(p.id)]) continue;
        const Number argument = value_of(p.argument, values).re;
        values.set(p.id, p.logarithm ? logarithm(argument) : Number(exp(argument)));
    }
}

template struct SymbolicMoment<Wide>;
template struct SymbolicMoment<Float128>;

std::unique_ptr<SymbolicIntegral> symbolic_integral(const SymbolicFrame& frame, std::size_t most_panels) {
    if (frame.flow.empty()) return std::make_unique<Integral<Wide>>(frame, most_panels);
    return std::make_unique<Integral<Float128>>(frame, most_panels);
}

} // namespace resonform
