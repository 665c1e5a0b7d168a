// SPDX-License-Identifier: GPL-3.0-or-later
// The ring in which everything exact lives: one packed key holds the imaginary unit, the fast
// variables, eps, parameters, slow variables, roots, and the generators a solution adds.
//
//   pendulum:  i, z1, z2, eps, g, r, v, xi, G = g^(1/2), sigma = (xi^2 + r^2)^(1/4)
//   relations: i^2 = -1;  g = G^2;  xi^2 = sigma^4 - r^2   (read as rewriting rules, left to right)
//   derivation: d sigma / d xi = xi / (2 sigma^3)
//
// A Ring is built once by a RingBuilder and is immutable afterwards (RingPtr).
#pragma once

#include "algebra/number/functions.hpp"
#include "algebra/number/zero.hpp"
#include "algebra/ring/packing.hpp"
#include "algebra/ring/polynomial.hpp"
#include "algebra/ring/relation.hpp"

#include <map>
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
    small,     // eps^(1/index), weight 1: weights count in units of 1/index
    parameter, // weight 0
    slow,      // weight 0, with a derivation
    root,      // sigma with sigma^index = radicand, weight 0, invertible; positive, but for an index 1:
               // that is a divisor, which has an inverse because it does not vanish identically
    constant,  // a constant of the solution (C_delta, C_X, ...), weight 0
    phase,     // e^{i theta}: invertible, conjugate = inverse
    function,  // exp, sin, cos, log, ... of arguments in parameters and slow variables, weight 0
    primitive, // a function of slow variables known by its derivatives (a logarithm, a quadrature)
};

// The function behind a generator of kind function. Others are written with these: tan u = sin u/cos u.
struct FunctionOf {
    Function function = Function::exponential;
    Polynomial argument;     // in earlier generators
    GeneratorId sine = -1;   // cosine: the generator of the sine of the same argument, an earlier one
    std::string symbol = {}; // named: known by its name only, omega(tau), ...
    int derivative = 0;      // ... and by how often it is differentiated
    // f'(u), where it is no generator by itself (as that of a sine is) and no inverse (as of log, atan).
    std::optional<Polynomial> slope = {};
};

struct FractionProduct;

struct Generator {
    GeneratorKind kind = GeneratorKind::parameter;
    std::string name;
    int weight = 0;
    bool invertible = false;    // negative exponents are allowed (proved non-zero)
    bool positive = false;      // proved positive
    GeneratorId conjugate = -1; // fast: the partner. -1: itself (real); phase: its inverse
    int index = 0;              // root: sigma^index = radicand; small: eps = generator^index
    Polynomial radicand;        // root: a polynomial in parameters and slow variables, non-negative exponents
    // primitive: d/d(slow) = polynomial; slow variables not listed have derivative zero. It may contain
    // the primitive itself (an exponential). root, function: filled in by RingBuilder::freeze.
    std::vector<std::pair<GeneratorId, Polynomial>> derivatives;
    FunctionOf of = {};                    // function
    std::vector<GeneratorId> unknown = {}; // d/d(id) is no element of the ring; filled in by freeze
    // function: proved to be algebraically independent of the generators before it, but for the relation
    // of a cosine with its sine
    bool independent = true;
};

// factor * left * right
template <class Part> struct ProductOf {
    Rational factor;
    const Part* left;
    const Part* right;
};
using Product = ProductOf<Polynomial>;

class Ring;
using RingPtr = std::shared_ptr<const Ring>;

class Ring {
public:
    static constexpr GeneratorId imaginary_unit = 0;

    [[nodiscard]] int size() const { return static_cast<int>(generators_.size()); }
    [[nodiscard]] const Generator& generator(GeneratorId id) const {
        return generators_[static_cast<std::size_t>(id)];
    }
    // Numbers are rounded to so many significant decimal digits when they are printed; 0: they are exact.
    [[nodiscard]] int digits() const { return digits_; }
    [[nodiscard]] std::optional<GeneratorId> find(const std::string& name) const;

    // --- monomials -----------------------------------------------------------------------------
    // Exponents beyond packing().largest() are refused, here and in every product.
    [[nodiscard]] Monomial monomial(GeneratorId id, int exponent = 1) const {
        return packing_.power(id, exponent);
    }
    [[nodiscard]] Monomial monomial(const std::vector<int>& exponents) const; // one per generator
    [[nodiscard]] int exponent(const Monomial& m, GeneratorId id) const { return packing_.exponent(m, id); }
    [[nodiscard]] std::vector<int> exponents(const Monomial& m) const;
    [[nodiscard]] int weight(const Monomial& m) const;
    // How many of these weights a power of eps has: the index of the small generator, or 1.
    [[nodiscard]] int weights_in_one() const;
    // The exponent, of the small generator as that of eps.
    [[nodiscard]] Rational exponent_of_named(const Monomial& m, GeneratorId id) const {
        return Rational(exponent(m, id)) /
               (generator(id).kind == GeneratorKind::small ? weights_in_one() : 1);
    }
    [[nodiscard]] const Packing& packing() const { return packing_; }

