// SPDX-License-Identifier: GPL-3.0-or-later
// The content of system.toml, checked, in the order of the file (model/files/read_system.hpp).
#pragma once

#include "algebra/number/number.hpp"
#include "algebra/number/piecewise_polynomial.hpp"
#include "model/system/style.hpp"
#include "model/text/expression.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

enum class Role { fast, angle, slow, drift };
const char* to_string(Role role);

struct Parameter {
    std::string name;
    bool positive = false;
    bool nonzero = false; // implied by positive
    std::string unit;
    GiNaC::symbol symbol;
    Place place; // of its declaration
};

struct Variable {
    std::string name;
    Role role = Role::fast;
    std::string unit;
    bool positive = false, nonzero = false; // slow variables: their domain
    int weight = 0;                         // in units of 1/eps_root; 0 if the variable is not fast
    int order = 1;                          // highest derivative in the equations
    std::vector<GiNaC::symbol> jet;         // x, x', ..., x^(order)
    Place place;
};

struct Equation {
    std::string variable;
    std::string text;
    GiNaC::ex residual; // lhs - rhs, in jets, parameters and eps
    SourceText source;
};

struct Notation { // [notation] name = "amplitude.psi" | "phase.psi" | "constant.x"
    std::string name;
    std::string kind; // "amplitude", "phase", "constant"
    std::string variable;
};

struct Declaration { // [domain] positive = ["1 + tau"]
    GiNaC::ex value;
    std::string text;
    SourceText source;
};

struct NamedFunction { // [functions] omega = { of = ["tau"], positive = true }
    std::string name;
    std::string of; // the parameter or slow variable that it is a function of
    bool positive = false;
    bool nonzero = false;               // implied by positive
    std::optional<FunctionValue> value; // given by a scene: it stands in all expressions of the system
    // Likewise, by samples: the name stands in the expressions, and this is evaluated in its place.
    DataPointer data = nullptr, coarse_data = nullptr; // through every other sample; nullptr: too few
    std::string data_text = {};                        // "spline of degree 5 through 33 points of omega.csv"
    // Likewise, by an object that emitted code is given: where the scene says so.
    std::optional<Place> callable = {};

    // Is it evaluated by its name?
    [[nodiscard]] bool is_opaque() const { return data != nullptr || callable; }
};

// [hamiltonian]: x' = dH/dp, p' = -dH/dx for each pair
struct Hamiltonian {
    GiNaC::ex energy; // in variables, parameters and eps
    std::string text;
    SourceText source;
    // coordinate and momentum: indices into System::variables, in the order of the file
    std::vector<std::pair<std::size_t, std::size_t>> pairs;

    [[nodiscard]] bool has(std::size_t variable) const; // is it one of a pair?
};

// A complex number in parameters and slow variables, as the user wrote it.
struct GivenNumber {
    GiNaC::ex re = 0, im = 0;
    std::string text;
    SourceText source;
};

// [modes] z1 = { eigenvalue = "I*w", u = { x = "1/2", "x'" = "I*w/2" } }: the first of a conjugate pair
// (im != 0), or a real mode.
struct GivenMode {
    struct Entry {
        std::size_t variable; // index into System::variables
        std::size_t primes;
        GivenNumber value;
    };
    std::string name;
    GivenNumber eigenvalue;
    std::vector<Entry> column; // entries that are not given are 0
    Place place;
};
// Calls change(GiNaC::ex&) for real and imaginary part of the eigenvalue and of each entry.
template <class Change> void for_each_part(GivenMode& mode, const Change& change) {
    change(mode.eigenvalue.re);
    change(mode.eigenvalue.im);
    for (GivenMode::Entry& entry : mode.column) {
        change(entry.value.re);
        change(entry.value.im);
    }
}

