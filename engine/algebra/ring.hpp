// SPDX-License-Identifier: GPL-3.0-or-later
// The ring in which everything exact lives: one packed key holds the imaginary unit, the fast
// variables, eps, parameters, slow variables, roots, and the generators a solution adds.
//
//   pendulum:  i, z1, z2, eps, g, r, v, xi, G = g^(1/2), sigma = (xi^2 + r^2)^(1/4)
//   relations: i^2 = -1;  g = G^2;  xi^2 = sigma^4 - r^2
//   derivation: d sigma / d xi = xi / (2 sigma^3)
//
// A Ring is built once by a RingBuilder and is immutable afterwards (RingPtr).
#pragma once

#include "algebra/polynomial.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

using GeneratorId = int; // index into the ring's generators

enum class GeneratorKind {
    imaginary, // i with i^2 = -1; every ring has it, always generator 0
    fast,      // a mode z or its conjugate, weight >= 0
    small,     // eps, weight 1
    parameter, // weight 0
    slow,      // weight 0, with a derivation
    root,      // sigma with sigma^index = radicand, weight 0, invertible, positive
    constant,  // a constant of the solution (C_delta, C_X, ...), weight 0
    phase,     // e^{i theta}: invertible, conjugate = inverse
    primitive, // a function of slow variables known by its derivatives (a logarithm, a quadrature)
};

enum class Zero { yes, no, unknown };

struct Generator {
    GeneratorKind kind = GeneratorKind::parameter;
    std::string name;
    int weight = 0;
    bool invertible = false;    // negative exponents are allowed (proved non-zero)
    bool positive = false;      // proved positive
    GeneratorId conjugate = -1; // fast: the partner. -1: itself (real); phase: its inverse
    int index = 0;              // root: sigma^index = radicand
    Polynomial radicand;        // root: a polynomial in parameters and slow variables, non-negative exponents
    // primitive: d/d(slow) = polynomial; slow variables not listed have derivative zero
    std::vector<std::pair<GeneratorId, Polynomial>> derivatives;
};

class Ring;
using RingPtr = std::shared_ptr<const Ring>;

class Ring {
public:
    static constexpr GeneratorId imaginary_unit = 0;

    [[nodiscard]] int size() const { return static_cast<int>(generators_.size()); }
    [[nodiscard]] const Generator& generator(GeneratorId id) const {
        return generators_[static_cast<std::size_t>(id)];
    }
    [[nodiscard]] std::optional<GeneratorId> find(const std::string& name) const;

    // --- monomials -----------------------------------------------------------------------------
    [[nodiscard]] Monomial monomial(GeneratorId id, int exponent = 1) const;
    [[nodiscard]] Monomial monomial(const std::vector<int>& exponents) const; // one per generator
    [[nodiscard]] int exponent(const Monomial& m, GeneratorId id) const;
    [[nodiscard]] std::vector<int> exponents(const Monomial& m) const;
    [[nodiscard]] int weight(const Monomial& m) const;

    // --- polynomials ---------------------------------------------------------------------------
    [[nodiscard]] Polynomial one() const;
    [[nodiscard]] Polynomial gen(GeneratorId id, int exponent = 1) const; // reduced
    [[nodiscard]] Polynomial imaginary() const { return gen(imaginary_unit); }
    // Applies every relation until none applies. All Ring operations below return reduced results.
    [[nodiscard]] Polynomial reduce(Polynomial p) const;
    [[nodiscard]] Polynomial multiply(const Polynomial& a, const Polynomial& b) const;
    // sum_k a_k b_k, collected and reduced once: the kernel of all series products.
    [[nodiscard]] Polynomial
    dot(const std::vector<std::pair<const Polynomial*, const Polynomial*>>& pairs) const;
    [[nodiscard]] Polynomial power(const Polynomial& p, int exponent) const; // exponent < 0: needs inverse(p)
    // 1/p if p is a unit of the ring, that is one monomial in invertible generators (or i) times a
    // number, or the radicand of a root (recognised after reduction); nullopt otherwise.
    [[nodiscard]] std::optional<Polynomial> inverse(const Polynomial& p) const;
    // d/d(id), through roots and primitives. id: slow, fast, parameter or constant.
    [[nodiscard]] Polynomial derivative(const Polynomial& p, GeneratorId id) const;
    // i -> -i, fast <-> conjugate, phase -> 1/phase.
    [[nodiscard]] Polynomial conjugate(const Polynomial& p) const;
    // Splits by weight: result[n] is the homogeneous part of weight n (0 <= n <= through).
    [[nodiscard]] std::vector<Polynomial> by_weight(const Polynomial& p, int through) const;
    // yes/no exactly when the relations give canonical forms; otherwise denominators are cleared and
    // radicands expanded, which decides too when the roots are independent; else unknown.
    [[nodiscard]] Zero is_zero(const Polynomial& p) const;
    // Splits each term into (part in generators selected by `outer`) x (coefficient):
    // outer monomial -> coefficient polynomial in the remaining generators. Sorted by outer key.
    [[nodiscard]] std::vector<std::pair<Monomial, Polynomial>>
    collect(const Polynomial& p, const std::vector<GeneratorId>& outer) const;
    // Undoes the elimination for display: no generator was eliminated in favour of a root, i.e.
    // sigma^4 -> xi^2 + r^2 in every numerator; the common root power is factored out first.
    // Each element: (monomial of roots and invertible generators, numerator polynomial).
    [[nodiscard]] std::vector<std::pair<Monomial, Polynomial>> expanded_form(const Polynomial& p) const;

private:
    friend class RingBuilder;
    Ring() = default;

    struct Relation; // how one generator is rewritten; see ring.cpp
    std::vector<Generator> generators_;
    std::shared_ptr<const std::vector<Relation>> relations_;
    int field_bits_ = 16; // 16 generators of 16 bits, or 32 of 8
};

// Collects generators, then freezes them. The order of creation is the order of the keys, so callers
// create generators in the order of the user's file.
class RingBuilder {
public:
    RingBuilder();                // with the imaginary unit as generator 0
    GeneratorId add(Generator g); // roots: radicand given over the generators added so far
    [[nodiscard]] GeneratorId id(const std::string& name) const; // -1 if absent
    // While building, polynomials over the present generators may be formed (to give radicands and
    // derivatives): exponents are re-packed when the ring is frozen.
    [[nodiscard]] Polynomial gen(GeneratorId id, int exponent = 1) const;
    // Refuses more than 32 generators. Chooses for each root the relation that makes forms canonical
    // (eliminates x where radicand = c x^d + lower in x, c a unit, x polynomial and eliminated by no
    // other root; numeric radicands keep 0 <= exponent < index).
    [[nodiscard]] RingPtr freeze() const;

private:
    std::vector<Generator> generators_; // polynomials packed with 8-bit fields for 32 generators
};

// A homomorphism from one ring into another, given by the image of every generator of `from`.
class RingMap {
public:
    RingMap(RingPtr from, RingPtr to, std::vector<Polynomial> images);
    // Generators of the same name map to each other; the others as listed.
    static RingMap by_name(RingPtr from, RingPtr to,
                           std::vector<std::pair<GeneratorId, Polynomial>> others = {});
    [[nodiscard]] Polynomial operator()(const Polynomial& p) const;
    [[nodiscard]] const RingPtr& from() const { return from_; }
    [[nodiscard]] const RingPtr& to() const { return to_; }

private:
    RingPtr from_, to_;
    std::vector<Polynomial> images_;
};

} // namespace resonform
