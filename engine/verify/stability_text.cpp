// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/stability.hpp"

#include <fmt/format.h>

#include <cmath>

namespace resonform {

namespace {

std::string line_of(const SweptInput& input) {
    std::string text = fmt::format("  {:<12} {}{:g} ... {:g}", input.name, input.negative ? "+-" : "",
                                   input.low, input.high);
    if (input.zero) text += " and 0";
    if (input.weight == 1) text += ", times eps";
    if (input.weight > 1) text += fmt::format(", times eps^{}", input.weight);
    return text + fmt::format(" ({:.0f} decades)\n", std::log10(input.high / input.low));
}

} // namespace

std::string to_text(const Stability& s) {
    std::string text =
        fmt::format("{} / {}: {}, double against 50 digits, threshold {:g} ulp of the output's "
                    "scale{}\n  {} points (seed {}), {} compared, {} refused",
                    s.system, s.scene, to_string(s.verdict), s.threshold,
                    s.reason.empty() ? "" : ", widened: " + s.reason, s.cases, s.seed, s.compared, s.refused);
    for (const auto& [status, count] : s.refused_by) text += fmt::format(", {} {}", count, status);
    text += fmt::format("; {} without an explanation (at most {:.0f} %), {} beyond the reference\n",
                        s.unexplained, 100 * unexplained_share, s.beyond_reference);
    for (const SweptInput& input : s.inputs) text += line_of(input);
    for (const auto& [name, ulp] : s.median) text += fmt::format("  {:<8} median {:.2g} ulp\n", name, ulp);
    for (const WorstPoint& w : s.worst) {
        text += fmt::format("  {:<8} {:>9.3g} ulp", w.output, w.ulp);
        if (w.unavoidable > 0) text += fmt::format(" (a last bit of the inputs: {:.3g})", w.unavoidable);
        text += " at";
        for (const auto& [name, value] : w.at) text += fmt::format(" {} = {:.6g}", name, value);
        text += "\n";
    }
    return text;
}

} // namespace resonform
