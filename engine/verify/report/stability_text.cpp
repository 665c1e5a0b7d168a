// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/stability/stability.hpp"

#include "model/text/eps_powers.hpp"

#include <fmt/format.h>

#include <algorithm>

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
    return text + fmt::format(" ({:.0f} of {:.0f} decades){}\n", std::min(decades(input), decades(whole)),
                              decades(whole), input.rests ? ", from its equilibrium" : "");
}

// " eps = 0.01 tau_0 = 2 t = 0"
std::string text_of(const NamedInputs& at) {
    std::string text;
    for (const auto& [name, value] : at) text += fmt::format(" {} = {:.6g}", name, value);
    return text;
}

// "outside_domain (1 - tau): 12, 3 without an explanation; a 1e-12 ... 3, t 0 ... 1e5"
std::string line_of(const StabilityRefusals& refusals) {
    std::string text = fmt::format("  {}{}: {}", refusals.status,
                                   refusals.why.empty() ? "" : " (" + refusals.why + ")", refusals.count);
    if (refusals.unexplained > 0) text += fmt::format(", {} without an explanation", refusals.unexplained);
    text += ", at";
    for (const SweptInput& input : refusals.where)
        if (input.high > 0) text += fmt::format(" {} {:.3g} ... {:.3g},", input.name, input.low, input.high);
    text += fmt::format(" t {:.3g} ... {:.3g}\n", refusals.first_t, refusals.last_t);
    if (refusals.unexplained > 0)
        text += fmt::format("           without an explanation at{}\n", text_of(refusals.first));
    return text;
}

// "psi: median 0.21 ulp; 180 to 0.5, 12 to 1, 3 to 2 ulp"
std::string line_of(const std::string& output, double median, const std::vector<UlpBin>& bins) {
    std::string text = fmt::format("  {:<8} median {:.2g} ulp;", output, median);
    for (const UlpBin& bin : bins)
        if (bin.count > 0) text += fmt::format(" {} to {:g},", bin.count, bin.up_to);
    text.pop_back();
    return text + " ulp\n";
}

std::string text_of(const LostDigits& lost) {
    std::string text = fmt::format("           lost in {} = {:.6g}", lost.expression, lost.value);
    const char* before = ", of ";
    for (const LostDigits::Operand& operand : lost.operands) {
        text += fmt::format("{}{} = {:.6g}", before, operand.expression, operand.value);
        before = ", ";
    }
    text += fmt::format("\n           {:.0f} % of the error passes through it", 100 * lost.share);
    if (lost.cancellation > 1) text += fmt::format("; it cancels by {:.2g}", lost.cancellation);
    return text + fmt::format(", and its relative error grows by {:.2g}\n", lost.growth);
}

std::string text_of(const WorstPoint& w, double threshold) {
    std::string text = fmt::format("  {:<8} {:>9.3g} ulp", w.output, w.ulp);
    if (w.unavoidable > 0)
        text += fmt::format(" (a last bit of the slow time: {:.3g}, of the inputs: {:.3g})", w.by_slow_time,
                            w.unavoidable);
    text += " at" + text_of(w.at) + "\n";
    if (w.lost) text += text_of(*w.lost);
    if (w.unavoidable == 0 || w.is_wrong(threshold)) return text;
    if (!w.is_ill_conditioned()) return text + "           left open by the slow time, which is rounded\n";
    return text + fmt::format("           ill-conditioned, condition number {:.3g}, most of {}\n",
                              w.unavoidable, w.sensitive_to);
}

std::string line_of_not_judged(const Stability& s) {
    std::string text =
        fmt::format("  {} far beyond (phases at {:g}, slow variables beyond {:g} and at {:g}), without a "
                    "verdict",
                    s.not_judged, extreme_phase, judged_slow, subnormal_slow);
    const char* before = ": ";
    for (const auto& [output, ulp] : s.not_judged_ulp) {
        text += fmt::format("{}{} is off by {:.3g} ulp at most", before, output, ulp);
        before = ", ";
    }
    for (const auto& [status, count] : s.not_judged_refused_by) {
        text += fmt::format("{}{} {}", before, count, status);
        before = ", ";
    }
    return text + "\n";
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
    if (s.not_judged > 0) text += line_of_not_judged(s);
    if (s.ill_conditioned > 0)
        text += fmt::format(
            "  {} errors above {:g} ulp are left open: {} by a last bit of the slow time, {} by those of the "
            "inputs, with a condition number of 1e8 and more\n",
            s.ill_conditioned, s.threshold, s.moderately_ill_conditioned,
            s.ill_conditioned - s.moderately_ill_conditioned);
    if (!s.rule.empty()) text += fmt::format("  {}: {}\n", to_string(s.verdict), s.rule);
    text += "  swept, as far as the reference goes:\n";
    for (std::size_t i = 0; i < s.inputs.size(); ++i) text += line_of(s.swept[i], s.inputs[i]);
    for (const StabilityRefusals& r : s.refusals) text += line_of(r);
    for (const auto& [name, ulp] : s.median)
        for (const auto& [output, bins] : s.histogram)
            if (output == name) text += line_of(name, ulp, bins);
    for (const WorstPoint& w : s.worst) text += text_of(w, s.threshold);
    return text;
}

} // namespace resonform
