// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/sweep/result.hpp"

#include "algebra/number/error.hpp"
#include "model/text/diagnostic.hpp"
#include "runtime/status.hpp"
#include "verify/run/cache.hpp"
#include "verify/run/drafts.hpp"
#include "verify/sweep/hdf5.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <bit>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <system_error>

namespace resonform {

namespace fs = std::filesystem;

namespace {

static_assert(std::endian::native == std::endian::little, "F.npy and F.h5 say so");

// A file that may be larger than the memory: written among the blocks, then put in place. What a kill leaves
// there is removed by the next one that is written.
class Streamed {
public:
    Streamed(const fs::path& folder, fs::path target)
        : draft_(draft_of(folder / "result")), target_(std::move(target)),
          file_(std::fopen(draft_.c_str(), "wbe")) {
        if (file_ == nullptr) fail(errno);
    }
    ~Streamed() {
        if (file_ == nullptr) return;
        (void)std::fclose(file_);
        std::error_code ignored;
        fs::remove(draft_, ignored);
    }
    Streamed(const Streamed&) = delete;
    Streamed& operator=(const Streamed&) = delete;

    void put(const void* bytes, std::size_t length) {
        if (std::fwrite(bytes, 1, length, file_) != length) fail(errno);
    }
    void put(const std::string& text) { put(text.data(), text.size()); }
    // At a place of a file that has been made, with write_hdf5.
    void put_at(std::uint64_t offset, const std::vector<double>& numbers) {
        if (fseeko(file_, static_cast<off_t>(offset), SEEK_SET) != 0) fail(errno);
        put(numbers.data(), numbers.size() * sizeof(double));
    }
    [[nodiscard]] const fs::path& draft() const { return draft_; }
    void put_in_place() {
        if (std::fflush(file_) != 0) fail(errno);
        std::error_code failed;
        fs::rename(draft_, target_, failed);
        if (failed) fail(failed.value());
        (void)std::fclose(std::exchange(file_, nullptr));
    }

private:
    [[noreturn]] void fail(int error) const {
        bad_input(Reason::file,
                  {"the output must be a file in a folder that exists and can be written",
                   std::generic_category().message(error),
                   "free space, or give another path; the blocks are kept", whole_file(target_)});
    }

    fs::path draft_, target_;
    std::FILE* file_;
};

// Padded, so that the numbers begin at a multiple of 64 bytes.
std::string npy_header(const std::vector<std::uint64_t>& shape) {
    constexpr std::size_t prefix = 10, alignment = 64;
    std::string text = fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({},{}), }}",
                                   shape.front(), shape.size() > 1 ? " " : "");
    const std::string others = fmt::format("{}", fmt::join(shape.begin() + 1, shape.end(), ", "));
    text.insert(text.find("), }"), others);
    const std::size_t length = (prefix + text.size() + 1 + alignment - 1) / alignment * alignment - prefix;
    text.resize(length - 1, ' ');
    std::string head("\x93NUMPY\x01\x00", 8);
    head += static_cast<char>(length & 0xff);
    head += static_cast<char>(length >> 8);
    return head + text + "\n";
}

std::vector<std::uint64_t> shape_of(const SweepSubject& subject, const SweepGrid& grid) {
    std::vector<std::uint64_t> shape = grid.shape();
    shape.push_back(subject.rows());
    shape.push_back(subject.outputs.size());
    return shape;
}

void put_numbers(Streamed& out, const SweepBlock& block, const SweepSize& size) {
    for (std::size_t at = 0; at < block.numbers.size(); at += size.columns)
        out.put(&block.numbers[at + 1], (size.columns - 1) * sizeof(double)); // without the time
}

std::string csv_header(const SweepSubject& subject, const SweepGrid& grid) {
    std::string text;
    for (const Axis& axis : grid.axes()) text += axis.name() + ",";
    text += quantities(subject.what).size() > 1 ? "quantity,t" : "t";
    for (const std::string& output : subject.outputs) text += "," + output;
    return text + ",status\n";
}

void put_lines(Streamed& out, const SweepBlock& block, const SweepSize& size, const SweepSubject& subject,
               const SweepGrid& grid, std::uint64_t first) {
    std::string text;
    const std::vector<std::string> names = quantities(subject.what);
    const auto end = std::back_inserter(text);
    for (std::size_t row = 0; row < block.status.size(); ++row) {
        for (const double x : grid.point(first + row / size.rows)) fmt::format_to(end, "{:.17g},", x);
        if (names.size() > 1) text += names[row % size.rows] + ",";
        const double* numbers = &block.numbers[row * size.columns];
        fmt::format_to(end, "{:.17g}", numbers[0]);
        for (std::size_t k = 1; k < size.columns; ++k)
            if (std::isnan(numbers[k]))
                text += ',';
            else
                fmt::format_to(end, ",{:.17g}", numbers[k]);
        fmt::format_to(end, ",{}\n", to_string(static_cast<Status>(block.status[row])));
    }
    out.put(text);
}

