// SPDX-License-Identifier: GPL-3.0-or-later
// The symbols that the text of an expression may use, and the limits on its size.
#pragma once

#include "algebra/number/piecewise_polynomial.hpp"
#include "model/text/function_value.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

// The symbols that a text may use. Primes count derivatives: ("psi", 2) is psi''.
class Scope {
public:
    void define(const std::string& name, const GiNaC::ex& value);
    // The k-th time derivative of a declared variable; using a k that is not defined is an error that names
    // the variable and the largest k.
    void define_derivative(const std::string& name, int primes, const GiNaC::ex& value);
    // A function of the file, omega(tau), omega'(tau): known by its name only, or its value is read in its
    // place.
    void define_function(const std::string& name, std::optional<FunctionValue> value = std::nullopt) {
        functions_[name] = std::move(value);
    }
    // A function that is known by samples: it stands at the symbol `of`, or at a number, where it is one.
    void define_data(const std::string& name, const std::string& of, DataPointer data) {
        functions_[name] = std::nullopt;
        data_[name] = {of, std::move(data)};
    }
    // A name that the file knows, though not here: using it is told by this rule and this hint.
    void withhold(const std::string& name, const std::string& rule, const std::string& hint) {
        withheld_[name] = {rule, hint};
    }
    struct Withheld {
        std::string rule, hint;
    };
    // nullptr: it is not withheld.
    [[nodiscard]] const Withheld* withheld(const std::string& name) const;
    [[nodiscard]] bool is_function(const std::string& name) const { return functions_.count(name) != 0; }
    // nullptr: it is known by its name only.
    [[nodiscard]] const FunctionValue* value_of(const std::string& function) const;
    struct Data {
        std::string of;
        DataPointer samples;
    };
    // nullptr: it is not known by samples.
    [[nodiscard]] const Data* data_of(const std::string& function) const;
    [[nodiscard]] const GiNaC::ex* find(const std::string& name, int primes) const;
    [[nodiscard]] std::vector<std::string> names() const; // for "nearest known"
    [[nodiscard]] bool has_derivatives() const;           // as equations have them

private:
    std::map<std::pair<std::string, int>, GiNaC::ex> values_;
    std::map<std::string, std::optional<FunctionValue>> functions_;
    std::map<std::string, Data> data_;
    std::map<std::string, Withheld> withheld_;
};

// The limits on one expression. All are checked before GiNaC evaluates anything.
struct Limits {
    std::size_t length = 100000; // bytes
    int depth = 200;             // nested parentheses, functions and powers
    int digits = 1000;           // of one number, its decimal exponent included
    int exponent = 1000;         // |numerator|, |denominator| of a numeric exponent
    double bits = 100000;        // of any number that the expression evaluates or expands to
    double terms = 100000;       // of the expression when it is expanded
    double degree = 10000;       // of the expression when it is expanded
};

// The functions of the table, and sqrt, which is read as a power.
const std::vector<std::string>& function_names();

} // namespace resonform
