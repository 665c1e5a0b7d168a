// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/ball_matrix.hpp"

#include <acb_mat.h>

namespace resonform {

namespace {

class ArbMatrix {
public:
    ArbMatrix(std::size_t rows, std::size_t columns) {
        acb_mat_init(value_, static_cast<slong>(rows), static_cast<slong>(columns));
    }
    explicit ArbMatrix(const BallMatrix& a) : ArbMatrix(a.size(), a.size()) {
        for (std::size_t j = 0; j < a.size(); ++j)
            for (std::size_t k = 0; k < a.size(); ++k) acb_set(entry(j, k), a[j][k].get());
    }
    ArbMatrix(const ArbMatrix&) = delete;
    ArbMatrix& operator=(const ArbMatrix&) = delete;
    ~ArbMatrix() { acb_mat_clear(value_); }

    [[nodiscard]] acb_mat_struct* get() { return value_; }
    [[nodiscard]] acb_ptr entry(std::size_t row, std::size_t column) {
        return acb_mat_entry_ptr(value_, static_cast<slong>(row), static_cast<slong>(column));
    }
    [[nodiscard]] ComplexBall at(std::size_t row, std::size_t column) {
        ComplexBall result;
        acb_set(result.get(), entry(row, column));
        return result;
    }

private:
    acb_mat_t value_;
};

class ArbVector {
public:
    explicit ArbVector(std::size_t size)
        : size_(static_cast<slong>(size)), values_(_acb_vec_init(static_cast<slong>(size))) {}
    ArbVector(const ArbVector&) = delete;
    ArbVector& operator=(const ArbVector&) = delete;
    ~ArbVector() { _acb_vec_clear(values_, size_); }

    [[nodiscard]] acb_ptr get() { return values_; }

private:
    slong size_;
    acb_ptr values_;
};

} // namespace

std::optional<EigenSystem> simple_eigensystem(const BallMatrix& a, std::int64_t bits) {
    const std::size_t n = a.size();
    ArbMatrix matrix(a), approximate(n, n), left(n, n), right(n, n);
    ArbVector guesses(n), values(n);
    acb_mat_approx_eig_qr(guesses.get(), nullptr, approximate.get(), matrix.get(), nullptr, 0, bits);
    if (acb_mat_eig_simple(values.get(), left.get(), right.get(), matrix.get(), guesses.get(),
                           approximate.get(), bits) == 0)
        return std::nullopt;
    EigenSystem system;
    for (std::size_t k = 0; k < n; ++k) {
        std::vector<ComplexBall> column, row;
        ComplexBall scale, value;
        for (std::size_t s = 0; s < n; ++s) {
            column.push_back(right.at(s, k));
            row.push_back(left.at(k, s));
            scale = plus(scale, times(row.back(), column.back(), bits), bits);
        }
        if (scale.contains_zero()) return std::nullopt;
        for (ComplexBall& entry : row) entry = over(entry, scale, bits);
        acb_set(value.get(), values.get() + k);
        system.values.push_back(std::move(value));
        system.columns.push_back(std::move(column));
        system.rows.push_back(std::move(row));
    }
    return system;
}

std::optional<std::vector<ComplexBall>> solution(const BallMatrix& a, const std::vector<ComplexBall>& b,
                                                 std::int64_t bits) {
    const std::size_t n = a.size();
    ArbMatrix matrix(a), right(n, 1), unknown(n, 1);
    for (std::size_t k = 0; k < n; ++k) acb_set(right.entry(k, 0), b[k].get());
    if (acb_mat_solve(unknown.get(), matrix.get(), right.get(), bits) == 0) return std::nullopt;
    std::vector<ComplexBall> x;
    for (std::size_t k = 0; k < n; ++k) x.push_back(unknown.at(k, 0));
    return x;
}

} // namespace resonform
