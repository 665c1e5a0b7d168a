// SPDX-License-Identifier: GPL-3.0-or-later
// Results that are expensive to compute, kept in files named by a hash of everything they depend on.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace resonform {

// 128 bits as 32 hexadecimal digits (FNV-1a, Fowler, Noll and Vo).
std::string content_hash(std::string_view bytes);

// Written beside its place and renamed, so that nobody ever sees half a file. Makes the folder.
// Errors: bad_input, the folder or the file cannot be written.
void write_atomically(const std::filesystem::path& file, std::string_view bytes);

// Throws the error of write_atomically(); `file` is in the folder.
[[noreturn]] void cache_not_writable(const std::filesystem::path& file, const std::error_code& error);

// Tries to write a megabyte more beside the file, and leaves nothing. Error: why it cannot be.
std::error_code room_beside(const std::filesystem::path& file);

// Drafts, <file>.<pid>.part, of programs that run no more.
void remove_abandoned_drafts(const std::filesystem::path& folder);

// nullopt if there is no such file or it cannot be read.
std::optional<std::string> read_bytes(const std::filesystem::path& file);

// A payload with its length and hash in front: a file that was cut or changed reads as absent.
std::string checked(std::string_view payload);
void store_checked(const std::filesystem::path& file, std::string_view payload);
std::optional<std::string> load_checked(const std::filesystem::path& file);

} // namespace resonform
