// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/number.hpp"
#include "model/text/eps_powers.hpp"
#include "verify/judging/conditions.hpp"
#include "verify/judging/judge.hpp"
#include "verify/judging/ladder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <vector>

namespace resonform {

namespace {

std::string verdict_line(const OutputVerdict& o, const Conditions& c) {
    const auto power = [&](int held) { return spell_eps_power(o.order(held)); };
    std::string line =
        fmt::format("  {:<8} {:<10} claimed {}", o.name, to_string(o.verdict), power(o.claimed_order));
    if (o.guaranteed_order) line += ", guaranteed " + power(*o.guaranteed_order);
    if (o.found_order && std::isfinite(o.slope))
        line += fmt::format(", found {}: slope {:.3f} over eps = {:g} ... {:g}, max|error| -> {:.3e} {}",
                            power(*o.found_order), o.slope, o.slope_high_eps, o.slope_low_eps, o.constant,
                            power(*o.found_order));
    else if (std::isfinite(o.slope))
        line += fmt::format(", slope {:.3f} over eps = {:g} ... {:g}", o.slope, o.slope_high_eps,
                            o.slope_low_eps);
    if (o.verdict != o.expected)
        line += fmt::format("  EXPECTED {}", to_string(o.expected));
    else if (o.expected != Verdict::pass)
        line += "  (as expected)";
    if (c.shorter_than_promised) line += ", " + shortness(c);
    if (!o.layer.empty())
        line +=
            fmt::format("\n           in the layer, t <= 20/|Re lambda|: max|error| {:.2e} at eps = {:g}{}",
                        o.layer.back().max_error, to_double(o.layer.back().eps),
                        std::isfinite(o.layer_slope) ? fmt::format(", slope {:.3f}", o.layer_slope) : "");
    if (!o.reason.empty() && !o.fails_by_order()) line += "\n           " + o.reason;
    return line + "\n";
}

// "  error of x, estimated by order 4: 2.0e-08 at eps = 0.01 (map 1.5e-08, flow 7.0e-09), 1.01 of the true
// one"
std::string estimate_line(const OutputVerdict& o) {
    if (!o.estimate) return "";
    const ErrorEstimate& e = *o.estimate;
    std::string line = fmt::format("  estimated error of {}", o.name);
    if (const EstimatedRung* told = told_estimate(o); told != nullptr && std::isfinite(told->error)) {
        line += fmt::format(": {:.2e} at eps = {:g} (map {:.2e}, flow {:.2e}; by order {})", told->error,
                            to_double(told->eps), told->map, told->flow, to_string(o.order(e.next_order)));
        if (o.estimate_ratio) line += fmt::format(", {:.3g} times the true one", *o.estimate_ratio);
    }
    return line + (e.reason.empty() ? "\n" : ": " + e.reason + "\n");
}

// "  best of the orders 1 ... 4 for x, by extrapolation: 2 at eps = 0.2 ... 0.1, 4 at eps = 0.05"
std::string best_line(const OutputVerdict& o) {
    if (!o.estimate || o.estimate->best.empty()) return "";
    const std::vector<BestOrder>& best = o.estimate->best;
    std::vector<std::string> parts;
    for (std::size_t i = 0, j = 0; i < best.size(); i = j) {
        while (j < best.size() && best[j].order == best[i].order) ++j;
        parts.push_back(
            fmt::format("{} at eps = {:g}", to_string(o.order(best[i].order)), to_double(best[i].eps)));
        if (j > i + 1) parts.back() += fmt::format(" ... {:g}", to_double(best[j - 1].eps));
    }
    return fmt::format("  best of the orders {} ... {} for {}, by extrapolation: {}\n", to_string(o.order(1)),
                       to_string(o.order(best.front().looked_at)), o.name, fmt::join(parts, ", "));
}

// "  defect of x: max|x'' - f| 2.1e-10 at eps = 0.01, slope 5.001"
std::string defect_line(const OutputVerdict& d) {
    std::string line = fmt::format("  defect of {}, the formula put into its equation: {:.2e} at eps = {:g}",
                                   d.name, d.ladder.back().max_error, to_double(d.ladder.back().eps));
    if (std::isfinite(d.slope)) line += fmt::format(", slope {:.3f}", d.slope);
    return line + (d.reason.empty() ? "\n" : ": " + d.reason + "\n");
}

// "  data error of psi: 3.1e-07 at eps = 0.005: every other sample left out"
std::string data_line(const OutputVerdict& o) {
    if (!o.data_error) return "";
    return fmt::format("  data error of {}: {:.2e} at eps = {:g}, by the spline through every other sample\n",
                       o.name, o.data_error->error, o.data_error->eps);
}

// The slope above rung i; nothing where an error is zero or no number.
std::string slope_text(const OutputVerdict& o, std::size_t i) {
    if (i == 0 || !std::isfinite(o.local_slopes[i - 1])) return "";
    return fmt::format("{:.3f}", o.local_slopes[i - 1]);
}

// One row per eps: max error and local slope of each output.
std::string ladder_table(const Verification& v) {
    std::string text = fmt::format("  {:>8}", "eps");
    for (const OutputVerdict& o : v.outputs)
        text += fmt::format(" | {:>9} {:>9} {:>6}", o.name + ": max", "rms", "slope");
    text += " | digits\n";
    const std::size_t rungs = v.outputs.empty() ? 0 : v.outputs.front().ladder.size();
    for (std::size_t i = 0; i < rungs; ++i) {
        text += fmt::format("  {:>8g}", to_double(v.outputs.front().ladder[i].eps));
        for (const OutputVerdict& o : v.outputs)
            text += fmt::format(" | {:9.2e} {:9.2e} {:>6}", o.ladder[i].max_error, o.ladder[i].rms_error,
                                slope_text(o, i));
        text += fmt::format(" | {:>6}\n", v.outputs.front().ladder[i].digits);
    }
    return text;
}

// Explains inf in the table; "" if there is none.
std::string unanswered(const Verification& v) {
    std::vector<double> eps;
    if (!v.outputs.empty())
        for (const LadderRung& rung : v.outputs.front().ladder)
            if (std::isinf(rung.max_error)) eps.push_back(to_double(rung.eps));
    if (eps.empty()) return "";
    return fmt::format("  inf: the evaluator does not answer over the whole interval at eps = {:g}; "
                       "`resonform evaluate` shows from which t on, and with which status\n",
                       fmt::join(eps, ", "));
}

// The conditions of the verdicts: interval, eps, times, start, and where the ladder ends.
std::string conditions_text(const Verification& v) {
    const Conditions& c = v.conditions;
    const std::string from =
        c.layer_end > 0 ? fmt::format("{:.3g} (the layer, at the smallest eps)", c.layer_end) : "0";
    std::string text = fmt::format("  on {} <= t <= {}", from, c.interval);
    if (c.growth_end)
        text += fmt::format(", but not beyond t = {:.3g} beside a mode that grows", *c.growth_end);
    if (c.count > 0) {
        const std::vector<LadderRung>& ladder = v.outputs.front().ladder;
        text += fmt::format(", eps = {:g} ... {:g}; {} times at the smallest, half of them even",
                            to_double(ladder.front().eps), to_double(ladder.back().eps), c.count);
        if (std::isfinite(c.per_fast_period))
            text += fmt::format(" ({:.3g} or more in a fast period)", c.per_fast_period);
        text += fmt::format(", the others crowd at both ends, the first at t = {:.1e}", c.first);
    }
    for (const auto& [call, value] : c.functions) text += fmt::format("\n  {} = {}", call, value);
    std::vector<std::string> start;
    for (const auto& [name, value] : c.start) start.push_back(fmt::format("{} = {}", name, value));
    if (!start.empty()) text += fmt::format("\n  start: {}", fmt::join(start, ", "));
    if (c.growth_end && !c.beyond.empty()) text += "\n  " + c.beyond;
    for (const Conditions::Moved& moved : c.moved)
        text += moved.given
                    ? fmt::format("\n  projected at the smallest eps: {}(0) = {:g}, {:+.3e}", moved.state,
                                  *moved.given, moved.start - *moved.given)
                    : fmt::format("\n  found at the smallest eps: {}(0) = {:g}", moved.state, moved.start);
    if (!c.within_layer.empty()) {
        std::vector<double> eps;
        for (const Rational& e : c.within_layer) eps.push_back(to_double(e));
        text += fmt::format("\n  left out, as the layer takes half of the interval: eps = {:g}",
                            fmt::join(eps, ", "));
    }
    if (c.ladder_end)
        text += fmt::format("\n  the ladder ends above eps = {:g}: {}", to_double(c.ladder_end->eps),
                            c.ladder_end->reason);
    return text + "\n";
}

} // namespace

std::string to_text(const Verification& v) {
    std::string text = fmt::format("{} / {}: emitted code against direct integration\n", v.system, v.scene);
    text += ladder_table(v);
    text += unanswered(v);
    text += conditions_text(v);
    for (const OutputVerdict& o : v.outputs) text += verdict_line(o, v.conditions);
    for (const OutputVerdict& d : v.defects) text += defect_line(d);
    for (const OutputVerdict& o : v.outputs) text += estimate_line(o) + best_line(o);
    for (const OutputVerdict& o : v.outputs) text += data_line(o);
    text += to_text(v.emitted);
    return v.lies ? text + to_text(*v.lies) : text;
}

} // namespace resonform
