// SPDX-License-Identifier: GPL-3.0-or-later
// The JSON of verify, compare and stability (docs/file_formats.md): numbers with 17 digits, null for
// NaN and infinities.
#pragma once

#include "verify/comparison/comparison.hpp"
#include "verify/judging/ladder.hpp"
#include "verify/stability/stability.hpp"

#include <nlohmann/json.hpp>

namespace resonform {

nlohmann::ordered_json to_json(const Verification& verification); // resonform.verification/1
nlohmann::ordered_json to_json(const Comparison& comparison);     // resonform.comparison/1
nlohmann::ordered_json to_json(const Stability& stability);       // resonform.stability/1

} // namespace resonform
