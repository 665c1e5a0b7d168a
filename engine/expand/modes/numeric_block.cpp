// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/modes/numeric_block.hpp"

#include <algorithm>

namespace resonform {

namespace {

constexpr int digits_to_sort_by = 20;

NumberMatrix multiply(const Ring& ring, const NumberMatrix& a, const NumberMatrix& b) {
    NumberMatrix result(a.size(), std::vector<Polynomial>(a.size()));
    for (std::size_t j = 0; j < a.size(); ++j)
        for (std::size_t k = 0; k < a.size(); ++k) {
            std::vector<std::pair<const Polynomial*, const Polynomial*>> pairs;
            for (std::size_t m = 0; m < a.size(); ++m) pairs.emplace_back(&a[j][m], &b[m][k]);
            result[j][k] = ring.dot(pairs);
        }
    return result;
}

// c with det(lambda - A) = lambda^n + sum_j c_j lambda^j, by Faddeev and LeVerrier:
// M_1 = 1, c_{n-k} = -tr(A M_k)/k, M_{k+1} = A M_k + c_{n-k}.
std::vector<Polynomial> characteristic_polynomial(const Ring& ring, const NumberMatrix& a) {
    const std::size_t n = a.size();
    std::vector<Polynomial> c(n);
    NumberMatrix m(n, std::vector<Polynomial>(n));
    for (std::size_t k = 0; k < n; ++k) m[k][k] = ring.one();
    for (std::size_t k = 1; k <= n; ++k) {
        m = multiply(ring, a, m);
        Polynomial trace;
        for (std::size_t j = 0; j < n; ++j) trace = trace + m[j][j];
        c[n - k] = (Rational(-1) / Rational(static_cast<unsigned long>(k))) * trace;
        for (std::size_t j = 0; j < n; ++j) m[j][j] = m[j][j] + c[n - k];
    }
    return c;
}

// The number of values whose balls overlap this one.
std::ptrdiff_t overlaps(const std::vector<ComplexBall>& values, const ComplexBall& value) {
    return std::count_if(values.begin(), values.end(),
                         [&](const ComplexBall& v) { return v.overlaps(value); });
}

// Makes an eigenvector real that is complex only by a factor and by rounding.
void make_real(std::vector<ComplexBall>& vector, const ComplexBall& scale, std::int64_t bits) {
    for (ComplexBall& c : vector) c = ComplexBall(over(c, scale, bits).re(), RealBall());
}

bool comes_before(const NumericMode& a, const NumericMode& b) {
    const auto key = [](const NumericMode& m) {
        return std::pair(rounded(m.eigenvalue.im(), digits_to_sort_by),
                         rounded(m.eigenvalue.re(), digits_to_sort_by));
    };
    const auto [im_a, re_a] = key(a);
    const auto [im_b, re_b] = key(b);
    return im_a == im_b ? re_a < re_b : im_a < im_b;
}

} // namespace

NumericBlock::NumericBlock(const Ring& ring, NumberMatrix a, std::vector<ClosedMode> closed)
    : a_(std::move(a)), closed_(std::move(closed)), characteristic_(characteristic_polynomial(ring, a_)) {
    for (std::size_t k = 0; k < characteristic_.size(); ++k)
        if ((characteristic_.size() - k) % 2 == 1 && !characteristic_[k].empty()) even_ = false;
    singular_ = characteristic_.front().empty();
}

std::vector<NumericMode> NumericBlock::evaluated(const NumberDomain& numbers) const {
    const auto vector = [&](const std::vector<Polynomial>& entries) {
        std::vector<ComplexBall> result;
        for (const Polynomial& p : entries) result.push_back(numbers.value(p));
        return result;
    };
    std::vector<NumericMode> result;
    for (const ClosedMode& mode : closed_)
        result.push_back({numbers.value(mode.eigenvalue), vector(mode.column), vector(mode.row)});
    return result;
}

std::optional<std::vector<NumericMode>> NumericBlock::modes(const NumberDomain& numbers) const {
    if (is_closed()) return evaluated(numbers);
    BallMatrix matrix;
    for (const auto& row : a_) {
        matrix.emplace_back();
        for (const Polynomial& p : row) matrix.back().push_back(numbers.value(p));
    }
    auto system = simple_eigensystem(matrix, numbers.bits());
    if (!system) return std::nullopt;
    std::vector<NumericMode> result;
    for (std::size_t k = 0; k < system->values.size(); ++k) {
        NumericMode mode{system->values[k], std::move(system->columns[k]), std::move(system->rows[k])};
        const ComplexBall conjugate = mode.eigenvalue.conjugate();
        if (overlaps(system->values, conjugate) != 1) return std::nullopt;
        if (mode.eigenvalue.overlaps(conjugate)) {
            mode.eigenvalue = ComplexBall(mode.eigenvalue.re(), RealBall());
            if (singular_ && mode.eigenvalue.contains_zero()) {
                if (overlaps(system->values, ComplexBall()) != 1) return std::nullopt;
                mode.eigenvalue = ComplexBall();
            }
            const auto entry = std::find_if(mode.column.begin(), mode.column.end(),
                                            [](const ComplexBall& c) { return !c.contains_zero(); });
            if (entry == mode.column.end()) return std::nullopt;
            const ComplexBall scale = *entry;
            make_real(mode.column, scale, numbers.bits());
            make_real(mode.row, over(ComplexBall(1), scale, numbers.bits()), numbers.bits());
        } else {
            if (!mode.eigenvalue.im().is_positive()) {
                if (!mode.eigenvalue.im().negative().is_positive()) return std::nullopt;
                continue; // the second of a pair
            }
            const ComplexBall mirrored = conjugate.negative();
            if (even_ && mode.eigenvalue.overlaps(mirrored)) {
                if (overlaps(system->values, mirrored) != 1) return std::nullopt;
                mode.eigenvalue = ComplexBall(RealBall(), mode.eigenvalue.im());
            }
        }
        result.push_back(std::move(mode));
    }
    std::sort(result.begin(), result.end(), comes_before);
    return result;
}

} // namespace resonform
