// SPDX-License-Identifier: GPL-3.0-or-later
// Equations f(y) = t solved for y where y occurs in one part of f, and functions around it have inverses.
//
//   log(y) + x = R  ->  y = exp(R - x)          exp(y) - x = R  ->  y = log(R + x), where R + x > 0 is proved
#pragma once

#include "model/exact/form.hpp"

#include <functional>
#include <optional>
#include <string>

namespace resonform {

struct Inverse {
    std::optional<GiNaC::ex> value;
    std::string obstacle; // without a value: "R + x > 0"; empty: y occurs in parts that are not alike
};

// `positive(e)`: e > 0 is proved where the inverse is used. Inverted are linear functions, rational powers,
// exp, log, the hyperbolic and circular functions and arcs, each on the branch that its domain proves.
Inverse inverse_function(const GiNaC::ex& f, const GiNaC::symbol& y, const GiNaC::ex& t, ExactForm& form,
                         const std::function<bool(const GiNaC::ex&)>& positive);

} // namespace resonform
