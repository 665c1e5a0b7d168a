// SPDX-License-Identifier: GPL-3.0-or-later
// Random points of a ring modulo random primes.
#pragma once

#include "algebra/number/modular.hpp"
#include "algebra/ring/ring.hpp"

#include <cstdint>
#include <exception>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace resonform {

// The prime or the point hits a denominator: another one must be drawn.
class UnluckyPoint : public std::exception {
public:
    [[nodiscard]] const char* what() const noexcept override { return "a denominator vanishes at the point"; }
};

// A value for each generator: i^2 = -1, sigma^k = P and s^2 + c^2 = 1 hold, all values are non-zero, and w,
// wbar are independent of each other, as are functions.
struct Point {
    PrimeField field;
    std::vector<Residue> values;
};

// Draws points with all roots rational modulo p. A generator g that is the radicand of a root G, g = G^k, and
// occurs in no radicand before, is drawn as the k-th power of a random G, which gives the same points.
// Besides, it proves on the way that the roots are independent:
// sigma^k - P is irreducible over the field F of i and the roots before it if P is no l-th power in F
// for each prime l that divides k (Capelli; -4 F^4 lies in F^2, as F has i), and that is shown by a point
// at which P is no l-th power modulo p = 1 mod l. (x^k - g is irreducible by Eisenstein's criterion.)
class PointSampler {
public:
    PointSampler(const Ring& ring, std::uint64_t seed);

    // Errors (refused): no point found in a long search.
    Point next();
    // A root without a witness of independence after a long search; nullopt: all roots are independent.
    [[nodiscard]] std::optional<GeneratorId> dependent_root();

private:
    struct Witness {
        GeneratorId root;
        int prime; // divides the index
        bool found;
    };

    struct RadicandTerm {
        Rational coefficient;
        std::vector<std::pair<std::size_t, int>> powers; // of generators
    };

    void draw_powers();
    // Draws all values but those of fast and small variables and phases, with i given. False: a root is
    // missing.
    bool attempt(Point& point, Residue i);
    void draw_variables(Point& point);
    bool has_roots_of_numbers(const PrimeField& field);
    std::optional<Residue> root_value(const Point& point, GeneratorId id);
    std::optional<Residue> function_value(const Point& point, const Generator& g);
    void observe(const PrimeField& field, GeneratorId root, Residue radicand);

    const Ring& ring_;
    std::mt19937_64 random_;
    std::vector<Witness> witnesses_;
    std::vector<GeneratorId> root_of_;                 // by generator: the root that it is drawn by, -1
    std::vector<std::vector<RadicandTerm>> radicands_; // by generator
    Residue half_tangent_ = 0; // of the sine that was drawn last; its cosine comes right after it
};

} // namespace resonform
