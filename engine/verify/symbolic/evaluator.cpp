// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/symbolic/evaluator.hpp"

#include "runtime/interval.hpp"
#include "runtime/layer.hpp"
#include "runtime/phase.hpp"
#include "solve/slow_law.hpp"
#include "verify/symbolic/integral.hpp"
#include "verify/symbolic/margins.hpp"
#include "verify/symbolic/turning.hpp"

#include <algorithm>
#include <cmath>

namespace resonform {

namespace {

using Of = SymbolicVariable::Kind;
using Numbers = std::vector<Wide>;
using Moment = SymbolicMoment<Wide>;

bool turns(const SymbolicVariable& v) { return v.kind == Of::mode || v.kind == Of::angle; }

} // namespace

struct SymbolicEvaluator::Impl {
    // A phase that the flow moves: theta with a computed frequency, or a contribution of the flow to it, the
    // argument of a mode or the shift of an angle; an exponent with a computed rate.
    struct MovedPhase {
        std::size_t variable;
        bool of_all; // that turn with this theta; else of the variable itself
    };
    struct Output {
        MovingSum<Wide> sum;
        std::vector<std::vector<int>> turns; // [term][moved phase]
    };

    // int_0^T of the scale of a rate, by the midpoint rule: three digits of a scale are enough.
    struct IntegralScale {
        std::size_t variable;
        MovingSum<Wide> rate;
        Wide factor;
        Numbers sums = {Wide(0)}; // up to the end of each piece
    };

    Impl(std::shared_ptr<const SymbolicSolution> s, const SymbolicInputs& given, const Wide& wanted,
         std::size_t most_panels)
        : inputs(given), frame(std::move(s), given), integral(symbolic_integral(frame, most_panels)) {
        const Wide least = inputs.slow_time_end / 1024; // t = 0 alone is no interval
        status = construct(std::min(std::max(wanted, least), inputs.slow_time_end));
    }

    [[nodiscard]] const SymbolicSolution& solution() const { return *frame.solution; }
    [[nodiscard]] const std::vector<SymbolicVariable>& variables() const { return solution().variables(); }

    Status construct(const Wide& wanted) {
        if (const Cause bad = Interval<Wide>::check(inputs.eps, inputs.slow_time_end);
            bad.status != Status::ok)
            return bad.status;
        interval = Interval<Wide>(inputs.eps, inputs.slow_time_end);
        if (frame.start.status != Status::ok) return frame.start.status;
        for (const SymbolicCondition& c : solution().conditions()) {
            const bool keeps = c.kind == SymbolicCondition::Kind::keeps_sign;
            signs.push_back(keeps ? value_of(c.sum, frame.constants).re : Wide(1));
        }
        if (!conditions_hold(frame.constants, false)) return Status::outside_domain;
        const bool has_layers = !margins.empty();
        Wide reach = has_layers ? inputs.slow_time_end : wanted;
        for (const SymbolicFrame::Variable& v : frame.variables) {
            if (v.motion != SymbolicMotion::relaxes || !(v.decline > 0)) continue;
            const Wide rest = most_relaxations / v.decline;
            if (!(rest < inputs.slow_time_end)) continue;
            goes_on(Status::outside_domain, rest);
            reach = std::min(reach, rest);
        }
        const auto tabulate = [&](Status built) {
            if (built != Status::ok) tabulated = std::min(tabulated, reach);
            return goes_on(built, reach);
        };
        SymbolicIntegral::GoesOn is_clear;
        if (has_layers) is_clear = [&](const Moment& at) { return all_clear(margins.at(at.values)); };
        if (const Status built = integral->build_flow(is_clear, reach); !tabulate(built)) return built;
        if (has_layers) {
            const Status clear = margins.keep_clear(*integral, reach);
            if (!goes_on(clear, reach)) return clear;
            if (clear != Status::ok) tabulated = inputs.slow_time_end; // no tables are needed beyond a layer
            reach = std::min(reach, wanted);
        }
        if (const Status built = integral->build_along(reach); !tabulate(built)) return built;
        integral->propagate(reach);
        find_moved_phases();
        find_integral_scales(reach);
        for (const SymbolicOutput& output : solution().outputs()) outputs.push_back(prepared(output));
        return Status::ok;
    }

    // Returns false if there is no time at which it has an answer.
    bool goes_on(Status built, const Wide& reach) {
        return interval.shorten({built, ""}, reach).status == Status::ok;
    }

    // Do the conditions that move hold, or (moving = false) those that do not?
    [[nodiscard]] bool conditions_hold(const SymbolicValues<Wide>& values, bool moving) const {
        for (std::size_t k = 0; k < solution().conditions().size(); ++k)
            if (frame.any_moves(solution().conditions()[k].sum) == moving && !holds(k, values)) return false;
        return true;
    }

