// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials in some generators of a ring as those of FLINT, and back.
#pragma once

#include "algebra/ring/integer_polynomial.hpp"
#include "algebra/ring/polynomial.hpp"
#include "algebra/ring/ring.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace resonform {

class Translation {
public:
    Translation(const Ring& ring, std::vector<GeneratorId> ids)
        : ring_(ring), ids_(std::move(ids)), context_(ids_.size()) {}

    // p/content(p); nullopt: an exponent is negative.
    [[nodiscard]] std::optional<Packed> packed(const Polynomial& p) const;
    [[nodiscard]] Polynomial unpacked(const Packed& p) const;

private:
    const Ring& ring_;
    std::vector<GeneratorId> ids_;
    PolynomialContext context_;
};

} // namespace resonform
