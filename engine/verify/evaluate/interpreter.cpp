// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/evaluate/interpreter.hpp"

#include "emit/program/prune.hpp"
#include "runtime/decay.hpp"
#include "runtime/flow.hpp"
#include "runtime/interval.hpp"
#include "runtime/layer.hpp"
#include "runtime/phase.hpp"
#include "runtime/pieces.hpp"
#include "runtime/table.hpp"
#include "verify/evaluate/constant_walk.hpp"
#include "verify/evaluate/term_scale.hpp"
#include "verify/run/spline.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace resonform {

namespace {

using Nodes = std::vector<Graph::Node>;

template <class Real> bool all_finite(const std::vector<Real>& values) {
    return std::all_of(values.begin(), values.end(), [](const Real& x) { return math::finite(x); });
}

} // namespace

template <class Real> struct Interpreter<Real>::Impl {
    using Wide = ReferenceWide<Real>;

    Impl(std::shared_ptr<const Interpretation> s, const Real& eps_value, std::vector<Real> parameter_values,
         std::vector<Real> start_values, const Real& slow_time_end)
        : shared(std::move(s)), constants(program->graph, &shared->numbers), eps(eps_value),
          parameters(std::move(parameter_values)), start(std::move(start_values)), end(slow_time_end) {
        if (parameters.empty()) parameters = default_parameters<Real>(*program, eps);
        if (start.empty()) start = default_start<Real>(*program, eps, parameters);
        cause = construct();
    }

    Cause construct() {
        if (const Cause bad = Interval<Real>::check(eps, end); bad.status != Status::ok) return bad;
        if (const Cause bad = check_arguments(); bad.status != Status::ok) return bad;
        interval = Interval<Real>(eps, end);
        reach = end;
        if (const Cause lost = set_constants(constants); lost.status != Status::ok) return lost;
        plan_margins();
        if (const Cause failed = build_flow(); failed.status != Status::ok) return failed;
        if (const Cause failed = keep_clear_of_layers(); failed.status != Status::ok) return failed;
        if (const Cause failed = build_tables(); failed.status != Status::ok) return failed;
        return build_phases();
    }

    Cause check_arguments() const {
        for (const auto& [inputs, values, names] :
             {std::tuple(&program->parameters, &parameters, &plan.parameters),
              std::tuple(&program->start, &start, &plan.start)})
            for (std::size_t k = 0; k < values->size(); ++k)
                if (!math::finite((*values)[k])) return {Status::bad_argument, (*names)[k].c_str()};
        if (!plan.range.native) return {};
        const double bound = std::ldexp(1.0, plan.range.bound);
        for (const auto& [symbol, argument] : arguments())
            if (std::binary_search(plan.range.limited.begin(), plan.range.limited.end(), symbol) &&
                !math::within(argument.first, bound))
                return {Status::overflow, argument.second};
        return {};
    }

    // eps, parameters and start values by their symbols, with their names.
    [[nodiscard]] std::map<Graph::Node, std::pair<Real, const char*>> arguments() const {
        std::map<Graph::Node, std::pair<Real, const char*>> all{{program->eps, {eps, "eps"}}};
        for (std::size_t k = 0; k < parameters.size(); ++k)
            all[program->parameters[k].symbol] = {parameters[k], plan.parameters[k].c_str()};
        for (std::size_t k = 0; k < start.size(); ++k)
            all[program->start[k].symbol] = {start[k], plan.start[k].c_str()};
        return all;
    }

    // Constants in Number, by way of numbers of any range.
    template <class Number> Cause set_constants(GraphWalk<Number>& walk) const {
        GraphWalk<Scaled<Number>> scaled(program->graph, &shared->numbers);
        std::map<Graph::Node, Number> inputs;
        for (const auto& [symbol, argument] : arguments()) {
            inputs[symbol] = Number(argument.first);
            scaled.set(symbol, Scaled<Number>(inputs[symbol]));
        }
        Nodes nodes;
        for (std::size_t n = 0; n < changes.size(); ++n)
            if (!changes[n]) nodes.push_back(static_cast<Graph::Node>(n));
        scaled.compute(nodes);
        for (const ProgramCondition& condition : program->positive)
            if (!varies(condition) && !(scaled[condition.value] > Scaled<Number>(0)))
                return {Status::outside_domain, condition.quantity.c_str()};
        walk.keep(scaled, changes);
        return plan.range.native ? Cause{} : ConstantWalk<Number>(*shared, inputs).cause();
    }

    [[nodiscard]] bool varies(const ProgramCondition& condition) const {
        return changes[static_cast<std::size_t>(condition.value)];
    }

    static std::vector<Real> numbers_of(const GraphWalk<Real>& walk, const Nodes& nodes) {
        std::vector<Real> values;
        for (const Graph::Node n : nodes) values.push_back(walk[n]);
        return values;
    }

    // The slow times at which pieces of data end.
    template <class Number> std::vector<Number> edges(const GraphWalk<Number>& of) const {
        std::vector<Number> all;
        GraphWalk<Number> walk = of;
        for (const ProgramData& data : program->data) {
            const NodesBehind behind(*shared, {data.argument});
            const auto argument = [&](int T) {
                walk.set(program->slow_time, Number(T));
                walk.compute(behind.varying);
                return walk[data.argument];
            };
            append_edges(*data.samples, argument, all);
        }
        return all;
    }

    Cause build_flow() {
        if (program->flow.empty()) return {};
        Nodes rates;
        std::vector<Real> starts;
        for (const ProgramFlow& variable : program->flow) {
            rates.push_back(variable.rate);
            starts.push_back(constants[variable.start]);
        }
        const NodesBehind behind(*shared, rates);
        GraphWalk<Real> walk = constants;
        const auto rates_at = [&](const Real& T, const std::vector<Real>& values) {
            set_flow(walk, T, values);
            walk.compute(behind.varying);
            return numbers_of(walk, rates);
        };
        const auto is_clear = [&](const Real& T, const std::vector<Real>& values) {
            if (margins.empty()) return true;
            set_flow(walk, T, values);
            walk.compute(behind_margins->varying);
            return all_clear(numbers_of(walk, margins));
        };
        FlowTable<std::vector<Real>> built;
        const Status solved =
            built.build_while(in_pieces(rates_at, edges(constants)), is_clear, starts, reach);
        if (const Cause failed = interval.shorten({solved, "slow flow"}, reach); failed.status != Status::ok)
            return failed;
        flow.emplace(std::move(built));
        return {};
    }

    void plan_margins() {
        for (const ProgramCondition& margin : program->layers) margins.push_back(margin.value);
        if (!margins.empty()) behind_margins.emplace(*shared, margins);
    }

    Cause keep_clear_of_layers() {
        if (margins.empty()) return {};
        std::vector<const char*> names;
        for (const ProgramCondition& margin : program->layers) names.push_back(margin.quantity.c_str());
        GraphWalk<Real> walk = constants;
        const auto margins_at = [&](const Real& T) {
            set_slow_time(walk, T);
            walk.compute(behind_margins->varying);
            return numbers_of(walk, margins);
        };
        const int samples = plan.layers_are_broad ? broad_layer_samples : layer_samples;
        return interval.shorten(clear_of_layers(margins_at, names, reach, samples), reach);
    }

    Cause build_tables() {
        for (std::size_t k = 0; k < program->tables.size(); ++k) {
            const ProgramTable& table = program->tables[k];
            const NodesBehind behind(*shared, {table.integrand});
            GraphWalk<Real> walk = constants;
            PrimitiveTable<Real, 1> built;
            const auto integrand = [&](const Real& T) {
                set_slow_time(walk, T);
                walk.compute(behind.varying);
                return std::array<Real, 1>{walk[table.integrand]};
            };
            const Status fitted = built.build(in_pieces(integrand, edges(constants)), reach);
            if (const Cause failed = interval.shorten({fitted, level_of(k).name.c_str()}, reach);
                failed.status != Status::ok)
                return failed;
            tables.push_back(std::move(built));
        }
        return {};
    }

    Cause build_phases() {
        GraphWalk<Wide> walk(program->graph, &shared->numbers);
        if (program->phases.empty()) return {};
        if (const Cause lost = set_constants(walk); lost.status != Status::ok) return lost;
        for (std::size_t k = 0; k < program->phases.size(); ++k) {
            const ProgramPhase& phase = program->phases[k];
            const NodesBehind behind(*shared, {phase.rate});
            const auto at = [&](const Wide& T) {
                set_slow_time(walk, T);
                walk.compute(behind.varying);
                return std::array<Wide, 1>{walk[phase.rate]};
            };
            const auto rate = in_pieces(at, edges(walk));
            const bool rounded = uses_tables(phase.rate), fades = !phase.fades_with.empty();
            const Status fitted =
                phase.decays()
                    ? decays.emplace_back().build(rate, walk[phase.start], eps, reach, rounded)
                    : phases.emplace_back().build(rate, walk[phase.start], eps, reach, rounded, fades);
            if (const Cause failed = interval.shorten({fitted, plan.phase_names[k].c_str()}, reach);
                failed.status != Status::ok)
                return failed;
        }
        return {};
    }

    [[nodiscard]] const CppLevel& level_of(std::size_t table) const {
        return *std::find_if(plan.levels.begin(), plan.levels.end(), [&](const CppLevel& level) {
            return !level.flow &&
                   std::find(level.members.begin(), level.members.end(), table) != level.members.end();
        });
    }

    [[nodiscard]] bool uses_tables(Graph::Node n) const {
        const std::vector<bool> used = reachable(program->graph, {n});
        const auto in_flow = [&](const ProgramFlow& variable) {
            return used[static_cast<std::size_t>(variable.value)];
        };
        if (std::any_of(program->flow.begin(), program->flow.end(), in_flow)) return true;
        return std::any_of(program->tables.begin(), program->tables.end(), [&](const ProgramTable& table) {
            return used[static_cast<std::size_t>(table.value)];
        });
    }

    template <class Number>
    void set_flow(GraphWalk<Number>& walk, const Number& T, const std::vector<Real>& values) const {
        walk.set(program->slow_time, T);
        for (std::size_t k = 0; k < values.size(); ++k) walk.set(program->flow[k].value, Number(values[k]));
    }

    // Slow time, the flow and the tables built so far.
    template <class Number> void set_slow_time(GraphWalk<Number>& walk, const Number& T) const {
        set_flow(walk, T, flow ? (*flow)(static_cast<Real>(T)) : std::vector<Real>());
        for (std::size_t k = 0; k < tables.size(); ++k)
            walk.set(program->tables[k].value, Number(tables[k](static_cast<Real>(T))[0]));
    }

    // Whether digits are left where growth rates have changed their sign.
    bool passes(const GraphWalk<Real>& walk) const {
        const auto is_positive = [&](Graph::Node n) { return walk[n] > Real(0); };
        for (const ProgramPhase& phase : program->phases)
            for (const Nodes& either : phase.precision)
                if (std::none_of(either.begin(), either.end(), is_positive)) return false;
        return true;
    }

    // Whether everything has decayed that turns with a phase.
    static bool is_gone(const ProgramPhase& phase, const GraphWalk<Real>& walk) {
        return !phase.fades_with.empty() && std::all_of(phase.fades_with.begin(), phase.fades_with.end(),
                                                        [&](Graph::Node n) { return faded(Real(walk[n])); });
    }

    // These nodes at t, conditions among them; low_precision where the phase is, else as the domain says.
    Status walk_to(const Real& t, const Nodes& nodes, GraphWalk<Real>& walk) const {
        if (cause.status != Status::ok) return cause.status;
        Real T(0);
        if (const Status located = interval.locate(t, T); located != Status::ok) return located;
        set_slow_time(walk, T);
        walk.set(program->time, t);
        Status precision = Status::ok;
        for (std::size_t k = 0; k < decays.size(); ++k) { // exponents come last
            const ProgramPhase& phase = program->phases[phases.size() + k];
            walk.set(phase.exponential, decays[k](t));
            if (phase.growth >= 0 && !(walk[phase.exponential] * walk[phase.growth] <= Real(1)))
                precision = Status::low_precision;
        }
        for (std::size_t k = 0; k < phases.size(); ++k) {
            const ProgramPhase& phase = program->phases[k];
            Real cosine(0), sine(0);
            if (const Status seen = phases[k](t, cosine, sine); seen != Status::ok && !is_gone(phase, walk))
                precision = seen;
            walk.set(phase.cosine, cosine);
            walk.set(phase.sine, sine);
        }
        walk.compute(nodes);
        for (const ProgramCondition& condition : program->positive)
            if (varies(condition) && !(walk[condition.value] > Real(0))) return Status::outside_domain;
        return passes(walk) ? precision : Status::low_precision;
    }

    Status call(const Real& t, const std::vector<ProgramOutput>& wanted, const Nodes& nodes,
                std::vector<Real>& values) const {
        values.assign(wanted.size(), math::not_a_number<Real>());
        GraphWalk<Real> walk = constants;
        const Status walked = walk_to(t, nodes, walk);
        if (!has_numbers(walked)) return walked;
        std::vector<Real> computed = numbers_of(walk, values_of(wanted));
        if (!all_finite(computed)) return Status::overflow;
        values = std::move(computed);
        return walked;
    }

    Status scale(const Real& t, std::vector<Real>& scales) const {
        scales.assign(program->outputs.size(), math::not_a_number<Real>());
        GraphWalk<Real> walk = constants;
        const Status walked = walk_to(t, shared->outputs_at_call, walk);
        if (has_numbers(walked)) scales = term_scales(*shared, walk);
        return walked;
    }

    Status trace(const Real& t, std::vector<Real>& nodes) const {
        GraphWalk<Real> walk = constants;
        const Status walked = walk_to(t, shared->outputs_at_call, walk);
        nodes = has_numbers(walked) ? walk.values() : std::vector<Real>();
        return walked;
    }

    // As in emitted code.
    [[nodiscard]] const char* why(Status status) const {
        if (cause.status != Status::ok) return status == cause.status ? cause.quantity : "";
        if (status == Status::low_precision)
            for (const bool fading : {false, true})
                for (std::size_t k = 0; k < phases.size(); ++k)
                    if (!phases[k].precise() && program->phases[k].fades_with.empty() != fading)
                        return plan.phase_names[k].c_str();
        if (status == Status::low_precision && plan.loses_digits)
            return plan.phase_names[*plan.loses_digits].c_str();
        return interval.why(status, shared->conditions.c_str(), shared->results.c_str());
    }

    std::shared_ptr<const Interpretation> shared;
    const Program* program = shared->program.get();
    const CppPlan& plan = shared->plan;
    const std::vector<bool>& changes = shared->changes;
    GraphWalk<Real> constants;
    Real eps;
    std::vector<Real> parameters, start;
    Nodes margins;                             // of the layers
    std::optional<NodesBehind> behind_margins; // if there are any
    Real end, reach{};                         // of slow time; as far as everything is defined
    Interval<Real> interval;
    std::optional<FlowTable<std::vector<Real>>> flow;
    std::vector<PrimitiveTable<Real, 1>> tables;
    std::vector<Phase<Real, Wide>> phases;
    std::vector<Decay<Real, Wide>> decays;
    Cause cause;
};

