// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/series/series_history.hpp"

#include <algorithm>

namespace resonform {
namespace {

using Node = SeriesProgram::Node;
using Op = SeriesProgram::Op;

class Histories {
public:
    explicit Histories(const SeriesProgram& program)
        : all_(program.instructions()), history_(all_.size(), 0) {
        // A node comes after its operands, except a sine, which comes before its operand, the cosine.
        for (std::size_t k = all_.size(); k-- > 0;) spread(static_cast<Node>(k));
    }
    [[nodiscard]] std::vector<int> result() && { return std::move(history_); }

private:
    void read(Node node, int history) {
        int& known = history_[static_cast<std::size_t>(node)];
        known = std::max(known, history);
    }

    // The weights above 0 of a constant; -1: it is none.
    [[nodiscard]] int weights_of_constant(Node node) const {
        const SeriesProgram::Instruction& in = all_[static_cast<std::size_t>(node)];
        if (in.op == Op::number) return 0;
        return in.op == Op::constant ? std::max(static_cast<int>(in.parts.size()) - 1, 0) : -1;
    }

    void read_product(Node node, Node other, int history) {
        const int weights = weights_of_constant(other);
        const bool all = weights < 0 || history == whole_history;
        read(node, all ? whole_history : history + weights);
    }

    void spread(Node node) {
        const SeriesProgram::Instruction& in = all_[static_cast<std::size_t>(node)];
        const int own = history_[static_cast<std::size_t>(node)];
        switch (in.op) {
        case Op::input:
        case Op::constant:
        case Op::number: return;
        case Op::sum:
            for (const auto& addend : in.addends) read(addend.second, own);
            return;
        case Op::product:
            read_product(in.left, in.right, own);
            read_product(in.right, in.left, own);
            return;
        case Op::sine:
        case Op::cosine:
        case Op::exponential:
        case Op::logarithm:
        case Op::power:
        case Op::antiderivative: // all of them and of their operands enter each new part
            for (const Node operand : {node, in.left, in.right})
                if (operand >= 0) read(operand, whole_history);
            return;
        }
    }

    const std::vector<SeriesProgram::Instruction>& all_;
    std::vector<int> history_;
};

} // namespace

std::vector<int> histories(const SeriesProgram& program) { return Histories(program).result(); }

} // namespace resonform
