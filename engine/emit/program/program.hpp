// SPDX-License-Identifier: GPL-3.0-or-later
// A scene as one pruned expression graph: the values that the emitted evaluator computes, and when.
//
//   construction (once):  parameters, start values, eps -> constants, quadrature tables
//   call (per t):         t -> slow variables, cos theta, sin theta, outputs
#pragma once

#include "emit/graph/graph.hpp"
#include "model/system/scene_file.hpp"
#include "solve/solution.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace resonform {

// An argument of the evaluator's constructor with its default from the scene. Its name is a C++
// identifier; C++ name of "psi'" is psi_dot.
struct ProgramInput {
    std::string name;    // "g", "xi_0", "C_delta", "theta_0", "psi_0", "psi_dot_0"
    std::string meaning; // "amplitude.psi", "parameter g", "start of xi"
    Graph::Node symbol;
    Graph::Node default_value;  // in eps and parameters (a constant, or 3/10*eps); -1: none, it must be given
    std::string canonical = {}; // of a start value: its name in [start], "psi'", "amplitude.psi"
};

// One variable of the slow flow: d value/dT = rate(T, values of the flow), value(0) = start.
struct ProgramFlow {
    std::string name;  // "u_x"
    Graph::Node start; // in construction values
    Graph::Node rate;  // in slow_time, construction values and values of the flow
    Graph::Node value; // the symbol that stands for it
};

// A quadrature as a function of slow time T = eps t: value(T) = int_0^T integrand(T') dT'.
struct ProgramTable {
    std::string name;      // "Q_x"
    Graph::Node integrand; // in slow_time, construction values, the flow and values of earlier tables
    Graph::Node value;     // the symbol that stands for value(T) in the call section
};

// An angle theta(t) = start + int_0^T rate(T') dT', T = eps t, where rate = theta'/eps is large. Only its
// cosine and sine enter the outputs, so that it can be kept in more digits than it is asked for. Or the
// exponent of a mode that decays (or grows), of which e^theta enters.
struct ProgramPhase {
    std::string name;  // "theta", "chi"
    Graph::Node start; // in construction values
    Graph::Node rate;  // in slow_time, construction values, values of the flow and of tables
    // The symbols that stand for cos theta and sin theta, or for e^theta, in the call section; else -1.
    Graph::Node cosine = -1, sine = -1, exponential = -1;
    // Of an angle with which only modes turn that decay: their exponentials.
    std::vector<Graph::Node> fades_with = {};
    // Of an exponent that grows, in construction values: where this times e^theta exceeds 1, digits are lost.
    Graph::Node growth = -1;
    // Where its rate, or a divisor of what decays with it, may vanish: lists of nodes of a call. One of each
    // list is > 0, or digits are lost.
    std::vector<std::vector<Graph::Node>> precision = {};
    // The rate as a sum, where the second part turns the phase by a small angle that double has the digits
    // of: what has a factor eps^2 in theta'. -1: it is not divided.
    Graph::Node main_rate = -1, small_rate = -1;
    std::string of = {}; // of a slow flow, what turns or decays with it: "z1 of x, z3 of y"
    [[nodiscard]] bool decays() const { return exponential >= 0; }
    [[nodiscard]] std::vector<Graph::Node> symbols() const {
        if (decays()) return {exponential};
        return {cosine, sine};
    }
};

struct ProgramOutput {
    std::string name; // "psi"
    Graph::Node value;
};

// A part of an output: its amplitude times 1, cos k.theta or sin k.theta, and e^{d.chi} of what decays. The
// output is the sum of its rows.
enum class ProgramWave { one, cosine, sine };
struct ProgramRow {
    std::size_t output = 0; // index into Program::outputs
    ProgramWave wave = ProgramWave::one;
    std::vector<int> turns;     // k and d, one for each phase; the first k that is not 0 is positive
    Graph::Node amplitude = -1; // in slow_time, construction values, the flow and tables
};

