// SPDX-License-Identifier: GPL-3.0-or-later
// Unique C++ identifiers within one scope of emitted code.
#pragma once

#include "algebra/number/piecewise_polynomial.hpp"

#include <set>
#include <string>

namespace resonform {

class CppNames {
public:
    // Starts with the words of C++, its macros and the words of the emitted frame taken.
    CppNames();
    // wish as an identifier, with an underscore behind it if it is taken ("double" -> "double_"); never a
    // macro or one that belongs to the compiler (two underscores, one before a capital).
    std::string unique(const std::string& wish);
    // The next of prefix_1, prefix_2, ...
    std::string numbered(const std::string& prefix);

private:
    std::set<std::string> taken_;
    int last_ = 0;
};

// resonform::generated::<system>::<scene>, where any name of a file is a legal name of a namespace.
std::string cpp_namespace(const std::string& system, const std::string& scene);

// The table of data: "data_omega".
// The member that holds a callable.
std::string cpp_callable_name(const std::string& function);
std::string cpp_data_name(const PiecewisePolynomial& data);

// Whether a character may stand in an identifier, and whether a C++ text uses one, not as a member.
bool cpp_in_word(char c);
bool cpp_mentions(const std::string& text, const std::string& identifier);

// A C++ string literal of ASCII text.
std::string cpp_literal(const std::string& text);

} // namespace resonform