// [equilibrium] c = "s/(s + kappa)": where a fast variable rests at eps = 0, slow variables frozen.
struct Equilibrium {
    std::size_t variable; // index into System::variables
    GiNaC::ex value;      // in parameters and slow variables: an equilibrium of the equations, proved
    bool wanted = false;  // "solve": the value is yet to be found (no longer so once the file is read)
    SourceText source;
};

struct Derivation; // of the equations (model/mechanics/derivation.hpp)

// A number in place of a parameter, as the user wrote it: an expression in numbers (4/5, 0.8, sqrt(2)).
struct Setting {
    std::string parameter, value;
};

// [relations] k = "J*c/m": a parameter given by others.
struct ParameterRelation {
    std::string parameter, text;
    SourceText source;
};

struct System {
    std::string name, title, source;
    Place name_place;
    std::filesystem::path file; // system.toml; its folder holds scenes/
    std::vector<Parameter> parameters;
    std::vector<Parameter>
        cancelled;                 // of the file, but in no equation of a mechanism, as a mass that cancels
    std::vector<Setting> settings; // of parameters that are no longer among them
    std::vector<ParameterRelation> relations; // likewise
    std::vector<Variable> variables;
    std::vector<Equation> equations;        // one per variable, in the order of variables
    std::optional<Hamiltonian> hamiltonian; // the equations of its pairs are among the equations
    std::vector<NamedFunction> functions;
    std::vector<Notation> notation;
    std::vector<Declaration> positive;    // declared positive
    std::vector<GivenMode> modes;         // empty: they are to be found
    std::vector<Equilibrium> equilibrium; // of the fast variables that do not rest at 0
    Rational near = 0;                    // [normal_form] near: divisors up to this size are not divided by
    Style style = Style::poincare;        // [normal_form] style
    // Of a mechanism, or by a change of variables; nullptr: the equations are those of the file.
    std::shared_ptr<const Derivation> derivation;
    int digits = 0; // of coefficients in numbers (--digits); 0: they are exact
    // Weights are held as integers, in units of 1/eps_root, and the symbol `eps` stands for
    // eps^(1/eps_root), whose weight is that unit: 1 if the file has no weight and no power of eps that is
    // not an integer.
    int eps_root = 1;
    GiNaC::symbol eps{"eps"};

    // A weight as the user counts it.
    [[nodiscard]] Rational weight(int held) const { return Rational(held) / eps_root; }
    // The value of the symbol `eps` where the small parameter of the file has this one.
    [[nodiscard]] GiNaC::ex small_at(const Rational& value) const;
    // The name as documents show it: "pendulum", "pendulum with g = 1, r = 4/5".
    [[nodiscard]] std::string name_with_settings() const;
    // nullptr if there is none of that name.
    [[nodiscard]] const Variable* variable(const std::string& name) const;
    // Where the file declares a variable: the key at least.
    [[nodiscard]] Place place_of(std::size_t variable) const;
    // nullptr: it is measured from 0.
    [[nodiscard]] const Equilibrium* equilibrium_of(std::size_t variable) const;
    [[nodiscard]] const Parameter* parameter(const std::string& name) const;
    // One of the file: in the equations, or cancelled.
    [[nodiscard]] const Parameter* declared_parameter(const std::string& name) const;
    [[nodiscard]] const NamedFunction* function(const std::string& name) const;
    // An expression with the values of data in place of calls at rational numbers in their range.
    [[nodiscard]] GiNaC::ex with_data(const GiNaC::ex& e) const;
    // Whether a function of it is given by samples.
    [[nodiscard]] bool has_data() const;
    // Whether a function of it has values and no formula.
    [[nodiscard]] bool has_opaque_functions() const;
    // The user's name of a constant of the solution, or kind + "_" + variable ("amplitude_psi").
    [[nodiscard]] std::string constant_name(const std::string& kind, const std::string& variable) const;
    // The parameters and eps: the symbols that start values and intervals may contain.
    [[nodiscard]] Scope constants() const;
    // The functions of the file, in the scope of a text.
    void define_functions(Scope& scope) const;
};

} // namespace resonform
