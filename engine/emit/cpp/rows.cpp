// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp/rows.hpp"

#include "emit/cpp/digits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <numeric>

namespace resonform {

namespace {

using Value = StraightLine::Value;

// The rows as a RowList of the runtime.
std::string row_list(const Program& program) {
    std::map<std::vector<int>, std::size_t> harmonics;
    std::vector<std::size_t> first(program.outputs.size() + 1);
    int highest = 1;
    for (const ProgramRow& row : program.rows) {
        harmonics.emplace(row.turns, 0);
        ++first[row.output + 1];
        for (const int k : row.turns) highest = std::max(highest, std::abs(k));
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::string k_text, waves;
    std::size_t count = 0;
    for (auto& [turns, place] : harmonics) {
        place = count++;
        for (const long k : turns) k_text += in_digits(static_cast<std::size_t>(k + highest), 2);
    }
    for (const ProgramRow& row : program.rows)
        waves += in_digits(2 * harmonics.at(row.turns) + (row.wave == ProgramWave::sine ? 1 : 0), 2);
    return fmt::format("resonform::RowList<{}, {}, {}, {}, {}>(\n            {{{}}},\n{},\n{})",
                       program.phases.size(), highest, count, program.rows.size(), program.outputs.size(),
                       fmt::join(first, ", "), literal_lines(k_text), literal_lines(waves));
}

// "{0, resonform::kernel::Wave::cosine, {1}}," for each row; an atom is an output of its own
std::string as_list(const CppPlan& plan) {
    static constexpr std::array waves{"one", "cosine", "sine"};
    std::string text;
    for (std::size_t k = 0; plan.recipe && k < plan.recipe->atoms.size(); ++k)
        text += fmt::format("{}{{{}}},{}", k % 16 == 0 ? "            " : " ", k,
                            k % 16 == 15 || k + 1 == plan.recipe->atoms.size() ? "\n" : "");
    for (const ProgramRow& row : plan.program->rows)
        text += fmt::format("            {{{}, resonform::kernel::Wave::{}, {{{}}}}},\n", row.output,
                            waves[static_cast<std::size_t>(row.wave)], fmt::join(row.turns, ", "));
    return text;
}

} // namespace

std::string cpp_terms(const CppPlan& plan) {
    constexpr const char* head = "        static constexpr ";
    const Program& program = *plan.program;
    if (program.sums_rows) return fmt::format("{}auto terms = row_list.terms();\n", head);
    if (!plan.recipe && plan.walks_constants())
        return fmt::format("{}auto terms = {}.terms();\n", head, row_list(program));
    return fmt::format("{}std::array<resonform::kernel::Term<{}>, {}> terms{{{{\n{}        }}}};\n", head,
                       program.phases.size(), plan.tabulated().size(), as_list(plan));
}

std::string cpp_row_list(const CppPlan& plan) {
    if (!plan.program->sums_rows) return "";
    return fmt::format("    // The rows that outputs are sums of (runtime/rows.hpp).\n"
                       "    static constexpr auto row_list = {};\n\n",
                       row_list(*plan.program));
}

std::vector<std::string> cpp_sums(const CppPlan& plan) {
    const std::vector<ProgramPhase>& phases = plan.program->phases;
    std::vector<std::string> turns;
    for (std::size_t k = 0; k < phases.size(); ++k)
        turns.push_back(fmt::format(
            fmt::runtime(phases[k].decays() ? "{{a.exp_{0}, Real(0)}}" : "{{a.cos_{0}, a.sin_{0}}}"),
            plan.phase_names[k]));
    return {fmt::format("const std::array<resonform::Turn<Real>, {}> turns{{{{{}}}}};", phases.size(),
                        fmt::join(turns, ", ")),
            fmt::format("const auto sums = resonform::sum_rows(row_list, amplitudes(c, a.T{}), turns);",
                        plan.levels.empty() ? "" : ", a.tables")};
}

std::vector<std::string> cpp_return_list(const CppPlan& plan, const std::string& type,
                                         const std::vector<Value>& values,
                                         const std::vector<std::string>& texts) {
    if (!plan.walks_constants()) return {fmt::format("return {{{}}};", fmt::join(texts, ", "))};
    const auto place = [&](std::size_t k) { // in the list of constants, or behind it
        const auto found = std::lower_bound(plan.listed.begin(), plan.listed.end(), values[k]);
        return found != plan.listed.end() && *found == values[k] ? found - plan.listed.begin() : -1;
    };
    std::vector<std::string> lines{type + " list;"};
    for (std::size_t k = 0, next = 0; k < values.size(); k = next) {
        next = k + 1;
        const std::ptrdiff_t first = place(k);
        while (first >= 0 && next < values.size() &&
               place(next) == first + static_cast<std::ptrdiff_t>(next - k))
            ++next;
        if (next == k + 1)
            lines.push_back(fmt::format("list[{}] = {};", k, texts[k]));
        else
            lines.push_back(fmt::format("std::copy_n(&c.{}[{}], {}, &list[{}]);", CppPlan::list_name, first,
                                        next - k, k));
    }
    lines.emplace_back("return list;");
    return lines;
}

} // namespace resonform
