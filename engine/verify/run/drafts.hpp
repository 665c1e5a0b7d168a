// SPDX-License-Identifier: GPL-3.0-or-later
// How files are written: beside their places, and put there when all of them are whole.
#pragma once

#include "verify/run/child.hpp"

#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace resonform {

// <file>.<pid>.part
std::filesystem::path draft_of(const std::filesystem::path& file);

// Nobody ever sees half a file, or some of these without the others; an interruption waits. Drafts that
// were not put in place are removed with the object.
class Drafts {
public:
    Drafts() = default;
    ~Drafts();
    Drafts(const Drafts&) = delete;
    Drafts& operator=(const Drafts&) = delete;

    // Error: it cannot be written.
    [[nodiscard]] std::error_code write(const std::filesystem::path& file, std::string_view bytes);
    [[nodiscard]] std::error_code put_in_place();

private:
    Uninterrupted until_done_;
    std::vector<std::pair<std::filesystem::path, std::filesystem::path>> drafts_; // the draft, its file
};

} // namespace resonform
