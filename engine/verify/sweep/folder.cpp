// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/sweep/folder.hpp"

#include "algebra/number/error.hpp"
#include "model/text/diagnostic.hpp"
#include "verify/run/cache.hpp"
#include "verify/run/drafts.hpp"

#include <fmt/format.h>

#include <cstring>
#include <utility>

namespace resonform {

namespace fs = std::filesystem;

namespace {

constexpr const char* subject_file = "sweep.json";

[[noreturn]] void of_another_sweep(const fs::path& file, const std::string& found) {
    bad_input(Reason::file, {"the folder must hold blocks of the same sweep: of scene, grid and version",
                             found, "give another --output, or delete the folder", whole_file(file)});
}

void write_whole(const fs::path& file, const std::string& bytes) {
    Drafts drafts;
    std::error_code failed = drafts.write(file, bytes);
    if (!failed) failed = drafts.put_in_place();
    if (failed)
        bad_input(Reason::file,
                  {"the folder of the blocks must be one that can be written", failed.message(),
                   "free space, or give another --output; what is there is kept", whole_file(file)});
}

} // namespace

SweepFolder::SweepFolder(fs::path path, const Json& subject)
    : path_(std::move(path)), identity_(identity(subject)) {
    std::error_code failed;
    fs::create_directories(path_, failed);
    if (failed || !fs::is_directory(path_))
        bad_input(Reason::file, {"blocks are kept in a folder beside the output",
                                 failed ? failed.message() : "the path exists and is no folder",
                                 "give another --output", whole_file(path_)});
    if (!fs::exists(path_ / subject_file)) write_whole(path_ / subject_file, subject.dump(2) + "\n");
    const std::string key = difference(subject, read_subject(path_));
    if (!key.empty()) of_another_sweep(path_, fmt::format("blocks of another '{}'", key));
}

Json SweepFolder::read_subject(const fs::path& path) {
    const std::optional<std::string> text = read_bytes(path / subject_file);
    Json subject = text ? Json::parse(*text, nullptr, false) : Json();
    if (!subject.is_object() || subject.value("schema", "") != "resonform.sweep_parts/1")
        bad_input(Reason::file, {"the blocks of a sweep must be described by sweep.json beside them",
                                 text ? "no description of a sweep" : "no such file",
                                 "give the --output of a sweep, without its suffix, or sweep anew",
                                 whole_file(path / subject_file)});
    return subject;
}

fs::path SweepFolder::file_of(std::uint64_t b) const { return path_ / fmt::format("{:08}.block", b); }

std::optional<SweepBlock> SweepFolder::load(std::uint64_t b, const SweepSize& size) const {
    const std::optional<std::string> bytes = load_checked(file_of(b));
    if (!bytes) return std::nullopt;
    const std::uint64_t rows = size.count(b) * size.rows, numbers = rows * size.columns;
    if (bytes->compare(0, identity_.size(), identity_) != 0 ||
        bytes->size() != identity_.size() + (1 + numbers) * sizeof(double) + rows)
        of_another_sweep(file_of(b), "a block of another sweep");
    SweepBlock block;
    block.numbers.resize(numbers);
    block.status.resize(rows);
    const char* at = bytes->data() + identity_.size();
    const auto take = [&at](void* to, std::size_t length) {
        std::memcpy(to, at, length);
        at += length;
    };
    take(&block.seconds, sizeof block.seconds);
    take(block.numbers.data(), numbers * sizeof(double));
    take(block.status.data(), rows);
    return block;
}

void SweepFolder::store(std::uint64_t b, const SweepBlock& block) const {
    std::string bytes = identity_;
    const auto put = [&bytes](const void* from, std::size_t length) {
        bytes.append(static_cast<const char*>(from), length);
    };
    put(&block.seconds, sizeof block.seconds);
    put(block.numbers.data(), block.numbers.size() * sizeof(double));
    put(block.status.data(), block.status.size());
    write_whole(file_of(b), checked(bytes));
}

} // namespace resonform
