// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/sweep/values.hpp"

#include "verify/evaluate/evaluator.hpp"
#include "verify/evaluate/interpretation.hpp"
#include "verify/sweep/arguments.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace resonform {

SweepValues::SweepValues(std::shared_ptr<const Program> program, const Scene& scene, const SweepGrid& grid,
                         std::vector<double> times, const std::filesystem::path& cache,
                         const std::function<void(const std::string&)>& progress)
    : program_(std::move(program)), grid_(grid), times_(std::move(times)),
      place_(places_of_axes(grid, *program_, scene)), library_(*program_, cache, progress) {}

void SweepValues::operator()(std::uint64_t first, std::uint64_t count, double* numbers,
                             unsigned char* status) const {
    const std::size_t rows = times_.empty() ? 1 : times_.size(), members = count * rows;
    const std::size_t outputs = program_->outputs.size(), columns = 1 + outputs;
    std::vector<std::vector<double>> given(place_.size(), std::vector<double>(members));
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::vector<double> point = grid_.point(first + i);
        for (std::size_t a = 0; a < place_.size(); ++a)
            std::fill_n(given[a].begin() + static_cast<std::ptrdiff_t>(i * rows), rows, point[a]);
    }
    std::vector<const double*> arguments(1 + program_->parameters.size() + program_->start.size(), nullptr);
    for (std::size_t a = 0; a < place_.size(); ++a) arguments[place_[a]] = given[a].data();

    std::vector<double> t(members);
    if (times_.empty())
        library_.interval_ends(arguments, members, t.data());
    else
        for (std::size_t i = 0; i < members; ++i) t[i] = times_[i % rows];
    std::vector<std::vector<double>> values(outputs, std::vector<double>(members));
    library_.evaluate(arguments, members, t.data(), arrays_of(values), status);
    for (std::size_t i = 0; i < members; ++i) {
        numbers[i * columns] = t[i];
        for (std::size_t k = 0; k < outputs; ++k)
            numbers[i * columns + 1 + k] = has_numbers(static_cast<Status>(status[i]))
                                               ? values[k][i]
                                               : std::numeric_limits<double>::quiet_NaN();
    }
}

} // namespace resonform
