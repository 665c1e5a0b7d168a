// SPDX-License-Identifier: GPL-3.0-or-later
// The clock of a derivation does not run on for what is printed of it, which has the time again.
#include "cli/watch.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <thread>

namespace resonform {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

void wait(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

TEST(SlowWatch, PrintingHasATimeOfItsOwn) {
    Watch watch({6, none, none, false});
    wait(3.2);
    watch.print();
    wait(3.2);
    watch.finish(); // refuses where both count
}

TEST(SlowWatch, EachTimeIsLimited) {
    const auto derive = [](double deriving, double printing) {
        Watch watch({0.5, none, none, false});
        watch.certified("3");
        wait(deriving);
        watch.print();
        wait(printing);
        watch.finish();
    };
    EXPECT_EXIT(derive(5, 0), testing::ExitedWithCode(3),
                "a derivation takes at most 0.5 s\n  found: weight 3 reached and certified");
    EXPECT_EXIT(
        derive(0, 5), testing::ExitedWithCode(3),
        "printing it takes at most 0.5 s\n  found: weight 3 reached and certified, what is printed under "
        "way");
}

} // namespace
} // namespace resonform
