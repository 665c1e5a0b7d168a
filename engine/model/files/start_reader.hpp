// SPDX-License-Identifier: GPL-3.0-or-later
// [start] of a scene: where the motion begins.
#pragma once

#include "model/system/scene_file.hpp"
#include "model/text/toml_tree.hpp"

namespace resonform {

// The start values in the order of the file; `table` is nullptr if the scene has no [start]. Every
// slow variable, every fast one (amplitude and phase, or value and derivatives), and every drift that
// is an output must be given. Uses system, outputs and fix of the scene.
// Errors (bad_input): an unknown name, both kinds of values for one variable, one missing, a slow
// variable outside its declared domain, a value that is not finite.
std::vector<StartValue> read_start(const TomlNode* table, const Scene& scene);

} // namespace resonform
