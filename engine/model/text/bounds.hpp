// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers between which an expression stays: -1 <= cos(tau) <= 1, 1 <= 2 + cos(tau) <= 3.
#pragma once

#include <ginac/ginac.h>

#include <functional>
#include <optional>

namespace resonform {

// low <= e <= high; absent: no bound is known.
struct Bounds {
    std::optional<GiNaC::numeric> low, high;
};

// For real symbols; nonnegative(e) says what is proved to be >= 0 otherwise.
Bounds bounds_of(const GiNaC::ex& e, const std::function<bool(const GiNaC::ex&)>& nonnegative);

} // namespace resonform
