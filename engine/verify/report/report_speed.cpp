// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/number.hpp"
#include "verify/report/page.hpp"
#include "verify/report/sections.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <utility>
#include <vector>

namespace resonform::report {

Section speed_section(const Findings& f, const Figures& figures, bool every_run) {
    Table rows{"Every run",
               {"method", "setting", "task", "form", "points", "max error", "seconds", "construction, s"},
               {},
               true};
    for (const ComparisonRow& row : f.comparison.rows) {
        std::vector<std::string> errors;
        for (const double e : row.max_error) errors.push_back(short_number(e));
        rows.rows.push_back({row.method, typeset(row.setting), to_string(row.task),
                             row.form ? to_string(*row.form) : "", std::to_string(row.points),
                             row.failure.empty() ? fmt::format("{}", fmt::join(errors, ", ")) : row.failure,
                             short_number(row.seconds.median), short_number(row.construction_seconds)});
    }
    Table even{"Rivals at the accuracy of the emitted evaluator",
               {"task", "method", "tolerance", "seconds", "rival / emitted", "winner"},
               {}};
    for (const BreakEven& b : f.comparison.by_eps.front().tasks) {
        if (b.order != f.scene->system->weight(f.scene->order)) continue;
        if (!b.failure.empty())
            even.rows.push_back({to_string(b.task), "emitted", "–", b.failure, "–", "not compared"});
        for (const RivalAtEqualAccuracy& rival : b.rivals)
            even.rows.push_back({to_string(b.task), rival.method,
                                 rival.seconds ? short_number(rival.tolerance) : "–",
                                 rival.seconds ? short_number(*rival.seconds) : "not reached",
                                 rival.ratio ? short_number(*rival.ratio) : "–", b.winner});
    }
    Section section{"Error against run time", {figures.work(f.comparison), even}};
    if (every_run) section.blocks.push_back(std::move(rows));
    return section;
}

} // namespace resonform::report
