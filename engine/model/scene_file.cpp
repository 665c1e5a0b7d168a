// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/scene_file.hpp"

#include "model/scene_reader.hpp"
#include "model/start_names.hpp"
#include "model/toml_tree.hpp"

namespace resonform {

const char* to_string(Verdict verdict) {
    switch (verdict) {
    case Verdict::pass: return "pass";
    case Verdict::fail: return "fail";
    case Verdict::undecided: break;
    }
    return "undecided";
}

const StartValue* Scene::start_of(const std::string& canonical) const {
    for (const StartValue& value : start) {
        if (canonical_start(value.name, *system) == canonical) return &value;
    }
    return nullptr;
}

Scene read_scene(const std::filesystem::path& file, const std::filesystem::path& systems) {
    return SceneReader(read_toml(read_text(file), file), file, systems).read();
}

} // namespace resonform
