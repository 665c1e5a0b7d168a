// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/build_program.hpp"

#include "algebra/number/error.hpp"
#include "algebra/ring/constant.hpp"
#include "emit/display/identifier.hpp"
#include "emit/display/quantity.hpp"
#include "emit/graph/lower.hpp"
#include "emit/program/corrections.hpp"
#include "emit/program/fixed_divisors.hpp"
#include "emit/program/flow_program.hpp"
#include "emit/program/harmonics.hpp"
#include "emit/program/layers.hpp"
#include "emit/program/moment.hpp"
#include "emit/program/operations.hpp"
#include "emit/program/prune.hpp"
#include "emit/program/quadratures.hpp"
#include "emit/program/scene_formulas.hpp"
#include "emit/program/scene_program.hpp"
#include "emit/program/start_constants.hpp"
#include "emit/program/straight_line.hpp"
#include "model/text/canonical.hpp"
#include "solve/first_correction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>

namespace resonform {

namespace {

class ProgramBuilder : SceneProgram {
public:
    ProgramBuilder(const Solution& solution, const Scene& scene, const ProgramOptions& options)
        : SceneProgram(solution, scene, options), quadratures_(program_, solution) {}

    Program build() {
        open(solution_.ring->generator(solution_.eps).name);
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
        const RingMap& real = *solution_.from_normal_form;
        add_layers(
            program_, *solution_.normalization, surroundings_,
            [&](const Polynomial& p) { return call.lowering.polynomial(real(p)); },
            [&](const Polynomial& p) { return call.lowering.divisor(real(p)); });
        if (!solution_.modes.empty())
            add_corrections(
                program_, solution_, surroundings_,
                {{call.lowering.polynomial(leading_modulus(solution_)), program_.graph.rational(0)}},
                [&](const Polynomial& p) { return call.lowering.polynomial(p); });
        add_transients(call);
        constants.require_map(surroundings_);
        close();
        return std::move(program_);
    }

private:
    void define_constant_roots(Lowering& lowering);
    void define_slow_variables();
    void define_phase(Moment& call, Graph::Node start);
    void divide_rate(ProgramPhase& phase, const Polynomial& rate, Moment& call);
    void define_results(Moment& call);
    void add_transients(const Moment& call);
    Graph::Node lower(const Polynomial& p, Moment& call, const std::string& name, bool oscillating,
                      Amplitudes* rows = nullptr);
    Graph::Node result(const SolutionOutput& output, Moment& call, bool oscillating,
                       Amplitudes* rows = nullptr);
    void define_output(const std::string& name, Moment& call);
    const SolutionOutput& output_of(const std::string& name) const;
    [[nodiscard]] std::vector<int> no_turns() const {
        return std::vector<int>(solution_.modes.size(), 0); // one phase for each
    }

