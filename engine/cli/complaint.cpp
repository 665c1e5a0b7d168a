// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/complaint.hpp"

#include "cli/output.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <new>
#include <string_view>

namespace resonform {

namespace {

using Json = nlohmann::ordered_json;

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(shown(text)); }
Json count_or_null(int count) { return count > 0 ? Json(count) : Json(nullptr); }

std::string document(const Error& error) {
    const Diagnostic& d = error.diagnostic();
    const Json json{{"schema", "resonform.error/1"},
                    {"exit_code", static_cast<int>(error.kind())},
                    {"reason", to_string(d.reason, error.kind())},
                    {"rule", shown(d.rule)},
                    {"found", text_or_null(d.value)},
                    {"hint", text_or_null(d.hint)},
                    {"file", text_or_null(d.place.file)},
                    {"line", count_or_null(d.place.line)},
                    {"column", count_or_null(d.place.column)},
                    {"key", text_or_null(d.place.key)}};
    return document_text(json);
}

} // namespace

void say_error(const Error& error) noexcept { say(std::string("resonform: ") + error.what()); }

void tell_error(const Error& error, bool as_json) noexcept {
    say_error(error);
    if (!as_json) return;
    const std::string text = document(error);
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fflush(stdout);
}

bool Complaints::attempt(const std::function<void()>& work) {
    try {
        work();
        return true;
    } catch (const Error& error) {
        say_error(error);
        code = std::max(code, static_cast<int>(error.kind()));
    }
    return false;
}

Error error_of(const std::exception_ptr& failure) {
    try {
        std::rethrow_exception(failure);
    } catch (const Error& error) {
        return error;
    } catch (const std::bad_alloc&) {
        return {ErrorKind::refused,
                {"the memory is exhausted", "", "ask for a lower order", {}, Reason::memory}};
    } catch (const std::exception& unforeseen) {
        return {ErrorKind::refused,
                {"refused, by a fault of the engine that its authors would like to know",
                 unforeseen.what(),
                 "",
                 {},
                 Reason::fault}};
    }
}

bool asks_for_json(int argc, const char* const* argv) {
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word == "--format=json") return true;
        if (word == "--format" && i + 1 < argc && std::string_view(argv[i + 1]) == "json") return true;
    }
    return false;
}

} // namespace resonform
