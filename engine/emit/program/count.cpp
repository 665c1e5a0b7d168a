// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/count.hpp"

#include "emit/program/prune.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace resonform {

namespace {

// The counts in the order of OperationCount, wide: written out, expressions grow exponentially.
using Count = std::array<long long, 7>;
enum CountIndex : std::size_t { sums, products, divisions, roots, angles, others, lookups };

long long multiplications(int exponent) {
    long long count = -1;
    for (int e = exponent < 0 ? -exponent : exponent; e > 0; e /= 2) count += 1 + e % 2;
    return std::max(count - 1, 0LL);
}

void count_own(const Graph::Entry& e, Count& count) {
    const auto n = static_cast<long long>(e.operands.size());
    switch (e.op) {
    case Graph::Op::add: count[sums] += n - 1; break;
    case Graph::Op::multiply: count[products] += n - 1; break;
    case Graph::Op::power:
        count[products] += multiplications(e.exponent);
        count[divisions] += e.exponent < 0 ? 1 : 0;
        break;
    case Graph::Op::root: count[roots] += 1; break;
    case Graph::Op::sin:
    case Graph::Op::cos: count[angles] += 1; break;
    case Graph::Op::rational: count[divisions] += cln::denominator(e.value) == 1 ? 0 : 1; break;
    case Graph::Op::symbol: break;
    default: count[others] += 1;
    }
}

Count leaf_count(const Program& program, Graph::Node n) {
    Count count{};
    for (const ProgramFlow& variable : program.flow)
        if (variable.value == n) count[lookups] = 1;
    for (const ProgramTable& table : program.tables)
        if (table.value == n) count[lookups] = 1;
    for (const ProgramPhase& phase : program.phases)
        if (phase.cosine == n || phase.sine == n) count[angles] = 1;
    return count;
}

int clamped(long long n) { return static_cast<int>(std::min<long long>(n, std::numeric_limits<int>::max())); }

} // namespace

OperationCount count_written_out(const Program& program) {
    const std::vector<bool> varies = depending(program.graph, varying_symbols(program));
    std::vector<bool> given(program.graph.size(), false); // constants with a name: amplitude, phase, ...
    for (const ProgramOutput& named : program.names)
        given[static_cast<std::size_t>(named.value)] = !varies[static_cast<std::size_t>(named.value)];
    std::vector<Count> counts;
    for (std::size_t n = 0; n < program.graph.size(); ++n) {
        const Graph::Entry& e = program.graph.at(static_cast<Graph::Node>(n));
        Count count = leaf_count(program, static_cast<Graph::Node>(n));
        for (const Graph::Node operand : e.operands)
            for (std::size_t k = 0; k < count.size(); ++k)
                count[k] = std::min(count[k] + counts[static_cast<std::size_t>(operand)][k], 1LL << 40);
        count_own(e, count);
        counts.push_back(given[n] ? Count{} : count);
    }
    Count sum{};
    for (const ProgramOutput& output : program.outputs)
        for (std::size_t k = 0; k < sum.size(); ++k)
            sum[k] += counts[static_cast<std::size_t>(output.value)][k];
    return {clamped(sum[sums]),   clamped(sum[products]), clamped(sum[divisions]), clamped(sum[roots]),
            clamped(sum[angles]), clamped(sum[others]),   clamped(sum[lookups])};
}

} // namespace resonform
