// SPDX-License-Identifier: GPL-3.0-or-later
// The unit of a quantity, as powers of base units and of units not known yet.
//
//   "kg*m^2/s^2", "N*m", "J"  ->  { kg: 1, m: 2, s: -2 }
#pragma once

#include "algebra/number/number.hpp"
#include "model/text/toml_tree.hpp"

#include <map>
#include <string>

namespace resonform {

// Base unit, or the name of a symbol with '?' in front -> exponent, not zero.
using Dimension = std::map<std::string, Rational>;

Dimension product(const Dimension& a, const Dimension& b);
Dimension power(const Dimension& a, const Rational& exponent);
Dimension quotient(const Dimension& a, const Dimension& b);
std::string to_string(const Dimension& dimension); // "kg*m^2/s^2"

// A unit as a file has it: SI units, derived ones, and any other names, which are units by themselves.
// Errors (bad_input): no product of rational powers of names.
Dimension read_unit(const std::string& text, const SourceText& source);

// The unit under the key `unit` of a declaration, empty if there is none. Errors: those of read_unit.
std::string unit_of(const TomlNode& table);

// Unknown units, found from equations between units.
class Dimensions {
public:
    static Dimension unknown(const std::string& symbol) { return {{"?" + symbol, 1}}; }
    // With all known units put in.
    [[nodiscard]] Dimension resolved(const Dimension& dimension) const;
    // Learns that two units are equal; false: they are not.
    bool equate(const Dimension& a, const Dimension& b);

private:
    std::map<std::string, Dimension> known_; // the units found so far
};

} // namespace resonform
