// SPDX-License-Identifier: GPL-3.0-or-later
// Normal forms of mechanisms against what is known: the drift of the particle, the catenary's pendulum by two
// files, the adiabatic invariant of a lengthening string.
#include "emit/derive/derive.hpp"
#include "literature/trajectory.hpp"
#include "model/text/toml_tree.hpp"
#include "normalize/certified.hpp"
#include "normalize/styles/normalize.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>

namespace resonform {
namespace {

Normalization form_of(const std::string& system, int order) {
    Normalization n = normalize(test::field_named(system), order);
    n.certificate = test::certificate_of(n);
    return n;
}

// z' = eps*omega*(C2*C3 - C1*C4), with z1 = (C1 - I*C2)*exp(I*omega*t), z3 = (C3 - I*C4)*exp(I*omega*t):
// the rate is I/2*eps*omega*(z1*z4 - z2*z3), and nothing else, neither in the rate nor in the map.
TEST(ParticleOfThePaper, RisesUniformly) {
    const Normalization n = form_of("nonholonomic_particle", 4);
    const GradedField& field = *n.normal_form.field;
    const Ring& ring = *field.ring;
    const Polynomial half = test::coefficient(field, "sqrt(c/m)/2", true);
    const Polynomial rise = ring.multiply(half, test::monomial(ring, {{"z1", 1}, {"z4", 1}, {"eps", 1}}) -
                                                    test::monomial(ring, {{"z2", 1}, {"z3", 1}, {"eps", 1}}));
    Polynomial rate, map;
    for (int k = 0; k <= 4; ++k) {
        rate = rate + n.normal_form.drift.at(0).part(k);
        map = map + n.map.drift.at(0).part(k);
        for (const Series& mode : n.map.mode) map = map + mode.part(k);
    }
    EXPECT_EQ(rate, rise);
    EXPECT_TRUE(map.empty());
}

// The file with (15) and the one with the mechanism give the same bytes, but for the name.
TEST(PendulumOfThePaper, IsTheSameFromItsMechanism) {
    for (const int order : {3, 5}) {
        const auto json = [&](const std::string& name) {
            return std::regex_replace(json_document(normal_form_json(form_of(name, order), order)),
                                      std::regex("\"" + name + "\""), "\"the pendulum\"");
        };
        EXPECT_EQ(json("almost_holonomic_pendulum"), json("pendulum_mechanism"));
    }
}

// E/omega with E = m*g*l*amplitude^2/2 is constant: the amplitude goes as l^(-3/4).
TEST(LengtheningPendulum, HasItsAdiabaticInvariant) {
    const Normalization n = form_of("lengthening_pendulum", 3);
    EXPECT_EQ(test::coefficient_of(*n.normal_form.field, n.normal_form.mode.at(0), {{"z1", 1}, {"eps", 1}}),
              test::coefficient(*n.normal_form.field, "-3*v/(4*l)"));
}

// With the velocity along the edge for a variable, in the place of x', the modes have the same rates as far
// as these do not depend on the choice of variables.
TEST(SteeredKnifeEdge, IsTheSameInQuasiVelocities) {
    std::string file =
        read_text(std::filesystem::path(RESONFORM_SOURCE_DIR) / "systems/steered_knife_edge/system.toml");
    const auto insert = [&](const std::string& before, const std::string& text) {
        file.insert(file.find(before), text);
    };
    insert("[energy]",
           "[quasi_velocities]\nu = \"x'*cos(eps*theta) + y'*sin(eps*theta)\"\nw = \"theta'\"\n\n");
    insert("[coordinates]", "u = { role = \"fast\", weight = 0 }\nw = { role = \"fast\", weight = 0 }\n\n");
    const auto rates = [](const Normalization& n) {
        return json_document(normal_form_json(n, 2)["normal_form"]);
    };
    Normalization quasi = normalize(test::field_from(file), 4);
    EXPECT_EQ(rates(quasi), rates(form_of("steered_knife_edge", 2)));
    quasi.certificate = test::certificate_of(quasi);
    EXPECT_TRUE(quasi.certificate.holds);

    const test::Trajectory::Values values = {{"m", 1.5}, {"J", 0.7},   {"c", 2}, {"eps", 0.4},
                                             {"x", 0.3}, {"theta", 1}, {"y", 0}};
    test::Trajectory::Values of_coordinates = values, of_quasi = values;
    of_coordinates.insert({{"x'", std::cos(0.4)}, {"theta'", -0.5}});
    of_quasi.insert({{"u", 1}, {"w", -0.5}}); // x' = u*cos(eps*theta)
    test::Trajectory one(*test::field_named("steered_knife_edge")->first_order, of_coordinates);
    test::Trajectory other(*quasi.normal_form.field->first_order, of_quasi);
    for (int n = 0; n < 200; ++n) {
        one.step(0.01);
        other.step(0.01);
    }
    for (const char* name : {"x", "theta", "y"}) EXPECT_NEAR(one[name], other[name], 1e-9) << name;
}

// <eps*theta*x'>, both of frequency omega: y' = eps*omega/2*Im(conj(z1)*z3) to first order.
TEST(SteeredKnifeEdge, MovesAside) {
    const Normalization n = form_of("steered_knife_edge", 2);
    const GradedField& field = *n.normal_form.field;
    const auto rate = [&](const char* a, const char* b) {
        return test::coefficient_of(field, n.normal_form.drift.at(0), {{a, 1}, {b, 1}, {"eps", 1}});
    };
    EXPECT_EQ(rate("z1", "z4"), test::coefficient(field, "sqrt(c/m)/4", true));
    EXPECT_EQ(rate("z2", "z3"), test::coefficient(field, "-sqrt(c/m)/4", true));
}

} // namespace
} // namespace resonform
