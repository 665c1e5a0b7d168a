// SPDX-License-Identifier: GPL-3.0-or-later
// The ensemble form of emitted code, compiled and called: many members, each with arguments and a time of its
// own. What a member gets depends on its arguments alone.
#pragma once

#include "verify/evaluate/evaluator.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace resonform {

class EnsembleLibrary {
public:
    // Errors: those of SharedObject.
    EnsembleLibrary(const Program& program, const std::filesystem::path& cache,
                    const std::function<void(const std::string&)>& progress);

    // arguments: eps, the parameters and the start values in the program's order, an array of n each, or null
    // for the scene's default (not of eps). outputs[k][i], status[i]: of member i at t[i]; NaN where there is
    // no number. Thread-safe.
    void evaluate(const std::vector<const double*>& arguments, std::size_t n, const double* t,
                  const std::vector<double*>& outputs, unsigned char* status) const;
    // The ends of the members' intervals, as the scene has them at their eps and parameters.
    void interval_ends(const std::vector<const double*>& arguments, std::size_t n, double* t) const;

private:
    std::shared_ptr<const EvaluatorLibrary> library_;
    void (*evaluate_)(const double* const*, long, const double*, double* const*, unsigned char*) = nullptr;
    void (*interval_ends_)(const double* const*, long, double*) = nullptr;
};

} // namespace resonform
