// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/read_scene.hpp"

#include "model/files/scene_reader.hpp"
#include "model/text/toml_tree.hpp"

namespace resonform {

Scene read_scene(const std::filesystem::path& file, const std::filesystem::path& systems) {
    return read_scene_text(read_text(file), file, systems);
}

Scene read_scene_text(std::string_view toml, const std::filesystem::path& file,
                      const std::filesystem::path& systems) {
    return SceneReader(read_toml(toml, file), file, systems).read();
}

} // namespace resonform
