// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/scene_program.hpp"

#include "algebra/number/error.hpp"
#include "emit/display/identifier.hpp"
#include "emit/display/quantity.hpp"
#include "emit/graph/conditioning.hpp"
#include "emit/graph/from_expression.hpp"
#include "model/files/interval_length.hpp"
#include "solve/slow_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace resonform {

Graph::Node add_start_input(Program& program, const Scene& scene,
                            const std::map<std::string, Graph::Node>& names, const std::string& name,
                            const std::string& meaning, const std::string& canonical) {
    const Graph::Node symbol = program.graph.symbol("start " + name); // no parameter has a space in its name
    const StartValue* given = scene.start_of(canonical);
    const Graph::Node value =
        given == nullptr ? program.graph.rational(0)
                         : from_expression(program.graph, given->value, names, place_of(given->source),
                                           [&](const std::string& function, int derivative, Graph::Node x) {
                                               return program.graph.callable(function, derivative, x);
                                           });
    program.start.push_back({identifier(name), meaning, symbol, value, canonical});
    return symbol;
}

Graph::Node SceneProgram::input(const std::string& name, const std::string& meaning,
                                const std::string& canonical) {
    return add_start_input(program_, scene_, names_, name, meaning, canonical);
}

void SceneProgram::open(const std::string& eps) {
    program_.system = solution_.system().name;
    program_.scene = scene_.name;
    program_.title = scene_.title;
    program_.order = solution_.order;
    program_.truncation = solution_.truncation;
    program_.eps = program_.graph.symbol("eps");
    program_.time = program_.graph.symbol("t");
    program_.slow_time = program_.graph.symbol("slow time"); // a space: no parameter has this name
    program_.eps_root = solution_.system().eps_root;
    program_.small = program_.graph.root(program_.eps, program_.eps_root);
    names_[solution_.system().eps.get_name()] = program_.small;
    surroundings_.symbols[eps] = program_.small;
    surroundings_.positive.insert({program_.eps, program_.small});
    program_.slow_time_end = program_.graph.rational(1);
    for (const NamedFunction& f : solution_.system().functions) {
        if (f.data != nullptr) surroundings_.data.emplace(f.name, f.data);
        if (f.callable) surroundings_.callables.emplace(f.name, f.positive);
    }
    define_parameters();
}

void SceneProgram::define_parameters() {
    surroundings_.symbols["pi"] = from_expression(program_.graph, GiNaC::Pi, {});
    surroundings_.positive.insert(surroundings_.symbols["pi"]);
    for (const Parameter& parameter : solution_.system().parameters) {
        const auto fixed = scene_.fix.find(parameter.name);
        const Graph::Node value =
            fixed == scene_.fix.end()
                ? -1
                : from_expression(program_.graph, fixed->second, {},
                                  {scene_.file.string(), 0, 0, "fix." + parameter.name, ""});
        Graph::Node node = value;
        if (node < 0 || !options_.fold_fixed) {
            node = program_.graph.symbol(parameter.name);
            program_.parameters.push_back(
                {identifier(parameter.name), "parameter " + parameter.name, node, value});
            if (parameter.positive) program_.positive.push_back({node, parameter.name});
        }
        if (parameter.positive) surroundings_.positive.insert(node);
        surroundings_.symbols[parameter.name] = names_[parameter.name] = node;
    }
}

// xi_0 + drive T, or xi_0 e^{-bT} + drive (1 - e^{-bT})/b: where xi_0, drive and b are positive, nothing
// cancels, and the second part keeps its digits where b T is small.
Graph::Node SceneProgram::value_on_path(const std::string& xi, Graph::Node begin, Graph::Node drive,
                                        Graph::Node decline) {
    Graph& graph = program_.graph;
    if (decline < 0) return graph.add({begin, graph.multiply({drive, program_.slow_time})});
    const Graph::Node exponent = graph.negate(graph.multiply({decline, program_.slow_time}));
    if (!signs_of(graph, graph.negate(decline), surroundings_.positive).is_positive())
        end_behind(exponent, xi);
    const Graph::Node lost = graph.negate(graph.function(Graph::Op::expm1, {exponent}));
    return graph.add({graph.multiply({begin, graph.function(Graph::Op::exp, {exponent})}),
                      graph.multiply({drive, graph.power(decline, -1), lost})});
}

