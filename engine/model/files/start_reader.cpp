// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/start_reader.hpp"

#include "algebra/number/error.hpp"
#include "model/system/names.hpp"
#include "model/system/start_names.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/nearest.hpp"
#include "model/text/toml_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace resonform {

namespace {

constexpr std::string_view amplitude_of = "amplitude.";

class StartReader {
public:
    explicit StartReader(const Scene& scene) : scene_(scene), system_(*scene.system) {}

    void read(const TomlNode* table);
    void put_into(Scene& scene) {
        scene.start = std::move(values_);
        scene.at_zero = std::move(at_zero_);
    }

private:
    void add(const TomlEntry& entry);
    void add_mode(const TomlEntry& entry);
    void check_one_left_out();
    void check_domain(const StartValue& value) const;
    void check_fast(const Variable& variable);
    void check_begins(const Variable& variable, const std::string& what) const;
    void check_drift(const Variable& variable) const;
    [[nodiscard]] const StartValue* find(const std::string& canonical) const;
    [[noreturn]] void complain_missing(const std::string& rule, const std::string& canonical) const;
    [[noreturn]] static void complain_both(const StartValue& one, const StartValue& other);

    const Scene& scene_;
    const System& system_;
    std::vector<StartValue> values_;
    std::optional<ModeAtZero> at_zero_;
    std::vector<std::string> left_out_; // beside a mode at 0
};

void StartReader::read(const TomlNode* table) {
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
    if (at_zero_) check_one_left_out();
}

const StartValue* StartReader::find(const std::string& canonical) const {
    const auto found = std::find_if(values_.begin(), values_.end(), [&](const StartValue& value) {
        return canonical_start(value.name, system_) == canonical;
    });
    return found == values_.end() ? nullptr : &*found;
}

void StartReader::add(const TomlEntry& entry) {
    if (entry.key.rfind(amplitude_of, 0) == 0 && is_mode(entry.key.substr(amplitude_of.size()))) {
        add_mode(entry);
        return;
    }
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

void StartReader::add_mode(const TomlEntry& entry) {
    if (at_zero_)
        bad_input({"one mode is 0 at the start",
                   in_quotes(entry.key) + " beside the amplitude of " + at_zero_->mode,
                   "remove one of the two, and give the physical value that it left out", entry.place});
    if (!expression_of(entry.value, scene_.constants()).is_zero())
        bad_value(entry.value,
                  "the amplitude of a mode that decays or grows is 0, or follows from physical values",
                  "write 0, or give physical values of all fast variables instead");
    at_zero_ = {entry.key.substr(amplitude_of.size()), "", entry.place};
}

void StartReader::check_one_left_out() {
    const std::string rule = "a mode that is 0 takes the place of one physical value of the fast variables";
    if (left_out_.empty())
        bad_input(
            {rule, "every value is given", "leave out the one that is to follow from it", at_zero_->place});
    if (left_out_.size() > 1)
        bad_input({rule, fmt::format("no value of {}", fmt::join(left_out_, ", ")),
                   "give all but one of them", at_zero_->place});
    at_zero_->state = left_out_.front();
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

void StartReader::check_fast(const Variable& variable) {
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
    if (constant != nullptr && at_zero_)
        bad_input({"beside a mode that is 0 fast variables start from physical values",
                   in_quotes(constant->name), "give the physical values of " + variable.name,
                   place_of(constant->source)});
    if (wanted.empty() || at_zero_) wanted = physical;
    for (const std::string& name : wanted) {
        if (find(name) != nullptr) continue;
        if (at_zero_) {
            left_out_.push_back(name);
            continue;
        }
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

void read_start(const TomlNode* table, Scene& scene) {
    StartReader reader(scene);
    reader.read(table);
    reader.put_into(scene);
}

} // namespace resonform
