// SPDX-License-Identifier: GPL-3.0-or-later
// Systems and rings whose print is tested.
#pragma once

#include "certify/certificate.hpp"
#include "emit/derive/document.hpp"
#include "normalize/recursion/poincare.hpp"
#include "support/exact.hpp"
#include "support/generators.hpp"
#include "support/system_text.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace resonform::test {

// i, z1, z2, eps, g > 0, r > 0, v, xi, G = g^(1/2), sigma = (xi^2 + r^2)^(1/4)
struct PrintedRing {
    RingPtr ring;
    GeneratorId z1, z2, eps, g, r, v, xi, G, sigma;

    PrintedRing() {
        RingBuilder b;
        Generator first = named(GeneratorKind::fast, "z1"), second = named(GeneratorKind::fast, "z2");
        first.conjugate = 2;
        second.conjugate = 1;
        z1 = b.add(first);
        z2 = b.add(second);
        eps = b.add(named(GeneratorKind::small, "eps"));
        g = b.add(named(GeneratorKind::parameter, "g", true));
        r = b.add(named(GeneratorKind::parameter, "r", true));
        v = b.add(named(GeneratorKind::parameter, "v"));
        xi = b.add(named(GeneratorKind::slow, "xi"));
        G = b.add(root_of("G", 2, b.gen(g)));
        sigma = b.add(root_of("sigma", 4, b.gen(xi, 2) + b.gen(r, 2)));
        ring = b.freeze();
    }

    // The product of powers, reduced.
    [[nodiscard]] Polynomial product(const std::vector<std::pair<GeneratorId, int>>& powers) const {
        Polynomial p = ring->one();
        for (const auto& [id, power] : powers) p = ring->multiply(p, ring->gen(id, power));
        return p;
    }
};

// Normal form and map through weight `through`, with their certificate.
inline std::shared_ptr<const Normalization> certified(std::shared_ptr<const GradedField> field, int through) {
    auto normalization = std::make_shared<Normalization>(normalize_poincare(std::move(field), through));
    normalization->certificate = certify(normalization->normal_form, normalization->map);
    return normalization;
}

inline std::shared_ptr<const Normalization> pendulum(int through) {
    return certified(field_named("almost_holonomic_pendulum"), through);
}

// Names that the script uses, Greek ones, and those with digits and underscores; `word` is one more.
inline std::shared_ptr<const GradedField> field_with_odd_names(const std::string& word) {
    std::string file =
        system_text("odd_names",
                    {{"q", "fast", "q'' + (lambda1 + tau^2)*q + alpha*x_2*q^3 - WORD*eps^2 = 0"},
                     {"sum", "drift", "sum' = WORD*eps*q + x_2*eps*q^2"},
                     {"tau", "slow", "tau' = eps/3"}},
                    "[parameters]\nlambda1 = { positive = true }\nalpha = {}\n"
                    "WORD = { positive = true }\nx_2 = { nonzero = true }\n");
    for (std::size_t at; (at = file.find("WORD")) != std::string::npos;) file.replace(at, 4, word);
    return field_from(file);
}

inline void expect_part(const std::string& document, const std::string& part) {
    EXPECT_NE(document.find(part), std::string::npos) << part << "\nis not in\n" << document;
}

} // namespace resonform::test