    // --- polynomials ---------------------------------------------------------------------------
    [[nodiscard]] Polynomial one() const { return Polynomial(Rational(1)); }
    // Reduced. Refused: a negative power of a generator that is not invertible.
    [[nodiscard]] Polynomial gen(GeneratorId id, int exponent = 1) const;
    [[nodiscard]] Polynomial imaginary() const { return gen(imaginary_unit); }
    // Applies every relation until none applies. All Ring operations below return reduced results.
    [[nodiscard]] Polynomial reduce(Polynomial p) const;
    [[nodiscard]] Polynomial multiply(const Polynomial& a, const Polynomial& b) const;
    // sum_k a_k b_k, collected and reduced once: the kernel of all series products.
    [[nodiscard]] Polynomial
    dot(const std::vector<std::pair<const Polynomial*, const Polynomial*>>& pairs) const;
    [[nodiscard]] Polynomial dot(const std::vector<Product>& products) const; // with factors
    // exponent < 0: refused unless p is a unit (inverse below).
    [[nodiscard]] Polynomial power(const Polynomial& p, int exponent) const;
    // 1/p if p is one monomial in invertible generators (or i) times a number times powers of radicands
    // of roots (recognised after reduction) or a sum of numeric roots; nullopt otherwise.
    [[nodiscard]] std::optional<Polynomial> inverse(const Polynomial& p) const;
    // The positive p^exponent where p is a positive number times a monomial (or a product of
    // radicands) and the result is again one: (4 r^2 sigma^4)^(-1/2) = 1/(2 r sigma^2). An integer
    // exponent needs only a unit. nullopt where the ring holds no such element.
    [[nodiscard]] std::optional<Polynomial> rational_power(const Polynomial& p,
                                                           const Rational& exponent) const;
    // d/d(id), through roots and primitives. id: slow, fast, parameter, constant, small, phase.
    // Refused: the derivative of a primitive with respect to a parameter it does not list, and one that
    // needs a derivative of a named function that the ring does not hold.
    [[nodiscard]] Polynomial derivative(const Polynomial& p, GeneratorId id) const;
    // Whether the ring holds every derivative of named functions that derivative(p, id) needs.
    [[nodiscard]] bool derivative_known(const Polynomial& p, GeneratorId id) const;
    // i -> -i, fast <-> conjugate, phase -> 1/phase.
    [[nodiscard]] Polynomial conjugate(const Polynomial& p) const;
    // Splits by weight: result[n] is the homogeneous part of weight n (0 <= n <= through). Heavier
    // terms are cut; a term of negative weight is refused.
    [[nodiscard]] std::vector<Polynomial> by_weight(const Polynomial& p, int through) const;
    // yes: p vanishes identically, by the relations (after denominators are cleared, where a root
    //      was not eliminated);
    // no:  some coefficient of p over fast, small, phase and constant generators is non-zero at a
    //      point of the domain, by interval arithmetic in rationals;
    // unknown: neither was proved, e.g. sqrt(2) sqrt(3) - sqrt(6) over three roots, or a combination
    //      of primitives that may be dependent.
    [[nodiscard]] Zero is_zero(const Polynomial& p) const;
    // is_zero(p) == Zero::yes, without the search for a proof of the opposite.
    [[nodiscard]] bool vanishes(const Polynomial& p) const { return cleared(p).empty(); }
    // Whether every polynomial but the empty one is non-zero: no root is left that was not eliminated,
    // and all functions are independent. (Numbers under roots and primitives are taken to be independent,
    // as by vanishes.)
    [[nodiscard]] bool is_canonical() const;
    // Whether a relation binds the powers of a generator, or it is a function of others: it is not
    // independent of them then. (The inverse of a polynomial, a root of index 1, counts as a quotient.)
    [[nodiscard]] bool is_algebraic(GeneratorId id) const;
    // Splits each term into (part in generators selected by `outer`) x (coefficient):
    // outer monomial -> coefficient polynomial in the remaining generators. Sorted by outer key.
    [[nodiscard]] std::vector<std::pair<Monomial, Polynomial>>
    collect(const Polynomial& p, const std::vector<GeneratorId>& outer) const;
    // The lowest exponent of a generator in the terms of p. Precondition: p is not zero.
    [[nodiscard]] int lowest_exponent(const Polynomial& p, GeneratorId id) const;
    // The part of m in the selected generators.
    [[nodiscard]] Monomial restricted(const Monomial& m, const std::vector<GeneratorId>& generators) const;
    // Undoes the elimination for display: p = sum of (factor) x (numerator), one element for each class
    // of terms whose exponents agree modulo the index of every root, sorted by the key of the factor.
    //   factor:    a monomial of roots and invertible generators, each with the lowest exponent that it
    //              has in the class (so a numerator has a term without it);
    //   numerator: no root (unless radicands are nested: lower roots with exponents >= 0), sigma^4
    //              written as xi^2 + r^2 again; other generators, i included, with exponents >= 0.
    // A numerator is for reading with exponents(): it is not reduced.
    //   (xi^2 + r^2)^(-3/4) xi^2 g^(1/2), held as G (sigma^4 - r^2)/sigma^3  ->  {G sigma^-3, xi^2}
    [[nodiscard]] std::vector<std::pair<Monomial, Polynomial>> expanded_form(const Polynomial& p) const;

private:
    friend class RingBuilder;
    explicit Ring(int size) : packing_(size) {}

