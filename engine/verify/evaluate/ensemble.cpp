// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/evaluate/ensemble.hpp"

#include <utility>

namespace resonform {

FinalPointLibrary::FinalPointLibrary(std::shared_ptr<const EvaluatorLibrary> library)
    : library_(std::move(library)),
      at_end_(reinterpret_cast<decltype(at_end_)>(library_->object()->symbol("rf_at_end"))) {}

Status FinalPointLibrary::at_end(double eps, const double* parameters, const double* start, double t,
                                 double* outputs) const {
    return static_cast<Status>(at_end_(&eps, parameters, start, &t, outputs));
}

EnsembleLibrary::EnsembleLibrary(const Program& program, const std::filesystem::path& cache,
                                 const std::function<void(const std::string&)>& progress)
    : EnsembleLibrary(EvaluatorLibrary::build(program, cache, progress, "e")) {}

EnsembleLibrary::EnsembleLibrary(std::shared_ptr<const EvaluatorLibrary> library)
    : library_(std::move(library)) {
    evaluate_ = reinterpret_cast<decltype(evaluate_)>(library_->object()->symbol("rf_ensemble"));
    interval_ends_ =
        reinterpret_cast<decltype(interval_ends_)>(library_->object()->symbol("rf_interval_ends"));
}

void EnsembleLibrary::evaluate(const std::vector<const double*>& arguments, std::size_t n, const double* t,
                               const std::vector<double*>& outputs, unsigned char* status) const {
    evaluate_(arguments.data(), static_cast<long>(n), t, outputs.data(), status);
}

void EnsembleLibrary::interval_ends(const std::vector<const double*>& arguments, std::size_t n,
                                    double* t) const {
    interval_ends_(arguments.data(), static_cast<long>(n), t);
}

} // namespace resonform