    [[nodiscard]] bool holds(std::size_t k, const SymbolicValues<Wide>& values) const {
        const SymbolicCondition& c = solution().conditions()[k];
        if (c.kind == SymbolicCondition::Kind::correction) {
            const SymbolicCorrection& added = solution().corrections()[c.index];
            return (added.is_layer && frame.any_moves(added.needs)) || margins.of(added, values) > 0;
        }
        if (c.kind != SymbolicCondition::Kind::declared) return value_of(c.sum, values).re * signs[k] > 0;
        std::vector<Wide> slow;
        for (const SymbolicVariable& v : variables())
            if (v.kind == Of::slow) slow.push_back(values[v.id].re);
        return solution().declared_at(slow, inputs)[c.index] > 0;
    }

    void find_moved_phases() {
        std::vector<bool> computed(frame.moves.size(), false);
        const auto sees = [&](const SymbolicSum& sum) {
            return std::any_of(sum.begin(), sum.end(), [&](const SymbolicTerm& term) {
                return std::any_of(term.powers.begin(), term.powers.end(), [&](const auto& power) {
                    return computed[static_cast<std::size_t>(power.first)];
                });
            });
        };
        for (const SymbolicVariable& v : variables()) // its velocity is known no better than the amplitudes
            if (v.kind == Of::mode) {
                computed[static_cast<std::size_t>(v.id)] = true;
                computed[static_cast<std::size_t>(v.conjugate)] = true;
            }
        for (const SymbolicVariable& v : variables())
            if (v.kind == Of::slow && sees(v.rate)) computed[static_cast<std::size_t>(v.id)] = true;
        for (const std::size_t k : frame.flow)
            if (variables()[k].kind == Of::slow) computed[static_cast<std::size_t>(variables()[k].id)] = true;
        for (const SymbolicRing::Root& root : solution().ring().roots())
            if (sees(root.radicand)) computed[static_cast<std::size_t>(root.id)] = true;
        for (const std::size_t k : frame.along)
            if ((variables()[k].kind == Of::phase || variables()[k].kind == Of::exponent) &&
                sees(variables()[k].rate))
                moved.push_back({k, true});
        for (const std::size_t k : frame.flow)
            if (turns(variables()[k])) moved.push_back({k, false});
    }

    void find_integral_scales(const Wide& reach) {
        for (const std::size_t k : frame.along) {
            const SymbolicVariable& v = variables()[k];
            if (v.kind != Of::drift && v.kind != Of::quadrature) continue;
            integral_scales.push_back({k, MovingSum<Wide>(v.rate, frame.constants, frame.moves),
                                       1 / math::power(frame.small, v.power)});
        }
        if (integral_scales.empty()) return;
        piece = reach / pieces;
        Moment at(frame);
        for (int i = 0; i < pieces; ++i) {
            integral->move_to(piece * (i + Wide(0.5)), at);
            const Numbers rates = rate_scales(at, piece * (i + Wide(0.5)));
            for (std::size_t k = 0; k < rates.size(); ++k)
                integral_scales[k].sums.push_back(integral_scales[k].sums.back() + piece * rates[k]);
        }
    }

    // The uncertainty that the flow leaves in functions f of the moment at T: sum |df/dy| (scale of y - |y|)
    // over its variables. Angles have their own part, as phases.
    template <class Functions>
    [[nodiscard]] Numbers left_open(const Moment& at, const Wide& T, const Functions& functions) const {
        Numbers result, here;
        for (const SymbolicIntegral::Beyond& beyond : integral->beyond(at, T)) {
            if (variables()[beyond.variable].kind == Of::angle || !(beyond.size > 0)) continue;
            if (here.empty()) here = functions(at);
            const Wide push = (at.now[beyond.variable].size() + beyond.size) * Wide(1e-25);
            Moment beside = at;
            WideComplex& y = beside.now[beyond.variable];
            (beyond.imaginary ? y.im : y.re) += push;
            beside.move_to(frame, T);
            const Numbers displaced = functions(beside);
            result.resize(here.size(), Wide(0));
            for (std::size_t k = 0; k < here.size(); ++k)
                result[k] += abs(Wide(displaced[k] - here[k])) / push * beyond.size;
        }
        return result;
    }

    // Of each of integral_scales.
    [[nodiscard]] Numbers rate_scales(const Moment& at, const Wide& T) const {
        const Numbers open = left_open(at, T, [&](const Moment& moment) {
            Numbers rates;
            for (const IntegralScale& s : integral_scales) rates.push_back(s.rate.value(moment.values).re);
            return rates;
        });
        Numbers result;
        for (std::size_t k = 0; k < integral_scales.size(); ++k) {
            const IntegralScale& s = integral_scales[k];
            result.push_back(s.factor * (s.rate.scale(at.values) + (open.empty() ? Wide(0) : open[k])));
        }
        return result;
    }