// A quantity that must be > 0, and its name for a reader: "xi", "r^2 - xi^2", a divisor.
struct ProgramCondition {
    Graph::Node value;
    std::string quantity;
    bool of_start_map = false; // the near-identity map leads back to the start
    bool broad = false;        // of a layer: a few samples see where it begins
    Graph::Node of = -1;       // if it is one: pruned with this node
};

// Operations of one call; a power x^n counts as its multiplications.
struct OperationCount {
    int add = 0, multiply = 0, divide = 0, root = 0, sincos = 0, other = 0, tables = 0;
};

// Of a point among many; nullopt: there can be no such form.
struct OperationsByForm {
    std::optional<int> tables, atoms;
    int direct = 0;
};

// A function that is given by data, and the slow variable that it stands at: linear in slow time.
struct ProgramData {
    DataPointer samples;
    Graph::Node argument = -1; // in slow_time and construction values
};

struct Program {
    std::string system, scene, title;
    int order = 0, truncation = 0; // in units of 1/eps_root, as weights are held
    int eps_root = 1;
    std::vector<std::string> notes; // equations it computes, source: for the banner
    Graph graph;
    Graph::Node eps = -1, time = -1, slow_time = -1; // symbols; slow_time = eps*time
    Graph::Node small = -1; // eps^(1/eps_root), by whose powers weights count: eps itself where it is 1
    // A weight as the user counts it.
    [[nodiscard]] Rational weight(int held) const { return Rational(held) / eps_root; }
    std::vector<ProgramInput> parameters;   // those not fixed and needed
    std::vector<ProgramInput> start;        // those needed
    std::vector<ProgramFlow> flow;          // solved together, before all tables
    std::vector<ProgramTable> tables;       // in order of construction
    std::vector<ProgramPhase> phases;       // one per frequency that the outputs see, then exponents
    std::vector<ProgramOutput> slow;        // slow variables as functions of slow_time
    std::vector<ProgramOutput> outputs;     // as the scene lists them
    std::vector<ProgramData> data;          // those that the motion runs along
    std::vector<ProgramRow> rows;           // of the outputs, where something is the sum of them
    std::vector<ProgramOutput> state;       // all states at full weight (for direct integration), at any t
    std::vector<ProgramCondition> positive; // > 0 at every call, else outside_domain, named by the first
    std::vector<ProgramCondition> layers;   // > 0 up to where the evaluator ends (layers.hpp); no tables
    std::vector<ProgramOutput> names;       // sub-expressions that a reader knows by name: "psi_2", "rho_8"
    // The horizon in slow time that the scene asks for, verify.interval * eps: in eps and parameters, and
    // as a number (at the smallest eps of the scene's ladder if it depends on eps).
    Graph::Node slow_time_end = -1;
    double interval_slow_time = 1;
    using Count = OperationCount;
    Count before; // of all variables of the solution, written out, nothing shared, fixed or left out
    Count after;  // of the emitted code
    // Of many points, if ProgramOptions::rows: why they are computed as they are.
    std::string form_reason;
    OperationsByForm operations_by_form;
    EmitForm many_points = EmitForm::direct; // never automatic; atoms: see recipe.hpp
    bool sums_rows = false; // one point, too, is the sum of its rows: its formula would be long
    // How many points are computed.
    [[nodiscard]] const char* form() const {
        return many_points == EmitForm::atoms    ? "atoms"
               : many_points == EmitForm::tables ? "tables"
                                                 : "direct";
    }
    [[nodiscard]] bool has_tables() const { return many_points != EmitForm::direct; }
};

struct ProgramOptions {
    bool fold_fixed = true;  // false: [fix] values become defaults of parameters (stability sweep)
    bool keep_state = false; // true: `state` is filled and its quadratures kept
    bool rows = false;       // true: `rows` is filled, for evaluators that tabulate them
    // Names of parameters and start values that stay though no output needs them.
    std::set<std::string> kept_inputs = {};
    // Additions and multiplications of one point: where there are more, it is the sum of its rows. A compiler
    // takes seconds for so long a formula, and its constants fill a header.
    int longest_formula = 2000;
};

} // namespace resonform
