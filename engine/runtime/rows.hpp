// SPDX-License-Identifier: MIT
// Outputs as sums of rows, each an amplitude times a wave of k.theta and e^{d.chi} of what decays:
//
//   u = sum of A e^{d.chi} cos(k.theta) and A e^{d.chi} sin(k.theta)
#ifndef RESONFORM_RUNTIME_ROWS
#define RESONFORM_RUNTIME_ROWS

#include "runtime/digits.hpp"

#include <array>
#include <cstddef>

namespace resonform {

namespace kernel {

enum class Wave : unsigned char { one, cosine, sine };

// A row: the output it belongs to and its wave of k.theta; the first index of k that is not 0 is positive,
// and the last of them are d. One that decays and does not turn is a cosine.
template <std::size_t Phases> struct Term {
    unsigned output = 0;
    Wave wave = Wave::one;
    std::array<int, Phases> k{};
};

} // namespace kernel

// The rows of many: each harmonic once. All k and d are at most `Highest`.
template <std::size_t Phases, int Highest, std::size_t Harmonics, std::size_t Rows, std::size_t Outputs>
struct RowList {
    std::array<std::array<int, Phases>, Harmonics> k{}; // ascending
    std::array<unsigned short, Rows> waves{};           // 2 h: the cosine of harmonic h, 2 h + 1: its sine
    std::array<std::size_t, Outputs + 1> first{};       // rows of the outputs, one after the other
    // The products of powers of the first 1, 2 ... phases that harmonics begin with; the last are they.
    struct Made {
        unsigned short from = 0;  // the product for one phase less
        unsigned short power = 0; // k + Highest of the last of its phases
    };
    std::array<std::array<Made, Harmonics>, Phases> made{};
    std::array<std::size_t, Phases> count{};

    // Of the harmonics all k + Highest, and the waves of the rows, two digits each (runtime/digits.hpp).
    constexpr RowList(const std::array<std::size_t, Outputs + 1>& rows, const char* harmonics,
                      const char* text)
        : first(rows) {
        for (auto& harmonic : k)
            for (int& n : harmonic) n = static_cast<int>(read_digits(harmonics, 2)) - Highest;
        for (unsigned short& wave : waves) wave = static_cast<unsigned short>(read_digits(text, 2));
        for (std::size_t h = 0; h < Harmonics; ++h) {
            std::size_t p = 0;
            while (h > 0 && k[h][p] == k[h - 1][p]) ++p;
            for (; p < Phases; ++p)
                made[p][count[p]++] = {static_cast<unsigned short>(p == 0 ? 0 : count[p - 1] - 1),
                                       static_cast<unsigned short>(k[h][p] + Highest)};
        }
    }

    [[nodiscard]] constexpr std::array<kernel::Term<Phases>, Rows> terms() const {
        std::array<kernel::Term<Phases>, Rows> list{};
        unsigned output = 0;
        for (std::size_t r = 0; r < Rows; ++r) {
            while (r == first[output + 1]) ++output;
            list[r].output = output;
            list[r].k = k[waves[r] / 2];
            bool moves = false;
            for (const int n : list[r].k) moves = moves || n != 0;
            if (moves) list[r].wave = waves[r] % 2 == 0 ? kernel::Wave::cosine : kernel::Wave::sine;
        }
        return list;
    }
};

// cos theta and sin theta of an angle, or e^chi and 0.
template <class Number> struct Turn { Number cosine, sine; };
template <class Number> Turn<Number> operator*(const Turn<Number>& x, const Turn<Number>& y) {
    return {x.cosine * y.cosine - x.sine * y.sine, x.cosine * y.sine + x.sine * y.cosine};
}

// Cosines and sines of the harmonics at one point, where RowList::waves says.
template <class Number, std::size_t Phases, int Highest, std::size_t Harmonics, std::size_t Rows,
          std::size_t Outputs>
std::array<Number, 2 * Harmonics> waves_of(const RowList<Phases, Highest, Harmonics, Rows, Outputs>& rows,
                                           const std::array<Turn<Number>, Phases>& turns) {
    constexpr std::size_t middle = Highest;
    std::array<Turn<Number>, 2 * middle + 1> powers;
    std::array<Turn<Number>, Harmonics> before, products;
    before[0] = powers[middle] = {Number(1), Number(0)};
    for (std::size_t p = 0; p < Phases; ++p) {
        for (std::size_t n = 1; n <= middle; ++n) { // by halves: few steps, small errors
            powers[middle + n] = n == 1 ? turns[p] : powers[middle + n / 2] * powers[middle + n - n / 2];
            powers[middle - n] = {powers[middle + n].cosine, -powers[middle + n].sine};
        }
        for (std::size_t n = 0; n < rows.count[p]; ++n)
            products[n] = before[rows.made[p][n].from] * powers[rows.made[p][n].power];
        before = products;
    }
    std::array<Number, 2 * Harmonics> waves;
    for (std::size_t h = 0; h < Harmonics; ++h) {
        waves[2 * h] = products[h].cosine;
        waves[2 * h + 1] = products[h].sine;
    }
    return waves;
}

// The outputs at one point.
template <class Number, std::size_t Phases, int Highest, std::size_t Harmonics, std::size_t Rows,
          std::size_t Outputs>
std::array<Number, Outputs> sum_rows(const RowList<Phases, Highest, Harmonics, Rows, Outputs>& rows,
                                     const std::array<Number, Rows>& amplitudes,
                                     const std::array<Turn<Number>, Phases>& turns) {
    const auto waves = waves_of(rows, turns);
    std::array<Number, Outputs> sums;
    for (std::size_t output = 0; output < Outputs; ++output) {
        Number a(0), b(0), c(0), d(0); // sums that need not wait for each other
        std::size_t r = rows.first[output];
        const std::size_t end = rows.first[output + 1];
        for (; r + 4 <= end; r += 4) {
            a = a + amplitudes[r] * waves[rows.waves[r]];
            b = b + amplitudes[r + 1] * waves[rows.waves[r + 1]];
            c = c + amplitudes[r + 2] * waves[rows.waves[r + 2]];
            d = d + amplitudes[r + 3] * waves[rows.waves[r + 3]];
        }
        for (; r < end; ++r) a = a + amplitudes[r] * waves[rows.waves[r]];
        sums[output] = (a + b) + (c + d);
    }
    return sums;
}

} // namespace resonform

#endif