void SceneProgram::end_behind(Graph::Node exponent, const std::string& quantity, Graph::Node of) {
    Graph& graph = program_.graph;
    const Graph::Node margin = graph.add({graph.rational(most_relaxations), exponent});
    if (!signs_of(graph, margin, surroundings_.positive).is_positive())
        program_.layers.push_back({margin, quantity, false, true, of});
}

void SceneProgram::move_slow(const Variable& variable, const std::string& called, Graph::Node begin,
                             Graph::Node value) {
    names_[variable.name] = value;
    program_.names.push_back({called, value});
    // A variable declared nonzero must keep the sign that it starts with.
    if (variable.nonzero && !variable.positive)
        program_.positive.push_back({program_.graph.multiply({begin, value}), variable.name});
    if (!variable.positive) return;
    program_.positive.push_back({value, variable.name});
    surroundings_.positive.insert({begin, value});
}

// c_0 + eps (c_1 + eps (c_2 + ...)), each c_n named
Graph::Node
SceneProgram::by_powers_of_eps(const Ring& ring, GeneratorId eps, const Polynomial& p,
                               const std::string& name,
                               const std::function<Graph::Node(const Polynomial&, int power)>& value) {
    Graph& graph = program_.graph;
    std::map<int, Polynomial> parts;
    for (auto& [power, coefficient] : ring.collect(p, {eps}))
        parts.emplace(ring.exponent(power, eps), std::move(coefficient));
    Graph::Node sum = graph.rational(0);
    int above = 0;
    for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
        const Graph::Node node = value(part->second, part->first);
        program_.names.push_back({fmt::format("{}_{}", identifier(name), part->first), node});
        sum = graph.add({node, graph.multiply({graph.power(program_.small, above - part->first), sum})});
        above = part->first;
    }
    return graph.multiply({graph.power(program_.small, above), sum});
}

GiNaC::ex SceneProgram::slow_time() const {
    const System& system = solution_.system();
    return scene_.verify.interval * GiNaC::pow(system.eps, system.eps_root);
}

// The slow time of the interval at the smallest eps of the ladder; infinite or 0 where double cannot hold it.
double SceneProgram::interval_slow_time() const {
    const Rational eps = scene_.verify.eps.empty() ? Rational(1) / Rational(100) : scene_.verify.eps.back();
    const double end = length_at(scene_, slow_time(), eps);
    if (std::isnan(end))
        bad_input({"the interval of a scene is a positive number once [fix] and eps are put in",
                   scene_.verify.interval_text, "give the parameters in it under [fix]",
                   scene_.verify.interval_source ? place_of(*scene_.verify.interval_source) : Place()});
    return end;
}

void SceneProgram::close() {
    const NamedNode named = [this](const std::string& name, int derivative, Graph::Node x) {
        return named_node(program_.graph, surroundings_, name, derivative, x);
    };
    for (const Declaration& condition : solution_.system().positive) {
        const Graph::Node node =
            from_expression(program_.graph, condition.value, names_, place_of(condition.source), named);
        const bool known = std::any_of(program_.positive.begin(), program_.positive.end(),
                                       [&](const ProgramCondition& c) { return c.value == node; });
        if (!known) program_.positive.push_back({node, short_quantity(condition.text)});
    }
    // Conditions of the start map go last: if it fails because a divisor nearly vanishes, name the divisor.
    std::stable_partition(program_.positive.begin(), program_.positive.end(),
                          [](const ProgramCondition& c) { return !c.of_start_map; });
    program_.interval_slow_time = interval_slow_time();
    program_.slow_time_end =
        from_expression(program_.graph, slow_time(), names_,
                        scene_.verify.interval_source ? place_of(*scene_.verify.interval_source) : Place());
}

} // namespace resonform
