// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluates polynomials of a ring and their partial derivatives at a point, by one pass over their terms.
// Neighbouring terms agree in most words of their monomials: the products of these words are kept.
#pragma once

#include "algebra/ring/fractions.hpp"
#include "certify/points/program.hpp"
#include "certify/points/sampler.hpp"

#include <array>
#include <span>
#include <tuple>
#include <utility>
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
    // Through the last word of these generators: the exponents of later ones count as 0.
    ExponentReader(const Ring& ring, const std::vector<GeneratorId>& through);

    [[nodiscard]] int words() const { return words_; }
    [[nodiscard]] int word_of(GeneratorId id) const { return id / per_word_; }
    [[nodiscard]] GeneratorId first_of(int word) const { return word * per_word_; }
    // All words of the next monomial count as new.
    void forget() { started_ = false; }
    // The first word in which m differs from the monomial read before; words() if there is none.
    int read(const Monomial& m);
    [[nodiscard]] std::span<const Power> powers(int word) const {
        const auto w = static_cast<std::size_t>(word);
        return {powers_[w].data(), counts_[w]};
    }
    // By generator; entries past the last generator are 0.
    [[nodiscard]] const std::vector<int>& exponents() const { return exponents_; }

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

// Evaluates at some points and their conjugates. Results are in Montgomery's form. UnluckyPoint is thrown
// where a prime divides a denominator.
class PointReader {
    __extension__ using Signed = __int128;

public:
    static constexpr std::size_t most_points = 4;
    // `points`: 1 ... most_points of them. A generator that is zero at a point occurs in no denominator;
    // slopes by it read 0.
    PointReader(const Ring& ring, std::span<const Point> points);

    // The sum of all terms, and its derivatives by some generators, at each point.
    class Wanted {
    public:
        Wanted(Side side, const std::vector<GeneratorId>& slopes);
        [[nodiscard]] Residue value(std::size_t point) const { return value_[point]; }
        [[nodiscard]] Residue slope(std::size_t k, std::size_t point) const {
            return slopes_[k].value[point];
        }

    private:
        friend class PointReader;
        using Sums = std::array<Signed, most_points>;
        using Values = std::array<Residue, most_points>;
        struct Slope {
            GeneratorId by;
            Sums sum{}; // times the generator
            Values value{};
        };
        Side side_;
        std::vector<Slope> slopes_;
        std::array<int, Packing::most_fields> place_; // in slopes_, by generator; -1
        Sums sum_{};
        Values value_{};
    };
    void read(const Fractions& part, std::vector<Wanted>& wanted);
    // Of each term, at the first point.
    std::vector<Residue> terms(const Fractions& part);

private:
    static constexpr std::size_t span = 128; // exponents whose powers are kept
    struct Half {                            // one side
        std::vector<Residue> values, inverses;
        std::vector<Residue> powers; // by generator and exponent, -span/2 ...; 0: not known yet
        Residue head = 0;            // of the monomial that is read
    };
    struct AtPoint {
        Montgomery montgomery;
        std::array<Half, 2> halves;
        Residue one = 0;
        std::vector<Residue> limb_factors;                 // 2^(64 k + 64)
        std::vector<std::pair<Residue, Residue>> inverses; // of denominators, ascending: the same ones recur
        std::array<Residue, 5> tails{};                    // of the first words after the head, times 2^64
        Residue cofactor = 0, number = 0;                  // of the part, of the current term
    };

    // With the number of generators in the head.
    [[nodiscard]] static AtPoint prepared(const Ring& ring, const Point& point, std::size_t head);
    [[nodiscard]] static Residue power(const AtPoint& at, Half& half, const ExponentReader::Power& p);
    [[nodiscard]] static Residue far_power(const AtPoint& at, const Half& half,
                                           const ExponentReader::Power& p);
    [[nodiscard]] Residue multiplied(const AtPoint& at, Half& half, Residue product, int word) const;
    void read_head(Side side);
    void read_tail(AtPoint& at, int from) const;
    static void read_denominator(AtPoint& at, const Fractions& part);
    static void read_number(AtPoint& at, const Fractions& part, std::size_t k, Residue tail);
    [[nodiscard]] static Residue reduced(const AtPoint& at, Signed sum);
    void read_term(const Fractions& part, std::size_t k);
    void add_term(Wanted& wanted);
    void finish(Wanted& wanted) const;

    ExponentReader exponents_;
    std::vector<AtPoint> points_;
    // The words of generators that are not their own conjugates are the head of a monomial: the tail is the
    // same on both sides.
    int head_;
    std::array<bool, 2> has_head_{}; // by side: it is up to date
};

} // namespace resonform
