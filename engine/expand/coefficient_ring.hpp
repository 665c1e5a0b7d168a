// SPDX-License-Identifier: GPL-3.0-or-later
// The coefficient ring of a system: parameters, slow variables, and one invertible generator for
// every base of which a root or an inverse occurs.
//
//   collect:  sees every power of weight 0 in an expression and notes base and root index
//   freeze:   builds the Ring (fast generators, eps, parameters, slow, roots)
//   convert:  an expression of weight 0 (and eps) -> its Polynomial
#pragma once

#include "algebra/ring.hpp"
#include "expand/complex_expression.hpp"
#include "expand/power_product.hpp"

#include <string>
#include <vector>

namespace resonform {

// What is divided by besides what stands in the equations: small divisors k.omega, polynomials of another
// ring of the same system, with exponents >= 0 of every generator.
struct Divisors {
    RingPtr ring;
    std::vector<Polynomial> values;
};

struct FastGenerator {
    std::string name;
    int weight = 1;
    int conjugate = -1; // index of the partner among the fast generators; -1: real
};

class CoefficientRing {
public:
    explicit CoefficientRing(std::shared_ptr<const System> system);

    // The generators besides what the system file names; before freeze. A phase e^{i phi} has the name of
    // its angle.
    void set_fast(std::vector<FastGenerator> fast) { fast_ = std::move(fast); }
    void set_angles(std::vector<std::string> angles) { angles_ = std::move(angles); }

    // Symbols that are no constants of the ring: set to zero, they leave the weight-0 part of an expression.
    void vanish(const GiNaC::ex& symbol);
    // Symbols that are a constant of the ring plus something of positive weight, xi = zeta + k.
    void move(const GiNaC::ex& symbol);
    // Errors (bad_input): a pole at the origin.
    [[nodiscard]] GiNaC::ex at_origin(const GiNaC::ex& e, const Place& place) const;
    // Does a symbol occur in e that vanishes or moves?
    [[nodiscard]] bool has_weight(const GiNaC::ex& e) const;

    // Notes the roots and inverses that a later convert of e, or of the weight-0 part of a power of
    // positive weight in e, will need.
    void collect(const GiNaC::ex& e, const Place& place);
    void freeze(const Divisors& divisors = {});

    [[nodiscard]] const RingPtr& ring() const { return ring_; }
    [[nodiscard]] GeneratorId fast(std::size_t k) const;
    [[nodiscard]] GeneratorId angle(std::size_t k) const;
    [[nodiscard]] GeneratorId eps() const;
    [[nodiscard]] GeneratorId slow(std::size_t variable) const; // -1 if the variable is not slow
    [[nodiscard]] const std::vector<GeneratorId>& divisors() const { return divisors_; } // those of freeze

    // Precondition: freeze() was called and e was collected. e in parameters, slow variables, eps.
    [[nodiscard]] Polynomial convert(const GiNaC::ex& e, const Place& place) const;
    [[nodiscard]] Polynomial convert(const Complex& e, const Place& place) const;

private:
    struct Base {
        GiNaC::ex expression;
        int index = 1;   // least common denominator of the exponents seen
        int level = 0;   // 0: no root inside; a base comes after those inside it
        std::string key; // canonical order of bases of one level
        GeneratorId id = -1;
        Place place; // where it was seen first
    };

    void note(const PowerProduct& product, const Place& place);
    Base* find_base(const GiNaC::ex& e);
    [[nodiscard]] const Base* find_base(const GiNaC::ex& e) const;
    [[nodiscard]] Polynomial convert_power(const GiNaC::ex& base, const Rational& exponent,
                                           const Place& place) const;
    [[nodiscard]] Polynomial convert_symbol(const GiNaC::ex& symbol, int exponent, const Place& place) const;
    [[nodiscard]] Polynomial radicand(const Base& root, const RingBuilder& builder) const;
    [[nodiscard]] Term radicand_factor(const GiNaC::ex& factor, const RingBuilder& builder,
                                       const Place& place) const;
    [[nodiscard]] std::string key_of(const GiNaC::ex& base) const;
    [[nodiscard]] int level_of(const GiNaC::ex& base) const;
    void add_symbols(RingBuilder& builder);
    void add_roots(RingBuilder& builder);

    std::shared_ptr<const System> system_;
    std::vector<FastGenerator> fast_;
    std::vector<std::string> angles_;
    GiNaC::exmap zero_;
    std::vector<GiNaC::ex> moving_;
    std::vector<Base> bases_;
    std::vector<std::pair<GiNaC::ex, GeneratorId>> symbols_; // eps, parameters, slow variables
    std::vector<GeneratorId> divisors_;
    RingPtr ring_;
};

} // namespace resonform