    // Of each of integral_scales, at T.
    [[nodiscard]] Numbers integral_scales_at(const Wide& T) const {
        Numbers result;
        if (integral_scales.empty()) return result;
        const int whole = std::min(static_cast<int>(static_cast<double>(Wide(T / piece))), pieces);
        const Wide rest = T - whole * piece;
        Moment at(frame);
        integral->move_to(T - rest / 2, at);
        const Numbers rates = rate_scales(at, T - rest / 2);
        for (std::size_t k = 0; k < rates.size(); ++k)
            result.push_back(integral_scales[k].sums[static_cast<std::size_t>(whole)] + abs(rest) * rates[k]);
        return result;
    }

    [[nodiscard]] Output prepared(const SymbolicOutput& output) const {
        std::vector<bool> turning = frame.moves;
        for (const SymbolicVariable& v : variables()) {
            if (!turns(v)) continue;
            turning[static_cast<std::size_t>(v.id)] = true;
            if (v.conjugate >= 0) turning[static_cast<std::size_t>(v.conjugate)] = true;
        }
        Output result{MovingSum<Wide>(output.sum, frame.constants, turning), {}};
        for (const MovingSum<Wide>::Term& term : result.sum.terms()) {
            std::vector<int> counts;
            for (const MovedPhase& phase : moved) counts.push_back(turns_of(term, phase));
            result.turns.push_back(std::move(counts));
        }
        return result;
    }

    // Of an exponent: how often e^chi is in the term.
    [[nodiscard]] int turns_of(const MovingSum<Wide>::Term& term, const MovedPhase& phase) const {
        int count = 0;
        const bool turns_back = variables()[phase.variable].kind != Of::exponent;
        for (std::size_t k = 0; k < variables().size(); ++k) {
            const SymbolicVariable& v = variables()[k];
            const std::optional<std::size_t>& own = turns_back ? v.phase : v.decay;
            if (!turns(v) || (phase.of_all ? own != phase.variable : k != phase.variable)) continue;
            for (const auto& [id, exponent] : term.powers) {
                if (v.id == id) count += exponent;
                if (v.conjugate == id && v.conjugate != v.id) count += turns_back ? -exponent : exponent;
            }
        }
        return count;
    }

    // Modes and angles with their phases.
    void turn(Moment& at) const {
        for (std::size_t k = 0; k < variables().size(); ++k) {
            const SymbolicVariable& v = variables()[k];
            if (!v.needed || !turns(v)) continue;
            const Wide theta = v.phase ? at.now[*v.phase].re : Wide(0);
            if (v.kind == Of::mode) {
                const WideComplex turned = at.now[k] * unit(theta);
                at.put_mode(frame, v, v.decay ? Wide(exp(at.now[*v.decay].re)) * turned : turned);
            } else {
                at.values.set(v.id, unit(Wide(frame.start.angles[v.start] + at.now[k].re + theta)), Wide(1));
            }
        }
    }

    [[nodiscard]] std::vector<Wide> all_of(Of kind, const Wide& t) const {
        Moment at(frame);
        integral->move_to(inputs.eps * t, at);
        std::vector<Wide> all;
        for (std::size_t k = 0; k < variables().size(); ++k)
            if (variables()[k].kind == kind) all.push_back(at.now[k].re);
        return all;
    }

    void hold(const std::vector<Wide>& theta, Moment& at) const {
        std::size_t next = 0;
        for (std::size_t k = 0; k < variables().size(); ++k)
            if (variables()[k].kind == Of::phase) at.now[k].re = theta[next++];
    }

    // Of each of the moved phases.
    [[nodiscard]] Numbers ways_at(const Moment& at, const Wide& T) const {
        Numbers ways;
        for (const MovedPhase& phase : moved)
            ways.push_back(variables()[phase.variable].kind == Of::mode
                               ? turned(frame, *integral, phase.variable, T)
                               : Wide(abs(at.now[phase.variable].re)));
        for (const SymbolicIntegral::Beyond& beyond : integral->beyond(at, T))
            for (std::size_t p = 0; p < moved.size(); ++p)
                if (moved[p].variable == beyond.variable && variables()[beyond.variable].kind == Of::angle)
                    ways[p] += beyond.size;
        return ways;
    }

