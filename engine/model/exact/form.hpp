// SPDX-License-Identifier: GPL-3.0-or-later
// Expressions of mechanics as fractions of polynomials. Sines, cosines, roots and other functions become
// generators with their relations, so that equal expressions are written the same:
//
//   sin(psi + atan(xi/r))  ->  (xi*cos(psi) + r*sin(psi))/sqrt(xi^2 + r^2)        where r > 0 is declared
//
// Complete for sin, cos, sinh and cosh of sums and integer multiples, atan, asin and log inside of them, and
// roots whose factors are declared positive; other functions of equal arguments are equal, and nothing else
// is known of them.
#pragma once

#include "model/signs/polynomial_quotients.hpp"
#include "model/system/system_file.hpp"
#include "model/text/zero_test.hpp"

#include <string>
#include <vector>

namespace resonform {

class ExactForm {
public:
    // The kind of a symbol, in the order in which terms are written.
    enum class Kind { acceleration, velocity, moving, coordinate, rate, constant, slow, parameter, eps };
    struct Generator {
        enum class Relation { none, square, root };
        GiNaC::symbol symbol;
        GiNaC::ex meaning; // the function this generator stands for, or the symbol itself
        Kind kind;
        std::string text;
        Relation relation = Relation::none;
        GiNaC::ex value; // of symbol^index: of a sine 1 - cos^2, of a root its base
        int index = 0;
    };
    struct Fraction {
        GiNaC::ex numerator, denominator; // expanded, in symbols of generators
    };

    // `domain` has the declared signs; it outlives the form.
    explicit ExactForm(const System& domain) : domain_(&domain) {}
    // The place of errors from here on.
    void set_place(Place place) { place_ = std::move(place); }
    // Precondition: every symbol of an expression is added before the expression comes.
    void add(const GiNaC::symbol& symbol, Kind kind);

    // Without common factors, roots out of the denominator.
    // Errors: bad_input: a denominator is zero; refused: a root of a quotient whose denominator is not
    // proved positive.
    Fraction fraction(const GiNaC::ex& e);
    GiNaC::ex simplified(const GiNaC::ex& e); // the same value
    // yes: the numerator is zero by the relations; no: by ball arithmetic.
    Zero vanishes(const GiNaC::ex& e);
    [[nodiscard]] GiNaC::ex meaning(const GiNaC::ex& e) const; // functions in the place of their symbols
    [[nodiscard]] const std::vector<Generator>& generators() const { return generators_; }

private:
    GiNaC::ex converted(const GiNaC::ex& e, bool in_order = true); // a rational expression in generators
    [[nodiscard]] bool is_known(const GiNaC::ex& e) const;
    GiNaC::ex function(const GiNaC::ex& e);
    GiNaC::ex root(const GiNaC::ex& base, int index);
    GiNaC::ex root_of_polynomial(const GiNaC::ex& base, int index);
    GiNaC::ex root_of_number(const GiNaC::numeric& base, int index);
    GiNaC::ex root_generator(const GiNaC::ex& base, int index);
    struct Unit {
        GiNaC::ex cosine, sine;
    };
    static Unit sum_of(const Unit& u, const Unit& v, bool hyperbolic);
    Unit angle(const GiNaC::ex& argument, bool hyperbolic = false);
    Unit angle_of_term(const GiNaC::ex& term, bool hyperbolic);
    Unit unit_of_arc(const GiNaC::ex& function);
    Unit unit_of_logarithm(const GiNaC::ex& function);
    Unit angle_of_multiple_of_pi(const GiNaC::numeric& multiple);
    // Two generators; their squares differ by 1 (hyperbolic) or have the sum 1.
    Unit circle(const GiNaC::ex& argument, bool hyperbolic = false);
    GiNaC::ex exponential(const GiNaC::ex& argument);
    GiNaC::ex generator(const GiNaC::ex& meaning, const std::string& name, const GiNaC::ex& argument);
    Generator& add(const GiNaC::ex& meaning, std::string text);
    [[nodiscard]] const Generator* find(const GiNaC::ex& meaning) const;
    // The argument of a function with its sign taken out.
    struct Signed {
        int sign;
        GiNaC::ex value;
    };
    Signed signed_argument(const GiNaC::ex& argument);
    [[nodiscard]] Kind kind_of(const GiNaC::ex& meaning) const;
    [[nodiscard]] GiNaC::ex reduced(GiNaC::ex polynomial) const;
    [[nodiscard]] std::vector<GiNaC::symbol> symbols() const; // of generators
    [[nodiscard]] std::vector<PowerRelation> relations() const;
    [[nodiscard]] Fraction quotient(const GiNaC::ex& rational) const; // coprime, lowered
    void make_rational(Fraction& f) const;                            // its denominator
    [[nodiscard]] bool positive(const GiNaC::ex& e) const;
    std::string text_of(const GiNaC::ex& e);

    const System* domain_;
    Place place_;
    std::vector<Generator> generators_;
    GiNaC::exmap known_; // functions and roots, converted
};

} // namespace resonform
