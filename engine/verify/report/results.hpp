// SPDX-License-Identifier: GPL-3.0-or-later
// The results of a scene as they are kept: resonform.results/1 (docs/file_formats.md).
#pragma once

#include "verify/report/findings.hpp"
#include "verify/report/page.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace resonform::report {

// What was found of a scene, the rows of the comparison left out. `timed` = false: the comparison, too.
nlohmann::ordered_json results_of(const Findings& findings, bool timed = true);

// Where the results of a scene differ from those that were kept: verdicts and orders exactly, slopes by 0.01,
// constants by 1 %, ulp by half of them and one; never times. Empty: nowhere.
std::vector<std::string> differences(const nlohmann::ordered_json& kept, const nlohmann::ordered_json& anew);

// One line a scene, in the order given; each is linked as <system>/<scene>/report.md.
Page summary_page(const std::vector<nlohmann::ordered_json>& results);

} // namespace resonform::report