    // held: or nullptr
    [[nodiscard]] SymbolicPoint call(const Wide& t, const std::vector<Wide>* held) const {
        SymbolicPoint point;
        point.status = status;
        if (status != Status::ok) return point;
        Wide T = 0;
        if (point.status = interval.locate(t, T); point.status != Status::ok) return point;
        Moment at(frame);
        integral->move_to(T, at);
        if (!conditions_hold(at.values, true)) {
            point.status = Status::outside_domain;
            return point;
        }
        const Numbers ways = ways_at(at, T);
        if (held != nullptr) hold(*held, at);
        turn(at);
        const Numbers integrals = integral_scales_at(T);
        for (std::size_t k = 0; k < integrals.size(); ++k)
            if (const SymbolicVariable& v = variables()[integral_scales[k].variable]; v.id >= 0)
                at.values.set(v.id, at.values[v.id], integrals[k]);
        for (std::size_t k = 0; k < outputs.size(); ++k) add_output(k, at, ways, integrals, point);
        const Numbers open = left_open(at, T, [&](Moment moment) {
            turn(moment);
            Numbers values;
            for (const Output& output : outputs) values.push_back(output.sum.value(moment.values).re);
            return values;
        });
        for (std::size_t k = 0; k < open.size(); ++k) point.scales[k] += open[k];
        return point;
    }

    void add_output(std::size_t k, const Moment& at, const Numbers& ways, const Numbers& integrals,
                    SymbolicPoint& point) const {
        const Output& output = outputs[k];
        Wide value = 0, scale = output.sum.scale(at.values), part = 0;
        Numbers slopes(moved.size(), Wide(0));
        for (std::size_t i = 0; i < output.sum.terms().size(); ++i) {
            const WideComplex term = MovingSum<Wide>::value(output.sum.terms()[i], at.values);
            value += term.re;
            for (std::size_t p = 0; p < slopes.size(); ++p) {
                const bool grows = variables()[moved[p].variable].kind == Of::exponent;
                slopes[p] -= output.turns[i][p] * (grows ? term.re : term.im);
            }
        }
        for (std::size_t p = 0; p < slopes.size(); ++p) part += abs(Wide(slopes[p] * ways[p]));
        if (const auto drift = solution().outputs()[k].drift) {
            const SymbolicStart::Sum& constant = frame.start.drifts[variables()[*drift].start];
            value += constant.value + at.now[*drift].re;
            scale += constant.scale;
            if (frame.variables[*drift].motion == SymbolicMotion::uniform) scale += abs(at.now[*drift].re);
            for (std::size_t i = 0; i < integrals.size(); ++i)
                if (integral_scales[i].variable == *drift) scale += integrals[i];
        }
        point.values.push_back(value);
        point.scales.push_back(scale + part);
        point.phase_parts.push_back(part);
    }

    static constexpr int pieces = 64;
    SymbolicInputs inputs;
    SymbolicFrame frame;
    SymbolicMargins margins{frame};
    std::unique_ptr<SymbolicIntegral> integral;
    std::vector<Wide> signs; // of the conditions at T = 0
    std::vector<MovedPhase> moved;
    std::vector<IntegralScale> integral_scales;
    Wide piece = 0; // of slow time
    Wide tabulated = inputs.slow_time_end;
    Interval<Wide> interval;
    std::vector<Output> outputs;
    Status status = Status::ok;
};

SymbolicEvaluator::SymbolicEvaluator(std::shared_ptr<const SymbolicSolution> solution,
                                     const SymbolicInputs& inputs, const Wide& reach, std::size_t most_panels)
    : impl_(std::make_unique<Impl>(std::move(solution), inputs, reach, most_panels)) {}
SymbolicEvaluator::~SymbolicEvaluator() = default;
SymbolicEvaluator::SymbolicEvaluator(SymbolicEvaluator&&) noexcept = default;

SymbolicPoint SymbolicEvaluator::operator()(const Wide& t) const { return impl_->call(t, nullptr); }
std::vector<Wide> SymbolicEvaluator::phases(const Wide& t) const { return impl_->all_of(Of::phase, t); }
std::vector<Wide> SymbolicEvaluator::exponents(const Wide& t) const { return impl_->all_of(Of::exponent, t); }
SymbolicPoint SymbolicEvaluator::with_phases(const Wide& t, const std::vector<Wide>& theta) const {
    return impl_->call(t, &theta);
}
Status SymbolicEvaluator::construction_status() const { return impl_->status; }
bool SymbolicEvaluator::loses_phase(const Wide& t, const Wide& end, const Wide& resolution) const {
    const Wide later = std::min(Wide(t + end / 8), end);
    const std::vector<Wide> theta = phases(later);
    return std::any_of(theta.begin(), theta.end(),
                       [&](const Wide& phase) { return 2 * abs(phase) * resolution > Wide(known_radians); });
}

const Wide& SymbolicEvaluator::tabulated() const { return impl_->tabulated; }

} // namespace resonform
