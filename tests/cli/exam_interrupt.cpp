// SPDX-License-Identifier: GPL-3.0-or-later
// A signal to the program alone ends the compiler that it started, and leaves no draft.
#include "support/command.hpp"

#include <csignal>

namespace resonform::test {

namespace {

class Interrupt : public CommandOfSpring {
protected:
    Interrupt() {
        // A compiler that begins its output, starts a program of its own, and takes its time.
        write(scratch_.path() / "slow_cxx",
              "#!/bin/bash\nfor last; do :; done\ntouch \"$last\"\nsleep 120 &\necho $! >sleeper\nwait\n");
    }
    // The outcome of a verification that gets the signal while the compiler runs.
    [[nodiscard]] Outcome interrupted(const std::string& signal) const {
        return run("unset RESONFORM_CACHE; chmod +x slow_cxx; set -m\n" // jobs do not ignore SIGINT
                   "CXX=$PWD/slow_cxx resonform verify systems/spring/scenes/s.toml & pid=$!\n"
                   "for i in {1..600}; do [ -s sleeper ] && break; sleep 0.1; done\n"
                   "kill -" +
                       signal +
                       " $pid; wait $pid; echo ended $?\n"
                       "for i in {1..50}; do kill -0 $(cat sleeper) 2>/dev/null || break; sleep 0.1; done\n"
                       "kill -0 $(cat sleeper) 2>/dev/null && { kill $(cat sleeper); echo left; }\n"
                       "ls build/cache | grep -c part\n",
                   scratch_.path());
    }
};

} // namespace

TEST_F(Interrupt, EndsTheCompiler) {
    for (const auto& [name, number] : {std::pair("INT", SIGINT), {"TERM", SIGTERM}, {"HUP", SIGHUP}}) {
        std::filesystem::remove(scratch_.path() / "sleeper");
        EXPECT_EQ(interrupted(name).out, "ended " + std::to_string(128 + number) + "\n0\n") << name;
    }
}

} // namespace resonform::test
