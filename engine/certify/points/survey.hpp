// SPDX-License-Identifier: GPL-3.0-or-later
// The shape of a series, and bounds of degree and height, from one pass over its monomials.
#pragma once

#include "algebra/series/series.hpp"
#include "certify/points/reader.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace resonform {

// A t-series s: with one polynomial Q of degree <= denominator, all Q s_n are polynomials of degree
// <= degree, and the sum of the sizes of the integer coefficients of each Q s_n, and of Q, is <= 2^bits.
struct Size {
    double degree = 0, denominator = 0, bits = 0;
};

struct Survey {
    struct Range {
        int lowest = 0, highest = 0;
    };
    int first = -1, last = -1;    // weights of the parts that are not empty; -1: there are none
    bool homogeneous = true;      // all monomials of part n have weight n
    std::vector<Range> exponents; // by generator, with 0
    Size size;                    // over the common denominator of numbers, and of generators

    [[nodiscard]] bool is_empty() const { return last < 0; }
    // The largest absolute value.
    [[nodiscard]] int exponent(GeneratorId id) const;
};

// The size of a generator as a quotient of polynomials in the quantities drawn at random (bound.hpp).
struct GeneratorSize {
    double degree, denominator; // of the numerator; 1 + t^2 of a sine
    double radicand_bits;       // of a root, over its index
};

class Surveyor {
public:
    explicit Surveyor(const Ring& ring);

    // The survey of a series is found again by its address: the series must stay as it is.
    const Survey& operator()(const Series& s);
    [[nodiscard]] Size size_of(const Polynomial& p) { return read(Series({p})).size; }

    [[nodiscard]] const Ring& ring() const { return ring_; }
    [[nodiscard]] const GeneratorSize& generator(GeneratorId id) const {
        return sizes_[static_cast<std::size_t>(id)];
    }
    [[nodiscard]] bool is_circle(GeneratorId id) const; // sin or cos

private:
    // Of the first words of a monomial.
    struct Sums {
        int weight = 0;
        std::int64_t degree = 0; // before denominators are cleared
        std::int64_t own = 0;    // of the denominators of the generators themselves
    };
    struct Tally {
        std::int64_t degree, denominator; // at most largest_degree
        int weight;
        Survey::Range range = {}; // in the series that is read
    };
    static constexpr double largest_degree = 1e12; // a bound with it is refused

    [[nodiscard]] Survey read(const Series& s);
    // With one more word.
    [[nodiscard]] Sums add(Sums sums, std::span<const ExponentReader::Power> word);

    const Ring& ring_;
    std::vector<GeneratorSize> sizes_;
    std::vector<Tally> tallies_;
    ExponentReader exponents_;
    std::array<Sums, 5> sums_{}; // of the first words of the monomial that is read
    std::map<const Series*, Survey> known_;
};

} // namespace resonform
