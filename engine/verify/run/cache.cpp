// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/run/cache.hpp"

#include "algebra/number/error.hpp"
#include "verify/run/drafts.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <system_error>

namespace resonform {

namespace {

__extension__ using UnsignedWide = unsigned __int128;

constexpr std::string_view magic = "resonform cache 1";

std::string header(std::string_view payload) {
    return fmt::format("{} {} {}\n", magic, payload.size(), content_hash(payload));
}

// One that has ended stays in the table of processes until it is waited for, which the first process of many
// a container never does.
bool runs(pid_t process) {
    if (kill(process, 0) != 0 && errno == ESRCH) return false;
    const std::string status = read_bytes(fmt::format("/proc/{}/stat", process)).value_or("");
    const std::size_t name_end = status.rfind(") "); // PID (name) state ..., where a name may hold anything
    return name_end == std::string::npos || status.compare(name_end + 2, 1, "Z") != 0;
}

} // namespace

std::string content_hash(std::string_view bytes) {
    UnsignedWide hash = (UnsignedWide(0x6c62272e07bb0142ULL) << 64) | 0x62b821756295c58dULL;
    constexpr UnsignedWide prime = (UnsignedWide(1) << 88) | 0x13b;
    for (const char c : bytes) {
        hash ^= static_cast<unsigned char>(c);
        hash *= prime;
    }
    return fmt::format("{:016x}{:016x}", static_cast<std::uint64_t>(hash >> 64),
                       static_cast<std::uint64_t>(hash));
}

void cache_not_writable(const std::filesystem::path& file, const std::error_code& error) {
    Place place;
    place.file = file.parent_path().string();
    bad_input(Reason::file,
              {"the folder of cached results can be written", error.message(),
               "make it writable, free space, or set RESONFORM_CACHE to another folder", place});
}

void write_atomically(const std::filesystem::path& file, std::string_view bytes) {
    std::error_code failed;
    std::filesystem::create_directories(file.parent_path(), failed);
    Drafts drafts;
    if (!failed) failed = drafts.write(file, bytes);
    if (!failed) failed = drafts.put_in_place();
    if (failed) cache_not_writable(file, failed);
}

std::error_code room_beside(const std::filesystem::path& file) {
    constexpr std::size_t room = 1 << 20;
    return Drafts().write(std::filesystem::path(file) += ".room", std::string(room, '\0'));
}

void remove_abandoned_drafts(const std::filesystem::path& folder) {
    std::error_code ignored;
    for (std::filesystem::directory_iterator entry(folder, ignored), end; !ignored && entry != end;
         entry.increment(ignored)) {
        const std::filesystem::path& draft = entry->path();
        const std::string owner = draft.stem().extension().string(); // ".1234"
        if (draft.extension() != ".part" || owner.size() < 2) continue;
        const long process = std::strtol(owner.c_str() + 1, nullptr, 10);
        std::error_code failed;
        if (process > 0 && !runs(static_cast<pid_t>(process))) std::filesystem::remove(draft, failed);
    }
}

std::optional<std::string> read_bytes(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) return std::nullopt;
    std::ostringstream bytes;
    bytes << in.rdbuf();
    return bytes.str();
}

std::string checked(std::string_view payload) { return header(payload).append(payload); }

void store_checked(const std::filesystem::path& file, std::string_view payload) {
    write_atomically(file, checked(payload));
}

std::optional<std::string> load_checked(const std::filesystem::path& file) {
    const std::optional<std::string> bytes = read_bytes(file);
    if (!bytes) return std::nullopt;
    const std::size_t end = bytes->find('\n');
    if (end == std::string::npos) return std::nullopt;
    std::string payload = bytes->substr(end + 1);
    if (bytes->compare(0, end + 1, header(payload)) != 0) return std::nullopt;
    return payload;
}

} // namespace resonform
