// SPDX-License-Identifier: GPL-3.0-or-later
// [verify] of a scene: how its accuracy is put to the test.
#pragma once

#include "model/system/scene_file.hpp"
#include "model/text/toml_tree.hpp"

namespace resonform {

// The plan with every default filled in; `table` is nullptr if the scene has no [verify]. Uses system,
// outputs, order, time_scale and fix of the scene. Errors (bad_input): eps outside 1e-12 ... 0.5 or
// twice, an interval that is not positive, claims or expectations about a name that is no output, ulp outside
// 1 ... 10^6 or a reason for an ulp that is not widened.
VerifyPlan read_verify(const TomlNode* table, const Scene& scene);

} // namespace resonform
