// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/number.hpp"
#include "verify/comparison/break_even.hpp"
#include "verify/report/page.hpp"
#include "verify/report/sections.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace resonform::report {

namespace {

// "third order", "order 7/2": of an error O(eps^3), O(eps^(7/2)).
std::string order_in_words(const Rational& order) {
    static constexpr std::array<const char*, 9> words{"first", "second",  "third",  "fourth", "fifth",
                                                      "sixth", "seventh", "eighth", "ninth"};
    for (std::size_t i = 0; i < words.size(); ++i)
        if (order == static_cast<int>(i) + 1) return std::string(words[i]) + " order";
    return "order " + to_string(order);
}

// "fourth order" after "third order": "fourth".
std::string in_short(const std::string& order) {
    return order.substr(0, order.compare(0, 6, "order ") == 0 ? order.size() : order.find(' '));
}

std::string what_was_found(const OutputVerdict& o) {
    const std::string claimed = order_in_words(o.order(o.claimed_order));
    if (!o.found_order)
        return o.verdict == Verdict::pass
                   ? fmt::format("is {} as claimed, with no error that could be seen", claimed)
                   : fmt::format("is claimed to be {}", claimed);
    const std::string found = order_in_words(o.order(*o.found_order));
    if (*o.found_order < o.claimed_order)
        return fmt::format("is {}, not {} as claimed", found, in_short(claimed));
    if (*o.found_order > o.claimed_order)
        return fmt::format("is {}, more than the claimed {}", found, in_short(claimed));
    return fmt::format("is {} as claimed", found);
}

std::string expectation_of(const OutputVerdict& o) {
    if (o.verdict != o.expected) return fmt::format("; NOT as expected, which is: {}", to_string(o.expected));
    return o.expected == Verdict::pass ? "" : "; as expected";
}

Statement of_output(const OutputVerdict& o, const Conditions& c) {
    std::string text = fmt::format("{} {} on {}", pretty(o.name), what_was_found(o), interval_of(c));
    if (c.shorter_than_promised) text += fmt::format(", shorter than {} as promised", typeset(c.promised));
    if (o.found_order && std::isfinite(o.slope))
        text += fmt::format(": slope {:.3f}, constant {} (max |Δ{}| → {} {})", o.slope,
                            short_number(o.constant, 4), pretty(o.name), short_number(o.constant, 4),
                            power_of_eps(o.order(*o.found_order)));
    if (!o.reason.empty() && !o.fails_by_order()) text += ": " + typeset(o.reason);
    return {to_string(o.verdict), text + expectation_of(o)};
}

Statement of_emitted(const EmittedCheck& check) {
    return {to_string(check.verdict),
            fmt::format("The compiled code differs from the exact formulas by at most {} ulp of the output's "
                        "scale; {} are "
                        "allowed",
                        short_number(check.worst()), short_number(check.threshold))};
}

Statement of_task(const BreakEven& even, const Rational& eps) {
    const std::string task =
        even.task == Task::final
            ? "One point at the end of the run"
            : fmt::format("{} points along the run", plain_number(static_cast<double>(even.measured_points)));
    const std::string where = fmt::format("{}, ε = {}", task, plain_number(to_double(eps)));
    if (!even.failure.empty()) return {"not compared", where + ": " + typeset(even.failure)};
    const RivalAtEqualAccuracy* best = best_rival(even);
    if (best == nullptr) return {"wins", where + ": no integrator reaches the accuracy of the emitted code"};
    const double ratio = *best->ratio;
    if (ratio < 1)
        return {"loses", fmt::format("{}: {} reaches the same accuracy in {} of the time ({} s)", where,
                                     best->method, short_number(ratio), short_number(*best->seconds))};
    return {"wins",
            fmt::format("{}: {} s; the best rival, {}, takes {} times as long for the same accuracy", where,
                        short_number(even.emitted_seconds), best->method, short_number(ratio))};
}

const WorstPoint* worst_of(const Stability& s) {
    const auto less = [](const WorstPoint& a, const WorstPoint& b) { return a.ulp < b.ulp; };
    const auto worst = std::max_element(s.worst.begin(), s.worst.end(), less);
    return worst == s.worst.end() ? nullptr : &*worst;
}

Statement of_stability(const Stability& s) {
    std::string text = "Rounding over many decades of every input: ";
    if (const WorstPoint* worst = worst_of(s))
        text += fmt::format("{} is off by {} ulp at worst, where {} are unavoidable; ", pretty(worst->output),
                            short_number(worst->ulp), short_number(worst->left_open()));
    text += fmt::format("{} of {} points are answered by a status", s.refused, s.cases);
    if (!s.rule.empty()) text += "; " + typeset(s.rule);
    return {to_string(s.verdict), text};
}

// Nothing where no error is estimated.
std::vector<Statement> of_estimates(const std::vector<OutputVerdict>& outputs) {
    std::vector<std::string> ratios;
    for (const OutputVerdict& o : outputs)
        if (o.estimate_ratio)
            ratios.push_back(fmt::format("{} of {}", short_number(*o.estimate_ratio), pretty(o.name)));
    if (ratios.empty()) return {};
    return {{"estimate",
             fmt::format(
                 "The error estimated by the next weight, without direct integration, is {} times the true "
                 "one",
                 fmt::join(ratios, ", "))}};
}

} // namespace

std::string interval_of(const Conditions& c) {
    if (c.layer_end > 0) return fmt::format("{} ≤ t ≤ {}", short_number(c.layer_end), typeset(c.interval));
    return "0 ≤ t ≤ " + typeset(c.interval);
}

Section verdict_section(const Findings& f) {
    Statements said;
    for (const OutputVerdict& o : f.verification.outputs)
        said.all.push_back(of_output(o, f.verification.conditions));
    for (Statement& s : of_estimates(f.verification.outputs)) said.all.push_back(std::move(s));
    const BreakEvenAtEps& at = f.comparison.by_eps.front();
    for (const BreakEven& even : at.tasks)
        if (even.order == f.scene->system->weight(f.scene->order)) said.all.push_back(of_task(even, at.eps));
    said.all.push_back(of_stability(f.stability));
    said.all.push_back(of_emitted(f.verification.emitted));
    return {"Verdict", {std::move(said)}};
}

} // namespace resonform::report
