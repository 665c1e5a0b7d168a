// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluates polynomials of a ring and their partial derivatives at a point, by one pass over their terms.
// Neighbouring terms agree in most words of their monomials: what these give is kept.
#pragma once

#include "algebra/fractions.hpp"
#include "normalize/certificate_program.hpp"
#include "normalize/certificate_sampler.hpp"

#include <array>
#include <span>
#include <tuple>
#include <vector>

namespace resonform {

// The exponents of monomials that are read one after the other.
class ExponentReader {
public:
    struct Power {
        GeneratorId id;
        int exponent; // not 0
    };

    explicit ExponentReader(const Ring& ring);

    [[nodiscard]] int words() const { return words_; }
    [[nodiscard]] int word_of(GeneratorId id) const { return id / per_word_; }
    // The first word in which m differs from the monomial read before; words() if there is none.
    int read(const Monomial& m);
    [[nodiscard]] std::span<const Power> powers(int word) const {
        const auto w = static_cast<std::size_t>(word);
        return {powers_[w].data(), counts_[w]};
    }
    [[nodiscard]] const std::vector<int>& exponents() const { return exponents_; } // of all generators

private:
    static constexpr std::size_t most_words = std::tuple_size_v<decltype(Monomial::word)>;

    void decode(const Monomial& m, int word);

    const Ring& ring_;
    int per_word_, words_;
    Monomial last_; // all exponents 0 at first
    std::array<std::array<Power, Packing::most_fields / most_words>, most_words> powers_;
    std::array<std::size_t, most_words> counts_{};
    std::vector<int> exponents_;
    bool started_ = false;
};

// At a point and its conjugate. Results are in Montgomery's form. UnluckyPoint is thrown where the prime
// divides a denominator.
class PointReader {
    __extension__ using Signed = __int128;

public:
    // `generators`: their values, residues; all are non-zero.
    PointReader(const Ring& ring, const Montgomery& montgomery, const std::vector<Residue>& generators);

    // The sum of all terms, and its derivatives by some generators.
    class Wanted {
    public:
        Wanted(const Ring& ring, Side side)
            : side_(side), place_(static_cast<std::size_t>(ring.size()), -1) {}
        void add_slope(GeneratorId by);
        [[nodiscard]] Residue value() const { return value_; }
        [[nodiscard]] Residue slope(std::size_t k) const {
            return slope_values_[k];
        } // in the order of add_slope()

    private:
        friend class PointReader;
        Side side_;
        std::vector<GeneratorId> slopes_;
        std::vector<int> place_; // in slopes_, by generator
        Signed sum_ = 0;
        std::vector<Signed> slope_sums_; // times the generator
        Residue value_ = 0;
        std::vector<Residue> slope_values_;
    };
    void read(const Fractions& part, std::vector<Wanted>& wanted);
    // Of each term.
    std::vector<Residue> terms(const Fractions& part);

private:
    struct Half { // one side
        std::vector<Residue> values, inverses;
        std::vector<std::vector<Residue>> powers, negative_powers; // by generator and exponent, from 1 on
        std::array<Residue, 5> products{};                         // of the first words of a monomial
        int fresh = 0;                                             // the first of them that is not up to date
    };

    [[nodiscard]] Residue power(Half& half, const ExponentReader::Power& p) const;
    void multiply_words(Half& half, int from) const;
    [[nodiscard]] Residue inverse_of_denominator(const Fractions& part);
    [[nodiscard]] Residue numerator(const Fractions& part, std::size_t k) const;
    [[nodiscard]] Residue reduced(Signed sum) const;

    const Montgomery& montgomery_;
    ExponentReader exponents_;
    std::array<Half, 2> halves_;
    std::vector<Residue> limb_factors_; // 2^(64 k + 128)
};

} // namespace resonform
