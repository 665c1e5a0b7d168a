// SPDX-License-Identifier: MIT
// Chebyshev series of 32 terms, their halves and their powers. Series are handled side by side, as numbers of
// any type with + - * (Side: eight doubles).
#ifndef RESONFORM_RUNTIME_KERNEL_CHEBYSHEV
#define RESONFORM_RUNTIME_KERNEL_CHEBYSHEV

#include "runtime/kernel/chebyshev_powers.hpp"
#include "runtime/math.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace resonform::kernel {

inline constexpr std::size_t nodes = 32;

// x rounded to 26 bits: its products with numbers of as many are exact.
inline double upper_half(double x) {
    int exponent = 0;
    const double part = std::frexp(x, &exponent);
    return std::ldexp(std::round(std::ldexp(part, 26)), exponent - 26);
}

struct Side { // eight series
    double at[8];
    friend Side operator+(Side a, const Side& b) {
        for (int i = 0; i < 8; ++i) a.at[i] += b.at[i];
        return a;
    }
    friend Side operator-(Side a, const Side& b) {
        for (int i = 0; i < 8; ++i) a.at[i] -= b.at[i];
        return a;
    }
    friend Side operator*(Side a, double x) {
        for (int i = 0; i < 8; ++i) a.at[i] *= x;
        return a;
    }
};
// sum += x factor
inline void add_product(Side& sum, const Side& x, double factor) {
    for (int i = 0; i < 8; ++i) sum.at[i] += x.at[i] * factor;
}
template <class Number, class Factor> void add_product(Number& sum, const Number& x, const Factor& factor) {
    sum = sum + x * Number(factor);
}

// cos(k pi/64), k = 0 ... 32
template <class Number> const std::array<Number, nodes + 1>& quadrant() {
    static const std::array<Number, nodes + 1> values = [] {
        using math::cos;
        std::array<Number, nodes + 1> result;
        for (std::size_t k = 0; k <= nodes; ++k)
            result[k] = Number(cos(math::pi<Number>() * Number(static_cast<int>(k)) / Number(64)));
        return result;
    }();
    return values;
}

// cos((2j + 1) pi/64), descending
template <class Number> Number node(std::size_t j) {
    const auto& c = quadrant<Number>();
    return j < nodes / 2 ? c[2 * j + 1] : Number(-c[2 * (nodes - 1 - j) + 1]);
}

// cos(k (2j + 1) pi/64) for j < 16
template <class Number> const std::array<std::array<Number, nodes / 2>, nodes>& cosines() {
    static const std::array<std::array<Number, nodes / 2>, nodes> values = [] {
        std::array<std::array<Number, nodes / 2>, nodes> result;
        const auto& c = quadrant<Number>();
        for (std::size_t k = 0; k < nodes; ++k)
            for (std::size_t j = 0; j < nodes / 2; ++j) {
                std::size_t m = k * (2 * j + 1) % 128;
                if (m > 64) m = 128 - m;
                result[k][j] = m > 32 ? Number(-c[64 - m]) : c[m];
            }
        return result;
    }();
    return values;
}

// sum_k result[k] T_k(x) through values[j] at node(j). Factor: the type of cosines.
template <class Factor, class Number>
std::array<Number, nodes> interpolated(const std::array<Number, nodes>& values) {
    const auto& c = cosines<Factor>();
    std::array<Number, nodes / 2> even, odd;
    for (std::size_t j = 0; j < nodes / 2; ++j) {
        even[j] = values[j] + values[nodes - 1 - j];
        odd[j] = values[j] - values[nodes - 1 - j];
    }
    std::array<Number, nodes> result;
    for (std::size_t k = 0; k < nodes; ++k) {
        const auto& half = k % 2 == 0 ? even : odd;
        Number sum{};
        for (std::size_t j = 0; j < nodes / 2; ++j) add_product(sum, half[j], c[k][j]);
        result[k] = sum * Factor(k == 0 ? 1.0 / 32 : 1.0 / 16);
    }
    return result;
}

// T_j((x + 1)/2) = sum_i at[i][j] T_i(x); the numbers are exact up to j = 26.
struct RightHalf {
    double at[nodes + 1][nodes + 1] = {};
    RightHalf() {
        at[0][0] = 1;
        at[0][1] = at[1][1] = 0.5;
        for (std::size_t j = 1; j < nodes; ++j)
            for (std::size_t i = 0; i <= j + 1; ++i) { // T_{j+1}(y) = 2y T_j(y) - T_{j-1}(y), 2y = x + 1
                const double below = i == 0 ? 0 : at[i - 1][j] * (i == 1 ? 2 : 1);
                const double above = i < nodes ? at[i + 1][j] : 0;
                at[i][j + 1] = (below + above) / 2 + at[i][j] - at[i][j - 1];
            }
    }
};
inline const RightHalf& right_half() {
    static const RightHalf half;
    return half;
}

// The series c of `size` terms on the halves of its interval.
template <class Number> void halve(const Number* c, std::size_t size, Number* left, Number* right) {
    const RightHalf& half = right_half();
    for (std::size_t i = 0; i < size; ++i) {
        Number same{}, other{}; // parity of j - i
        for (std::size_t j = size; j-- > i;)
            add_product((j - i) % 2 == 0 ? same : other, c[j], half.at[i][j]);
        right[i] = same + other;
        left[i] = same - other;
    }
}

inline constexpr ChebyshevPowers<nodes> powers_of_chebyshev{};

// The same by powers, in place.
template <class Number> void to_powers(Number* c, std::size_t size) {
    for (std::size_t j = 0; j < size; ++j) {
        Number sum{}; // small terms first
        const std::size_t last = size - 1 - (size - 1 - j) % 2;
        for (std::size_t k = last;; k -= 2) {
            add_product(sum, c[k], powers_of_chebyshev.at[k][j]);
            if (k == j) break;
        }
        c[j] = sum;
    }
}

} // namespace resonform::kernel

#endif
