// SPDX-License-Identifier: GPL-3.0-or-later
// Which root of the ring is meant by a fractional power in an equation of the file, and which functions.
// Decided on the expressions, never by comparing residues: modulo a prime both square roots look alike.
//
//   sigma^4 = xi^2 + r^2:           (4*xi^2 + 4*r^2)^(-1/2)  ->  1/2 * sigma^-2
//   E = exp(tau/2), s, c of tau:    exp(-tau)*sin(2*tau)     ->  E^-2 * 2 s c
#pragma once

#include "expand/expansion/graded_field.hpp"

#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace resonform {

// number * product of root powers * rest; `rest` has whole powers of sums in parameters, slow variables and
// generators.
struct Radical {
    Rational number = 1;
    std::vector<std::pair<GeneratorId, int>> roots;
    GiNaC::ex rest = 1;
};

class CertificateRoots {
public:
    explicit CertificateRoots(const GradedField& field);

    // The weight-0 part of `base` to a fractional power, by (a b)^e = a^e b^e and (a^d)^e = a^(d e), which
    // hold because every factor is required to be positive.
    // Errors (refused, with the equation as written): a factor that is not proved positive, or is neither
    // a radicand of the ring nor raised to a whole power.
    const Radical& resolve(const GiNaC::ex& base, const Rational& exponent, const Equation& equation);

    // The weight-0 part of e as a rational expression in the symbols of parameters, slow variables and
    // generators. Errors (refused, with the equation as written): what the ring has no generators for.
    [[nodiscard]] GiNaC::ex at_origin(const GiNaC::ex& e, const Equation& equation);
    // The generator of a symbol in this expression; also that of the number pi.
    [[nodiscard]] std::optional<GeneratorId> generator_of(const GiNaC::ex& symbol) const;
    // The argument of a generator that is a function, as an expression in the names of the file.
    [[nodiscard]] GiNaC::ex argument_of(GeneratorId function) const;
    // Has the ring this derivative of a function that is known by its name only?
    [[nodiscard]] bool knows(const GiNaC::ex& named, const Equation& equation);

private:
    struct Root {
        GeneratorId id;
        int index;
        bool positive;
        GiNaC::ex radicand;
        GiNaC::symbol symbol; // stands for the root inside the radicand of another
    };
    struct FunctionAtom {
        GeneratorId id;
        FunctionOf of;
        bool positive;
        GiNaC::ex argument; // in symbols
        GiNaC::symbol symbol;
    };
    struct Known {
        GiNaC::ex base;
        Rational exponent;
        Radical radical;
    };
    // A product of positive factors, each to a rational power.
    struct Product {
        GiNaC::ex whole;             // the base that was asked for
        std::vector<Rational> roots; // exponent of each radicand
        std::vector<std::pair<Rational, Rational>> numbers;
        std::vector<std::pair<GiNaC::ex, Rational>> rest;
    };

    [[nodiscard]] GiNaC::ex expression_of(const Polynomial& p, const std::vector<GiNaC::ex>& symbols) const;
    [[nodiscard]] bool positive(const GiNaC::ex& e) const;
    [[noreturn]] void refuse_part(const std::string& rule, const GiNaC::ex& part,
                                  const Equation& equation) const;
    void split(const GiNaC::ex& e, const Rational& exponent, const Equation& equation, Product& product);
    [[nodiscard]] std::vector<std::pair<GiNaC::ex, Rational>>
    positive_factors(const GiNaC::ex& product, const Equation& equation) const;
    [[nodiscard]] std::pair<GiNaC::ex, GiNaC::ex> rationalised(const GiNaC::ex& e) const;
    [[nodiscard]] GiNaC::ex without_radicands(GiNaC::ex e, const Rational& exponent, Product& product) const;
    void split_polynomial(GiNaC::ex e, const Rational& exponent, const Equation& equation, Product& product);
    void split_rest(const GiNaC::ex& e, const Rational& exponent, const Equation& equation,
                    Product& product) const;
    void split_number(const Rational& value, const Rational& exponent, const Equation& equation,
                      Product& product) const;
    [[nodiscard]] Radical collect(const Product& product, const Equation& equation) const;
    // A rational expression in which symbols stand for the fractional powers and for functions.
    [[nodiscard]] GiNaC::ex with_symbols(const GiNaC::ex& e, const Equation& equation);
    [[nodiscard]] GiNaC::ex radical_with_symbols(const GiNaC::ex& base, const Rational& exponent,
                                                 const Equation& equation);
    // functions.cpp
    [[nodiscard]] GiNaC::ex function_with_symbols(const GiNaC::ex& e, const Equation& equation);
    [[nodiscard]] GiNaC::ex exponential(const GiNaC::ex& u, const Equation& equation);
    [[nodiscard]] GiNaC::ex circular(const GiNaC::ex& argument, bool cosine, const Equation& equation);
    [[nodiscard]] std::pair<GiNaC::ex, GiNaC::ex> of_arc(Function name, const GiNaC::ex& argument,
                                                         const Equation& equation);
    [[nodiscard]] GiNaC::ex plain(Function name, const GiNaC::ex& u, const Equation& equation) const;
    [[nodiscard]] GiNaC::ex without_whole_powers(const GiNaC::ex& e) const;
    [[nodiscard]] GiNaC::ex logarithm(const GiNaC::ex& u, const Equation& equation) const;
    [[nodiscard]] GiNaC::ex logarithm_of_factors(GiNaC::ex& rest) const;
    [[nodiscard]] GiNaC::ex logarithm_of_number(GiNaC::ex& rest) const;
    [[noreturn]] void refuse_function(const GiNaC::ex& function, const Equation& equation) const;
    [[nodiscard]] GiNaC::ex lowered(const GiNaC::ex& e) const;
    [[nodiscard]] const FunctionAtom* find_named(const GiNaC::ex& e, const Equation& equation);
    [[nodiscard]] const FunctionAtom& atom(GeneratorId id) const;

    const GradedField* field_;
    GiNaC::symbol pi_{"pi"};
    std::vector<Root> roots_; // largest degree first, so that a product is tried before its factors
    std::vector<FunctionAtom> functions_;
    GiNaC::exmap meanings_;   // symbols of roots and functions -> their expressions
    GiNaC::exmap origin_;     // symbols of positive weight -> 0
    std::deque<Known> known_; // references into it are handed out
    std::map<GiNaC::ex, GiNaC::ex, GiNaC::ex_is_less> origins_; // looked up only
};

} // namespace resonform
