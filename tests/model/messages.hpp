// SPDX-License-Identifier: GPL-3.0-or-later
// The pendulum's files as a quarry for bad input, and the whole message that an input earns.
#pragma once

#include "model/exact/first_order_system.hpp"
#include "model/files/read_scene.hpp"
#include "model/files/read_system.hpp"
#include "model/system/scene_file.hpp"
#include "model/text/toml_tree.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace resonform {

inline std::filesystem::path source_dir() { return RESONFORM_SOURCE_DIR; }

inline std::filesystem::path pendulum_scene_file() {
    return source_dir() / "systems/almost_holonomic_pendulum/scenes/third_order.toml";
}

inline std::string pendulum_system() {
    return read_text(source_dir() / "systems/almost_holonomic_pendulum/system.toml");
}

inline std::string pendulum_scene() { return read_text(pendulum_scene_file()); }

// `text` with its first `from` replaced; a test that replaces nothing tests nothing.
inline std::string edited(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("nothing to replace: " + from);
    return text.replace(at, from.size(), to);
}

// Reads a system and solves it; "" or the message, its exit code in front.
inline std::string system_message(const std::string& toml) {
    try {
        solve_for_highest(std::make_shared<System>(read_system_text(toml, "system.toml")));
    } catch (const Error& error) {
        return std::to_string(static_cast<int>(error.kind())) + " " + error.what();
    }
    return "";
}

// Reads a scene of the pendulum; its path is cut down to the file's name.
inline std::string scene_message(const std::string& toml) {
    try {
        read_scene_text(toml, pendulum_scene_file(), source_dir() / "systems");
    } catch (const Error& error) {
        std::string message = error.what();
        const std::string path = pendulum_scene_file().string();
        if (message.compare(0, path.size(), path) == 0) message.replace(0, path.size(), "scene.toml");
        return std::to_string(static_cast<int>(error.kind())) + " " + message;
    }
    return "";
}

// One edit of a good file and the message it earns, its exit code in front.
struct BadInput {
    const char* name;
    const char* from;
    const char* to;
    const char* message;
};

inline std::ostream& operator<<(std::ostream& out, const BadInput& bad) { return out << bad.name; }

inline std::string name_of(const testing::TestParamInfo<BadInput>& info) { return info.param.name; }

} // namespace resonform
