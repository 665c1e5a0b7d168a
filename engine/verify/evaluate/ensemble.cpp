// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/evaluate/ensemble.hpp"

#include <utility>

namespace resonform {

namespace {

constexpr const char *final_point = "rf_at_end", *members = "rf_ensemble";

bool has(const EvaluatorLibrary& library, const char* function) {
    return library.object() && library.object()->symbol(function) != nullptr;
}

} // namespace

bool FinalPointLibrary::is_in(const EvaluatorLibrary& library) { return has(library, final_point); }

bool EnsembleLibrary::is_in(const EvaluatorLibrary& library) { return has(library, members); }

FinalPointLibrary::FinalPointLibrary(std::shared_ptr<const EvaluatorLibrary> library)
    : library_(std::move(library)),
      at_end_(reinterpret_cast<decltype(at_end_)>(library_->object()->symbol(final_point))) {}

Status FinalPointLibrary::at_end(double eps, const double* parameters, const double* start, double t,
                                 double* outputs) const {
    return static_cast<Status>(at_end_(&eps, parameters, start, &t, outputs));
}

EnsembleLibrary::EnsembleLibrary(const Program& program, const std::filesystem::path& cache,
                                 const std::function<void(const std::string&)>& progress)
    : EnsembleLibrary(EvaluatorLibrary::build(program, cache, progress, "e")) {}

EnsembleLibrary::EnsembleLibrary(std::shared_ptr<const EvaluatorLibrary> library)
    : library_(std::move(library)) {
    evaluate_ = reinterpret_cast<decltype(evaluate_)>(library_->object()->symbol(members));
    interval_ends_ =
        reinterpret_cast<decltype(interval_ends_)>(library_->object()->symbol("rf_interval_ends"));
}

void EnsembleLibrary::evaluate(const std::vector<const double*>& arguments, std::size_t n, const double* t,
                               const std::vector<double*>& outputs, unsigned char* status,
                               bool full_phase) const {
    evaluate_(arguments.data(), static_cast<long>(n), t, outputs.data(), status, full_phase ? 1 : 0);
}

void EnsembleLibrary::interval_ends(const std::vector<const double*>& arguments, std::size_t n,
                                    double* t) const {
    interval_ends_(arguments.data(), static_cast<long>(n), t);
}

} // namespace resonform
