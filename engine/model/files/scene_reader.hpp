// SPDX-License-Identifier: GPL-3.0-or-later
// From the tree of a scene file to a checked Scene, table by table.
#pragma once

#include "model/system/scene_file.hpp"
#include "model/text/toml_tree.hpp"

namespace resonform {

class SceneReader {
public:
    SceneReader(TomlNode root, const std::filesystem::path& file, const std::filesystem::path& systems);
    Scene read();

private:
    void read_system_of_scene();
    void read_orders();
    void read_outputs();
    [[nodiscard]] std::vector<Setting> settings_of_fix() const;
    void read_fix();
    void read_parts();
    void read_emit();
    [[nodiscard]] static GiNaC::ex fixed_value(const TomlNode& node, const Parameter& parameter);

    TomlNode root_;
    std::filesystem::path systems_;
    Scene scene_;
};

} // namespace resonform