// All but the numbers of the points: `values`, and `t` where each point has an end of its own. They are last.
Hdf5Frame hdf5_frame(const SweepSubject& subject, const SweepGrid& grid) {
    Hdf5Frame frame;
    const Json description = subject_json(subject, grid);
    frame.attributes = {{"schema", {"resonform.sweep/1"}},
                        {"version", {description.at("version")}},
                        {"instructions", {description.at("instructions")}},
                        {"system", {subject.system}},
                        {"scene", {subject.scene}},
                        {"what", {description.at("what")}},
                        {"outputs", subject.outputs},
                        {"interval", {subject.interval}}};
    if (const std::vector<std::string> names = quantities(subject.what); !names.empty())
        frame.attributes.push_back({"quantities", names});
    if (subject.what == SweepKind::validity)
        frame.attributes.push_back({"tolerance", {fmt::format("{}", subject.tolerance)}});
    std::vector<std::string> axes;
    for (std::size_t a = 0; a < grid.axes().size(); ++a) {
        axes.push_back(grid.axes()[a].name());
        frame.arrays.push_back({"axes/" + axes.back(), {grid.values(a).size()}, grid.values(a)});
    }
    frame.attributes.push_back({"axes", axes});
    frame.arrays.push_back(subject.times.empty() ? Hdf5Array{"t", grid.shape(), {}}
                                                 : Hdf5Array{"t", {subject.times.size()}, subject.times});
    frame.arrays.push_back({"values", shape_of(subject, grid), {}});
    return frame;
}

// Into a frame whose last arrays, t and values, begin at these offsets.
void put_block(Streamed& out, const SweepBlock& block, const SweepSize& size, const SweepSubject& subject,
               const std::vector<std::uint64_t>& offsets, std::uint64_t first) {
    std::vector<double> ends, values;
    for (std::size_t row = 0; row < block.status.size(); ++row) {
        const auto numbers = block.numbers.begin() + static_cast<std::ptrdiff_t>(row * size.columns);
        if (row % size.rows == 0) ends.push_back(*numbers);
        values.insert(values.end(), numbers + 1, numbers + static_cast<std::ptrdiff_t>(size.columns));
    }
    const std::uint64_t of_point = size.rows * (size.columns - 1);
    if (subject.times.empty()) out.put_at(offsets.end()[-2] + first * sizeof(double), ends);
    out.put_at(offsets.back() + first * of_point * sizeof(double), values);
}

Json axes_json(const SweepGrid& grid) {
    Json axes = Json::array();
    for (std::size_t a = 0; a < grid.axes().size(); ++a)
        axes.push_back({{"name", grid.axes()[a].name()},
                        {"spacing", to_string(grid.axes()[a].spacing())},
                        {"values", grid.values(a)}});
    return axes;
}

} // namespace

SweepTotals read_blocks(const SweepFolder& folder, const SweepSize& size,
                        const std::function<void(std::uint64_t b, const SweepBlock&)>& each) {
    SweepTotals totals;
    for (std::uint64_t b = 0; b < size.blocks(); ++b) {
        const std::optional<SweepBlock> block = folder.load(b, size);
        if (!block && totals.blocks == b) totals.first_missing = b;
        if (!block) continue;
        ++totals.blocks;
        totals.done += size.count(b);
        totals.seconds += block->seconds;
        for (const unsigned char status : block->status) ++totals.statuses[status];
        each(b, *block);
    }
    return totals;
}

SweepTotals write_result(const fs::path& file, const SweepFolder& folder, const SweepSubject& subject,
                         const SweepGrid& grid, const SweepSize& size) {
    const bool table = file.extension() == ".csv", framed = file.extension() == ".h5";
    Streamed out(folder.path(), file);
    std::vector<std::uint64_t> offsets;
    if (framed)
        offsets = write_hdf5(out.draft(), hdf5_frame(subject, grid));
    else
        out.put(table ? csv_header(subject, grid) : npy_header(shape_of(subject, grid)));
    SweepTotals totals = read_blocks(folder, size, [&](std::uint64_t b, const SweepBlock& block) {
        if (framed)
            put_block(out, block, size, subject, offsets, size.first(b));
        else if (table)
            put_lines(out, block, size, subject, grid, size.first(b));
        else
            put_numbers(out, block, size);
    });
    if (totals.blocks < size.blocks()) return totals;
    out.put_in_place();
    remove_abandoned_drafts(folder.path());
    return totals;
}

Json sweep_json(const Json& subject_file, const SweepSubject& subject, const SweepGrid& grid,
                const SweepTotals& totals) {
    Json statuses = Json::object();
    for (const auto& [status, count] : totals.statuses)
        statuses[to_string(static_cast<Status>(status))] = count;
    const std::vector<std::string> names = quantities(subject.what);
    Json json{{"schema", "resonform.sweep/1"},
              {"version", subject_file.at("version")},
              {"instructions", subject_file.at("instructions")},
              {"system", subject.system},
              {"scene", subject.scene},
              {"what", subject_file.at("what")}};
    if (subject.what == SweepKind::validity) json["tolerance"] = subject.tolerance;
    json["axes"] = axes_json(grid);
    json["sample"] = subject_file.at("sample");
    if (names.empty())
        json["t"] = subject.times.empty() ? Json(subject.interval) : Json(subject.times);
    else
        json["quantities"] = names;
    json["outputs"] = subject.outputs;
    json["points"] = grid.points();
    json["done"] = totals.done;
    json["statuses"] = statuses;
    json["seconds"] = totals.seconds;
    return json;
}

} // namespace resonform
