// SPDX-License-Identifier: GPL-3.0-or-later
// generated/ is what the engine emits today, byte for byte, and a stale file would be seen.
#include "support/shell.hpp"

#include <gtest/gtest.h>

#include <regex>

namespace resonform::test {

namespace {

bool says(const std::string& text, const std::string& pattern) {
    return std::regex_search(text, std::regex(pattern));
}

} // namespace

TEST(Generated, IsUpToDate) {
    const Outcome outcome = run("resonform regenerate --check", RESONFORM_SOURCE_DIR);
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

TEST(Generated, StaleMissingAndOrphanedFilesAreSeen) {
    const Scratch scratch;
    scratch.copy_systems();
    const auto folder = scratch.path() / "generated" / "almost_holonomic_pendulum";
    write(folder / "third_order.hpp", read(folder / "third_order.hpp") + "\n");
    std::filesystem::remove(folder / "xy_only.hpp");
    write(folder / "forgotten.hpp", "");

    const Outcome check = run("resonform regenerate --check", scratch.path());
    EXPECT_EQ(check.code, 1);
    EXPECT_TRUE(says(check.out, "third_order.hpp +out of date")) << check.out;
    EXPECT_TRUE(says(check.out, "xy_only.hpp +missing")) << check.out;
    EXPECT_TRUE(says(check.out, "forgotten.hpp +without a scene")) << check.out;

    std::filesystem::remove(folder / "forgotten.hpp");
    EXPECT_EQ(run("resonform regenerate", scratch.path()).code, 0);
    EXPECT_EQ(read(folder / "xy_only.hpp"), read(std::filesystem::path(RESONFORM_SOURCE_DIR) /
                                                 "generated/almost_holonomic_pendulum/xy_only.hpp"));
}

} // namespace resonform::test
