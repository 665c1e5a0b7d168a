// SPDX-License-Identifier: GPL-3.0-or-later
// A sweep as a picture: of its first output, at the last time (or of the first quantity; of errors the
// logarithm), a line over one axis or a colour over two.
#pragma once

#include "verify/sweep/folder.hpp"

#include <filesystem>
#include <string>

namespace resonform {

// Refuses what cannot be drawn. Errors (bad_input): a sample; axes with several values that are not one or
// two; a list that is not monotone; no gnuplot.
void require_map(const SweepGrid& grid);

// An SVG file. Of an axis with more than 200 values so many, evenly picked, its ends included, are drawn.
// Precondition: require_map, and all blocks are there. Errors: those of to_svg.
std::string sweep_map(const SweepFolder& folder, const SweepSubject& subject, const SweepGrid& grid,
                      const SweepSize& size, const std::filesystem::path& scratch);

} // namespace resonform
