// SPDX-License-Identifier: GPL-3.0-or-later
// F.parts/: the blocks of a sweep that have been computed, each in a file that is there whole or not at all,
// and sweep.json, which says what they are of. Any number of programs may work on it, on any machines that
// see the folder.
#pragma once

#include "verify/sweep/size.hpp"
#include "verify/sweep/subject.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace resonform {

struct SweepBlock {
    std::vector<double> numbers;       // [point][row][column]
    std::vector<unsigned char> status; // [point][row]
    double seconds = 0;                // that it took
};

class SweepFolder {
public:
    // Makes the folder for this subject, or finds it. Errors (bad_input): it holds blocks of another subject;
    // it cannot be written.
    SweepFolder(std::filesystem::path path, const Json& subject);

    // What the folder is of. Errors (bad_input): it is no such folder.
    static Json read_subject(const std::filesystem::path& path);

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    // nullopt: it is not there, or was cut or changed. Errors (bad_input): it is of another subject.
    [[nodiscard]] std::optional<SweepBlock> load(std::uint64_t b, const SweepSize& size) const;
    // Errors (bad_input): it cannot be written.
    void store(std::uint64_t b, const SweepBlock& block) const;

private:
    [[nodiscard]] std::filesystem::path file_of(std::uint64_t b) const;

    std::filesystem::path path_;
    std::string identity_;
};

} // namespace resonform
