// SPDX-License-Identifier: GPL-3.0-or-later
// What emitted code computes without an object, compiled and called: one final point; many members, each with
// arguments and a time of its own. What a member gets depends on its arguments alone.
#pragma once

#include "verify/evaluate/evaluator.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace resonform {

// One point at a final time.
class FinalPointLibrary {
public:
    // Whether it has the letter "f".
    static bool is_in(const EvaluatorLibrary& library);
    // Precondition: it is there.
    explicit FinalPointLibrary(std::shared_ptr<const EvaluatorLibrary> library);
    // parameters, start: in the order of the program's. Thread-safe.
    Status at_end(double eps, const double* parameters, const double* start, double t, double* outputs) const;

private:
    std::shared_ptr<const EvaluatorLibrary> library_;
    int (*at_end_)(const double*, const double*, const double*, const double*, double*);
};

// Radians (runtime/ensemble.hpp).
constexpr double quick_phase_error = 4e-13;

class EnsembleLibrary {
public:
    // Whether it has the letter "e".
    static bool is_in(const EvaluatorLibrary& library);
    // Precondition: it is there.
    explicit EnsembleLibrary(std::shared_ptr<const EvaluatorLibrary> library);
    // Errors: those of SharedObject.
    EnsembleLibrary(const Program& program, const std::filesystem::path& cache,
                    const std::function<void(const std::string&)>& progress);

    // arguments: eps, the parameters and the start values in the program's order, an array of n each, or null
    // for the scene's default (not of eps). outputs[k][i], status[i]: of member i at t[i]; NaN where there is
    // no number. full_phase: false: a phase may be off by quick_phase_error. Thread-safe.
    void evaluate(const std::vector<const double*>& arguments, std::size_t n, const double* t,
                  const std::vector<double*>& outputs, unsigned char* status, bool full_phase = true) const;
    // The ends of the members' intervals, as the scene has them at their eps and parameters.
    void interval_ends(const std::vector<const double*>& arguments, std::size_t n, double* t) const;

private:
    std::shared_ptr<const EvaluatorLibrary> library_;
    void (*evaluate_)(const double* const*, long, const double*, double* const*, unsigned char*,
                      int) = nullptr;
    void (*interval_ends_)(const double* const*, long, double*) = nullptr;
};

} // namespace resonform
