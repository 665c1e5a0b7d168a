// SPDX-License-Identifier: GPL-3.0-or-later
// Data shared by all interpreters of one program: making it costs as much as a thousand calls.
#pragma once

#include "algebra/number/binary_parts.hpp"
#include "emit/cpp/plan.hpp"
#include "runtime/status.hpp"

#include <memory>
#include <string>
#include <vector>

namespace resonform {

struct Interpretation {
    explicit Interpretation(std::shared_ptr<const Program> p);

    std::shared_ptr<const Program> program;
    CppPlan plan;
    std::vector<bool> changes; // of the nodes, those that are computed at each call
    std::vector<Graph::Node> outputs_at_call, state_at_call; // those behind them and behind the conditions
    std::string conditions, results;                         // causes of a status
    std::vector<BinaryParts> numbers;                        // of the graph, by node
    std::vector<BinaryParts> plan_numbers;                   // of plan.code, by value
};

// The nodes behind some roots, operands first: the constant ones, and those that change from call to call.
struct NodesBehind {
    NodesBehind(const Interpretation& shared, const std::vector<Graph::Node>& roots);
    std::vector<Graph::Node> constant, varying;
};

// With low_precision, an evaluator answers in numbers, too.
inline bool has_numbers(Status status) { return status == Status::ok || status == Status::low_precision; }

std::vector<Graph::Node> values_of(const std::vector<ProgramOutput>& results);

} // namespace resonform
