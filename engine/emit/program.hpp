// SPDX-License-Identifier: GPL-3.0-or-later
// A scene as one pruned expression graph: what the emitted evaluator computes, and when.
//
//   construction (once):  parameters, start values, eps -> constants, quadrature tables
//   call (per t):         t -> slow variables, theta, outputs
#pragma once

#include "emit/graph.hpp"
#include "model/scene_file.hpp"
#include "solve/solution.hpp"

#include <string>
#include <vector>

namespace resonform {

// An argument of the evaluator's constructor with its default from the scene. Its name is a C++
// identifier; C++ name of "psi'" is psi_dot.
struct ProgramInput {
    std::string name;    // "g", "xi_0", "C_delta", "theta_0", "psi_0", "psi_dot_0"
    std::string meaning; // "amplitude.psi", "parameter g", "start of xi"
    Graph::Node symbol;
    Graph::Node default_value; // in eps and parameters (a constant, or 3/10*eps)
};

// A quadrature as a function of slow time T = eps t: value(T) = int_0^T integrand(T') dT'.
struct ProgramTable {
    std::string name;      // "theta", "Q_x2"
    Graph::Node integrand; // in slow_time and construction values
    Graph::Node value;     // the symbol that stands for value(T) in the call section
};

struct ProgramOutput {
    std::string name; // "psi"
    Graph::Node value;
};

struct Program {
    std::string system, scene, title;
    int order = 0, truncation = 0;
    std::vector<std::string> notes; // equations it computes, source: for the banner
    Graph graph;
    Graph::Node eps, time, slow_time;     // symbols; slow_time = eps*time
    std::vector<ProgramInput> parameters; // those not fixed and needed
    std::vector<ProgramInput> start;      // those needed
    std::vector<ProgramTable> tables;     // in order of construction
    std::vector<ProgramOutput> slow;      // slow variables as functions of slow_time
    std::vector<ProgramOutput> outputs;   // as the scene lists them
    std::vector<ProgramOutput> state;     // all states at full weight (for direct integration), at any t
    std::vector<Graph::Node> positive;    // must be > 0 at every call, else status outside_domain
    double interval_slow_time = 1;        // horizon in slow time the scene asks for (verify.interval * eps)
    struct Count {
        int add = 0, multiply = 0, divide = 0, root = 0, sincos = 0, other = 0, tables = 0;
    };
    Count before, after; // per call, before and after pruning and sharing
};

struct ProgramOptions {
    bool fold_fixed = true;  // false: [fix] values become defaults of parameters (stability sweep)
    bool keep_state = false; // true: `state` is filled and its quadratures kept
};

Program build_program(const Solution& solution, const Scene& scene, const ProgramOptions& options = {});

} // namespace resonform
