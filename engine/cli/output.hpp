// SPDX-License-Identifier: GPL-3.0-or-later
// The two streams of the command. Results go to standard output and must arrive there; messages and progress
// go to standard error and may be lost.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace resonform {

// Opens /dev/null for each standard stream that the caller closed: otherwise the next file to be opened would
// take its number, and messages would be written into that file. To be called first.
void hold_streams();

// Errors (bad_input): standard output is closed, full, or gone.
void print_result(std::string_view text);
// Flushes standard output. Errors: as above. To be called before success is reported.
void finish_results();

// One line on standard error. Never fails: the exit code says what the line would have said.
void say(std::string_view line) noexcept;

template <class... Arguments> void put(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    print_result(fmt::format(format, std::forward<Arguments>(arguments)...));
}

// A JSON document as it is printed. Texts and file names of the user need not be UTF-8.
template <class Json> std::string document_text(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

// One line on the progress of a long command.
void show_progress(const std::string& line);

} // namespace resonform
