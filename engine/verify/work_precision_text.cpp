// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/work_precision.hpp"

#include <fmt/format.h>

namespace resonform {

namespace {

std::string row_line(const ComparisonRow& r) {
    std::string line = fmt::format("  {:<6} {:<15} {:<16}", to_string(r.task), r.method, r.setting);
    if (!r.failure.empty()) return line + " " + r.failure + "\n";
    for (const double e : r.max_error) line += fmt::format(" {:>9.2e}", e);
    return line + fmt::format(" | {:>9.3g} s", r.seconds) +
           (r.construction_seconds > 0 ? fmt::format(" + {:.3g} s to construct", r.construction_seconds)
                                       : "") +
           "\n";
}

std::string even_lines(const BreakEven& b) {
    std::string text =
        fmt::format("  {}: emitted {:.3g} s, construction included;", to_string(b.task), b.emitted_seconds);
    for (const RivalAtEqualAccuracy& r : b.rivals)
        text += r.seconds ? fmt::format(" {} {:.3g} s ({:.3g} times);", r.method, *r.seconds, *r.ratio)
                          : fmt::format(" {} does not reach it;", r.method);
    return text + fmt::format(" the fastest is {}\n", b.winner);
}

} // namespace

std::string to_text(const Comparison& c) {
    std::string text = fmt::format("{} / {}: error against run time at eps = {:g}\n  {:<6} {:<15} {:<16}",
                                   c.system, c.scene, to_double(c.eps), "task", "method", "setting");
    for (const std::string& name : c.outputs) text += fmt::format(" {:>9}", name);
    text += "\n";
    for (const ComparisonRow& r : c.rows) text += row_line(r);
    text += "At the accuracy of the emitted code along the run:\n";
    for (const BreakEven& b : c.break_even) text += even_lines(b);
    return text;
}

} // namespace resonform
