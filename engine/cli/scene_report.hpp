// SPDX-License-Identifier: GPL-3.0-or-later
// A scene verified, compared and swept, and the files of its report: for `verify` and `results`.
#pragma once

#include "cli/limits.hpp"
#include "cli/locations.hpp"
#include "cli/pipeline.hpp"
#include "verify/judging/ladder.hpp"
#include "verify/report/findings.hpp"
#include "verify/report/origin.hpp"
#include "verify/report/page.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace resonform {

// limits: of the derivations to higher orders that claims and error estimates need.
VerifyOptions verify_options(const CacheFolder& cache, const DerivationLimits& limits);

// `timed` = false: without the comparison.
report::Findings findings_of(const SceneLine& line, Verification verification, const CacheFolder& cache,
                             report::Origin origin, bool timed = true);

// Says on standard error if they cannot.
bool figures_can_be_drawn();

// report.md and figures/*.svg in a folder.
std::vector<TextFile> markdown_files(const std::filesystem::path& folder, const report::Page& page);
// Besides report.html and the numbers of the figures, figures/*.csv.
std::vector<TextFile> report_files(const std::filesystem::path& folder, const report::Page& page);

} // namespace resonform
