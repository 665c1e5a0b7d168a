// SPDX-License-Identifier: GPL-3.0-or-later
// One-line spellings of display sums: the text of the command, <e> of its JSON, Python, Maxima. They
// differ in a handful of spellings only; LaTeX has its own printer (latex.hpp).
//
//   -1 * i * sqrt(g) (r^2 + xi^2)^(-1/4) z1 /16
//   text    -I*sqrt(g)/(16*(r^2 + xi^2)^(1/4))*z1
//   JSON    -I*sqrt(g)/(16*(r**2 + xi**2)**(1/4))*z1
//   Maxima  -%i*sqrt(g)/(16*(r^2 + xi^2)^(1/4))*z1
#pragma once

#include "emit/display/display.hpp"

#include <string>

namespace resonform {

struct Spelling {
    const char* power;
    const char* imaginary;
    bool root_of_sums;     // sqrt(r^2 + xi^2), else (r^2 + xi^2)**(1/2); symbols always have sqrt(g)
    bool wrapped_rational; // Rational(1, 4): 1/4 is a float in Python
    std::string (*symbol)(const std::string& name, int primes);
    // of a function that is known by its name: omega''(tau), Derivative(omega(tau), (tau, 2)), ...
    std::string (*derivative)(const std::string& function, int order, const std::string& argument);
    std::string (*integral)(const std::string& integrand, const std::string& variable,
                            const std::string& from, const std::string& to);
};

const Spelling& text_spelling();
const Spelling& json_spelling();
const Spelling& python_spelling(); // names that Python or SymPy own get a trailing "_"
const Spelling& maxima_spelling(); // the same for Maxima

std::string spell(const DisplaySum& sum, const Spelling& spelling);
std::string spell(const DisplayFactor& factor, const Spelling& spelling);

} // namespace resonform
