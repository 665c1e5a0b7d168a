// SPDX-License-Identifier: GPL-3.0-or-later
// The common beginning and end of all programs of a scene: title, symbols, parameters, start values, domain
// and interval.
#pragma once

#include "emit/program/moment.hpp"
#include "emit/program/program.hpp"

#include <functional>
#include <map>
#include <string>

namespace resonform {

class SceneProgram {
public:
    SceneProgram(const Solution& solution, const Scene& scene, const ProgramOptions& options)
        : solution_(solution), scene_(scene), options_(options) {}

protected:
    // Title, symbols and parameters. eps: the name of its generator.
    void open(const std::string& eps);
    // The conditions that the files declare positive, and the interval.
    void close();

    // An argument of the evaluator with its default from the scene (0 if it gives none).
    Graph::Node input(const std::string& name, const std::string& meaning, const std::string& canonical);
    // c_0 + eps (c_1 + eps (c_2 + ...)), each c_n = value(part, n) named
    Graph::Node by_powers_of_eps(const Ring& ring, GeneratorId eps, const Polynomial& p,
                                 const std::string& name,
                                 const std::function<Graph::Node(const Polynomial&, int power)>& value);

    // xi at slow time T, where d xi/dT = drive - decline xi from begin. decline: not zero, or -1 for none;
    // the evaluator ends after most_relaxations of it.
    Graph::Node value_on_path(const std::string& xi, Graph::Node begin, Graph::Node drive,
                              Graph::Node decline);
    // Lets the evaluator end where e^exponent has fallen to e^{-most_relaxations}, unless it never does. The
    // condition is pruned with the node `of`, if there is one.
    void end_behind(Graph::Node exponent, const std::string& quantity, Graph::Node of = -1);
    // Gives a slow variable its value during a call, and adds the conditions of its sign. called: its name
    // for readers.
    void move_slow(const Variable& variable, const std::string& called, Graph::Node begin, Graph::Node value);

    const Solution& solution_;
    const Scene& scene_;
    const ProgramOptions& options_;
    Program program_;
    Surroundings surroundings_;
    std::map<std::string, Graph::Node> names_; // of the user's files: eps, parameters, slow variables

private:
    void define_parameters();
    [[nodiscard]] GiNaC::ex slow_time() const; // of the interval
    [[nodiscard]] double interval_slow_time() const;
};

// An argument of the evaluator's constructor that [start] of the scene may give.
Graph::Node add_start_input(Program& program, const Scene& scene,
                            const std::map<std::string, Graph::Node>& names, const std::string& name,
                            const std::string& meaning, const std::string& canonical);

} // namespace resonform
