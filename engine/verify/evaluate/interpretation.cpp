// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/evaluate/interpretation.hpp"

#include "emit/program/prune.hpp"

namespace resonform {

Interpretation::Interpretation(std::shared_ptr<const Program> p)
    : program(std::move(p)), plan(*program), changes(depending(program->graph, varying_symbols(*program))),
      conditions(plan.conditions_text()), results(plan.results_text()) {
    for (std::size_t n = 0; n < program->graph.size(); ++n) {
        const Graph::Entry& e = program->graph.at(static_cast<Graph::Node>(n));
        numbers.push_back(e.op == Graph::Op::rational ? binary_parts(e.value) : BinaryParts{});
    }
    for (std::size_t v = 0; v < plan.code.size(); ++v) {
        const StraightLine::Instruction& i = plan.code.at(static_cast<StraightLine::Value>(v));
        plan_numbers.push_back(i.op == StraightLine::Op::number ? binary_parts(i.number) : BinaryParts{});
    }
}

} // namespace resonform
