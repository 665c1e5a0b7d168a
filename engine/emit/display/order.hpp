// SPDX-License-Identifier: GPL-3.0-or-later
// The order of terms in a printed polynomial.
#pragma once

#include <numeric>
#include <vector>

namespace resonform {

// Falling total degree, then falling powers of the first symbols: r^2 + r*xi + xi^2 + r + 1.
inline bool before_in_polynomial(const std::vector<int>& a, const std::vector<int>& b) {
    const int degree_a = std::accumulate(a.begin(), a.end(), 0);
    const int degree_b = std::accumulate(b.begin(), b.end(), 0);
    return degree_a != degree_b ? degree_a > degree_b : a > b;
}

} // namespace resonform
