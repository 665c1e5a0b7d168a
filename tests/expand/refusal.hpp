// SPDX-License-Identifier: GPL-3.0-or-later
// A system that is not expanded, and what is said of it.
#pragma once

#include "support/error_when.hpp"
#include "support/exact.hpp"

#include <gtest/gtest.h>

#include <string>

namespace resonform::test {

// The message: of this kind, of at most 2 kB, with its place and its hint.
inline std::string refusal(const std::string& toml, ErrorKind kind) {
    const Error e = error_when([&] { field_from(toml); }, toml);
    EXPECT_EQ(e.kind(), kind) << e.what();
    EXPECT_LE(std::string(e.what()).size(), 2048U);
    EXPECT_FALSE(e.diagnostic().hint.empty());
    EXPECT_NE(std::string(e.what()).find("test/system.toml"), std::string::npos) << e.what();
    return e.what();
}

inline ::testing::AssertionResult has(const std::string& text, const std::string& part) {
    if (text.find(part) != std::string::npos) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << "'" << part << "' is not in: " << text;
}

} // namespace resonform::test
