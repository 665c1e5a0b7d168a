// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate of a slow flow holds of the true one, and of none with another sign somewhere.
#include "solve/flow/named_parts.hpp"
#include "solve/flow_certificate.hpp"
#include "solve/line.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <ostream>
#include <utility>

using namespace resonform;
using namespace resonform::testing;

namespace {

struct Asked {
    const char* system;
    SolveOptions options;
};

std::string name_of(const Asked& asked) {
    return std::string(asked.system) + (asked.options.transients ? "" : "_on_the_manifold") +
           (asked.options.growing == Growing::project ? "_projected" : "");
}

void PrintTo(const Asked& asked, std::ostream* out) { *out << name_of(asked); }

Solution solved(const Asked& asked) {
    return solution_of(
        read_system(std::string(RESONFORM_SOURCE_DIR) + "/systems/" + asked.system + "/system.toml"),
        asked.options);
}

class ASlowFlowsCertificate : public ::testing::TestWithParam<Asked> {};

TEST_P(ASlowFlowsCertificate, HoldsAndBites) {
    const Solution solution = solved(GetParam());
    ASSERT_NE(solution.flow, nullptr);
    EXPECT_EQ(flow_complaint(solution), "");
    int told = 0;
    for (const NamedPart<SlowFlow>& part : named_parts(*solution.flow))
        for (const Term& term : part.truth.terms()) {
            Solution lying = solution;
            SlowFlow flow = *solution.flow;
            part.put(flow, part.truth - Rational(2) * Polynomial::from_terms({term}));
            lying.flow = std::make_shared<const SlowFlow>(std::move(flow));
            EXPECT_NE(flow_complaint(lying), "") << part.name;
            ++told;
        }
    EXPECT_GE(told, 4);
}

constexpr SolveOptions with(int order, int truncation, bool transients = true,
                            Growing growing = Growing::status) {
    SolveOptions options;
    options.order = order;
    options.truncation = truncation;
    options.transients = transients;
    options.growing = growing;
    return options;
}

INSTANTIATE_TEST_SUITE_P(
    Systems, ASlowFlowsCertificate,
    ::testing::Values(Asked{"nonholonomic_particle", with(1, 2)}, Asked{"van_der_pol", with(2, 3)},
                      Asked{"spring_pendulum", with(2, 3)}, Asked{"rotating_pendulum", with(1, 3)},
                      Asked{"michaelis_menten", with(2, 3)}, Asked{"michaelis_menten", with(2, 3, false)},
                      Asked{"stiff_spring", with(1, 2)}, Asked{"transition_state", with(1, 2)},
                      Asked{"transition_state", with(1, 2, true, Growing::project)},
                      Asked{"delayed_loss", with(1, 2)}),
    [](const auto& test) { return name_of(test.param); });

} // namespace
