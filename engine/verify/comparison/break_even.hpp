// SPDX-License-Identifier: GPL-3.0-or-later
// Who wins a task, and from where on.
#pragma once

#include "verify/comparison/comparison.hpp"

namespace resonform {

// own: the rows of one task and order, one for each form, of which the fastest counts. rivals: tuned to the
// accuracy of that order; ratios are set here. prepared: for `runs`. failure: why nothing is compared.
BreakEven break_even(const std::vector<ComparisonRow>& own, std::vector<RivalAtEqualAccuracy> rivals,
                     const Preparation& prepared, const std::string& failure = {});

// The fastest that reaches the accuracy of the emitted code; null: none does.
const RivalAtEqualAccuracy* best_rival(const BreakEven& even);

// Sets `eps` of every task: the largest eps at which, as at all smaller ones, the emitted code wins.
void find_break_even_eps(std::vector<BreakEvenAtEps>& by_eps);

} // namespace resonform
