// SPDX-License-Identifier: GPL-3.0-or-later
// Random points of the ring modulo random primes, and truncated series in a grading variable t there:
// a generator of weight k becomes value * t^k, so that weights are read off as powers of t.
#pragma once

#include "algebra/modular.hpp"
#include "normalize/certificate_flow.hpp"

#include <cstdint>
#include <exception>
#include <random>
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

// Draws points with all roots rational modulo p, and proves on the way that the roots are independent:
// sigma^k - P is irreducible over the field F of i and the roots before it if P is no l-th power in F
// for each prime l that divides k (Capelli; -4 F^4 lies in F^2, as F has i), and that is shown by a point
// at which P is no l-th power modulo p = 1 mod l.
class PointSampler {
public:
    PointSampler(const Ring& ring, std::uint64_t seed);

    // Errors (refused): no point found in a long search.
    Point next();
    // Errors (refused): a root without a witness of independence after a long search.
    void prove_roots_independent();

private:
    struct Witness {
        GeneratorId root;
        int prime; // divides the index
        bool found;
    };

    std::optional<Point> attempt(const PrimeField& field);
    std::optional<Residue> root_value(const Point& point, GeneratorId id);
    std::optional<Residue> function_value(const Point& point, const Generator& g);
    void observe(const PrimeField& field, GeneratorId root, Residue radicand);

    const Ring& ring_;
    std::mt19937_64 random_;
    std::vector<Witness> witnesses_;
    Residue half_tangent_ = 0; // of the sine that was drawn last; its cosine comes right after it
};

// The Algebra of certificate_equation.hpp over residues; all series are known through weight `through`.
class PointAlgebra {
public:
    using Value = std::vector<Residue>; // coefficients of t^0 ... t^through

    PointAlgebra(const Ring& ring, Point point, int through);

    [[nodiscard]] Value number(const Rational& value) const;
    [[nodiscard]] Value generator(GeneratorId id, int power) const; // weight * power <= through, else zero
    [[nodiscard]] Value add(const Value& a, const Value& b) const;
    [[nodiscard]] Value multiply(const Value& a, const Value& b) const;
    // Plain Taylor sums; u_0 must be 0 (1 for the logarithm), else Error(refused).
    [[nodiscard]] Value function(Elementary function, const Value& u) const;
    [[nodiscard]] Value power(const Value& a, const Rational& exponent, const Value& lead) const;
    [[nodiscard]] Value inverse_power(const Value& a, int n) const;
    [[nodiscard]] Value at_origin(const Value& a) const { return constant(a[0]); }
    [[nodiscard]] Gradient<Value> gradient(const Series& s, Side side) const;

    [[nodiscard]] const PrimeField& field() const { return point_.field; }

private:
    [[nodiscard]] Residue residue(const Rational& value) const;
    [[nodiscard]] Value constant(Residue value) const;
    // Throws UnluckyPoint where the prime divides it.
    [[nodiscard]] Residue inverse_of_denominator(const Fractions& part) const;
    [[nodiscard]] Residue value_of(GeneratorId id, Side side) const;
    // sum_k coefficients[k] u^k with u_0 = 0, by Horner's rule.
    [[nodiscard]] Value taylor(const std::vector<Residue>& coefficients, const Value& u) const;
    // coefficients of (1 + u)^exponent
    [[nodiscard]] std::vector<Residue> binomial(const Rational& exponent) const;
    [[nodiscard]] std::vector<Residue> taylor_coefficients(Elementary function) const;

    const Ring& ring_;
    Point point_;
    int through_;
};

} // namespace resonform
