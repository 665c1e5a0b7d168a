// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/number.hpp"
#include "verify/judging/work_precision.hpp"

#include <fmt/format.h>

namespace resonform {

namespace {

std::string row_line(const ComparisonRow& r) {
    std::string line = fmt::format("  {:<6} {:<15} {:<16}", to_string(r.task), r.method, r.setting);
    if (!r.failure.empty()) return line + " " + r.failure + "\n";
    for (const double e : r.max_error) line += fmt::format(" {:>9.2e}", e);
    return line +
           fmt::format(" | {:>9.3g} s ({:.3g} ... {:.3g}, {} runs)", r.seconds.median, r.seconds.low,
                       r.seconds.high, r.seconds.repetitions) +
           (r.construction_seconds > 0 ? fmt::format(" + {:.3g} s to construct", r.construction_seconds)
                                       : "") +
           "\n";
}

std::string even_lines(const BreakEven& b) {
    const std::string own = "emitted";
    if (!b.failure.empty())
        return fmt::format("  {}: the {} evaluator has no numbers ({}), and nothing is compared\n",
                           to_string(b.task), own, b.failure);
    std::string text =
        fmt::format("  {}: {} {:.3g} s, construction included;", to_string(b.task), own, b.emitted_seconds);
    for (const RivalAtEqualAccuracy& r : b.rivals)
        text += r.seconds ? fmt::format(" {} {:.3g} s ({:.3g} times);", r.method, *r.seconds, *r.ratio)
                          : fmt::format(" {} does not reach it;", r.method);
    return text + (b.winner == own
                       ? fmt::format(" the {} evaluator is the fastest\n", own)
                       : fmt::format(" the {} evaluator loses, {} is the fastest\n", own, b.winner));
}

std::string text_at(const Comparison& c, const BreakEvenAtEps& at) {
    std::string text = fmt::format("{} / {}: error against run time at eps = {:g}\n  {:<6} {:<15} {:<16}",
                                   c.system, c.scene, to_double(at.eps), "task", "method", "setting");
    for (const std::string& name : c.outputs) text += fmt::format(" {:>9}", name);
    text += " | median (least ... most)\n";
    for (const ComparisonRow& r : c.rows)
        if (r.eps == at.eps) text += row_line(r);
    text += "At the accuracy of the emitted code along the run:\n";
    for (const BreakEven& b : at.tasks) text += even_lines(b);
    return text;
}

} // namespace

std::string to_text(const Comparison& c) {
    std::string text;
    for (const BreakEvenAtEps& at : c.by_eps) text += (text.empty() ? "" : "\n") + text_at(c, at);
    return text;
}

} // namespace resonform
