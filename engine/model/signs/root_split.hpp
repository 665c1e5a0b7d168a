// SPDX-License-Identifier: GPL-3.0-or-later
// A sum by one of the roots in it: e = a + b r, where a and b hold even powers of r only.
//
//   sqrt(g^2 + k) - g                  ->  a = -g, b = 1, r^2 = g^2 + k
//   x - x^(1/4)*y + sqrt(x)            ->  a = x + sqrt(x), b = -y, r^2 = sqrt(x)
#pragma once

#include <ginac/ginac.h>

#include <optional>

namespace resonform {

struct RootSplit {
    GiNaC::ex a, b;
    GiNaC::ex square;   // r^2
    GiNaC::ex radicand; // what r is a root of

    // a^2 - b^2 r^2, expanded; nullopt: of more operands.
    [[nodiscard]] std::optional<GiNaC::ex> norm(std::size_t most_operands) const;
};

// Of e times a power of r, by a root of even index that stands in no other root; nullopt: there is none, or
// it stands in a denominator or a function. e is expanded.
std::optional<RootSplit> split_by_root(const GiNaC::ex& e);

} // namespace resonform
