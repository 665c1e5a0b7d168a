// SPDX-License-Identifier: GPL-3.0-or-later
// The generators of a solution's ring as nodes, at a given time: during a call (slow variables move with
// slow time) or at the start (they have their start values, quadratures are zero).
#pragma once

#include "emit/program/harmonics.hpp"
#include "emit/program/program.hpp"

#include <functional>
#include <map>
#include <set>
#include <string>

namespace resonform {

// Nodes that are the same at every moment.
struct Surroundings {
    std::map<std::string, Graph::Node>
        symbols;                    // eps, parameters, constants of the solution, by generator name
    std::set<Graph::Node> positive; // nodes whose sign is declared
    std::map<std::string, DataPointer> data = {}; // by the function that they are the value of
    std::map<std::string, bool> callables = {};   // likewise; whether it is declared positive
};

// The derivative-th derivative at x of a function that is evaluated by its name.
Graph::Node named_node(Graph& graph, const Surroundings& surroundings, const std::string& name,
                       int derivative, Graph::Node x);

struct MomentPlan {
    Graph::Node slow_time = -1;                        // T
    std::map<GeneratorId, Graph::Node> slow_variables; // in the ring of the solution
    // The value of a quadrature; called in the order of Solution::primitives.
    std::function<Graph::Node(const Primitive&, Lowering&)> quadrature;
};

// Defines the roots and functions of a ring, and adds conditions that radicands are positive and arguments in
// the domain of their function where that is not known; divisors (index 1) get no condition.
void define_roots_and_functions(Lowering& lowering, Program& program, const Surroundings& surroundings,
                                bool named);

class Moment {
public:
    // ring: that of the solution, or one that holds its generators under the same names.
    Moment(Program& program, const Solution& solution, RingPtr ring, const Surroundings& surroundings,
           const MomentPlan& plan);
    Moment(const Moment&) = delete;
    Moment& operator=(const Moment&) = delete;

    Lowering lowering;
    Harmonics harmonics;

private:
    void define_primitives(Program& program, const Solution& solution, const Surroundings& surroundings,
                           const MomentPlan& plan);
    void define(const Program& program, GeneratorId id, Graph::Node node);
    GeneratorId own(GeneratorId id, const Solution& solution) const;

    RingPtr ring_;
};

} // namespace resonform
