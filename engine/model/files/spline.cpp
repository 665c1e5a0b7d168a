// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/spline.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <cstddef>

namespace resonform {

namespace {

using Number = boost::multiprecision::cpp_bin_float_50;
using Numbers = std::vector<Number>;

Numbers knots_of(const std::vector<double>& x, std::size_t d) {
    Numbers knots(d + 1, Number(x.front()));
    for (std::size_t k = (d + 1) / 2; k + (d + 1) / 2 < x.size(); ++k) knots.emplace_back(x[k]);
    knots.resize(knots.size() + d + 1, Number(x.back()));
    return knots;
}

// The last knot at or before x that begins an interval.
std::size_t interval_of(const Numbers& knots, std::size_t d, const Number& x) {
    std::size_t k = d;
    while (k + 1 < knots.size() - d - 1 && !(x < knots[k + 1])) ++k;
    return k;
}

// B_{k-d}(x) ... B_k(x) in the interval of knot k (Cox and de Boor).
Numbers basis(const Numbers& knots, std::size_t d, std::size_t k, const Number& x) {
    Numbers b{Number(1)};
    for (std::size_t degree = 1; degree <= d; ++degree) {
        Numbers next(degree + 1, Number(0));
        for (std::size_t j = 0; j < degree; ++j) {
            const Number &right = knots[k + 1 + j], &left = knots[k + 1 + j - degree];
            const Number share = b[j] / (right - left);
            next[j] += (right - x) * share;
            next[j + 1] += (x - left) * share;
        }
        b = std::move(next);
    }
    return b;
}

// The coefficients of the B-splines. Their matrix is totally positive: elimination needs no pivots.
Numbers collocated(const Numbers& knots, std::size_t d, const std::vector<double>& x,
                   const std::vector<double>& y) {
    const std::size_t n = x.size();
    std::vector<Numbers> rows(n, Numbers(2 * d + 1, Number(0))); // [i][j - i + d]
    Numbers c(y.begin(), y.end());
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t k = interval_of(knots, d, Number(x[i]));
        const Numbers b = basis(knots, d, k, Number(x[i]));
        for (std::size_t j = 0; j <= d; ++j)
            if (const std::size_t at = k + j - i; at < 2 * d + 1) rows[i][at] = b[j];
    }
    for (std::size_t p = 0; p < n; ++p)
        for (std::size_t i = p + 1; i < std::min(n, p + d + 1); ++i) {
            const Number factor = rows[i][p + d - i] / rows[p][d];
            for (std::size_t j = p; j < std::min(n, p + d + 1); ++j)
                rows[i][j + d - i] -= factor * rows[p][j + d - p];
            c[i] -= factor * c[p];
        }
    for (std::size_t p = n; p-- > 0;) {
        for (std::size_t j = p + 1; j < std::min(n, p + d + 1); ++j) c[p] -= rows[p][j + d - p] * c[j];
        c[p] /= rows[p][d];
    }
    return c;
}

// sum_i c_i B_i(x) within the interval of knot k (de Boor's algorithm); knots and c are those of degree d.
Number value_at(const Numbers& knots, const Numbers& c, std::size_t d, std::size_t k, const Number& x) {
    const Numbers b = basis(knots, d, k, x);
    Number sum = 0;
    for (std::size_t j = 0; j <= d; ++j) sum += b[j] * c[k - d + j];
    return sum;
}

} // namespace

PiecewisePolynomial spline_through(const std::vector<double>& x, const std::vector<double>& y, int degree) {
    const auto d = static_cast<std::size_t>(degree);
    const Numbers knots = knots_of(x, d);
    std::vector<Numbers> slopes{collocated(knots, d, x, y)}; // of the derivatives, over the same knots
    for (std::size_t order = 1; order <= d; ++order) {
        const Numbers& c = slopes.back();
        const std::size_t of = d + 1 - order; // the degree that is differentiated
        Numbers next(c.size(), Number(0));
        for (std::size_t i = order; i < c.size(); ++i)
            next[i] = Number(of) * (c[i] - c[i - 1]) / (knots[i + of] - knots[i]);
        slopes.push_back(std::move(next));
    }
    PiecewisePolynomial result;
    result.degree = degree;
    for (std::size_t k = d; k + d + 1 < knots.size(); ++k) {
        result.breakpoints.push_back(static_cast<double>(knots[k]));
        Number factorial = 1;
        for (std::size_t order = 0; order <= d; ++order) {
            if (order > 0) factorial *= Number(order);
            result.coefficients.push_back(static_cast<double>(
                Number(value_at(knots, slopes[order], d - order, k, knots[k]) / factorial)));
        }
    }
    result.breakpoints.push_back(x.back());
    return result;
}

} // namespace resonform
