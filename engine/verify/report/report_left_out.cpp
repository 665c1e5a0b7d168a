// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/number.hpp"
#include "verify/judging/judge.hpp"
#include "verify/report/page.hpp"
#include "verify/report/sections.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace resonform::report {

namespace {

class LeftOut {
public:
    void add(const std::string& what, const std::string& why) { table_.rows.push_back({what, typeset(why)}); }

    void ladder(const Verification& v) {
        const Conditions& c = v.conditions;
        if (c.ladder_end)
            add(fmt::format("ε ≤ {}", plain_number(to_double(c.ladder_end->eps))), c.ladder_end->reason);
        for (const Rational& eps : c.within_layer) add(at(eps), "the layer takes half of the interval");
        if (c.growth_end)
            add(fmt::format("t > {}", short_number(*c.growth_end)),
                c.beyond.empty() ? "a mode grows there" : c.beyond);
        for (const OutputVerdict& o : v.outputs) {
            for (const LadderRung& rung : o.ladder)
                if (!rung.refusal.empty())
                    add(fmt::format("{}, {}", pretty(o.name), at(rung.eps)), rung.refusal);
            std::vector<std::string> noisy;
            for (const LadderRung& rung : o.ladder)
                if (rung.refusal.empty() && !usable(rung)) noisy.push_back(plain_number(to_double(rung.eps)));
            if (!noisy.empty())
                add(fmt::format("{}, ε = {} in the slope", pretty(o.name), fmt::join(noisy, ", ")),
                    "the error is not clear of rounding and of the error of the reference");
            if (o.estimate && !o.estimate->reason.empty())
                add("estimated error of " + pretty(o.name), o.estimate->reason);
        }
    }

    void comparison(const Comparison& comparison) {
        std::map<std::pair<std::string, std::string>, std::vector<std::string>> failed;
        for (const ComparisonRow& row : comparison.rows)
            if (!row.failure.empty())
                failed[{row.method, row.failure}].push_back(
                    fmt::format("{}, {}", to_string(row.task), row.setting));
        for (const auto& [what, settings] : failed)
            add(fmt::format("run time of {}: {}", what.first, fmt::join(settings, "; ")), what.second);
    }

    void stability(const Stability& s) {
        for (const auto& [status, count] : s.refused_by)
            add(fmt::format("{} of {} points of the stability sweep", count, s.cases),
                "the evaluator answers " + status);
        if (s.beyond_reference > 0)
            add(fmt::format("{} of {} points of the stability sweep", s.beyond_reference, s.cases),
                "the exact solution is not followed so far");
    }

    [[nodiscard]] Block block() const {
        if (table_.rows.empty()) return Paragraph{"Nothing was left out."};
        return table_;
    }

private:
    static std::string at(const Rational& eps) { return "ε = " + plain_number(to_double(eps)); }

    Table table_{"", {"what", "why"}, {}};
};

} // namespace

Section left_out_section(const Findings& f, bool drawn) {
    LeftOut out;
    if (!drawn) out.add("figures", "gnuplot could not be run");
    out.ladder(f.verification);
    out.comparison(f.comparison);
    out.stability(f.stability);
    return {"What was left out, and why", {out.block()}};
}

} // namespace resonform::report
