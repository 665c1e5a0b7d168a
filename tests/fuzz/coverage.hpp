// SPDX-License-Identifier: GPL-3.0-or-later
// What the program can do with random systems: how many are derived, solved and emitted, and by which reasons
// of the closed list (docs/file_formats.md, resonform.error/1) the others are refused. Anything else is a
// fault: bad input of a file that is none, `unsupported`, `fault`, a certificate that does not hold, a crash.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace resonform::test {

struct CoverageOptions {
    std::uint64_t first = 1; // seeds first, first + 1, ... of random_system
    std::size_t systems = 0;
    std::size_t verified = 0; // of those that are emitted and have values for all parameters, evenly spread
    double seconds = 60;      // of processor time, of one system
    double verify_seconds = 600;  // and of a verification, which derives once more
    std::filesystem::path folder; // for a folder of each system, which is removed
};

enum class Outcome { emitted, refused, too_long, fault };

struct Covered {
    std::uint64_t seed = 0;
    std::string roles;
    int order = 0;
    Outcome outcome = Outcome::fault;
    std::string reason;      // of a refusal, a word of the list
    std::string rule;        // of the message
    std::string what;        // the message; of what is too long or crashed, the step under way
    bool has_values = false; // all parameters have one
    double seconds = 0;
    std::string verification; // "" (none), "pass", "undecided", "too long", a reason of the list, or "fault"
};

struct Coverage {
    using Seeds = std::map<std::string, std::vector<std::uint64_t>>;
    std::size_t systems = 0, emitted = 0;
    Seeds refused; // by reason; "too long" among them
    Seeds faults;  // by reason and the first line of the message, without its place
    std::map<std::string, std::size_t> verified;
};

Coverage covered(const CoverageOptions& options, const std::function<void(const Covered&)>& tell);

std::string to_line(const Covered& system);
std::string to_text(const Coverage& coverage);

} // namespace resonform::test
