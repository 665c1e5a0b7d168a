// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/number.hpp"
#include "verify/report/page.hpp"
#include "verify/report/sections.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

namespace resonform::report {

namespace {

std::string what_figures_show(const Stability& s) {
    std::string text = "Over each input, by decades, the worst error of each output: level curves far below "
                       "the dashed threshold lose no digits anywhere. What lies above it is told with its "
                       "condition number below.";
    if (s.refused_by.empty()) return text;
    std::vector<std::string> statuses;
    for (const auto& [status, count] : s.refused_by) statuses.push_back(status);
    return text +
           fmt::format(" Crosses are decades in which points were answered by a status; from above: {}",
                       fmt::join(statuses, ", "));
}

std::string range_of(double low, double high) {
    return low == high ? short_number(low) : short_number(low) + " … " + short_number(high);
}

// "a 1.00·10⁻¹² … 3, b 1, t 0 … 1.00·10⁵"
std::string ranges_of(const StabilityRefusals& refusals) {
    std::vector<std::string> ranges;
    for (const SweptInput& input : refusals.where)
        if (input.high > 0)
            ranges.push_back(fmt::format("{} {}{}", pretty(input.name), input.negative ? "± " : "",
                                         range_of(input.low, input.high)));
    ranges.push_back("t " + range_of(refusals.first_t, refusals.last_t));
    return fmt::format("{}", fmt::join(ranges, ", "));
}

// By status and cause, with the ranges of the inputs there.
Table refusals_table(const std::vector<StabilityRefusals>& all) {
    Table table{"Refusals", {"status", "cause", "points", "without an explanation", "at"}, {}};
    for (const StabilityRefusals& r : all)
        table.rows.push_back({r.status, r.why.empty() ? "–" : typeset(r.why), fmt::format("{}", r.count),
                              fmt::format("{}", r.unexplained), ranges_of(r)});
    return table;
}

} // namespace

Section stability_section(const Findings& f, const Figures& figures) {
    Table worst{"Worst points", {"output", "ulp", "unavoidable", "at"}, {}};
    for (const WorstPoint& point : f.stability.worst) {
        std::vector<std::string> at;
        for (const auto& [name, value] : point.at)
            at.push_back(fmt::format("{} = {}", pretty(name), short_number(value)));
        worst.rows.push_back({pretty(point.output), short_number(point.ulp), short_number(point.left_open()),
                              fmt::format("{}", fmt::join(at, ", "))});
    }
    Table median{"Median", {"output", "ulp"}, {}};
    for (const auto& [name, ulp] : f.stability.median)
        median.rows.push_back({pretty(name), short_number(ulp)});
    Table swept{"Swept", {"input", "from", "to"}, {}};
    for (const SweptInput& input : f.stability.swept) {
        const std::string unit = input.weight == 0 ? "" : " " + power_of_eps(input.weight);
        swept.rows.push_back({pretty(input.name),
                              (input.negative ? "± " : "") + short_number(input.low) + unit,
                              short_number(input.high) + unit});
    }
    Section section{
        "Stability of the emitted code",
        {Paragraph{fmt::format(
             "Verdict: {}{}. Double against 50 digits at {} points over many decades of every input; {} were "
             "answered with a status, of them {} that nothing explains (at most {:.0f} % may be); {} more "
             "are "
             "beyond the reference. Errors in ulp of the output's scale, the sum of its terms' magnitudes; "
             "the threshold is {:g} times 1 + what a last bit of the slow time makes unavoidable, or, from a "
             "condition number of 10⁸ on, one of all inputs.",
             to_string(f.stability.verdict), f.stability.rule.empty() ? "" : ": " + typeset(f.stability.rule),
             f.stability.cases, f.stability.refused, f.stability.unexplained, 100 * unexplained_share,
             f.stability.beyond_reference, f.stability.threshold)},
         Paragraph{what_figures_show(f.stability)}, figures.stability(f.stability), swept, median, worst}};
    if (!f.stability.refusals.empty()) section.blocks.emplace_back(refusals_table(f.stability.refusals));
    return section;
}

} // namespace resonform::report
