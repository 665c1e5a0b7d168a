// SPDX-License-Identifier: GPL-3.0-or-later
// What one pass over the monomials of a series tells: its shape, and bounds of degree and height.
#pragma once

#include "algebra/series.hpp"
#include "normalize/certificate_reader.hpp"

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
    int first = -1, last = -1;        // weights of the parts that are not empty; -1: there are none
    bool homogeneous = true;          // all monomials of part n have weight n
    std::vector<int> lowest, highest; // by generator, exponents and 0
    Size size;                        // over the common denominator of numbers, and of generators

    [[nodiscard]] bool is_empty() const { return last < 0; }
    // The largest absolute value.
    [[nodiscard]] int exponent(GeneratorId id) const;
};

// Of a generator, as polynomials in what is chosen at random (certificate_bound.hpp).
struct GeneratorSize {
    double degree, denominator; // of the numerator; 1 + t^2 of a sine
    int weight;
};

class Surveyor {
public:
    explicit Surveyor(const Ring& ring);

    // The same series is read once: it must stay as it is.
    const Survey& operator()(const Series& s);
    [[nodiscard]] Size size_of(const Polynomial& p) const { return read(Series({p})).size; }

    [[nodiscard]] const Ring& ring() const { return ring_; }
    [[nodiscard]] const GeneratorSize& generator(GeneratorId id) const {
        return sizes_[static_cast<std::size_t>(id)];
    }
    [[nodiscard]] bool is_circle(GeneratorId id) const; // sin or cos

private:
    // Of the first words of a monomial.
    struct Sums {
        int weight = 0;
        double degree = 0, own = 0; // before denominators are cleared; of those of the generators themselves
    };

    [[nodiscard]] Survey read(const Series& s) const;
    // With one more word.
    [[nodiscard]] Sums add(Sums sums, std::span<const ExponentReader::Power> word, Survey& survey) const;

    const Ring& ring_;
    std::vector<GeneratorSize> sizes_;
    std::map<const Series*, Survey> known_;
};

} // namespace resonform
