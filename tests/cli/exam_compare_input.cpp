// SPDX-License-Identifier: GPL-3.0-or-later
// Every mistake on the command line of a comparison: one message, exit code 2, nothing derived.
#include "support/command.hpp"

namespace resonform::test {

namespace {

class CompareInput : public CommandOfSpring {
protected:
    void expect_message(const std::string& words, const std::string& message) const {
        expect_bad_input("compare systems/spring/scenes/s.toml " + words, message);
    }
};

} // namespace

TEST_F(CompareInput, Options) {
    expect_message("--tasks dens", "--tasks: must be one of final, dense, grid, ensemble\n  found: dens\n"
                                   "  hint:  did you mean dense?\n");
    expect_message("--tasks final,", "--tasks: must be one of final, dense, grid, ensemble\n  found: ''\n");
    expect_message("--tasks grid,grid", "--tasks: each name must be given once\n  found: grid,grid\n"
                                        "  hint:  leave out the second grid\n");
    for (const char* points : {"0", "1", "10000001", "1e6", "-5"})
        expect_message(std::string("--points ") + points,
                       "--points: must be an integer from 2 to 10000000\n  found: " + std::string(points));
    expect_message("--points 1000,1000", "--points: each number must be given once\n");
    expect_message("--tasks final --points 1000",
                   "--points: must be given with --tasks dense\n  found: 1000\n");
    for (const char* orders : {"0", "64", "x"})
        expect_message(std::string("--orders 1,") + orders,
                       "--orders: must be an integer from 1 to 63\n  found: " + std::string(orders) +
                           "\n  hint:  give for example --orders 3\n");
    expect_message("--orders 2,1,2", "--orders: each number must be given once\n");
    for (const char* members : {"0", "10000001"})
        expect_message(std::string("--tasks ensemble --members ") + members,
                       "--members: must be an integer from 1 to 10000000\n");
    expect_message("--members 10", "--members: must be given with --tasks ensemble\n  found: 10\n");
    for (const char* repetitions : {"0", "1001"})
        expect_message(std::string("--repetitions ") + repetitions,
                       "--repetitions: must be an integer from 1 to 1000\n");
    expect_message("--format xml", "--format: must be one of text, json, csv\n");
}

TEST_F(CompareInput, OrdersWithinATruncationThatIsGiven) {
    write(scratch_.path() / "systems/spring/scenes/s.toml",
          "order = 1\ntruncation = 2\n[start]\namplitude.x = 1\nphase.x = 0\n[verify]\ninterval = 5\n");
    expect_message("--orders 2,3",
                   "--orders: orders must not exceed the truncation = 2 that the scene gives\n  found: 3\n");
}

} // namespace resonform::test
