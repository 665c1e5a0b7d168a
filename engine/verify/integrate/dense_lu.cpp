// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/integrate/dense_lu.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace resonform {

bool DenseLu::factor(std::vector<double> matrix) {
    lu_ = std::move(matrix);
    size_ = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(lu_.size()))));
    rows_.resize(size_);
    std::iota(rows_.begin(), rows_.end(), std::size_t{0});
    if (!scale_rows()) return false;
    for (std::size_t k = 0; k < size_; ++k) {
        if (!pivot(k)) return false;
        const double* top = lu_.data() + k * size_;
        for (std::size_t i = k + 1; i < size_; ++i) {
            double* row = lu_.data() + i * size_;
            if (row[k] == 0) continue;
            const double factor = row[k] /= top[k];
            for (std::size_t j = k + 1; j < size_; ++j) row[j] -= factor * top[j];
        }
    }
    return true;
}

bool DenseLu::scale_rows() {
    row_factors_.assign(size_, 0.0);
    for (std::size_t i = 0; i < size_; ++i) {
        double* row = lu_.data() + i * size_;
        double largest = 0, sum = 0;
        for (std::size_t j = 0; j < size_; ++j) {
            largest = std::max(largest, std::abs(row[j]));
            sum += row[j];
        }
        if (largest == 0 || !std::isfinite(sum)) return false;
        row_factors_[i] = 1 / largest;
        for (std::size_t j = 0; j < size_; ++j) row[j] *= row_factors_[i];
    }
    return true;
}

bool DenseLu::pivot(std::size_t k) {
    std::size_t best = k;
    for (std::size_t i = k + 1; i < size_; ++i)
        if (std::abs(lu_[i * size_ + k]) > std::abs(lu_[best * size_ + k])) best = i;
    const auto row = [this](std::size_t i) { return lu_.begin() + static_cast<std::ptrdiff_t>(i * size_); };
    if (best != k) {
        std::swap_ranges(row(k), row(k + 1), row(best));
        std::swap(rows_[k], rows_[best]);
    }
    return lu_[k * size_ + k] != 0;
}

void DenseLu::solve(std::vector<double>& b) const {
    std::vector<double> x(size_);
    for (std::size_t i = 0; i < size_; ++i) {
        const double* row = lu_.data() + i * size_;
        x[i] = b[rows_[i]] * row_factors_[rows_[i]];
        for (std::size_t j = 0; j < i; ++j) x[i] -= row[j] * x[j];
    }
    for (std::size_t i = size_; i-- > 0;) {
        const double* row = lu_.data() + i * size_;
        for (std::size_t j = i + 1; j < size_; ++j) x[i] -= row[j] * x[j];
        x[i] /= row[i];
    }
    b = std::move(x);
}

} // namespace resonform
