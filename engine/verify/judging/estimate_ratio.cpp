// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/number.hpp"
#include "verify/judging/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace resonform {

namespace {

constexpr std::size_t compared_rungs = 2;
constexpr double most_ratio = 3;

// How far a ratio is from 1, up or down.
double distance_of_ratio(double ratio) { return std::max(ratio, 1 / ratio); }

// Whether reference or rounding may hide a third of the estimated error.
bool is_hidden(const LadderRung& rung, const EstimatedRung& estimated) {
    return 3 * std::max({rung.reference_error, rung.floor, estimated.rounding}) >= estimated.error;
}

} // namespace

void weigh_estimate(OutputVerdict& output, ErrorEstimate estimate) {
    output.estimate_ratio.reset();
    output.estimate = std::move(estimate);
    ErrorEstimate& e = *output.estimate;
    if (e.next_order == 0) return;
    std::size_t compared = 0;
    bool hidden = !output.ladder.empty();
    for (std::size_t i = output.ladder.size(); i-- > 0 && compared < compared_rungs;) {
        const LadderRung& rung = output.ladder[i];
        hidden = hidden && is_hidden(rung, e.ladder[i]);
        if (!usable(rung)) continue;
        ++compared;
        const double ratio = e.ladder[i].error / rung.max_error;
        if (!output.estimate_ratio || distance_of_ratio(ratio) > distance_of_ratio(*output.estimate_ratio))
            output.estimate_ratio = ratio;
    }
    if (compared > 0 && distance_of_ratio(*output.estimate_ratio) <= most_ratio) return;
    if (hidden)
        e.reason = "reference or rounding is above a third of it";
    else if (compared == 0)
        e.reason = "the ladder has no usable rung";
    else if (std::isinf(*output.estimate_ratio))
        e.reason = fmt::format("the formula of order {} does not answer over the whole interval",
                               to_string(output.order(e.next_order)));
    else
        e.reason = "no test tells why";
}

const EstimatedRung* told_estimate(const OutputVerdict& output) {
    if (!output.estimate || output.estimate->next_order == 0 || output.ladder.empty()) return nullptr;
    std::size_t i = output.ladder.size() - 1;
    while (i > 0 && !usable(output.ladder[i])) --i;
    if (!usable(output.ladder[i])) i = output.ladder.size() - 1;
    return &output.estimate->ladder[i];
}

} // namespace resonform
