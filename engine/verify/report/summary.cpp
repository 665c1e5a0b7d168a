// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/report/results.hpp"

#include "verify/report/page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace resonform::report {

namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const Json& value) {
    return value.is_string() ? value.get<std::string>() : value.is_null() ? "–" : value.dump();
}

std::string number_of_json(const Json& value) {
    return value.is_number() ? short_number(value.get<double>()) : "–";
}

// "ψ fail (3 of 4), as expected; x pass (4)": orders found, and claimed where that differs.
std::string verdicts_of(const Json& results) {
    std::vector<std::string> all;
    for (const Json& o : results.at("verification").at("outputs")) {
        const std::string verdict = text_of(o.at("verdict")), found = text_of(o.at("found_order")),
                          claimed = text_of(o.at("claimed_order"));
        std::string text = fmt::format("{} {} ({})", pretty(text_of(o.at("name"))), verdict,
                                       found == claimed ? found : fmt::format("{} of {}", found, claimed));
        if (o.at("verdict") != o.at("expected"))
            text += ", expected " + text_of(o.at("expected"));
        else if (verdict != "pass")
            text += ", as expected";
        all.push_back(std::move(text));
    }
    return fmt::format("{}", fmt::join(all, "; "));
}

// "Taylor, 272": the fastest rival of a task, and how many times as long it takes.
std::string rival_of(const Json& results, const char* task) {
    if (!results.contains("comparison") || !results["comparison"].at("break_even").contains(task)) return "–";
    const Json& even = results["comparison"]["break_even"][task];
    if (even.at("emitted_seconds").is_null()) return "not compared";
    const Json* best = nullptr;
    for (const Json& rival : even.at("rivals"))
        if (rival.at("ratio").is_number() && (best == nullptr || rival["ratio"] < (*best)["ratio"]))
            best = &rival;
    return best == nullptr
               ? "none is as accurate"
               : fmt::format("{}, {}", text_of((*best)["method"]), number_of_json((*best)["ratio"]));
}

std::string worst_ulp_of(const Json& stability) {
    double worst = 0;
    for (const Json& w : stability.at("worst"))
        if (w.at("ulp").is_number()) worst = std::max(worst, w["ulp"].get<double>());
    return fmt::format("{}, {}", text_of(stability.at("verdict")), short_number(worst));
}

std::string estimates_of(const Json& results) {
    std::vector<std::string> ratios;
    for (const Json& o : results.at("verification").at("outputs"))
        if (o.contains("error_estimate") && o["error_estimate"].at("ratio").is_number())
            ratios.push_back(fmt::format("{} {}", pretty(text_of(o.at("name"))),
                                         number_of_json(o["error_estimate"]["ratio"])));
    return ratios.empty() ? "–" : fmt::format("{}", fmt::join(ratios, "; "));
}

} // namespace

Page summary_page(const std::vector<Json>& results) {
    Table table{"",
                {"scene", "order", "verdicts (order found)", "one point: best rival, times",
                 "10⁶ points: best rival, times", "stability, worst ulp", "emitted = symbolic, ulp",
                 "estimated / true error"},
                {}};
    std::set<std::string> commits;
    for (const Json& r : results) {
        const std::string name = text_of(r.at("system")) + "/" + text_of(r.at("scene"));
        table.rows.push_back({name, text_of(r.at("order")), verdicts_of(r), rival_of(r, "final"),
                              rival_of(r, "dense"), worst_ulp_of(r.at("stability")),
                              number_of_json(r.at("verification").at("emitted_against_symbolic_ulp")),
                              estimates_of(r)});
        table.links.push_back(name + "/report.md");
        commits.insert(text_of(r.at("commit")));
    }
    return {
        "Results of every scene",
        fmt::format(
            "{} scenes, made by `resonform results` at commit {}. A rival below 1 is faster than the emitted "
            "code, at the same accuracy; ulp are those of an output's scale.",
            results.size(), fmt::join(commits, ", ")),
        {{"Scenes", {std::move(table)}}}};
}

} // namespace resonform::report
