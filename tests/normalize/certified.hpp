// SPDX-License-Identifier: GPL-3.0-or-later
// Systems on which the certificate and the inverse map are tried, and ways to lie about them.
#pragma once

#include "certify/certificate.hpp"
#include "normalize/recursion/named_series.hpp"
#include "normalize/recursion/poincare.hpp"
#include "normalize/styles/normalize.hpp"
#include "support/exact.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace resonform::test {

inline std::string oscillator_file(const std::string& equation, const std::string& more_variables = "",
                                   const std::string& more_equations = "",
                                   const std::string& parameters = "") {
    return "[system]\nname = \"test\"\n[parameters]\n" + parameters +
           "[variables]\nx = { role = \"fast\" }\n" + more_variables + "[equations]\nx = \"" + equation +
           "\"\n" + more_equations;
}

inline std::shared_ptr<const GradedField> duffing() {
    return field_from(oscillator_file("x'' + x + x^3 = 0"));
}

inline std::shared_ptr<const GradedField> pendulum() { return field_named("almost_holonomic_pendulum"); }

inline Certificate certificate_of(const Normalization& n, std::uint64_t seed = 1) {
    return certify(n.normal_form, n.map, seed);
}

inline Normalization certified(const std::shared_ptr<const GradedField>& field, int through = 4) {
    Normalization n = normalize(field, through);
    n.certificate = certificate_of(n);
    EXPECT_TRUE(n.certificate.holds) << n.certificate.complaint;
    return n;
}

// The coefficient of a monomial of modes, phases and eps: {{"z1", 2}, {"z2", 1}}.
inline Polynomial coefficient_of(const GradedField& field, const Series& series,
                                 const std::vector<std::pair<std::string, int>>& powers) {
    const Monomial wanted = monomial(*field.ring, powers).terms().front().monomial;
    for (const auto& [key, value] : field.ring->collect(series.total(99), field.outer()))
        if (key == wanted) return value;
    return {};
}

using resonform::all_series;
using resonform::SeriesOfForm;

// Part by part, of two rings with the same generators.
inline void expect_same(Normalization a, Normalization b) {
    const auto left = all_series(a), right = all_series(b);
    ASSERT_EQ(left.size(), right.size());
    for (std::size_t k = 0; k < left.size(); ++k)
        for (int n = 0; n <= a.map.through; ++n)
            EXPECT_EQ(left[k].series->part(n), right[k].series->part(n)) << left[k].name << ", " << n;
}

} // namespace resonform::test