template <class Real>
Interpreter<Real>::Interpreter(std::shared_ptr<const Program> program, Real eps, std::vector<Real> parameters,
                               std::vector<Real> start, Real slow_time_end)
    : Interpreter(std::make_shared<const Interpretation>(std::move(program)), eps, std::move(parameters),
                  std::move(start), slow_time_end) {}
template <class Real>
Interpreter<Real>::Interpreter(std::shared_ptr<const Interpretation> shared, Real eps,
                               std::vector<Real> parameters, std::vector<Real> start, Real slow_time_end)
    : impl_(std::make_unique<Impl>(std::move(shared), eps, std::move(parameters), std::move(start),
                                   slow_time_end)) {}
template <class Real> Interpreter<Real>::~Interpreter() = default;
template <class Real> Interpreter<Real>::Interpreter(Interpreter&&) noexcept = default;

template <class Real> Status Interpreter<Real>::call(Real t, std::vector<Real>& outputs) const {
    return impl_->call(t, impl_->program->outputs, impl_->shared->outputs_at_call, outputs);
}
template <class Real> Status Interpreter<Real>::state(Real t, std::vector<Real>& state) const {
    return impl_->call(t, impl_->program->state, impl_->shared->state_at_call, state);
}
template <class Real> Status Interpreter<Real>::scale(Real t, std::vector<Real>& scale) const {
    return impl_->scale(t, scale);
}
template <class Real> Status Interpreter<Real>::trace(Real t, std::vector<Real>& nodes) const {
    return impl_->trace(t, nodes);
}
template <class Real> Status Interpreter<Real>::construction_status() const { return impl_->cause.status; }
template <class Real> const char* Interpreter<Real>::why(Status status) const { return impl_->why(status); }

template class Interpreter<double>;
template class Interpreter<long double>;
template class Interpreter<Float128>;
template class Interpreter<boost::multiprecision::cpp_bin_float_50>;
template class Interpreter<boost::multiprecision::cpp_bin_float_100>;

} // namespace resonform
