// SPDX-License-Identifier: GPL-3.0-or-later
// Forty random systems are derived, solved and emitted or refused for a reason of the closed list, and five
// are verified. (Two thousand: fuzz_scenes --coverage 2000.)
#include "fuzz/coverage.hpp"

#include <gtest/gtest.h>

namespace resonform::test {
namespace {

TEST(SlowCoverage, HasNoFaults) {
    CoverageOptions options;
    options.first = 140;
    options.systems = 40;
    options.verified = 5;
    options.seconds = 20;
    options.verify_seconds = 60;
    options.folder = std::filesystem::path(RESONFORM_BINARY_DIR) / "test_cache";
    const Coverage all = covered(
        options, [](const Covered& system) { EXPECT_NE(system.outcome, Outcome::fault) << to_line(system); });
    EXPECT_TRUE(all.faults.empty()) << to_text(all);
}

} // namespace
} // namespace resonform::test
