// SPDX-License-Identifier: GPL-3.0-or-later
// HDF5 files of a sweep. The library is loaded when a file is asked for, not linked: Debian's drags thirty
// others with it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

// "" or why there can be none: built without HDF5, or the library is not found.
std::string why_no_hdf5();

// The frame of a file: all but the large numbers. Names are paths: "values", "axes/eps".
struct Hdf5Array {
    std::string name;
    std::vector<std::uint64_t> shape;
    std::vector<double> numbers; // empty: room is made, to be filled at the offset that write_hdf5 returns
};
struct Hdf5Frame {
    std::vector<std::pair<std::string, std::vector<std::string>>> attributes; // of the file; one text or many
    std::vector<Hdf5Array> arrays; // float64, little-endian, contiguous
};

// Writes the file and returns the offset of each array in it. Its bytes depend on the frame alone: there are
// no times in it, and the format is the oldest that holds it. Errors (bad_input): it cannot be written;
// why_no_hdf5.
std::vector<std::uint64_t> write_hdf5(const std::filesystem::path& file, const Hdf5Frame& frame);

} // namespace resonform
