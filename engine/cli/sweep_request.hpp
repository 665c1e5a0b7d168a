// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of `sweep`, read and checked.
#pragma once

#include "cli/command.hpp"
#include "cli/limits.hpp"
#include "verify/sweep/compute.hpp"
#include "verify/sweep/subject.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace resonform {

// Of --output F.npy, or of --gather F.
struct SweepFiles {
    std::filesystem::path stem;   // F
    std::filesystem::path output; // F.npy, F.h5 or F.csv; empty: that of the sweep which is gathered
    std::filesystem::path json, parts;
};
std::filesystem::path with_suffix(const SweepFiles& files, const std::string& suffix);

// Errors (bad_input): an output in HDF5, which this program cannot write, and why.
void require_form(const char* option, const std::filesystem::path& output);

struct SweepRequest {
    std::string scene; // empty: --gather
    std::vector<std::string> over;
    std::optional<SweepSample> sample;
    SweepKind what = SweepKind::values;
    double tolerance = 0;      // of validity
    std::vector<double> times; // empty: the end of the interval
    SweepFiles files;
    std::filesystem::path map; // empty: none
    SweepShare share;          // jobs 0: by default
    DerivationLimits limits;
    std::string format;
};

class SweepOptions {
public:
    explicit SweepOptions(CLI::App& command);
    // Errors (bad_input): a value or a combination that is not one of the help.
    [[nodiscard]] SweepRequest value() const;

private:
    [[nodiscard]] double tolerance(SweepKind what) const;
    [[nodiscard]] SweepShare share() const;
    [[nodiscard]] std::vector<double> times() const;
    [[nodiscard]] std::optional<SweepSample> sample() const;
    [[nodiscard]] SweepFiles files_of_output() const;
    [[nodiscard]] SweepFiles files_to_gather() const;
    void require_alone() const;

    const CLI::App* command_;
    Text scene_;
    Texts over_;
    Text sample_, seed_, what_, tolerance_, times_, output_, map_, jobs_, shard_, gather_;
    FormatOption format_;
    LimitOptions limits_;
};

} // namespace resonform
