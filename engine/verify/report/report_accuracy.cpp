// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/number.hpp"
#include "verify/judging/conditions.hpp"
#include "verify/report/page.hpp"
#include "verify/report/sections.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace resonform::report {

namespace {

Table ladder_table(const OutputVerdict& output) {
    Table table{fmt::format("{}: errors on the ladder", pretty(output.name)),
                {"ε", "max error", "RMS error", "local slope", "digits", "error of the reference"},
                {}};
    for (std::size_t i = 0; i < output.ladder.size(); ++i) {
        const LadderRung& rung = output.ladder[i];
        const bool has_slope = i > 0 && std::isfinite(output.local_slopes[i - 1]);
        table.rows.push_back({plain_number(to_double(rung.eps)), short_number(rung.max_error),
                              short_number(rung.rms_error),
                              has_slope ? fmt::format("{:.3f}", output.local_slopes[i - 1]) : "",
                              std::to_string(rung.digits), short_number(rung.reference_error)});
    }
    return table;
}

std::string order_of(const OutputVerdict& output, int held) {
    return fmt::format("O({})", power_of_eps(output.order(held)));
}

Table verdict_table(const Verification& verification) {
    const std::string shorter = shortness(verification.conditions);
    Table table{"Error over the interval against direct integration, as ε → 0",
                {"output", "claimed", "guaranteed", "found", "slope", "window of ε",
                 "limit of max|Δ|/ε^found", "verdict", "expected"},
                {}};
    for (const OutputVerdict& o : verification.outputs)
        table.rows.push_back(
            {pretty(o.name), order_of(o, o.claimed_order),
             o.guaranteed_order ? order_of(o, *o.guaranteed_order) : "",
             o.found_order ? order_of(o, *o.found_order) : "",
             std::isfinite(o.slope) ? fmt::format("{:.3f}", o.slope) : "",
             fmt::format("{} … {}", plain_number(o.slope_low_eps), plain_number(o.slope_high_eps)),
             short_number(o.constant),
             to_string(o.verdict) + (shorter.empty() ? "" : ", " + typeset(shorter)), to_string(o.expected)});
    return table;
}

// Estimated beside true errors; no rows where nothing is estimated.
Table estimate_table(const OutputVerdict& output) {
    Table table{fmt::format("{}: error estimated by the next weight", pretty(output.name)),
                {"ε", "map", "flow", "estimated error", "max error", "estimated / true"},
                {}};
    if (!output.estimate || output.estimate->next_order == 0) return table;
    for (std::size_t i = 0; i < output.ladder.size(); ++i) {
        const EstimatedRung& e = output.estimate->ladder[i];
        const double error = output.ladder[i].max_error;
        table.rows.push_back({plain_number(to_double(e.eps)), short_number(e.map), short_number(e.flow),
                              short_number(e.error), short_number(error), short_number(e.error / error)});
    }
    return table;
}

Table best_orders(const OutputVerdict& output) {
    Table table{fmt::format("{}: the best order for each ε, by extrapolation", pretty(output.name)),
                {"ε", "order", "of the orders", "expected error"},
                {}};
    if (!output.estimate) return table;
    for (const BestOrder& b : output.estimate->best)
        table.rows.push_back(
            {plain_number(to_double(b.eps)), to_string(output.order(b.order)),
             fmt::format("{} … {}", to_string(output.order(1)), to_string(output.order(b.looked_at))),
             short_number(b.accuracy)});
    return table;
}

} // namespace

Section accuracy_section(const Findings& f, const Figures& figures) {
    Section section{"Order of accuracy",
                    {figures.ladders(f.verification.outputs), verdict_table(f.verification)}};
    for (const OutputVerdict& o : f.verification.outputs)
        if (!o.reason.empty())
            section.blocks.push_back(Paragraph{fmt::format("{}: {}", pretty(o.name), typeset(o.reason))});
    for (const OutputVerdict& o : f.verification.outputs) {
        section.blocks.push_back(ladder_table(o));
        if (Table estimated = estimate_table(o); !estimated.rows.empty())
            section.blocks.push_back(std::move(estimated));
        if (o.estimate && !o.estimate->reason.empty())
            section.blocks.push_back(Paragraph{
                fmt::format("Estimated error of {}: {}", pretty(o.name), typeset(o.estimate->reason))});
        if (Table best = best_orders(o); !best.rows.empty()) section.blocks.push_back(std::move(best));
    }
    section.blocks.push_back(Paragraph{
        "What covers what: the ladder sees errors of the formulas down to the order found; the certificate "
        "sees every coefficient of normal form and map; what lies between the solution and the compiled code "
        "is seen by the next section."});
    return section;
}

} // namespace resonform::report
