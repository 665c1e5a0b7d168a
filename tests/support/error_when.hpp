// SPDX-License-Identifier: GPL-3.0-or-later
// The error that a call must end with:
//
//   const Error error = error_when([&] { read_scene_text(text, file, systems); });
//   EXPECT_EQ(error.diagnostic().hint, "leave d out");
#pragma once

#include "algebra/number/error.hpp"

#include <gtest/gtest.h>

#include <string>

namespace resonform::test {

// Without one the test fails, and the error is empty. about: told then.
template <class Work> Error error_when(const Work& work, const std::string& about = "") {
    try {
        work();
    } catch (const Error& error) {
        return error;
    }
    ADD_FAILURE() << "there was no error" << (about.empty() ? "" : ": ") << about;
    return {ErrorKind::refused, {}};
}

// What the error says; "" if there is none.
template <class Work> std::string message_when(const Work& work) {
    try {
        work();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

} // namespace resonform::test
