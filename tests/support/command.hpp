// SPDX-License-Identifier: GPL-3.0-or-later
// The program in a folder of its own, with systems/ that a test writes.
#pragma once

#include "support/shell.hpp"

#include <gtest/gtest.h>

#include <string>

namespace resonform::test {

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
    Scratch scratch_;
};

} // namespace resonform::test
