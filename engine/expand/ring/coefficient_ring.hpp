// SPDX-License-Identifier: GPL-3.0-or-later
// The coefficient ring of a system: parameters, slow variables, one invertible generator for every base
// of which a root or an inverse occurs, and generators for functions of slow variables and parameters.
//
//   collect:  sees every power and function in an expression and notes the generators it needs at weight 0
//   freeze:   builds the Ring (fast generators, eps, parameters, slow, roots and functions)
//   convert:  an expression of weight 0 (and eps) -> its Polynomial
#pragma once

#include "algebra/ring/ring.hpp"
#include "expand/ring/complex_expression.hpp"
#include "expand/ring/function_atoms.hpp"

#include <string>
#include <vector>

namespace resonform {

// f(u) for the function f of e = f(...).
GiNaC::ex with_argument(const GiNaC::ex& e, const GiNaC::ex& u);

// Divisors besides those in the equations: small divisors k.omega, polynomials of another ring of the same
// system, with exponents >= 0 of every generator.
struct Divisors {
    RingPtr ring;
    std::vector<Polynomial> values;
    int derivatives = 1; // and how often functions known by their names only are differentiated
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
    // Real numbers without an exact value.
    struct Number {
        GiNaC::symbol symbol;
        std::string name;
    };
    void set_numbers(std::vector<Number> numbers) { numbers_ = std::move(numbers); }

    // Symbols that are no constants of the ring: set to zero, they leave the weight-0 part of an expression.
    void vanish(const GiNaC::ex& symbol);
    // Symbols that are a constant of the ring plus something of positive weight, xi = zeta + k.
    void move(const GiNaC::ex& symbol);
    // Without terms that cancel by the relations of roots and functions. Errors (bad_input): a pole at the
    // origin.
    [[nodiscard]] GiNaC::ex at_origin(const GiNaC::ex& e, const Place& place) const;
    // Is an expression in parameters and slow variables zero? If cancelling common factors does not
    // decide it, a ring is built for it. Errors (refused): those of collect and convert.
    [[nodiscard]] Zero vanishes(const GiNaC::ex& e, const Place& place) const;
    // Does a symbol occur in e that vanishes or moves?
    [[nodiscard]] bool has_weight(const GiNaC::ex& e) const;
    // Does it contain a fast variable of weight 0 at eps = 0 and small variables 0? Such a value cannot be
    // expanded about.
    [[nodiscard]] bool is_finite(const GiNaC::ex& e) const;
    // How often functions known by their names only can be differentiated.
    [[nodiscard]] int derivatives() const { return derivatives_; }
    // Was a function known by its name collected that must be expanded, such as omega(tau + psi)?
    [[nodiscard]] bool expands_named() const { return expands_named_; }

    // Notes the roots, inverses and functions that a later convert of e, or of the weight-0 part of a power
    // or function of positive weight in e, will need.
    void collect(const GiNaC::ex& e, const Place& place);
    void freeze(const Divisors& divisors = {});

    [[nodiscard]] const RingPtr& ring() const { return ring_; }
    [[nodiscard]] GeneratorId fast(std::size_t k) const;
    [[nodiscard]] GeneratorId angle(std::size_t k) const;
    [[nodiscard]] GeneratorId eps() const;
    [[nodiscard]] GeneratorId number(std::size_t k) const;
    [[nodiscard]] GeneratorId slow(std::size_t variable) const; // -1 if the variable is not slow
    [[nodiscard]] const std::vector<GeneratorId>& divisors() const { return divisors_; } // those of freeze

    // Where a root or a function of the ring was met first; empty of anything else.
    [[nodiscard]] Place place_of(GeneratorId id) const;

    // Precondition: freeze() was called and e was collected. e in parameters, slow variables, eps.
    [[nodiscard]] Polynomial convert(const GiNaC::ex& e, const Place& place) const;
    [[nodiscard]] Polynomial convert(const Complex& e, const Place& place) const;
    // The inverse of convert: a polynomial in constants of the ring, with roots and functions written out.
    [[nodiscard]] GiNaC::ex expression(const Polynomial& p) const;

private:
    bool set_slopes(RingBuilder& builder) const; // true: there are some
    struct Base {
        GiNaC::ex expression;
        int index = 1;   // least common denominator of the exponents seen
        int level = 0;   // 0: no root inside; a base comes after those inside it
        std::string key; // canonical order of bases of one level
        GeneratorId id = -1;
        Place place; // where it was seen first
    };
    struct Needed { // of weight 0: a power or a function
        GiNaC::ex expression;
        Place place;
    };

    [[noreturn]] static void refuse_pole(const GiNaC::ex& e, const Place& place);
    [[nodiscard]] GiNaC::ex simplified(const GiNaC::ex& e, const Place& place) const;
    [[nodiscard]] CoefficientRing ring_of(const GiNaC::ex& e, const Place& place) const; // for e alone
    void collect_function(const GiNaC::ex& e, const GiNaC::ex& u, const Place& place);
    [[nodiscard]] GiNaC::ex without_angles(const GiNaC::ex& argument) const;
    void learn_functions(int derivatives);
    void note_powers(const GiNaC::ex& e, const Place& place);
    void note(const PowerProduct& product, const Place& place);
    Base* find_base(const GiNaC::ex& e);
    [[nodiscard]] const Base* find_base(const GiNaC::ex& e) const;
    [[nodiscard]] Polynomial convert_rewritten(const GiNaC::ex& e, const Place& place) const;
    [[nodiscard]] Polynomial convert_power(const GiNaC::ex& base, const Rational& exponent,
                                           const Place& place) const;
    [[nodiscard]] Polynomial convert_symbol(const GiNaC::ex& symbol, int exponent, const Place& place) const;
    [[nodiscard]] Polynomial polynomial(const GiNaC::ex& e, const RingBuilder& builder,
                                        const Place& place) const;
    [[nodiscard]] Term factor(const GiNaC::ex& e, const RingBuilder& builder, const Place& place) const;
    [[nodiscard]] GiNaC::ex power_of(GeneratorId id, int exponent) const;
    [[nodiscard]] std::string key_of(const GiNaC::ex& base) const;
    [[nodiscard]] int level_of(const GiNaC::ex& base) const;
    void add_symbols(RingBuilder& builder);
    void add_roots_and_functions(RingBuilder& builder);
    [[nodiscard]] static std::string name_of(const Base& base);
    void add_root(Base& base, RingBuilder& builder);
    void add_function(const FunctionAtom& atom, std::vector<GeneratorId>& ids, RingBuilder& builder);

    std::shared_ptr<const System> system_;
    std::vector<FastGenerator> fast_;
    std::vector<std::string> angles_;
    std::vector<Number> numbers_;
    GiNaC::exmap zero_;
    std::vector<GiNaC::ex> moving_;
    std::vector<Needed> needed_;
    std::shared_ptr<FunctionAtoms> functions_;
    std::vector<int> levels_; // of the atoms of functions_, as those of bases
    std::vector<Base> bases_;
    std::vector<std::pair<GiNaC::ex, GeneratorId>> symbols_; // eps, parameters, slow variables, atoms
    std::vector<GeneratorId> divisors_;
    int derivatives_ = 1;
    bool expands_named_ = false;
    RingPtr ring_;
};

} // namespace resonform
