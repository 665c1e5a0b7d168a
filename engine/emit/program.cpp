// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program.hpp"

#include "algebra/error.hpp"
#include "emit/count.hpp"
#include "emit/from_expression.hpp"
#include "emit/identifier.hpp"
#include "emit/moment.hpp"
#include "emit/prune.hpp"
#include "emit/quadratures.hpp"
#include "emit/scene_formulas.hpp"
#include "emit/start_constants.hpp"
#include "emit/straight_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace resonform {

namespace {

class ProgramBuilder {
public:
    ProgramBuilder(const Solution& solution, const Scene& scene, const ProgramOptions& options)
        : solution_(solution), scene_(scene), options_(options), quadratures_(program_, solution) {}

    Program build() {
        describe();
        define_symbols();
        define_parameters();
        define_slow_variables();
        StartConstants constants(program_, solution_, scene_, slow_starts_, names_);
        const Graph::Node phase_start = constants.define(surroundings_);
        MomentPlan plan;
        plan.slow_time = program_.slow_time;
        plan.slow_variables = slow_values_;
        plan.quadrature = [this](const Primitive& p, Lowering& lowering) {
            return quadratures_.value(p, lowering);
        };
        Moment call(program_, solution_, solution_.ring, surroundings_, plan);
        define_phase(call, phase_start);
        define_results(call);
        declare_domain();
        return std::move(program_);
    }

private:
    void describe();
    void define_symbols();
    void define_parameters();
    void define_constant_roots(Lowering& lowering);
    void define_slow_variables();
    void define_phase(Moment& call, Graph::Node start);
    void define_results(Moment& call);
    void declare_domain();
    Graph::Node by_powers_of_eps(const Polynomial& p, Moment& call, const std::string& name,
                                 bool oscillating);
    const SolutionOutput& output_of(const std::string& name) const;
    double number_of(const GiNaC::ex& e) const;

