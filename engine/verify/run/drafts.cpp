// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/run/drafts.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>

namespace resonform {

namespace {

namespace fs = std::filesystem;

std::error_code last_error() { return {errno, std::generic_category()}; }

std::error_code write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t n = write(descriptor, bytes.data(), bytes.size());
        if (n < 0 && errno != EINTR) return last_error();
        if (n > 0) bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    return {};
}

} // namespace

fs::path draft_of(const fs::path& file) { return fs::path(file) += fmt::format(".{}.part", getpid()); }

Drafts::~Drafts() {
    std::error_code ignored;
    for (const auto& [draft, file] : drafts_) fs::remove(draft, ignored);
}

std::error_code Drafts::write(const fs::path& file, std::string_view bytes) {
    const fs::path draft = draft_of(file);
    constexpr mode_t as_usual = 0666;
    const int descriptor = open(draft.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, as_usual);
    if (descriptor < 0) return last_error();
    drafts_.emplace_back(draft, file);
    const std::error_code error = write_all(descriptor, bytes);
    const bool closed = close(descriptor) == 0; // some file systems say only now that there is no room
    return error || closed ? error : last_error();
}

std::error_code Drafts::put_in_place() {
    std::error_code error;
    while (!error && !drafts_.empty()) {
        fs::rename(drafts_.front().first, drafts_.front().second, error);
        if (!error) drafts_.erase(drafts_.begin());
    }
    return error;
}

} // namespace resonform
