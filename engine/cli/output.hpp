// SPDX-License-Identifier: GPL-3.0-or-later
// The two streams of the command. Results go to standard output and must arrive there; what is said on
// the way (messages, progress) goes to standard error and may be lost.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace resonform {

// A stream that was closed by the caller is opened on nothing, before any file can take its number:
// else a message would be written into the user's file. To be called first.
void hold_streams();

// Errors (bad_input): standard output is closed, full, or gone.
void print_result(std::string_view text);
// What is still buffered is written. Errors: as above. To be called before success is reported.
void finish_results();

// One line on standard error. Never fails: the exit code says what the line would have said.
void say(std::string_view line) noexcept;

template <class... Arguments> void put(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    print_result(fmt::format(format, std::forward<Arguments>(arguments)...));
}

// A JSON document as it is printed. What the user wrote, or called a file, need not be UTF-8.
template <class Json> std::string document_text(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

// What a long command is doing.
void show_progress(const std::string& line);

} // namespace resonform
