// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/integrate/dense_lu.hpp"

#include <algorithm>
#include <cmath>

namespace resonform {

bool DenseLu::factor(const std::vector<double>& matrix) {
    size_ = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(matrix.size()))));
    if (!scale_rows(matrix)) return false;
    columns_.resize(size_);
    pivots_.resize(size_);
    for (std::size_t j = 0; j < size_; ++j) columns_[j] = lu_.data() + j * size_;
    const auto n = static_cast<sunindextype>(size_);
    return SUNDlsMat_denseGETRF(columns_.data(), n, n, pivots_.data()) == 0;
}

bool DenseLu::scale_rows(const std::vector<double>& matrix) {
    lu_.resize(matrix.size());
    row_factors_.resize(size_);
    for (std::size_t i = 0; i < size_; ++i) {
        const double* row = matrix.data() + i * size_;
        double largest = 0, sum = 0;
        for (std::size_t j = 0; j < size_; ++j) {
            largest = std::max(largest, std::abs(row[j]));
            sum += row[j];
        }
        if (largest == 0 || !std::isfinite(sum)) return false;
        row_factors_[i] = 1 / largest;
        for (std::size_t j = 0; j < size_; ++j) lu_[j * size_ + i] = row[j] * row_factors_[i];
    }
    return true;
}

void DenseLu::solve(std::vector<double>& b) {
    for (std::size_t i = 0; i < size_; ++i) b[i] *= row_factors_[i];
    SUNDlsMat_denseGETRS(columns_.data(), static_cast<sunindextype>(size_), pivots_.data(), b.data());
}

} // namespace resonform
