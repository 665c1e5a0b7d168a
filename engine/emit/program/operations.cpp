// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/operations.hpp"

#include "algebra/number/error.hpp"
#include "emit/program/prune.hpp"
#include "emit/program/recipe.hpp"
#include "emit/program/straight_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <set>
#include <utility>
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

std::set<std::vector<int>> harmonics_of(const Program& program) {
    std::set<std::vector<int>> harmonics;
    for (const ProgramRow& row : program.rows)
        if (row.wave != ProgramWave::one) harmonics.insert(row.turns);
    return harmonics;
}

constexpr std::size_t most_outputs = 16; // of a kernel's tables (runtime/kernel/view.hpp)

// Why there can be no tables, "" if there can: those of the kernel (runtime/kernel/view.hpp) hold 512
// harmonics, some of which lead to others.
std::string too_large(const Program& program) {
    constexpr std::size_t most_rows = 1024, most_harmonics = 192;
    const std::size_t rows = program.rows.size(), harmonics = harmonics_of(program).size();
    if (rows > most_rows || harmonics > most_harmonics)
        return fmt::format("{} rows of {} harmonics, more than {} or {}", rows, harmonics, most_rows,
                           most_harmonics);
    if (program.outputs.size() > most_outputs)
        return fmt::format("{} outputs, more than {}", program.outputs.size(), most_outputs);
    return "";
}

int clamped(long long n) { return static_cast<int>(std::min<long long>(n, std::numeric_limits<int>::max())); }

// Sums and products, and what takes as long: measured with g++ 12 on x86-64.
int direct_operations(const Program& program) {
    const OperationCount& c = program.after;
    constexpr int division = 8, root = 16, function = 60, look_up = 80, turn = 240;
    const long long sum = 1LL * c.add + c.multiply + 1LL * division * c.divide + 1LL * root * c.root +
                          1LL * function * c.other + 1LL * look_up * c.tables + 1LL * turn * c.sincos;
    return clamped(sum);
}

// A row is a polynomial of degree 4, nearly; the others follow from one cosine and sine.
int tabulated_operations(const Program& program) {
    constexpr std::size_t row = 9, phase = 60, harmonic = 6;
    const std::size_t harmonics = harmonics_of(program).size(), phases = program.phases.size();
    return static_cast<int>(row * program.rows.size() + phase * phases +
                            harmonic * (harmonics - std::min(harmonics, phases)));
}

// Each operation is read, and its numbers come from memory and go there.
std::optional<int> operations_on_atoms(const Program& program) {
    constexpr std::size_t atom = 9, phase = 60, operation = 3;
    if (program.rows.empty() || program.outputs.size() > most_outputs) return std::nullopt;
    StraightLine code(program);
    const std::optional<Recipe> recipe = recipe_of(program, code);
    if (!recipe) return std::nullopt;
    return static_cast<int>(atom * recipe->atoms.size() + operation * recipe->operations.size() +
                            phase * program.phases.size());
}

// The higher the harmonic, the smaller the row, as a rule; a sum rounds less if it begins with small ones.
int degree(const ProgramRow& row) {
    int sum = 0;
    for (const int k : row.turns) sum += std::abs(k);
    return sum;
}

void sum_rows_of_long_formula(Program& program, bool possible, int longest) {
    constexpr long long longer = 4;              // sums than formulas
    constexpr std::size_t most_harmonics = 4000; // that two digits tell (emit/cpp/rows.hpp)
    const auto all = [](const OperationCount& count) { return 1LL * count.add + count.multiply; };
    if (!possible || all(program.after) <= longest || harmonics_of(program).size() > most_harmonics) return;
    program.sums_rows = true;
    const OperationCount of_sums = count_operations(program);
    program.sums_rows = all(of_sums) < longer * all(program.after);
    if (!program.sums_rows) return;
    program.after = of_sums;
    std::stable_sort(program.rows.begin(), program.rows.end(), [](const ProgramRow& a, const ProgramRow& b) {
        return std::pair(a.output, -degree(a)) < std::pair(b.output, -degree(b));
    });
}

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

void choose_form(Program& program, EmitForm wish, const Place& place, int longest) {
    OperationsByForm& counts = program.operations_by_form;
    counts.direct = direct_operations(program);
    const bool possible = !program.rows.empty();
    const std::string large = too_large(program);
    if (possible && large.empty()) counts.tables = tabulated_operations(program);
    counts.atoms = operations_on_atoms(program);
    if (wish == EmitForm::tables && !counts.tables)
        refuse(Reason::size,
               {"a scene whose many points come from tables has rows for them, and not too many",
                possible ? large : "none", "leave out emit.form, or some outputs", place});
    if (wish == EmitForm::atoms && !counts.atoms)
        refuse(Reason::size,
               {"a scene whose many points are made of atoms has outputs that are polynomials in what turns, "
                "and not too large ones",
                program.form_reason.empty() ? "another function of what turns, or too many numbers at a time"
                                            : program.form_reason,
                "leave out emit.form, or some outputs", place});
    // Operations that take as long as one of a call, with two numbers in a vector: there is no status or
    // look-up for each point, and rows that do not matter at an eps are left out.
    constexpr int of_tables = 5, of_atoms = 2;
    const auto takes = [&](EmitForm form, const std::optional<int>& count, int as_long) {
        return wish == form || (wish == EmitForm::automatic && count && *count < as_long * counts.direct);
    };
    const bool tables = takes(EmitForm::tables, counts.tables, of_tables);
    const bool atoms = !tables && takes(EmitForm::atoms, counts.atoms, of_atoms);
    program.many_points = tables ? EmitForm::tables : atoms ? EmitForm::atoms : EmitForm::direct;
    if (wish != EmitForm::automatic)
        program.form_reason = "as the scene wants it";
    else if (!large.empty() && !atoms)
        program.form_reason = large;
    else if (tables)
        program.form_reason = fmt::format("tables pay below {} times a call", of_tables);
    else if (atoms)
        program.form_reason = fmt::format("atoms pay below {} times a call", of_atoms);
    else if (program.form_reason.empty())
        program.form_reason = "neither tables nor atoms would pay";
    sum_rows_of_long_formula(program, possible && !atoms && !program.phases.empty(), longest);
    if (!tables && !program.sums_rows) program.rows.clear();
}

} // namespace resonform
