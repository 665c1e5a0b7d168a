// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judging/lies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace resonform {

namespace {

// A row of the table: the lies of one kind in one function, or in one part of the formulas.
struct LiesOfKind {
    std::string name;
    std::size_t planted = 0, certificate = 0, ladder = 0, emitted = 0, below = 0, survivors = 0;
};

void count(LiesOfKind& row, const Lies& lies, const Lie& lie) {
    ++row.planted;
    row.certificate += lie.caught_by == "certificate" ? 1 : 0;
    row.ladder += lie.caught_by == "ladder" ? 1 : 0;
    row.emitted += lie.caught_by == "emitted = exact" ? 1 : 0;
    row.below += lies.is_below(lie) ? 1 : 0;
    row.survivors += lies.survives(lie) ? 1 : 0;
}

// In the order in which they were tried.
std::vector<LiesOfKind> rows_of(const Lies& lies) {
    std::vector<LiesOfKind> rows;
    LiesOfKind all{"all"};
    for (const Lie& lie : lies.all) {
        const std::string name =
            fmt::format("{}, {}", lie.where.substr(0, lie.where.find_first_of(",:")), lie.planted);
        auto row =
            std::find_if(rows.begin(), rows.end(), [&](const LiesOfKind& r) { return r.name == name; });
        if (row == rows.end()) row = rows.insert(rows.end(), {name});
        count(*row, lies, lie);
        count(all, lies, lie);
    }
    rows.push_back(std::move(all));
    return rows;
}

double largest_below(const Lies& lies) {
    double most = 0;
    for (const Lie& lie : lies.all)
        if (lies.is_below(lie)) most = std::max(most, lie.effect_ulp);
    return most;
}

} // namespace

std::string to_text(const Lies& lies) {
    std::string text = fmt::format("  {:<28} {:>8} {:>12} {:>7} {:>16} {:>6} {:>10}\n", "lies", "planted",
                                   "certificate", "ladder", "emitted = exact", "below", "survivors");
    for (const LiesOfKind& row : rows_of(lies))
        text += fmt::format("    {:<26} {:>8} {:>12} {:>7} {:>16} {:>6} {:>10}\n", row.name, row.planted,
                            row.certificate, row.ladder, row.emitted, row.below, row.survivors);
    text += fmt::format("  below: of no more than {:g} ulp, the largest of {:.3g}\n",
                        lies.clear_of_threshold(), largest_below(lies));
    if (lies.honest_fails)
        text += "  the code in which the lies were planted fails without any: nothing follows from them\n";
    for (const Lie& lie : lies.all) {
        if (!lies.survives(lie)) continue;
        text += fmt::format("  survives: {}, {}", lie.where, lie.planted);
        if (!std::isnan(lie.effect_ulp))
            text += fmt::format(", {:.3g} ulp of {}", lie.effect_ulp, lie.output);
        text += "\n";
    }
    return text;
}

} // namespace resonform
