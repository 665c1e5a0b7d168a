// SPDX-License-Identifier: GPL-3.0-or-later
// The program in a folder of its own, with systems/ that a test writes.
#pragma once

#include "support/shell.hpp"

#include <gtest/gtest.h>

#include <string>

namespace resonform::test {

// systems/spring with its scene s below a folder: one oscillator, two weights, three eps, verified in a
// second or two.
inline void write_spring(const std::filesystem::path& folder) {
    write(folder / "systems/spring/system.toml",
          "[system]\nname = \"spring\"\n[variables]\nx = { role = \"fast\" }\n"
          "[equations]\nx = \"x'' + x + x^3 = 0\"\n");
    write(folder / "systems/spring/scenes/s.toml",
          "order = 1\n[start]\namplitude.x = 1\nphase.x = 0\n[verify]\ninterval = 5\n"
          "eps = [0.1, 0.05, 0.02]\n");
}

class Command : public testing::Test {
protected:
    [[nodiscard]] Outcome said(const std::string& command) const {
        return run("resonform " + command, scratch_.path());
    }
    // Of a command that succeeds.
    [[nodiscard]] std::string printed(const std::string& command) const {
        const Outcome outcome = said(command);
        EXPECT_EQ(outcome.code, 0) << command << outcome.err;
        return outcome.out;
    }
    // Code 2, nothing printed, and a message that begins with `message`.
    void expect_bad_input(const std::string& command, const std::string& message) const {
        const Outcome outcome = said(command);
        EXPECT_EQ(outcome.code, 2) << command;
        EXPECT_EQ(outcome.out, "") << command;
        EXPECT_EQ(outcome.err.rfind("resonform: " + message, 0), 0U) << command << "\n" << outcome.err;
    }
    [[nodiscard]] std::string file(const std::string& name) const { return read(scratch_.path() / name); }
    Scratch scratch_;
};

class CommandOfSpring : public Command {
protected:
    CommandOfSpring() { write_spring(scratch_.path()); }
};

class SweepOfSpring : public CommandOfSpring {
protected:
    // In which `sweep WORDS` sweeps the scene.
    [[nodiscard]] Outcome shell(const std::string& commands) const {
        return run("sweep() { resonform sweep systems/spring/scenes/s.toml \"$@\"; }\n" + commands,
                   scratch_.path());
    }
};

} // namespace resonform::test
