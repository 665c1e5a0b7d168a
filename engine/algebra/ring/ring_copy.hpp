// SPDX-License-Identifier: GPL-3.0-or-later
// Copies the generators of a ring into a builder, so that a ring with more of them can be frozen.
#pragma once

#include "algebra/ring/ring.hpp"

#include <string>
#include <vector>

namespace resonform {

class RingCopy {
public:
    // `to` is fresh: it holds the imaginary unit only.
    RingCopy(const Ring& from, RingBuilder& to);

    // Copies one generator; what its radicand and derivatives use must have been copied before.
    // A root may be refined: sigma = rho^factor, rho^(index factor) = radicand, rho with a new name.
    GeneratorId copy(GeneratorId id);
    GeneratorId copy_refined(GeneratorId root, int factor, const std::string& name);
    void copy_all();
    // The slopes of functions, when all that they hold is copied under its own name.
    void copy_slopes();

    // p over the copied generators, written for the builder. No relation is applied.
    [[nodiscard]] Polynomial operator()(const Polynomial& p) const;

private:
    GeneratorId add(Generator g, GeneratorId id, int factor);

    struct Image {
        GeneratorId id = -1;
        int factor = 1;
    };
    const Ring& from_;
    RingBuilder& to_;
    std::vector<Image> images_;
};

// `wanted`, or `wanted` with the fewest underscores appended that no generator has as its name.
std::string fresh_name(const RingBuilder& builder, std::string wanted);

} // namespace resonform
