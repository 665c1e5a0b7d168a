// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/number.hpp"
#include "verify/comparison/comparison.hpp"

#include <fmt/format.h>

namespace resonform {

namespace {

// "dense, 1000 points"
std::string told(Task task, std::size_t points, std::size_t members) {
    if (task == Task::final) return to_string(task);
    return task == Task::ensemble ? fmt::format("{}, {} starts", to_string(task), members)
                                  : fmt::format("{}, {} points", to_string(task), points);
}

std::string row_line(const ComparisonRow& r) {
    std::string line = fmt::format("  {:<22} {:<13} {:<18} {:<8}", told(r.task, r.points, r.members),
                                   r.method, r.setting, r.form ? to_string(*r.form) : "");
    if (!r.failure.empty()) return line + " " + r.failure + "\n";
    for (const double e : r.max_error) line += fmt::format(" {:>9.2e}", e);
    line += fmt::format(" | {:>9.3g} s ({:.3g} ... {:.3g}, {} runs)", r.seconds.median, r.seconds.low,
                        r.seconds.high, r.seconds.repetitions);
    if (r.construction_seconds > 0) line += fmt::format(" + {:.3g} s to construct", r.construction_seconds);
    if (r.run_members < r.members) line += fmt::format(", scaled from {} starts", r.run_members);
    return line + "\n";
}

std::string rival_text(const RivalAtEqualAccuracy& r) {
    if (!r.seconds) return fmt::format("\n    {} does not reach it", r.method);
    std::string text = fmt::format("\n    {} {:.3g} s ({:.3g} times)", r.method, *r.seconds, *r.ratio);
    if (r.tolerance > 0)
        text += fmt::format(": {}, errors {:.2g} of the emitted code's, {:.3g} ... {:.3g} s",
                            setting_of(r.tolerance), r.error_ratio, r.spread.low, r.spread.high);
    return text;
}

// ladder: several eps were asked for.
std::string paid_text(const BreakEven& b, bool ladder) {
    std::string text;
    if (b.points && b.measured_points > 1)
        text += *b.points > 1 ? fmt::format(", from {} points on", *b.points) : ", from the first point on";
    if (b.eps && ladder) text += fmt::format(", for eps <= {:g}", to_double(*b.eps));
    if (b.runs)
        text += fmt::format("; derivation and compilation are paid after {} run{}", *b.runs,
                            *b.runs > 1 ? "s" : "");
    return text;
}

std::string even_lines(const BreakEven& b, bool ladder) {
    const std::string own = "emitted";
    const std::string task = told(b.task, b.measured_points, b.members);
    if (!b.failure.empty())
        return fmt::format("  {}: the {} evaluator has no numbers ({}), and nothing is compared\n", task, own,
                           b.failure);
    std::string text = fmt::format("  {}: {} {:.3g} s", task, own, b.emitted_seconds);
    if (b.form) text += fmt::format(" ({})", to_string(*b.form));
    text += ", construction included";
    for (const RivalAtEqualAccuracy& r : b.rivals) text += rival_text(r);
    return text + (b.winner == own
                       ? fmt::format("\n    the {} evaluator is the fastest{}\n", own, paid_text(b, ladder))
                       : fmt::format("\n    the {} evaluator loses, {} is the fastest\n", own, b.winner));
}

std::string text_at(const Comparison& c, const BreakEvenAtEps& at) {
    std::string text =
        fmt::format("{} / {}: error against run time at eps = {:g}\n  {:<22} {:<13} {:<18} {:<8}", c.system,
                    c.scene, to_double(at.eps), "task", "method", "setting", "form");
    for (const std::string& name : c.outputs) text += fmt::format(" {:>9}", name);
    text += " | median (least ... most)\n";
    for (const ComparisonRow& r : c.rows)
        if (r.eps == at.eps) text += row_line(r);
    Rational order = -1;
    for (const BreakEven& b : at.tasks) {
        if (b.order != order) {
            text += fmt::format("At the accuracy of the emitted code{} along the run:\n",
                                b.order > 0 ? " of order " + to_string(b.order) : "");
            order = b.order;
        }
        text += even_lines(b, c.by_eps.size() > 1);
    }
    return text;
}

std::string machine_text(const Comparison& c) {
    const Machine& m = c.machine;
    std::string text =
        fmt::format("{}, {} processor{}", m.processor, m.processors, m.processors == 1 ? "" : "s");
    if (m.load) text += fmt::format(", load {:.2f} before", *m.load);
    text += fmt::format("; {}; many points in {}; {}; {}\n", m.instructions, m.loops, m.compiler,
                        c.pinned ? "one thread, held on its processor" : "one thread");
    for (const Preparation& p : c.prepared)
        text += fmt::format("order {}: derivation {:.3g} s, compilation {:.3g} s\n", to_string(p.order),
                            p.derivation_seconds, p.compilation_seconds);
    return text;
}

} // namespace

std::string to_text(const Comparison& c) {
    std::string text;
    for (const BreakEvenAtEps& at : c.by_eps) text += text_at(c, at) + "\n";
    return text + machine_text(c);
}

} // namespace resonform
