// SPDX-License-Identifier: GPL-3.0-or-later
// The eps-ladder: max and RMS error of each output over t in [0, interval] for a descending ladder of
// eps, against direct integration in extended precision; the judge turns it into verdicts.
#pragma once

#include "emit/program.hpp"
#include "model/first_order_system.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace resonform {

struct LadderRung {
    Rational eps;
    double max_error = 0, rms_error = 0;
    int digits = 0;             // decimal digits of the arithmetic used
    double reference_error = 0; // estimated error of the direct integration
};

struct OutputVerdict {
    std::string name;
    int claimed_order = 0, found_order = 0;
    Verdict verdict = Verdict::undecided, expected = Verdict::pass;
    double slope = 0, slope_low_eps = 0, slope_high_eps = 0; // asymptotic slope and its window
    double constant = 0;                                     // lim max|error| / eps^found_order
    std::string reason;                                      // when undecided or failed
    std::vector<LadderRung> ladder;
    std::vector<double> local_slopes; // between rungs
};

struct Verification {
    std::string system, scene;
    std::vector<OutputVerdict> outputs;
    double emitted_against_symbolic = 0;    // worst |emitted - interpreted| in ulp of the scale
    [[nodiscard]] bool as_expected() const; // every verdict equals the expected one
};

struct VerifyOptions {
    std::filesystem::path cache; // integrations and compiled evaluators, by content hash
    std::function<void(const std::string&)> progress;
};

// Everything `resonform verify` prints.
Verification verify(std::shared_ptr<const FirstOrderSystem> system, const Scene& scene,
                    const Solution& solution, const VerifyOptions& options);

// Pure: ladder errors -> slope, constant, verdict (verify/judge.hpp implements; tested with made-up data).
void judge(OutputVerdict& output);

} // namespace resonform
