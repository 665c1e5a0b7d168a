// SPDX-License-Identifier: GPL-3.0-or-later
// The eps-ladder: max and RMS error of each output over t in [0, interval] for a descending ladder of
// eps, against direct integration in extended precision; the judge turns it into verdicts.
#pragma once

#include "model/exact/first_order_system.hpp"
#include "verify/judging/options.hpp"
#include "verify/judging/verification.hpp"

#include <memory>
#include <string>
#include <vector>

namespace resonform {

// Everything `resonform verify` prints.
Verification verify(std::shared_ptr<const FirstOrderSystem> system, const Scene& scene,
                    const Solution& solution, const VerifyOptions& options);

// One run at one eps, for plots: emitted values and their difference from direct integration.
// [output][point]; direct integration in extended precision, differences taken there.
struct ErrorCurves {
    double eps = 0;
    std::vector<std::string> outputs;
    std::vector<double> times;
    std::vector<std::vector<double>> emitted, direct, error;
};
// points: how many times, evenly spread over [0, interval], both ends included.
ErrorCurves error_curves(std::shared_ptr<const FirstOrderSystem> system, const Scene& scene,
                         const Solution& solution, const Rational& eps, std::size_t points,
                         const VerifyOptions& options);

// The screen of `resonform verify`: one ladder per output with its verdict.
std::string to_text(const Verification& verification);

} // namespace resonform
