// SPDX-License-Identifier: GPL-3.0-or-later
// What guaranteed orders and error estimates have in common: both derive more weights than a scene uses, with
// its values under [fix] put in.
#pragma once

#include "algebra/number/error.hpp"
#include "model/system/scene_file.hpp"
#include "solve/neglected.hpp"
#include "solve/solution.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace resonform {

// The solution through an order, with normal form and map through a weight, of a system.
using Derive = std::function<Solution(std::shared_ptr<const System>, int order, int truncation)>;

// The p of an interval that grows as eps^-p, at least what the scene promises; none where no power bounds it.
std::optional<int> time_power(const Scene& scene);

// How the formula of a scene is cut, over times of eps^-time_power.
TruncatedFormula formula_of(const Scene& scene, const Solution& solution, int time_power);

// What the count asks for at another order of the scene, without a `truncation` of its own.
int counted_truncation(const Scene& scene, const Solution& solution, int order);

// Rule and value of an error that ends a derivation, as the reason why something is not known.
std::string told(const Error& error);

} // namespace resonform
