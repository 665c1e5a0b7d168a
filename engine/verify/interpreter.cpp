// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/interpreter.hpp"

#include "emit/prune.hpp"
#include "runtime/flow.hpp"
#include "runtime/interval.hpp"
#include "runtime/layer.hpp"
#include "runtime/phase.hpp"
#include "runtime/table.hpp"
#include "verify/graph_walk.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <optional>

namespace resonform {

namespace {

using Nodes = std::vector<Graph::Node>;

// The nodes behind some roots, operands first: the constant ones or those that change from call to call.
struct Plan {
    Plan(const Program& program, const Nodes& roots) {
        const std::vector<bool> used = reachable(program.graph, roots);
        const std::vector<bool> changes = depending(program.graph, varying_symbols(program));
        for (std::size_t n = 0; n < used.size(); ++n)
            if (used[n]) (changes[n] ? varying : constant).push_back(static_cast<Graph::Node>(n));
    }
    Nodes constant, varying;
};

Nodes values_of(const std::vector<ProgramOutput>& results) {
    Nodes nodes;
    for (const ProgramOutput& result : results) nodes.push_back(result.value);
    return nodes;
}

template <class Number, class Real>
void set_inputs(GraphWalk<Number>& walk, const std::vector<ProgramInput>& inputs,
                const std::vector<Real>& values) {
    for (std::size_t k = 0; k < inputs.size(); ++k) walk.set(inputs[k].symbol, Number(values[k]));
}

template <class Real> bool all_finite(const std::vector<Real>& values) {
    return std::all_of(values.begin(), values.end(), [](const Real& x) { return math::finite(x); });
}

} // namespace

template <class Real> struct Interpreter<Real>::Impl {
    using Wide = typename Phase<Real>::Wide;

    Impl(std::shared_ptr<const Program> p, const Real& eps_value, std::vector<Real> parameter_values,
         std::vector<Real> start_values, const Real& slow_time_end)
        : program(std::move(p)), constants(program->graph), eps(eps_value),
          parameters(std::move(parameter_values)), start(std::move(start_values)), end(slow_time_end) {
        if (parameters.empty()) parameters = default_parameters<Real>(*program, eps);
        if (start.empty()) start = default_start<Real>(*program, eps, parameters);
        status = construct();
    }

    Status construct() {
        if (!Interval<Real>::accepts(eps, end)) return Status::bad_argument;
        if (!all_finite(parameters) || !all_finite(start)) return Status::bad_argument;
        interval = Interval<Real>(eps, end);
        reach = end;
        set_constants(constants);
        const std::vector<bool> changes = depending(program->graph, varying_symbols(*program));
        for (const Graph::Node condition : program->positive)
            if (!changes[static_cast<std::size_t>(condition)] && !(constants[condition] > Real(0)))
                return Status::outside_domain;
        if (const Status built = build_flow(); built != Status::ok) return built;
        if (const Status clear = keep_clear_of_layers(); clear != Status::ok) return clear;
        if (const Status built = build_tables(); built != Status::ok) return built;
        return build_phases();
    }

    template <class Number> void set_constants(GraphWalk<Number>& walk) const {
        walk.set(program->eps, Number(eps));
        set_inputs(walk, program->parameters, parameters);
        set_inputs(walk, program->start, start);
        Nodes all(program->graph.size());
        const std::vector<bool> changes = depending(program->graph, varying_symbols(*program));
        Nodes nodes;
        for (std::size_t n = 0; n < all.size(); ++n)
            if (!changes[n]) nodes.push_back(static_cast<Graph::Node>(n));
        walk.compute(nodes);
    }

    Status build_flow() {
        if (program->flow.empty()) return Status::ok;
        Nodes rates;
        std::vector<Real> starts;
        for (const ProgramFlow& variable : program->flow) {
            rates.push_back(variable.rate);
            starts.push_back(constants[variable.start]);
        }
        const Plan plan(*program, rates);
        GraphWalk<Real> walk = constants;
        FlowTable<std::vector<Real>> built;
        const Status solved = built.build(
            [&](const Real& T, const std::vector<Real>& values) {
                walk.set(program->slow_time, T);
                for (std::size_t k = 0; k < values.size(); ++k) walk.set(program->flow[k].value, values[k]);
                walk.compute(plan.varying);
                std::vector<Real> result;
                for (const Graph::Node rate : rates) result.push_back(walk[rate]);
                return result;
            },
            starts, reach);
        if (const Status kept = interval.shorten(solved, reach); kept != Status::ok) return kept;
        flow.emplace(std::move(built));
        return Status::ok;
    }

    Status keep_clear_of_layers() {
        if (program->layers.empty()) return Status::ok;
        const Plan plan(*program, program->layers);
        GraphWalk<Real> walk = constants;
        const auto margins = [&](const Real& T) {
            set_slow_time(walk, T);
            walk.compute(plan.varying);
            std::vector<Real> values;
            for (const Graph::Node margin : program->layers) values.push_back(walk[margin]);
            return values;
        };
        return interval.shorten(clear_of_layers(margins, reach), reach);
    }

    Status build_tables() {
        for (const ProgramTable& table : program->tables) {
            const Plan plan(*program, {table.integrand});
            GraphWalk<Real> walk = constants;
            PrimitiveTable<Real, 1> built;
            const Status fitted = built.build(
                [&](const Real& T) {
                    set_slow_time(walk, T);
                    walk.compute(plan.varying);
                    return std::array<Real, 1>{walk[table.integrand]};
                },
                reach);
            if (const Status kept = interval.shorten(fitted, reach); kept != Status::ok) return kept;
            tables.push_back(std::move(built));
        }
        return Status::ok;
    }

    Status build_phases() {
        GraphWalk<Wide> walk(program->graph);
        if (!program->phases.empty()) set_constants(walk);
        for (const ProgramPhase& phase : program->phases) {
            const Plan plan(*program, {phase.rate});
            phases.emplace_back();
            const Status fitted = phases.back().build(
                [&](const Wide& T) {
                    set_slow_time(walk, T);
                    walk.compute(plan.varying);
                    return std::array<Wide, 1>{walk[phase.rate]};
                },
                walk[phase.start], eps, reach, uses_tables(phase.rate));
            if (const Status kept = interval.shorten(fitted, reach); kept != Status::ok) return kept;
        }
        return Status::ok;
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

    // Slow time, the flow and the tables built so far.
    template <class Number> void set_slow_time(GraphWalk<Number>& walk, const Number& T) const {
        walk.set(program->slow_time, T);
        if (flow) {
            const std::vector<Real> values = (*flow)(static_cast<Real>(T));
            for (std::size_t k = 0; k < values.size(); ++k)
                walk.set(program->flow[k].value, Number(values[k]));
        }
        for (std::size_t k = 0; k < tables.size(); ++k)
            walk.set(program->tables[k].value, Number(tables[k](static_cast<Real>(T))[0]));
    }

    // All nodes behind the results at t; low_precision where the phase is, else as the domain says.
    Status walk_to(const Real& t, const Nodes& roots, GraphWalk<Real>& walk) const {
        if (status != Status::ok) return status;
        Real T(0);
        if (const Status located = interval.locate(t, T); located != Status::ok) return located;
        set_slow_time(walk, T);
        walk.set(program->time, t);
        Status precision = Status::ok;
        for (std::size_t k = 0; k < phases.size(); ++k) {
            Real cosine(0), sine(0);
            if (const Status seen = phases[k](t, cosine, sine); seen != Status::ok) precision = seen;
            walk.set(program->phases[k].cosine, cosine);
            walk.set(program->phases[k].sine, sine);
        }
        Nodes all = roots;
        all.insert(all.end(), program->positive.begin(), program->positive.end());
        walk.compute(Plan(*program, all).varying);
        for (const Graph::Node condition : program->positive)
            if (!(walk[condition] > Real(0))) return Status::outside_domain;
        return precision;
    }

    Status call(const Real& t, const std::vector<ProgramOutput>& wanted, std::vector<Real>& values) const {
        values.assign(wanted.size(), math::not_a_number<Real>());
        GraphWalk<Real> walk = constants;
        const Status walked = walk_to(t, values_of(wanted), walk);
        if (walked != Status::ok && walked != Status::low_precision) return walked;
        std::vector<Real> computed;
        computed.reserve(wanted.size());
        for (const ProgramOutput& output : wanted) computed.push_back(walk[output.value]);
        if (!all_finite(computed)) return Status::overflow;
        values = std::move(computed);
        return walked;
    }

    Status scale(const Real& t, std::vector<Real>& scales) const {
        scales.assign(program->outputs.size(), math::not_a_number<Real>());
        GraphWalk<Real> walk = constants;
        const Nodes roots = values_of(program->outputs);
        const Status walked = walk_to(t, roots, walk);
        if (walked != Status::ok && walked != Status::low_precision) return walked;
        const Plan plan(*program, roots);
        GraphWalk<Real> bounds(program->graph);
        set_symbol_bounds(walk, bounds);
        walk.compute_scale(plan.constant, bounds);
        walk.compute_scale(plan.varying, bounds);
        for (std::size_t k = 0; k < roots.size(); ++k) scales[k] = bounds[roots[k]];
        return walked;
    }

    void set_symbol_bounds(const GraphWalk<Real>& walk, GraphWalk<Real>& bounds) const {
        const auto size = [&](Graph::Node n) { bounds.set(n, math::magnitude(walk[n])); };
        for (const Graph::Node n : {program->eps, program->time, program->slow_time}) size(n);
        for (const std::vector<ProgramInput>* inputs : {&program->parameters, &program->start})
            for (const ProgramInput& input : *inputs) size(input.symbol);
        for (const ProgramFlow& variable : program->flow) size(variable.value);
        for (const ProgramTable& table : program->tables) size(table.value);
        for (const ProgramPhase& phase : program->phases) {
            bounds.set(phase.cosine, Real(1));
            bounds.set(phase.sine, Real(1));
        }
    }

    std::shared_ptr<const Program> program;
    GraphWalk<Real> constants;
    Real eps;
    std::vector<Real> parameters, start;
    Real end, reach{}; // of slow time; as far as everything is defined
    Interval<Real> interval;
    std::optional<FlowTable<std::vector<Real>>> flow;
    std::vector<PrimitiveTable<Real, 1>> tables;
    std::vector<Phase<Real>> phases;
    Status status = Status::ok;
};

template <class Real>
Interpreter<Real>::Interpreter(std::shared_ptr<const Program> program, Real eps, std::vector<Real> parameters,
                               std::vector<Real> start, Real slow_time_end)
    : impl_(std::make_unique<Impl>(std::move(program), eps, std::move(parameters), std::move(start),
                                   slow_time_end)) {}
template <class Real> Interpreter<Real>::~Interpreter() = default;
template <class Real> Interpreter<Real>::Interpreter(Interpreter&&) noexcept = default;

template <class Real> Status Interpreter<Real>::call(Real t, std::vector<Real>& outputs) const {
    return impl_->call(t, impl_->program->outputs, outputs);
}
template <class Real> Status Interpreter<Real>::state(Real t, std::vector<Real>& state) const {
    return impl_->call(t, impl_->program->state, state);
}
template <class Real> Status Interpreter<Real>::scale(Real t, std::vector<Real>& scale) const {
    return impl_->scale(t, scale);
}
template <class Real> Status Interpreter<Real>::construction_status() const { return impl_->status; }

template <class Real> std::vector<Real> default_parameters(const Program& program, Real) {
    std::vector<Real> values;
    for (const ProgramInput& input : program.parameters)
        values.push_back(input.default_value < 0
                             ? math::not_a_number<Real>()
                             : to_number<Real>(program.graph.at(input.default_value).value));
    return values;
}

template <class Real>
std::vector<Real> default_start(const Program& program, Real eps, const std::vector<Real>& parameters) {
    GraphWalk<Real> walk(program.graph);
    walk.set(program.eps, eps);
    set_inputs(walk, program.parameters, parameters);
    Nodes roots;
    for (const ProgramInput& input : program.start) roots.push_back(input.default_value);
    walk.compute(Plan(program, roots).constant);
    std::vector<Real> values;
    for (const Graph::Node n : roots) values.push_back(walk[n]);
    return values;
}

#define RESONFORM_INSTANTIATE(Real)                                                                          \
    template class Interpreter<Real>;                                                                        \
    template std::vector<Real> default_parameters(const Program&, Real);                                     \
    template std::vector<Real> default_start(const Program&, Real, const std::vector<Real>&);

RESONFORM_INSTANTIATE(double)
RESONFORM_INSTANTIATE(long double)
RESONFORM_INSTANTIATE(Float128)
RESONFORM_INSTANTIATE(boost::multiprecision::cpp_bin_float_50)
RESONFORM_INSTANTIATE(boost::multiprecision::cpp_bin_float_100)

#undef RESONFORM_INSTANTIATE

} // namespace resonform