    Quadratures quadratures_;
    std::map<GeneratorId, Graph::Node> slow_starts_, slow_values_;
};

// Roots of parameters and numbers, by which the ring may have written a parameter: a = root^2.
void ProgramBuilder::define_constant_roots(Lowering& lowering) {
    for (GeneratorId id = 0; id < solution_.ring->size(); ++id) {
        const Generator& g = solution_.ring->generator(id);
        if (g.kind == GeneratorKind::root && is_constant(*solution_.ring, g.radicand))
            lowering.define(id, program_.graph.root(lowering.conditioned(g.radicand), g.index), false);
    }
}

void ProgramBuilder::define_slow_variables() {
    Lowering lowering(program_.graph, solution_.ring);
    for (GeneratorId id = 0; id < solution_.ring->size(); ++id)
        if (const auto known = surroundings_.symbols.find(solution_.ring->generator(id).name);
            known != surroundings_.symbols.end())
            lowering.define(id, known->second, false);
    define_constant_roots(lowering);
    for (const SlowLaw& law : solution_.slow) {
        const Variable& variable = solution_.system().variables[law.variable];
        const Graph::Node begin = input(variable.name + "_0", variable.name + " at t = 0", variable.name);
        const Graph::Node drive = lowering.radicand(law.path.drive);
        const bool relaxes = law.path.relaxes();
        const Graph::Node value =
            value_on_path(variable.name, begin, drive, relaxes ? lowering.radicand(law.path.decline) : -1);
        slow_starts_[law.generator] = begin;
        slow_values_[law.generator] = value;
        if (!relaxes) quadratures_.set_clock_rate(drive);
        program_.slow.push_back({variable.name, value});
        move_slow(variable, variable.name, begin, value);
    }
}

// theta' = sum eps^n Theta_n, taken over slow time: d theta/dT = theta'/eps
void ProgramBuilder::define_phase(Moment& call, Graph::Node start) {
    Graph& graph = program_.graph;
    for (const ModeSolution& mode : solution_.modes) {
        const Graph::Node cosine = graph.symbol("cos theta"), sine = graph.symbol("sin theta");
        const Polynomial rate = mode.phase_rate.total(mode.phase_rate.through());
        const Graph::Node over_time = lower(rate, call, "theta_dot", false);
        const Graph::Node over_slow_time = graph.multiply({graph.power(program_.eps, -1), over_time});
        program_.phases.push_back({"theta", start, over_slow_time, cosine, sine, -1, {}});
        divide_rate(program_.phases.back(), rate, call);
        call.harmonics.set_angle(mode.phase, cosine, sine);
    }
}

void ProgramBuilder::divide_rate(ProgramPhase& phase, const Polynomial& rate, Moment& call) {
    std::vector<Term> main, small;
    for (const Term& term : rate.terms()) {
        const bool is_small = solution_.ring->exponent(term.monomial, solution_.eps) >= 2 * program_.eps_root;
        (is_small ? small : main).push_back(term);
    }
    if (main.empty() || small.empty()) return;
    const std::size_t named = program_.names.size();
    const auto over_slow_time = [&](std::vector<Term> part) {
        const Graph::Node over_time =
            lower(Polynomial::from_terms(std::move(part)), call, "theta_dot", false);
        return program_.graph.multiply({program_.graph.power(program_.eps, -1), over_time});
    };
    phase.main_rate = over_slow_time(std::move(main));
    phase.small_rate = over_slow_time(std::move(small));
    program_.names.resize(named); // they are the parts of the whole rate
}

Graph::Node ProgramBuilder::lower(const Polynomial& p, Moment& call, const std::string& name,
                                  bool oscillating, Amplitudes* rows) {
    return by_powers_of_eps(*solution_.ring, solution_.eps, p, name, [&](const Polynomial& part, int power) {
        return call.harmonics.value(part, oscillating, rows, power);
    });
}

const SolutionOutput& ProgramBuilder::output_of(const std::string& name) const {
    const auto found = std::find_if(solution_.outputs.begin(), solution_.outputs.end(),
                                    [&](const SolutionOutput& output) { return output.name == name; });
    if (found == solution_.outputs.end())
        bad_input(
            {"an output is a fast or a drift variable of the system", name, "remove it from outputs", {}});
    return *found;
}

Graph::Node ProgramBuilder::result(const SolutionOutput& output, Moment& call, bool oscillating,
                                   Amplitudes* rows) {
    const Polynomial all = output.value.total(output.value.through());
    const auto [rest, table] = quadratures_.extract(all, call, identifier(output.name));
    if (rows != nullptr) rows->add(no_turns(), 0, table);
    return program_.graph.add({lower(rest, call, output.name, oscillating, rows), table});
}

void ProgramBuilder::define_output(const std::string& name, Moment& call) {
    const bool slow = std::any_of(program_.slow.begin(), program_.slow.end(),
                                  [&](const ProgramOutput& variable) { return variable.name == name; });
    Amplitudes amplitudes;
    if (slow) amplitudes.add(no_turns(), 0, names_.at(name));
    const Graph::Node value =
        slow ? names_.at(name)
             : result(output_of(name), call, scene_.oscillating, options_.rows ? &amplitudes : nullptr);
    if (options_.rows) amplitudes.append_to(program_, program_.outputs.size());
    program_.outputs.push_back({name, value});
}

void ProgramBuilder::define_results(Moment& call) {
    for (const std::string& name : scene_.outputs) define_output(name, call);
    if (options_.keep_state)
        for (const SolutionOutput& state : solution_.state)
            program_.state.push_back({state.name, result(state, call, true)});
    for (const auto& [k, pair] : call.harmonics.multiples()) {
        if (k == 1) continue;
        program_.names.push_back({fmt::format("cos_{}theta", k), pair.first});
        program_.names.push_back({fmt::format("sin_{}theta", k), pair.second});
    }
}

// Exponentials e^a of slow time end the evaluator where a = -most_relaxations.
void ProgramBuilder::add_transients(const Moment& call) {
    std::set<Graph::Node> tables;
    for (const ProgramTable& table : program_.tables) tables.insert(table.value);
    for (const Primitive& p : solution_.primitives) {
        if (p.kind != PrimitiveKind::exponential) continue;
        const Graph::Node exponent = quadratures_.without_tables(p.argument, call.lowering);
        if (depending(program_.graph, tables)[static_cast<std::size_t>(exponent)]) continue;
        if (varies(program_, exponent))
            end_behind(exponent, fmt::format("exp({})", quantity(*solution_.ring, p.argument)),
                       call.lowering.node(p.id));
    }
}

// "with g = 1, r = 1, v = 1", in the order of the system's file
std::string fixed_values(const System& system, const Scene& scene) {
    std::string text;
    const auto add = [&](const std::string& name) {
        if (const auto fixed = scene.fix.find(name); fixed != scene.fix.end())
            text += fmt::format("{} {} = {}", text.empty() ? "with" : ",", name, spell(fixed->second));
    };
    for (const Setting& setting : system.settings) add(setting.parameter);
    for (const auto* list : {&system.parameters, &system.cancelled})
        for (const Parameter& parameter : *list) add(parameter.name);
    return text;
}

// "omega(tau) = sqrt(1 + tau^2)", "omega(tau): spline of degree 5 through 33 points of omega.csv",
// "omega(tau): an object that the caller gives"
std::string given_value(const NamedFunction& f) {
    const std::string head = f.name + "(" + f.of + ")";
    if (f.value) return head + " = " + spell(f.value->value);
    return head + ": " + (f.callable ? "an object that the caller gives" : f.data_text);
}

Program built(const Solution& solution, const Scene& scene, const ProgramOptions& options) {
    return solution.flow ? build_flow_program(solution, scene, options)
                         : ProgramBuilder(solution, scene, options).build();
}

// With rational numbers put in, a division by zero shows by itself; that sqrt(2)^2 + w - 3 is zero has to be
// checked.
bool all_rational(const Scene& scene) {
    return std::all_of(scene.fix.begin(), scene.fix.end(),
                       [](const auto& fixed) { return GiNaC::is_a<GiNaC::numeric>(fixed.second); });
}

// Reports a division by zero as a divisor of the normal form, if it is one.
Program built_with_reason(const Solution& solution, const Scene& scene, const ProgramOptions& options) {
    if (!all_rational(scene)) require_divisors(*solution.normalization, scene);
    try {
        return built(solution, scene, options);
    } catch (const DivisionByZero&) {
        require_divisors(*solution.normalization, scene);
        throw;
    }
}

// The same scene with nothing left out and nothing fixed: what the evaluator would compute without pruning.
Program without_savings(const Solution& solution, Scene scene) {
    scene.outputs.clear();
    if (solution.flow)
        for (const FlowOutput& output : solution.flow->outputs) scene.outputs.push_back(output.name);
    for (const SolutionOutput& output : solution.outputs) scene.outputs.push_back(output.name);
    scene.oscillating = scene.transients = true; // what is only a transient may be listed
    return built(solution, scene, {false, false});
}

} // namespace

Program build_program(const Solution& solution, const Scene& scene, const ProgramOptions& wanted) {
    ProgramOptions options = wanted;
    const bool opaque = solution.system().has_opaque_functions();
    options.rows = wanted.rows && !opaque;
    Program program = built_with_reason(solution, scene, options);
    if (wanted.rows && opaque)
        program.form_reason = solution.system().has_data() ? "no tables of data" : "no tables of callables";
    prune(program, wanted.kept_inputs);
    find_data(program);
    program.notes = scene_formulas(solution, scene, !program.phases.empty());
    for (const NamedFunction& f : solution.system().functions)
        if (f.value || f.is_opaque()) program.notes.push_back(given_value(f));
    if (options.fold_fixed && !scene.fix.empty())
        program.notes.push_back(fixed_values(solution.system(), scene));
    if (!solution.system().source.empty()) program.notes.push_back("source: " + solution.system().source);
    program.before = count_written_out(without_savings(solution, scene));
    program.after = count_operations(program);
    if (wanted.rows) choose_form(program, scene.form, scene.form_place, options.longest_formula);
    return program;
}

} // namespace resonform
