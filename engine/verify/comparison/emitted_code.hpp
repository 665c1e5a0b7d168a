// SPDX-License-Identifier: GPL-3.0-or-later
// The emitted code of one order, as users get it: without the states that verification keeps.
#pragma once

#include "verify/comparison/comparison.hpp"
#include "verify/judging/trial.hpp"

#include <memory>
#include <string>
#include <vector>

namespace resonform {

class EmittedCode {
public:
    // solution: of the scene, whose order counts. Errors: those of build_program and SharedObject.
    EmittedCode(const Scene& scene, const Solution& solution, const CompareOptions& options);

    [[nodiscard]] const Program& program() const { return program_; }
    [[nodiscard]] const std::shared_ptr<const EvaluatorLibrary>& library() const { return library_; }
    [[nodiscard]] const Preparation& prepared() const { return prepared_; }
    [[nodiscard]] std::string setting() const;

    [[nodiscard]] std::vector<double> parameters(const TrialPoint& at) const;
    [[nodiscard]] std::vector<double> start(const TrialPoint& at) const;
    [[nodiscard]] Evaluator<double> construct(const TrialPoint& at) const;

private:
    Preparation prepared_;
    Program program_;
    std::shared_ptr<const EvaluatorLibrary> library_;
};

// The solution of a scene at a lower order: from the same normal form, through the weight that the count of
// that order asks.
Solution lower_solution(const Scene& lower, const Solution& solution);

// Of each order asked for, ascending; the last is that of the scene, whose solution this is.
std::vector<EmittedCode> emitted_codes(const Scene& scene, const Solution& solution,
                                       const CompareOptions& options);

} // namespace resonform
