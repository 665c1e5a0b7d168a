// SPDX-License-Identifier: GPL-3.0-or-later
// Which tolerance makes an integrator as accurate as a formula.
#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace resonform {

// max_k error_k/accuracy_k; infinite where an error is NaN, or above an accuracy of 0.
double error_ratio(const std::vector<double>& errors, const std::vector<double>& accuracy);

struct Tuned {
    double tolerance;
    double ratio; // the error ratio there, at most 1
};

// The loosest tolerance whose error ratio is at most 1: looked for in decades from 10^-1 to 10^-13, then
// between the two between which the ratio passes 1, by interpolation in log(ratio) over log(tolerance)
// (regula falsi, the Illinois variant), until the ratio lies in 0.9 ... 1 or the tolerance is known to 2 %.
// An error that does not fall steadily has several such places; the one found is next to the loosest decade.
// nullopt: no decade reaches it. ratio_at is called up to 25 times.
std::optional<Tuned> loosest_tolerance(const std::function<double(double)>& ratio_at);

} // namespace resonform