    const Solution& solution_;
    const Scene& scene_;
    const ProgramOptions& options_;
    Program program_;
    Quadratures quadratures_;
    Surroundings surroundings_;
    std::map<std::string, Graph::Node> names_; // of the user's files: eps, parameters, slow variables
    std::map<GeneratorId, Graph::Node> slow_starts_, slow_values_;
};

void ProgramBuilder::describe() {
    program_.system = solution_.system().name;
    program_.scene = scene_.name;
    program_.title = scene_.title;
    program_.order = solution_.order;
    program_.truncation = solution_.truncation;
}

void ProgramBuilder::define_symbols() {
    program_.eps = program_.graph.symbol("eps");
    program_.time = program_.graph.symbol("t");
    program_.slow_time = program_.graph.symbol("slow time"); // a space: no parameter has this name
    names_["eps"] = program_.eps;
    surroundings_.symbols[solution_.ring->generator(solution_.eps).name] = program_.eps;
    surroundings_.positive.insert(program_.eps);
    program_.slow_time_end = program_.graph.rational(1);
}

void ProgramBuilder::define_parameters() {
    surroundings_.symbols["pi"] = from_expression(program_.graph, GiNaC::Pi, {});
    surroundings_.positive.insert(surroundings_.symbols["pi"]);
    for (const Parameter& parameter : solution_.system().parameters) {
        const auto fixed = scene_.fix.find(parameter.name);
        const Graph::Node value = fixed == scene_.fix.end() ? -1 : program_.graph.rational(fixed->second);
        Graph::Node node = value;
        if (node < 0 || !options_.fold_fixed) {
            node = program_.graph.symbol(parameter.name);
            program_.parameters.push_back(
                {identifier(parameter.name), "parameter " + parameter.name, node, value});
            if (parameter.positive) {
                program_.positive.push_back(node);
                surroundings_.positive.insert(node);
            }
        }
        surroundings_.symbols[parameter.name] = names_[parameter.name] = node;
    }
}

// Roots of parameters and numbers, by which the ring may have written a parameter: a = root^2.
void ProgramBuilder::define_constant_roots(Lowering& lowering) {
    for (GeneratorId id = 0; id < solution_.ring->size(); ++id) {
        const Generator& g = solution_.ring->generator(id);
        if (g.kind == GeneratorKind::root && is_constant(*solution_.ring, g.radicand))
            lowering.define(id, program_.graph.root(lowering.radicand(g.radicand), g.index), false);
    }
}

// xi = xi_0 + rate T
void ProgramBuilder::define_slow_variables() {
    Graph& graph = program_.graph;
    Lowering lowering(graph, solution_.ring);
    for (GeneratorId id = 0; id < solution_.ring->size(); ++id)
        if (const auto known = surroundings_.symbols.find(solution_.ring->generator(id).name);
            known != surroundings_.symbols.end())
            lowering.define(id, known->second, false);
    define_constant_roots(lowering);
    StartConstants start(program_, solution_, scene_, {}, names_);
    for (const SlowLaw& law : solution_.slow) {
        const Variable& variable = solution_.system().variables[law.variable];
        const Graph::Node begin =
            start.input(variable.name + "_0", variable.name + " at t = 0", variable.name);
        const Graph::Node rate = lowering.radicand(law.rate);
        const Graph::Node value = graph.add({begin, graph.multiply({rate, program_.slow_time})});
        slow_starts_[law.generator] = begin;
        slow_values_[law.generator] = names_[variable.name] = value;
        quadratures_.set_clock_rate(rate);
        program_.slow.push_back({variable.name, value});
        program_.names.push_back({variable.name, value});
        // What must not vanish keeps the sign that it starts with.
        if (variable.nonzero && !variable.positive)
            program_.positive.push_back(graph.multiply({begin, value}));
        if (!variable.positive) continue;
        program_.positive.push_back(value);
        surroundings_.positive.insert({begin, value});
    }
}

// theta' = sum eps^n Theta_n, taken over slow time: d theta/dT = theta'/eps
void ProgramBuilder::define_phase(Moment& call, Graph::Node start) {
    Graph& graph = program_.graph;
    for (const ModeSolution& mode : solution_.modes) {
        const Graph::Node cosine = graph.symbol("cos theta"), sine = graph.symbol("sin theta");
        const Polynomial rate = mode.phase_rate.total(mode.phase_rate.through());
        const Graph::Node over_time = by_powers_of_eps(rate, call, "theta_dot", false);
        const Graph::Node over_slow_time = graph.multiply({graph.power(program_.eps, -1), over_time});
        program_.phases.push_back({"theta", start, over_slow_time, cosine, sine});
        call.harmonics.set_angle(mode.phase, cosine, sine);
    }
}

// c_0 + eps (c_1 + eps (c_2 + ...)), each c_n named
Graph::Node ProgramBuilder::by_powers_of_eps(const Polynomial& p, Moment& call, const std::string& name,
                                             bool oscillating) {
    Graph& graph = program_.graph;
    std::map<int, Polynomial> parts;
    for (auto& [power, coefficient] : solution_.ring->collect(p, {solution_.eps}))
        parts.emplace(solution_.ring->exponent(power, solution_.eps), std::move(coefficient));
    Graph::Node sum = graph.rational(0);
    int above = 0;
    for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
        const Graph::Node value = call.harmonics.value(part->second, oscillating);
        program_.names.push_back({fmt::format("{}_{}", identifier(name), part->first), value});
        sum = graph.add({value, graph.multiply({graph.power(program_.eps, above - part->first), sum})});
        above = part->first;
    }
    return graph.multiply({graph.power(program_.eps, above), sum});
}

const SolutionOutput& ProgramBuilder::output_of(const std::string& name) const {
    const auto found = std::find_if(solution_.outputs.begin(), solution_.outputs.end(),
                                    [&](const SolutionOutput& output) { return output.name == name; });
    if (found == solution_.outputs.end())
        bad_input(
            {"an output is a fast or a drift variable of the system", name, "remove it from outputs", {}});
    return *found;
}

