// SPDX-License-Identifier: MIT
// Chebyshev polynomials by powers.
#ifndef RESONFORM_RUNTIME_KERNEL_CHEBYSHEV_POWERS
#define RESONFORM_RUNTIME_KERNEL_CHEBYSHEV_POWERS

#include <cstddef>

namespace resonform::kernel {

// T_k(x) = sum_j at[k][j] x^j, k <= Most; whole numbers, all exact up to Most = 32.
template <std::size_t Most> struct ChebyshevPowers {
    double at[Most + 1][Most + 1] = {};
    constexpr ChebyshevPowers() {
        at[0][0] = at[1][1] = 1;
        for (std::size_t k = 2; k <= Most; ++k)
            for (std::size_t j = 0; j <= k; ++j) at[k][j] = (j > 0 ? 2 * at[k - 1][j - 1] : 0) - at[k - 2][j];
    }
};

} // namespace resonform::kernel

#endif
