// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of an emitted evaluator: values that are computed once and kept, functions and when they are
// called, and their names.
#pragma once

#include "emit/cpp/constant_range.hpp"
#include "emit/cpp/lies.hpp"
#include "emit/cpp/names.hpp"
#include "emit/program/recipe.hpp"

#include <map>
#include <string>
#include <vector>

namespace resonform {

// Tables that are built together, after those of earlier levels: the slow flow, which comes first, or tables
// whose integrands need no later ones.
struct CppLevel {
    bool flow = false;
    std::string name;                 // for a reader: "Q_x or Q_y"
    std::vector<std::size_t> members; // indices into program.tables, or program.flow: ascending
};

struct CppResult {
    std::string name; // the member of Values or State
    StraightLine::Value value;
};

struct CppRow { // of program.rows
    const ProgramRow* row;
    StraightLine::Value amplitude;
};

// A function that the user of the class gives by an object: the name of its members, and that of its type.
struct CppCallable {
    std::string function, name, type;
    int derivatives; // the highest
};

struct CppCondition { // > 0
    StraightLine::Value value;
    std::string quantity;
};

struct CppPlan {
    // beside: callables of formulas that go further, which the class is given, too.
    explicit CppPlan(const Program& program, const std::vector<CppCallable>& beside = {});

    const Program* program;
    StraightLine code;
    CppLies* lies = nullptr; // where the coefficients of its functions are to be planted, if they are
    std::vector<std::string> parameters, start; // members of Parameters and Start, as in the program
    std::vector<CppCallable> callables;         // members of Parameters and Constants
    std::vector<CppLevel> levels;
    std::vector<StraightLine::Value> flow_starts, flow_rates;   // of program.flow
    std::vector<StraightLine::Value> integrands;                // of program.tables
    std::vector<StraightLine::Value> phase_starts, phase_rates; // of program.phases
    std::vector<std::string> phase_names;
    std::vector<bool> phase_uses_tables; // or the flow
    // Of phases whose rates are summed in two types: the large part and the small one.
    struct DividedRate {
        StraightLine::Value main, small;
    };
    std::vector<std::optional<DividedRate>> divided_rates;
    [[nodiscard]] bool divides_rates(bool all = false) const; // some, or all
    struct Growth {                                           // of an exponent that grows
        std::size_t phase;
        StraightLine::Value factor;
    };
    std::vector<Growth> growths;
    std::vector<std::vector<StraightLine::Value>> precisions; // of exponents: one of each list is > 0
    std::optional<std::size_t> loses_digits;                  // the first phase with a growth or precision
    std::vector<CppResult> outputs, state;
    std::vector<StraightLine::Value> data_arguments; // of program.data
    std::vector<CppRow> rows;                        // empty: outputs are not summed from them
    std::optional<Recipe> recipe;                    // of many points from atoms
    std::vector<CppCondition> constant_conditions, varying_conditions;
    std::vector<CppCondition> layers; // of program.layers
    bool layers_use_flow = false, layers_are_broad = true;
    bool layers_have_bounds = false; // runtime/bounds.hpp knows all that they are made of
    // Constants that outlive the construction, and the names of their members.
    std::map<StraightLine::Value, std::string> members;
    // Those of them that are elements of one array, in its order: where there are so many that a loop walks
    // them. Else empty, and each has a name of its own.
    std::vector<StraightLine::Value> listed;
    static constexpr const char* list_name = "all";
    // Of an ensemble's members, which have no phase or may have one of fewer digits.
    [[nodiscard]] bool has_full_phase() const { return !program->phases.empty(); }
    [[nodiscard]] bool walks_constants() const { return !listed.empty(); }
    ConstantRange range;         // of the members
    bool fine_constants = false; // members are computed in more digits than they keep (emit/cpp/rounding.hpp)
    bool native_defaults;        // of start values and slow time, whatever the arguments are
    // The constant conditions are no members: these are native, and they would not be.
    bool conditions_apart = false;
    [[nodiscard]] bool uses_scaled() const { return !range.native || !native_defaults || conditions_apart; }
    // Members that phases read in more digits than Real has, main parts of their rates where all are divided,
    // if to compute these alone is much less. Ascending.
    std::vector<StraightLine::Value> phase_constants;
    // Which type reads those alone: each that is not Real, if whole rates do, or those that rates are divided
    // for.
    [[nodiscard]] bool whole_rates_read_some() const {
        return !phase_constants.empty() && !divides_rates(true);
    }
    [[nodiscard]] bool main_rates_read_some() const {
        return !phase_constants.empty() && divides_rates(true);
    }
    // What whole rates read in more digits than Real has: the functions that compute and keep it end so, and
    // its type.
    [[nodiscard]] const char* rate_constants() const {
        return whole_rates_read_some() ? "phase_constants" : "constants";
    }
    [[nodiscard]] const char* rate_constants_type() const {
        return whole_rates_read_some() ? "PhaseConstants" : "Constants";
    }
    // Members that must lie within the range of the real type, with the text that an evaluator reports if one
    // does not: "C_delta", "c_12 in psi_3". The others are conditions, of which only the sign matters.
    std::vector<std::pair<StraightLine::Value, std::string>> kept;
    // All values that are looked up: of the flow, and of the tables, level by level.
    struct Column {
        std::string name;
        Graph::Node value;
    };
    [[nodiscard]] std::vector<Column> columns() const;
    // What is tabulated for many points or summed at one: amplitudes of the rows, or atoms.
    [[nodiscard]] std::vector<StraightLine::Value> tabulated() const;
    // Names of the arguments that outputs of many points are stored in.
    [[nodiscard]] std::vector<std::string> output_arrays() const;
    // The conditions at every time, as text; the output that may overflow, "" if there are several.
    [[nodiscard]] std::string conditions_text() const;
    [[nodiscard]] std::string results_text() const { return outputs.size() == 1 ? outputs[0].name : ""; }
    [[nodiscard]] std::size_t columns_before(std::size_t level) const;
    // "c.u_x, c.v_x" for prefix "c."
    [[nodiscard]] std::string member_list(const std::vector<StraightLine::Value>& values,
                                          const std::string& prefix) const;
    // "{type} {name}", say, of all callables, separated by commas.
    [[nodiscard]] std::string callable_list(const char* form) const;
    // The exponents with which all decays that turns with a phase: indices of program.phases.
    [[nodiscard]] std::vector<std::size_t> fades_with(std::size_t phase) const;
    // Of eps, parameters and start values, by their symbols.
    [[nodiscard]] std::map<Graph::Node, std::string> input_names() const;
    // A phase is as exact as the tables or the flow in its rate.
    [[nodiscard]] bool rounded_phases() const;

private:
    [[nodiscard]] bool have_bounds(const std::vector<CppCondition>& margins) const;
    void name_inputs();
    void assign_levels();
    void lower_results();
    void find_members(bool conditions);
    [[nodiscard]] bool is_long(const std::vector<StraightLine::Value>& constants) const;
    void find_ranges();
    void name_kept();
    [[nodiscard]] std::vector<StraightLine::Value> read_by_phases() const;
    void find_phase_constants();
    void find_callables(const std::vector<CppCallable>& beside);
    [[nodiscard]] CppNames names_beside_callables() const;
    [[nodiscard]] std::vector<StraightLine::Value> roots() const;
    [[nodiscard]] std::vector<std::string> users() const;
};

} // namespace resonform