void ProgramBuilder::define_results(Moment& call) {
    const auto lower = [&](const SolutionOutput& output, bool oscillating) {
        const Polynomial all = output.value.total(output.value.through());
        const auto [rest, table] = quadratures_.extract(all, call, identifier(output.name));
        return program_.graph.add({by_powers_of_eps(rest, call, output.name, oscillating), table});
    };
    for (const std::string& name : scene_.outputs) {
        const bool slow = std::any_of(program_.slow.begin(), program_.slow.end(),
                                      [&](const ProgramOutput& variable) { return variable.name == name; });
        program_.outputs.push_back(
            {name, slow ? names_.at(name) : lower(output_of(name), scene_.oscillating)});
    }
    if (options_.keep_state)
        for (const SolutionOutput& state : solution_.state)
            program_.state.push_back({state.name, lower(state, true)});
    for (const auto& [k, pair] : call.harmonics.multiples()) {
        if (k == 1) continue;
        program_.names.push_back({fmt::format("cos_{}theta", k), pair.first});
        program_.names.push_back({fmt::format("sin_{}theta", k), pair.second});
    }
}

// The value of an expression in eps and fixed parameters, at the smallest eps of the ladder if it
// depends on eps.
double ProgramBuilder::number_of(const GiNaC::ex& e) const {
    GiNaC::exmap values;
    for (const Parameter& parameter : solution_.system().parameters)
        if (const auto fixed = scene_.fix.find(parameter.name); fixed != scene_.fix.end())
            values[parameter.symbol] = GiNaC::numeric(cln::cl_N(fixed->second));
    if (!scene_.verify.eps.empty())
        values[solution_.system().eps] = GiNaC::numeric(cln::cl_N(scene_.verify.eps.back()));
    const GiNaC::ex value = e.subs(values).evalf();
    if (!GiNaC::is_a<GiNaC::numeric>(value))
        bad_input({"the interval of a scene is a number once [fix] and eps are put in",
                   scene_.verify.interval_text,
                   "give the parameters in it under [fix]",
                   {}});
    return GiNaC::ex_to<GiNaC::numeric>(value).to_double();
}

void ProgramBuilder::declare_domain() {
    for (const Declaration& condition : solution_.system().positive) {
        const Graph::Node node = from_expression(program_.graph, condition.value, names_);
        const bool known =
            std::find(program_.positive.begin(), program_.positive.end(), node) != program_.positive.end();
        if (!known) program_.positive.push_back(node);
    }
    const GiNaC::ex slow_time = scene_.verify.interval * solution_.system().eps;
    program_.interval_slow_time = number_of(slow_time);
    program_.slow_time_end = from_expression(program_.graph, slow_time, names_);
}

// "with g = 1, r = 1, v = 1", in the order of the system's file
std::string fixed_values(const System& system, const Scene& scene) {
    std::string text;
    for (const Parameter& parameter : system.parameters)
        if (const auto fixed = scene.fix.find(parameter.name); fixed != scene.fix.end())
            text += fmt::format("{} {} = {}", text.empty() ? "with" : ",", parameter.name,
                                to_string(fixed->second));
    return text;
}

// The same scene with nothing left out and nothing fixed: what the evaluator would compute without pruning.
Program without_savings(const Solution& solution, Scene scene) {
    scene.outputs.clear();
    for (const SolutionOutput& output : solution.outputs) scene.outputs.push_back(output.name);
    scene.oscillating = true;
    return ProgramBuilder(solution, scene, {false, false}).build();
}

} // namespace

Program build_program(const Solution& solution, const Scene& scene, const ProgramOptions& options) {
    Program program = ProgramBuilder(solution, scene, options).build();
    prune(program);
    program.notes = scene_formulas(solution, scene, !program.phases.empty());
    if (options.fold_fixed && !scene.fix.empty())
        program.notes.push_back(fixed_values(solution.system(), scene));
    if (!solution.system().source.empty()) program.notes.push_back("source: " + solution.system().source);
    program.before = count_written_out(without_savings(solution, scene));
    program.after = count_operations(program);
    return program;
}

} // namespace resonform