    [[nodiscard]] Polynomial cleared(const Polynomial& p) const; // reduced, times a unit
    [[nodiscard]] bool may_depend(GeneratorId generator, GeneratorId id) const;
    [[nodiscard]] std::optional<Polynomial> slope(GeneratorId function) const;
    void derive(GeneratorId id);
    void relate_circle(GeneratorId cosine);
    [[nodiscard]] const Polynomial* derivative_of(GeneratorId generator, GeneratorId id) const;
    [[nodiscard]] Polynomial collected(const std::vector<FractionProduct>& products) const;
    [[nodiscard]] std::map<int, Fractions> by_exponent(const Fractions& f, GeneratorId id) const;

    Packing packing_;
    std::vector<Generator> generators_;
    int digits_ = 0;
    std::vector<Relation> relations_;
    bool related_ = true; // every root and every cosine has its rule
};

// Collects generators, then freezes them. The order of creation is the order of the keys, so callers
// create generators in the order of the user's file.
class RingBuilder {
public:
    // With the imaginary unit as generator 0, for at most so many; the fewer, the larger the exponents of
    // radicands and derivatives may be.
    explicit RingBuilder(int most = Packing::most_fields);
    // Roots: radicand given over the generators added so far, parameters, slow variables and roots.
    // Refuses more generators than expected; a name that is taken or empty is refused.
    GeneratorId add(Generator g);
    void round_to(int digits) { digits_ = digits; } // Ring::digits
    // The id that the next add() gives: for a derivative that contains its own generator, as that of an
    // exponential does.
    [[nodiscard]] GeneratorId next() const { return static_cast<GeneratorId>(generators_.size()); }
    [[nodiscard]] GeneratorId id(const std::string& name) const; // -1 if absent
    // While building, polynomials over the present generators may be formed (to give radicands and
    // derivatives): exponents are re-packed when the ring is frozen. No relation is applied.
    [[nodiscard]] Polynomial gen(GeneratorId id, int exponent = 1) const;
    [[nodiscard]] Polynomial multiply(const Polynomial& a, const Polynomial& b) const;
    // A polynomial of another ring, its generators found here by name (refused if one is missing).
    [[nodiscard]] Polynomial import(const Ring& from, const Polynomial& p) const;
    // Chooses for each root the relation that makes forms canonical:
    //   a radicand of one term, g = G^2: the generator is eliminated, g^-1 = G^-2; a number: the root
    //   keeps 0 <= exponent < index;
    //   else x^d -> (sigma^k - rest)/c where radicand = c x^d + lower in x, c a unit monomial, x not
    //   invertible and eliminated by no other root, a slow variable if possible;
    //   else sigma^k -> radicand, true but not canonical; Ring::is_zero then clears denominators.
    // sin^2 -> 1 - cos^2, or the other way round where the cosine or its square is under a root.
    [[nodiscard]] RingPtr freeze() const;
    // FunctionOf::slope of a generator, a polynomial of a ring that this builder has frozen.
    void set_slope(GeneratorId id, const Ring& frozen, const Polynomial& slope);

private:
    Packing packing_; // of as many generators as there may be
    int digits_ = 0;
    std::vector<Generator> generators_;
};

// A homomorphism from one ring into another, given by the image of every generator of `from`.
class RingMap {
public:
    // Refused unless the images obey the relations of `from` provably: image(sigma)^k = image(radicand).
    RingMap(RingPtr from, RingPtr to, std::vector<Polynomial> images);
    // Generators of the same name map to each other; the others as listed.
    static RingMap by_name(RingPtr from, RingPtr to,
                           std::vector<std::pair<GeneratorId, Polynomial>> others = {});
    // Reduced. Refused: a negative power of a generator whose image is no unit.
    [[nodiscard]] Polynomial operator()(const Polynomial& p) const;
    [[nodiscard]] const RingPtr& from() const { return from_; }
    [[nodiscard]] const RingPtr& to() const { return to_; }

private:
    RingPtr from_, to_;
    std::vector<Polynomial> images_;
};

} // namespace resonform
