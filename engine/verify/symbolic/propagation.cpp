// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/symbolic/propagation.hpp"

#include <algorithm>
#include <cmath>

namespace resonform {

namespace {

using Row = std::vector<long double>;
using Matrix = std::vector<Row>;

constexpr int pieces = 64;
constexpr int most_steps = 64;            // of a piece
constexpr long double longest_step = 0.5; // times |df/dy|
constexpr int series_terms = 6;

// By the largest sum of a row.
long double norm(const Matrix& a) {
    long double most = 0;
    for (const Row& row : a) {
        long double sum = 0;
        for (const long double x : row) sum += std::abs(x);
        if (!(sum <= most)) most = sum;
    }
    return most;
}

Matrix product(const Matrix& a, const Matrix& b) {
    Matrix c(a.size(), Row(b.front().size(), 0));
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < b.size(); ++k)
            for (std::size_t j = 0; j < b[k].size(); ++j) c[i][j] += a[i][k] * b[k][j];
    return c;
}

// e^(h slopes) b, |h slopes| <= `longest_step`
Matrix stepped(const Matrix& slopes, long double h, const Matrix& b) {
    Matrix sum = b, term = b;
    for (int n = 1; n <= series_terms; ++n) {
        term = product(slopes, term);
        for (std::size_t i = 0; i < sum.size(); ++i)
            for (std::size_t j = 0; j < sum[i].size(); ++j) {
                term[i][j] *= h / static_cast<long double>(n);
                sum[i][j] += term[i][j];
            }
    }
    return sum;
}

} // namespace

SymbolicPropagation::SymbolicPropagation(const Flow& flow, const Float128& end) : piece_(end / pieces) {
    const Values start = flow.solution(Float128(0));
    differences_.assign(start.size(), Row(start.size(), 0));
    for (std::size_t k = 0; k < start.size(); ++k)
        differences_[k][k] = std::abs(static_cast<long double>(start[k]));
    scales_.push_back(sums());
    for (int i = 0; i < pieces; ++i) {
        const Float128 left = piece_ * i, middle = left + piece_ / 2;
        const Values terms = flow.terms(middle, flow.solution(middle));
        // The contribution of a piece is added half at its beginning, half at its end.
        for (std::size_t k = 0; k < start.size(); ++k)
            for (std::size_t j = 0; j < start.size(); ++j)
                differences_[k].push_back(j == k ? static_cast<long double>(piece_ * terms[k] / 2) : 0);
        carry_on(flow, left);
        const std::size_t first = differences_.front().size() - start.size();
        for (std::size_t k = 0; k < start.size(); ++k)
            differences_[k][first + k] += static_cast<long double>(piece_ * terms[k] / 2);
        scales_.push_back(sums());
    }
}

std::vector<long double> SymbolicPropagation::operator()(const Float128& T) const {
    const long double at = static_cast<long double>(T / piece_);
    const auto whole = static_cast<std::size_t>(std::clamp(at, 0.0L, static_cast<long double>(pieces - 1)));
    const long double part = std::clamp(at - static_cast<long double>(whole), 0.0L, 1.0L);
    Row result = scales_[whole];
    for (std::size_t k = 0; k < result.size(); ++k) result[k] += part * (scales_[whole + 1][k] - result[k]);
    return result;
}

// Carries the differences through one piece; its first slopes say how many steps that takes. Where it would
// take too many, the differences are left unchanged: their growth would come from the steps, not the flow.
void SymbolicPropagation::carry_on(const Flow& flow, const Float128& left) {
    const auto length = static_cast<long double>(piece_);
    Row sizes = scales_.back();
    Matrix at = slopes(flow, left + piece_ / 2, sizes);
    const long double needed = std::ceil(norm(at) * length / longest_step);
    if (!(needed <= most_steps)) return;
    const int steps = std::max(1, static_cast<int>(needed));
    for (int i = 0; i < steps; ++i) {
        const Float128 middle = left + piece_ * (Float128(i) + Float128(0.5)) / steps;
        if (steps > 1) at = slopes(flow, middle, sizes);
        Matrix next = stepped(at, length / static_cast<long double>(steps), differences_);
        if (!std::isfinite(norm(next))) return;
        differences_ = std::move(next);
    }
}

// df/dy by difference quotients with steps of 2^-50 of the scales of the variables.
SymbolicPropagation::Matrix SymbolicPropagation::slopes(const Flow& flow, const Float128& T,
                                                        const Row& sizes) {
    Values y = flow.solution(T);
    const Values f = flow.rates(T, y);
    Matrix result(y.size(), Row(y.size(), 0));
    for (std::size_t j = 0; j < y.size(); ++j) {
        const Float128 before = y[j];
        const Float128 push = Float128(sizes[j] > 0 ? sizes[j] : 1.0L) * Float128(0x1p-50);
        y[j] = before + push;
        const Values moved = flow.rates(T, y);
        y[j] = before;
        for (std::size_t k = 0; k < y.size(); ++k)
            result[k][j] = static_cast<long double>((moved[k] - f[k]) / push);
    }
    return result;
}

SymbolicPropagation::Row SymbolicPropagation::sums() const {
    Row result;
    for (const Row& row : differences_) {
        long double sum = 0;
        for (const long double x : row) sum += std::abs(x);
        result.push_back(sum);
    }
    return result;
}

} // namespace resonform
