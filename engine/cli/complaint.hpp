// SPDX-License-Identifier: GPL-3.0-or-later
// What ended a command: a message on standard error and, with --format json, the document
// resonform.error/1 on standard output.
#pragma once

#include "algebra/number/error.hpp"

#include <exception>
#include <functional>
#include <string>

namespace resonform {

// "resonform: " and the message, on standard error.
void say_error(const Error& error) noexcept;

// The same, and with `as_json` the document: for what ends a command that has printed nothing. What cannot
// be written is lost: the exit code says that something was wrong.
void tell_error(const Error& error, bool as_json) noexcept;

// Of a command that goes on: one broken file hides none of the others.
struct Complaints {
    int code = 0; // the worst
    // Runs `work` and prints the Error that it may throw. False: it threw one.
    bool attempt(const std::function<void()>& work);
};

// Any exception as an Error: std::bad_alloc as a lack of memory, all others as a fault of the engine.
Error error_of(const std::exception_ptr& failure);

// --format json stands on the command line, whether or not the rest of it can be understood.
bool asks_for_json(int argc, const char* const* argv);

} // namespace resonform
