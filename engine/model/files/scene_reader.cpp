// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/scene_reader.hpp"

#include "algebra/number/error.hpp"
#include "model/files/heading.hpp"
#include "model/files/read_system.hpp"
#include "model/files/settings.hpp"
#include "model/files/start_domain.hpp"
#include "model/files/start_reader.hpp"
#include "model/files/verify_reader.hpp"
#include "model/system/names.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/enclosure.hpp"
#include "model/text/eps_powers.hpp"
#include "model/text/nearest.hpp"
#include "model/text/toml_values.hpp"
#include "model/text/zero_test.hpp"

#include <algorithm>
#include <map>

namespace resonform {

namespace {

constexpr int highest_order = 99;
constexpr int highest_time_scale = 9;
constexpr std::int64_t bits_of_fixed = 512;

// Values beyond these overflow in double when they are squared and cubed.
bool is_moderate(const RealBall& value) {
    constexpr int decades = 100;
    RealBall size;
    arb_abs(size.get(), value.get());
    return arb_lt(size.get(), RealBall(power_of_ten(-decades), bits_of_fixed).get()) == 0 &&
           arb_gt(size.get(), RealBall(power_of_ten(decades), bits_of_fixed).get()) == 0;
}

template <class Value>
Value word_of(const TomlNode& node, const std::string& rule, const std::map<std::string, Value>& words) {
    const std::string word = string_of(node);
    const auto known = words.find(word);
    if (known != words.end()) return known->second;
    std::vector<std::string> names;
    for (const auto& [name, value] : words) names.push_back(name);
    bad_value(node, rule, suggest(word, names));
}

} // namespace

SceneReader::SceneReader(TomlNode root, const std::filesystem::path& file,
                         const std::filesystem::path& systems)
    : root_(std::move(root)), systems_(systems) {
    scene_.file = file;
    scene_.name = file.stem().string();
    const auto place_of_key = [&](const char* key) {
        const TomlNode* value = root_.find(key);
        Place place = value == nullptr ? whole_file(file) : place_of(value->source);
        place.key = key;
        return place;
    };
    scene_.fix_place = place_of_key("fix");
    scene_.start_place = place_of_key("start");
    scene_.order_place = place_of_key("order");
    scene_.time_scale_place = place_of_key("time_scale");
    scene_.transients_place = place_of_key("transients");
}

Scene SceneReader::read() {
    scene_.title = heading_of_scene(root_, scene_.file).title;
    read_parts();
    read_system_of_scene();
    read_orders();
    read_outputs();
    read_fix();
    read_start(root_.find("start"), scene_);
    check_start_domain(scene_, root_.find("fix"));
    read_emit();
    scene_.verify = read_verify(root_.find("verify"), scene_);
    return std::move(scene_);
}

void SceneReader::read_parts() {
    if (const TomlNode* oscillating = root_.find("oscillating"))
        scene_.oscillating = boolean_of(*oscillating);
    const TomlNode* transients = root_.find("transients");
    scene_.transients = transients == nullptr ? scene_.oscillating : boolean_of(*transients);
    if (scene_.transients && !scene_.oscillating)
        bad_value(*transients, "a scene that does not oscillate has no transients",
                  "remove it, or write oscillating = true");
    const std::map<std::string, Growing> words{{"status", Growing::status}, {"project", Growing::project}};
    if (const TomlNode* growing = root_.find("growing"))
        scene_.growing = word_of(
            *growing, "what grows is followed with a status, or the start is projected: project", words);
    if (const TomlNode* estimate = root_.find("error_estimate"))
        scene_.error_estimate = boolean_of(*estimate);
}

void SceneReader::read_emit() {
    const TomlNode* emit = root_.find("emit");
    if (emit == nullptr) return;
    check_keys(*emit, {"form"});
    const TomlNode* form = emit->find("form");
    if (form == nullptr) return;
    const std::map<std::string, EmitForm> words{{"auto", EmitForm::automatic},
                                                {"atoms", EmitForm::atoms},
                                                {"direct", EmitForm::direct},
                                                {"tables", EmitForm::tables}};
    scene_.form = word_of(
        *form, "many points are computed from tables, from atoms, direct, or as is cheapest: auto", words);
    scene_.form_place = place_of(form->source);
}

void SceneReader::read_system_of_scene() {
    FunctionValues values{root_.find("functions"), whole_file(scene_.file)};
    if (values.table != nullptr) values.place = place_of(values.table->source);
    values.place.key = "functions";
    const TomlNode* name = root_.find("system");
    const std::string given = name == nullptr ? "" : string_of(*name);
    const std::filesystem::path beside =
        std::filesystem::absolute(scene_.file).parent_path().parent_path() / "system.toml";
    std::error_code ignored;
    if (std::filesystem::is_regular_file(beside, ignored)) {
        // Named relative to the scene, so that messages and banners do not depend on where one stands.
        const auto system = std::make_shared<System>(
            read_system((scene_.file.parent_path() / ".." / "system.toml").lexically_normal(),
                        settings_of_fix(), "[fix]", &values));
        if (name != nullptr && given != system->name) {
            bad_value(*name, "a scene names the system of its folder, " + in_quotes(system->name),
                      "write system = \"" + system->name + "\"");
        }
        scene_.system = system;
        return;
    }
    if (name == nullptr) {
        bad_input({"the scene lies outside the folder of its system and does not name it", "no key 'system'",
                   "write system = \"...\"", whole_file(scene_.file)});
    }
    if (!is_identifier(given)) bad_value(*name, identifier_rule("a system's name"), identifier_hint());
    try {
        scene_.system = std::make_shared<System>(
            read_system(find_system(given, systems_), settings_of_fix(), "[fix]", &values));
    } catch (const Error& error) {
        if (!error.diagnostic().place.file.empty()) throw;
        Diagnostic d = error.diagnostic();
        d.place = place_of(name->source);
        bad_input(d);
    }
}

void SceneReader::read_orders() {
    const int root = scene_.system->eps_root;
    const TomlNode* order = root_.find("order");
    scene_.order = order == nullptr ? 3 * root : held_weight_of(*order, root, 1, highest_order);
    const TomlNode* time_scale = root_.find("time_scale");
    const TomlNode* truncation = root_.find("truncation");
    if (time_scale != nullptr && truncation != nullptr) {
        bad_value(*truncation, "the scene gives both time_scale and truncation", "remove one of the two");
    }
    if (truncation != nullptr) {
        scene_.truncation = held_weight_of(*truncation, root, scene_.order, highest_order);
    } else {
        scene_.time_scale =
            time_scale == nullptr ? root : held_weight_of(*time_scale, root, 0, highest_time_scale);
    }
}

void SceneReader::read_outputs() {
    std::vector<std::string> known;
    for (const Variable& v : scene_.system->variables) known.push_back(v.name);
    const TomlNode* outputs = root_.find("outputs");
    if (outputs == nullptr) {
        for (const Variable& v : scene_.system->variables) {
            if (v.role == Role::fast || v.role == Role::drift) scene_.outputs.push_back(v.name);
        }
        if (!scene_.outputs.empty()) return;
        for (const Variable& v : scene_.system->variables)
            if (v.role == Role::slow) scene_.outputs.push_back(v.name);
        return;
    }
    if (outputs->type != TomlNode::Type::array || outputs->items.empty()) {
        bad_value(*outputs, "'outputs' is an array of variables, not empty",
                  "write outputs = [\"" + known.front() + "\"]");
    }
    for (const TomlNode& item : outputs->items) {
        const std::string name = string_of(item);
        const Variable* variable = scene_.system->variable(name);
        if (variable == nullptr) {
            bad_input(Reason::name,
                      {"the output is not a variable of the system", "\"" + excerpt(name) + "\"",
                       suggest(name, known), place_of(item.source)});
        }
        if (variable->role == Role::angle) {
            bad_value(item, "an angle cannot be an output: it is known by its sine and cosine",
                      "remove it from outputs");
        }
        if (std::find(scene_.outputs.begin(), scene_.outputs.end(), name) != scene_.outputs.end()) {
            bad_value(item, "the output is listed twice", "remove the second");
        }
        scene_.outputs.push_back(name);
    }
}

// A number as --set takes it: real, of known sign, and of moderate size.
GiNaC::ex SceneReader::fixed_value(const TomlNode& node, const Parameter& parameter) {
    GiNaC::ex value = expression_of(node, Scope{});
    if (vanishes(value) == Zero::yes) value = 0;
    const std::optional<RealBall> range = enclose(value, {}, bits_of_fixed);
    if (!value.is_zero() && !(range && range->sign() != 0))
        refuse(Reason::undecided,
               {"a fixed value is real, and told from zero by intervals", excerpt(node.text),
                "write it in a simpler form, or as a decimal number", place_of(node.source)});
    if (!value.is_zero() && !is_moderate(*range)) {
        bad_value(node, "the fixed value is neither zero nor between 1e-100 and 1e100 in size",
                  "choose other units");
    }
    const std::string declared = "the parameter '" + parameter.name + "' is declared ";
    if (parameter.positive && !range->is_positive())
        bad_value(node, declared + "positive", "give a positive value");
    if (parameter.nonzero && value.is_zero())
        bad_value(node, declared + "nonzero", "give a value other than zero");
    return value;
}

std::vector<Setting> SceneReader::settings_of_fix() const {
    std::vector<Setting> settings;
    const TomlNode* fix = root_.find("fix");
    if (fix == nullptr) return settings;
    check_table(*fix);
    for (const TomlEntry& entry : fix->entries) settings.push_back({entry.key, entry.value.text});
    return settings;
}

// Of parameters; one that is put in already was held against its declaration then.
void SceneReader::read_fix() {
    const TomlNode* fix = root_.find("fix");
    if (fix == nullptr) return;
    check_table(*fix);
    std::vector<std::string> known;
    for (const auto* list : {&scene_.system->parameters, &scene_.system->cancelled})
        for (const Parameter& p : *list) known.push_back(p.name);
    for (const TomlEntry& entry : fix->entries) {
        const Parameter* parameter = scene_.system->declared_parameter(entry.key);
        if (is_set(*scene_.system, entry.key)) {
            scene_.fix.emplace(entry.key, fixed_value(entry.value, {}));
            continue;
        }
        if (parameter == nullptr) {
            bad_input(Reason::name, {"[fix] gives values of parameters", in_quotes(entry.key),
                                     suggest(entry.key, known), entry.place});
        }
        scene_.fix.emplace(entry.key, fixed_value(entry.value, *parameter));
    }
}

} // namespace resonform
