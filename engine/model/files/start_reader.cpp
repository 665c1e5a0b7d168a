// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/start_reader.hpp"

#include "algebra/number/error.hpp"
#include "model/system/names.hpp"
#include "model/system/start_names.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/nearest.hpp"
#include "model/text/toml_values.hpp"

#include <algorithm>

namespace resonform {

namespace {

class StartReader {
public:
    explicit StartReader(const Scene& scene) : scene_(scene), system_(*scene.system) {}

    std::vector<StartValue> read(const TomlNode* table);

private:
    void add(const TomlEntry& entry);
    void check_domain(const StartValue& value) const;
    void check_fast(const Variable& variable) const;
    void check_begins(const Variable& variable, const std::string& what) const;
    void check_drift(const Variable& variable) const;
    [[nodiscard]] const StartValue* find(const std::string& canonical) const;
    [[noreturn]] void complain_missing(const std::string& rule, const std::string& canonical) const;
    [[noreturn]] static void complain_both(const StartValue& one, const StartValue& other);

    const Scene& scene_;
    const System& system_;
    std::vector<StartValue> values_;
};

std::vector<StartValue> StartReader::read(const TomlNode* table) {
    if (table != nullptr) check_table(*table);
    const std::vector<TomlEntry> none;
    for (const TomlEntry& entry : table == nullptr ? none : table->entries) {
        const bool kind = entry.key == "amplitude" || entry.key == "phase" || entry.key == "constant";
        if (!kind || entry.value.type != TomlNode::Type::table) {
            add(entry);
            continue;
        }
        // amplitude.psi = 1, without quotes, is a table in TOML.
        for (TomlEntry inner : entry.value.entries) {
            inner.key = entry.key + "." + inner.key;
            add(inner);
        }
    }
    for (const Variable& variable : system_.variables) {
        if (variable.role == Role::fast) check_fast(variable);
        if (variable.role == Role::slow) check_begins(variable, "a slow variable");
        if (variable.role == Role::angle) check_begins(variable, "an angle");
        if (variable.role == Role::drift) check_drift(variable);
    }
    return std::move(values_);
}

const StartValue* StartReader::find(const std::string& canonical) const {
    const auto found = std::find_if(values_.begin(), values_.end(), [&](const StartValue& value) {
        return canonical_start(value.name, system_) == canonical;
    });
    return found == values_.end() ? nullptr : &*found;
}

void StartReader::add(const TomlEntry& entry) {
    const std::string canonical = canonical_start(entry.key, system_);
    if (canonical.empty()) {
        bad_input(Reason::name, {"[start] gives variables or constants of the solution", in_quotes(entry.key),
                                 suggest(entry.key, start_names(system_)), entry.place});
    }
    if (const StartValue* earlier = find(canonical)) {
        bad_input({"the start value is given twice",
                   in_quotes(entry.key) + " and " + in_quotes(earlier->name), "remove one of the two",
                   entry.place});
    }
    StartValue value;
    value.name = entry.key;
    value.value = expression_of(entry.value, scene_.constants());
    value.text = entry.value.text;
    value.source = entry.value.source;
    check_domain(value);
    values_.push_back(std::move(value));
}

void StartReader::check_domain(const StartValue& value) const {
    const Estimate estimate = scene_.estimate(value.value);
    const auto complain = [&](const std::string& rule, const std::string& hint) {
        bad_input({rule, excerpt(value.text), hint, place_of(value.source)});
    };
    if (estimate == Estimate::unbounded) {
        if (const std::string why = scene_.why_unreal(value.value); !why.empty())
            bad_input({"the start value is not a real number for eps > 0",
                       excerpt(value.text) + ", where " + why, "write the real value meant",
                       place_of(value.source)});
        complain("the start value is not finite in double precision", "give a value of moderate size");
    }
    const Variable* variable = system_.variable(value.name);
    if (variable == nullptr) return;
    const std::string rule = "the slow variable " + in_quotes(value.name) + " starts in its declared domain";
    const bool outside = estimate == Estimate::negative || estimate == Estimate::zero;
    if (variable->positive && outside) complain(rule, "give a positive value");
    if (variable->nonzero && estimate == Estimate::zero) complain(rule, "give a value other than zero");
}

void StartReader::check_fast(const Variable& variable) const {
    std::vector<std::string> wanted;
    for (const std::string& kind : constant_kinds(variable.role))
        wanted.push_back(kind + "." + variable.name);
    const StartValue* constant = nullptr;
    for (const std::string& name : wanted) {
        if (constant == nullptr) constant = find(name);
    }
    std::vector<std::string> physical;
    for (int k = 0; k < variable.order; ++k) {
        physical.push_back(variable.jet[static_cast<std::size_t>(k)].get_name());
        const StartValue* value = find(physical.back());
        if (value == nullptr) continue;
        if (constant != nullptr) complain_both(*value, *constant);
        wanted.clear();
    }
    if (wanted.empty()) wanted = physical;
    for (const std::string& name : wanted) {
        if (find(name) != nullptr) continue;
        complain_missing(
            "a fast variable starts from its amplitude and phase, or from its value and derivatives", name);
    }
}

void StartReader::check_begins(const Variable& variable, const std::string& what) const {
    if (find(variable.name) == nullptr) complain_missing(what + " has a start value", variable.name);
}

void StartReader::check_drift(const Variable& variable) const {
    const StartValue* constant = find("constant." + variable.name);
    const StartValue* value = find(variable.name);
    if (constant != nullptr && value != nullptr) complain_both(*value, *constant);
    const std::vector<std::string>& outputs = scene_.outputs;
    const bool output = std::find(outputs.begin(), outputs.end(), variable.name) != outputs.end();
    if (output && constant == nullptr && value == nullptr) {
        complain_missing("an output starts from its value or its constant", "constant." + variable.name);
    }
}

void StartReader::complain_missing(const std::string& rule, const std::string& canonical) const {
    const std::string name = user_start(canonical, system_);
    const bool bare = is_identifier(name);
    bad_input({rule, "no value of " + in_quotes(name),
               "write " + (bare ? name : "\"" + name + "\"") + " = ... under [start]", scene_.start_place});
}

void StartReader::complain_both(const StartValue& one, const StartValue& other) {
    bad_input({"the variable starts both from physical values and from constants",
               in_quotes(one.name) + " and " + in_quotes(other.name), "remove one of the two",
               place_of(one.source)});
}

} // namespace

std::vector<StartValue> read_start(const TomlNode* table, const Scene& scene) {
    return StartReader(scene).read(table);
}

} // namespace resonform
