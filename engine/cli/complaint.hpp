// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a command that failed: a message on standard error and, with --format json, the document
// resonform.error/1 on standard output.
#pragma once

#include "algebra/number/error.hpp"

#include <exception>
#include <functional>
#include <string>

namespace resonform {

// "resonform: " and the message, on standard error.
void say_error(const Error& error) noexcept;

// The same, and with `as_json` the document: for an error that ends a command before it has printed anything.
// A failure to write is ignored: the exit code still says that something was wrong.
void tell_error(const Error& error, bool as_json) noexcept;

// For a command that goes on after an error: one broken file hides none of the others.
struct Complaints {
    int code = 0; // the worst
    // Runs `work` and prints the Error that it may throw. False: it threw one.
    bool attempt(const std::function<void()>& work);
};

// Any exception as an Error: std::bad_alloc as a lack of memory, all others as a fault of the engine.
Error error_of(const std::exception_ptr& failure);

// Whether --format json stands on the command line, even if the rest cannot be parsed.
bool asks_for_json(int argc, const char* const* argv);

} // namespace resonform
