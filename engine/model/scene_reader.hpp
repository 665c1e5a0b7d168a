// SPDX-License-Identifier: GPL-3.0-or-later
// From the tree of a scene file to a checked Scene, table by table.
#pragma once

#include "model/scene_file.hpp"
#include "model/toml_tree.hpp"

#include <set>

namespace resonform {

class SceneReader {
public:
    SceneReader(TomlNode root, const std::filesystem::path& file, const std::filesystem::path& systems);
    Scene read();

private:
    void find_and_read_system();
    void read_orders();
    void read_outputs();
    void read_fix();
    void read_start();
    void read_verify();

    void add_start_value(const TomlEntry& entry);
    void check_start_domain(const StartValue& value) const;
    void check_start_is_complete() const;
    void check_fast_start(const Variable& variable) const;
    void read_interval(const TomlNode* node);
    void read_ladder(const TomlNode* node);
    void read_claims(const TomlNode& verify);
    void check_output(const TomlEntry& entry) const;
    [[nodiscard]] bool has_start(const std::string& canonical) const {
        return start_of(canonical) != nullptr;
    }
    [[nodiscard]] const StartValue* start_of(const std::string& c) const { return scene_.start_of(c); }
    // An expression with the values of [fix] put in.
    [[nodiscard]] GiNaC::ex fixed(const GiNaC::ex& value) const;
    [[nodiscard]] Place whole_file() const;

    TomlNode root_;
    std::filesystem::path systems_;
    Scene scene_;
};

} // namespace resonform
