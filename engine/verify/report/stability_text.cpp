// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/stability/stability.hpp"

#include "model/text/eps_powers.hpp"

#include <fmt/format.h>

namespace resonform {

namespace {

// The range over which an input was swept, and the share of decades of the whole range.
std::string line_of(const SweptInput& input, const SweptInput& whole) {
    std::string text = fmt::format("  {:<12} ", input.name);
    if (input.high > 0)
        text += fmt::format("{}{:g} ... {:g}", input.negative ? "+-" : "", input.low, input.high);
    if (input.zero) text += input.high > 0 ? " and 0" : "0";
    if (!input.zero && input.high == 0) text += "nothing";
    if (input.weight == 1) text += ", times eps";
    if (input.weight != 0 && input.weight != 1) text += ", times " + spell_eps_power(input.weight);
    return text + fmt::format(" ({:.0f} of {:.0f} decades){}\n", decades(input), decades(whole),
                              input.rests ? ", from its equilibrium" : "");
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
    if (!s.rule.empty()) text += fmt::format("  {}: {}\n", to_string(s.verdict), s.rule);
    text += "  swept, as far as the reference goes:\n";
    for (std::size_t i = 0; i < s.inputs.size(); ++i) text += line_of(s.swept[i], s.inputs[i]);
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
