// SPDX-License-Identifier: GPL-3.0-or-later
// [start] of a scene: where the motion begins.
#pragma once

#include "model/system/scene_file.hpp"
#include "model/text/toml_tree.hpp"

namespace resonform {

// Puts the start values into the scene, in the order of the file; `table` is nullptr if it has no [start].
// Every slow variable, every fast one (amplitude and phase, or value and derivatives), and every drift that
// is an output must be given; beside "amplitude.z2" = 0 all fast ones but for one of their values. Uses
// system, outputs and fix of the scene.
// Errors (bad_input): an unknown name, both kinds of values for one variable, one missing, a slow
// variable outside its declared domain, a value that is not finite. Which modes there are is not known here.
void read_start(const TomlNode* table, Scene& scene);

} // namespace resonform
