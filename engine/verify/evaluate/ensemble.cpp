// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/evaluate/ensemble.hpp"

namespace resonform {

EnsembleLibrary::EnsembleLibrary(const Program& program, const std::filesystem::path& cache,
                                 const std::function<void(const std::string&)>& progress)
    : library_(EvaluatorLibrary::build(program, cache, progress, "e")) {
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
