// SPDX-License-Identifier: GPL-3.0-or-later
// What an emitted evaluator consists of: which values are computed once and kept, which functions are
// called at which time, and under which names.
#pragma once

#include "emit/straight_line.hpp"

#include <map>
#include <string>
#include <vector>

namespace resonform {

// Tables whose integrands need no later ones: they are built together, after all levels before.
struct CppLevel {
    std::vector<std::size_t> tables; // indices into program.tables, ascending
};

struct CppResult {
    std::string name; // the member of Values or State
    StraightLine::Value value;
};

struct CppPlan {
    explicit CppPlan(const Program& program);

    const Program* program;
    StraightLine code;
    std::vector<std::string> parameters, start; // members of Parameters and Start, as in the program
    std::vector<CppLevel> levels;
    std::vector<StraightLine::Value> integrands;                // of program.tables
    std::vector<StraightLine::Value> phase_starts, phase_rates; // of program.phases
    std::vector<std::string> phase_names;
    std::vector<bool> phase_uses_tables;
    std::vector<CppResult> outputs, state;
    std::vector<StraightLine::Value> constant_conditions, varying_conditions;
    // Constants that outlive the construction, and the names of their members.
    std::map<StraightLine::Value, std::string> members;
    // The place of a table's value among all, level by level.
    [[nodiscard]] std::size_t column(std::size_t table) const;
    [[nodiscard]] std::size_t tables_before(std::size_t level) const;

private:
    void name_inputs();
    void assign_levels();
    void lower_results();
    void find_members();
};

} // namespace resonform
