// SPDX-License-Identifier: GPL-3.0-or-later
// Twenty random scenes of the thousand of fuzz_scenes, of all roles and orders, and seven with modes that
// decay, that are quick: emitted code equals 50 digits, the ladders do not fail, and a change planted in each
// is caught.
#include "fuzz/scene_run.hpp"

#include <gtest/gtest.h>

namespace resonform::test {
namespace {

TEST(SlowRandomScenes, AreRight) {
    RunOptions options;
    options.folder = std::filesystem::path(RESONFORM_BINARY_DIR) / "test_cache";
    options.seeds = {2,   4,   7,   9,   15,  16,  17,    18,    20,    21,    22,    28,    32,   37,
                     501, 505, 509, 515, 516, 525, 10000, 10003, 10008, 10011, 10013, 10020, 10022};
    options.seconds = 250;
    options.starts = 10;
    const RunSummary summary = run_scenes(
        options, [](const SceneResult& result) { EXPECT_TRUE(result.wrong.empty()) << to_line(result); });
    EXPECT_EQ(summary.right, 27U) << to_text(summary);
    EXPECT_EQ(summary.caught_by.at("emitted = symbolic"), 20U) << to_text(summary);
    EXPECT_EQ(summary.caught_by.at("certificate"), 7U) << to_text(summary);
    EXPECT_LE(summary.undecided, 3U) << "ladders that say nothing\n" << to_text(summary);
}

} // namespace
} // namespace resonform::test
