// SPDX-License-Identifier: GPL-3.0-or-later
// JSON as the contract of the command fixes it (design 6.1): key order kept, numbers with as many of
// 17 digits as it takes to read the same double back, null for NaN and infinities.
#pragma once

#include "algebra/ring/ring.hpp"
#include "model/system/system_file.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace resonform {

using Json = nlohmann::ordered_json;

// NaN and infinities -> null.
Json json_number(double value);
Json json_numbers(const std::vector<double>& values);
// A weight or an exponent of eps: 2, or "3/2" where it is no integer.
Json json_rational(const Rational& value);

// One member of the outermost object per line, arrays of objects with one element per line, everything
// deeper on that line; ends with a newline. Parses to the same value; same bytes on every run.
std::string json_document(const Json& value);

// { "schema", "system" }, and "set", { "g": "1" }, where numbers stand in place of parameters.
Json json_head(const std::string& schema, const System& system);

// { "c": "s/(kappa + s)" }: [equilibrium], as found or given.
Json equilibrium_json(const System& system);

// An exact expression as <e> of design 6.1: "-v*xi/(4*(r**2 + xi**2))". Parses in SymPy.
std::string json_expression(const Ring& ring, const Polynomial& p);

// { "z1": 1, "eps": 2 }: the exponents of `outer` in a monomial, zeros left out.
Json json_exponents(const Ring& ring, const Monomial& monomial, const std::vector<GeneratorId>& outer);

// As the user counts it.
Json json_weight(const Ring& ring, const Monomial& monomial);

// Appends { variable, exponents, weight, coefficient } for every monomial of p in `outer`, by weight, then
// by exponents ascending.
void append_json_terms(Json& list, const Ring& ring, const std::string& variable, const Polynomial& p,
                       const std::vector<GeneratorId>& outer);

} // namespace resonform
