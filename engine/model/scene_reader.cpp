// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/scene_reader.hpp"

#include "model/names.hpp"
#include "model/start_names.hpp"
#include "model/toml_values.hpp"

#include <algorithm>

namespace resonform {

namespace {

constexpr int highest_order = 99;
constexpr int highest_time_scale = 9;
constexpr int highest_claim = 100;
constexpr std::size_t longest_ladder = 100;

// 0.2, 0.1, 0.05, 0.02, ... 10^-4: 1-2-5 in each decade.
std::vector<Rational> default_ladder() {
    std::vector<Rational> ladder;
    for (int decade = 1; decade <= 1000; decade *= 10) {
        for (int step : {5, 10, 20}) {
            const int inverse = decade * step;
            if (inverse <= 10000) ladder.push_back(Rational(1) / inverse);
        }
    }
    return ladder;
}

Verdict verdict_of(const TomlNode& node) {
    const std::string verdict = string_of(node);
    for (Verdict v : {Verdict::pass, Verdict::fail, Verdict::undecided}) {
        if (verdict == to_string(v)) return v;
    }
    bad_value(node, "an expected verdict is pass, fail or undecided",
              suggest(verdict, {"pass", "fail", "undecided"}));
}

GiNaC::ex exact(const Rational& value) { return GiNaC::numeric(cln::cl_N(value)); }

} // namespace

SceneReader::SceneReader(TomlNode root, const std::filesystem::path& file,
                         const std::filesystem::path& systems)
    : root_(std::move(root)), systems_(systems) {
    scene_.file = file;
    scene_.name = file.stem().string();
}

Scene SceneReader::read() {
    check_keys(root_, {"system", "title", "order", "time_scale", "truncation", "outputs", "oscillating",
                       "fix", "start", "verify"});
    const TomlNode* title = root_.find("title");
    scene_.title = title == nullptr ? scene_.name : string_of(*title);
    if (const TomlNode* oscillating = root_.find("oscillating"))
        scene_.oscillating = boolean_of(*oscillating);
    read_orders();
    find_and_read_system();
    read_outputs();
    read_fix();
    read_start();
    read_verify();
    return std::move(scene_);
}

void SceneReader::find_and_read_system() {
    const TomlNode* name = root_.find("system");
    const std::string given = name == nullptr ? "" : string_of(*name);
    const std::filesystem::path beside =
        std::filesystem::absolute(scene_.file).parent_path().parent_path() / "system.toml";
    std::error_code ignored;
    if (std::filesystem::is_regular_file(beside, ignored)) {
        // Named relative to the scene, so that messages and banners do not depend on where one stands.
        const auto system = std::make_shared<System>(
            read_system((scene_.file.parent_path() / ".." / "system.toml").lexically_normal()));
        if (name != nullptr && given != system->name) {
            bad_value(*name, "a scene names the system of its folder, " + in_quotes(system->name),
                      "write system = \"" + system->name + "\"");
        }
        scene_.system = system;
        return;
    }
    if (name == nullptr) {
        bad_input({"a scene outside the folder of its system names it", "no key 'system'",
                   "write system = \"...\"", whole_file()});
    }
    if (!is_identifier(given)) bad_value(*name, identifier_rule("a system's name"), identifier_mend());
    try {
        scene_.system = std::make_shared<System>(read_system(find_system(given, systems_)));
    } catch (const Error& error) {
        if (!error.diagnostic().place.file.empty()) throw;
        Diagnostic d = error.diagnostic();
        d.place = place_of(name->source);
        bad_input(d);
    }
}

void SceneReader::read_orders() {
    if (const TomlNode* order = root_.find("order")) scene_.order = integer_of(*order, 1, highest_order);
    const TomlNode* time_scale = root_.find("time_scale");
    const TomlNode* truncation = root_.find("truncation");
    if (time_scale != nullptr && truncation != nullptr) {
        bad_value(*truncation, "a scene gives time_scale or truncation, not both", "remove one of the two");
    }
    if (truncation != nullptr) {
        scene_.truncation = integer_of(*truncation, scene_.order, highest_order);
    } else {
        scene_.time_scale = time_scale == nullptr ? 1 : integer_of(*time_scale, 0, highest_time_scale);
    }
}

void SceneReader::read_outputs() {
    std::vector<std::string> known;
    for (const Variable& v : scene_.system->variables) known.push_back(v.name);
    const TomlNode* outputs = root_.find("outputs");
    if (outputs == nullptr) {
        for (const Variable& v : scene_.system->variables) {
            if (v.role != Role::slow) scene_.outputs.push_back(v.name);
        }
        return;
    }
    if (outputs->type != TomlNode::Type::array || outputs->items.empty()) {
        bad_value(*outputs, "'outputs' is an array of variables, not empty",
                  "write outputs = [\"" + known.front() + "\"]");
    }
    for (const TomlNode& item : outputs->items) {
        const std::string name = string_of(item);
        if (scene_.system->variable(name) == nullptr) {
            bad_value(item, "an output is a variable of the system", suggest(name, known));
        }
        if (std::find(scene_.outputs.begin(), scene_.outputs.end(), name) != scene_.outputs.end()) {
            bad_value(item, "an output is listed once", "remove the second");
        }
        scene_.outputs.push_back(name);
    }
}

void SceneReader::read_fix() {
    const TomlNode* fix = root_.find("fix");
    if (fix == nullptr) return;
    check_table(*fix);
    std::vector<std::string> known;
    for (const Parameter& p : scene_.system->parameters) known.push_back(p.name);
    for (const TomlEntry& entry : fix->entries) {
        const Parameter* parameter = scene_.system->parameter(entry.key);
        if (parameter == nullptr) {
            bad_input({"[fix] gives values of parameters", in_quotes(entry.key), suggest(entry.key, known),
                       entry.place});
        }
        const Rational value = number_of(entry.value);
        if (parameter->positive && value <= 0) {
            bad_value(entry.value, "the parameter '" + entry.key + "' is declared positive",
                      "give a positive value");
        }
        if (parameter->nonzero && value == 0) {
            bad_value(entry.value, "the parameter '" + entry.key + "' is declared nonzero",
                      "give a value other than zero");
        }
        scene_.fix.emplace(entry.key, value);
    }
}

void SceneReader::read_start() {
    if (const TomlNode* start = root_.find("start")) {
        check_table(*start);
        for (const TomlEntry& entry : start->entries) {
            const bool kind = entry.key == "amplitude" || entry.key == "phase" || entry.key == "constant";
            if (!kind || entry.value.type != TomlNode::Type::table) {
                add_start_value(entry);
                continue;
            }
            // amplitude.psi = 1, without quotes, is a table in TOML.
            for (TomlEntry inner : entry.value.entries) {
                inner.key = entry.key + "." + inner.key;
                add_start_value(inner);
            }
        }
    }
    check_start_is_complete();
}

void SceneReader::add_start_value(const TomlEntry& entry) {
    const std::string canonical = canonical_start(entry.key, *scene_.system);
    if (canonical.empty()) {
        bad_input({"[start] gives variables or constants of the solution", in_quotes(entry.key),
                   suggest(entry.key, start_names(*scene_.system)), entry.place});
    }
    if (const StartValue* earlier = start_of(canonical)) {
        bad_input({"a start value is given once", in_quotes(entry.key) + " and " + in_quotes(earlier->name),
                   "remove one of the two", entry.place});
    }
    StartValue value;
    value.name = entry.key;
    value.value = expression_of(entry.value, scene_.system->constants());
    value.text = entry.value.text;
    value.source = entry.value.source;
    check_start_domain(value);
    scene_.start.push_back(std::move(value));
}

void SceneReader::check_start_domain(const StartValue& value) const {
    const Variable* variable = scene_.system->variable(value.name);
    if (variable == nullptr) return;
    const GiNaC::ex number = fixed(value.value);
    if (!GiNaC::is_a<GiNaC::numeric>(number)) return;
    const GiNaC::numeric n = GiNaC::ex_to<GiNaC::numeric>(number);
    const bool outside = (variable->positive && !n.is_positive()) || (variable->nonzero && n.is_zero());
    if (!outside) return;
    bad_input({"the slow variable '" + value.name + "' starts in its declared domain", excerpt(value.text),
               variable->positive ? "give a positive value" : "give a value other than zero",
               place_of(value.source)});
}

void SceneReader::check_start_is_complete() const {
    for (const Variable& variable : scene_.system->variables) {
        const std::string& name = variable.name;
        if (variable.role == Role::fast) check_fast_start(variable);
        if (variable.role == Role::slow && !has_start(name)) {
            bad_input({"a slow variable has a start value", "no value of '" + name + "'",
                       "write " + name + " = ... under [start]", whole_file()});
        }
        if (variable.role != Role::drift) continue;
        const std::string constant = "constant." + name;
        if (has_start(constant) && has_start(name)) {
            bad_input({"a variable starts from its physical value or from constants, not both",
                       in_quotes(name) + " and " + in_quotes(start_of(constant)->name),
                       "remove one of the two", place_of(start_of(name)->source)});
        }
        const bool output =
            std::find(scene_.outputs.begin(), scene_.outputs.end(), name) != scene_.outputs.end();
        if (output && !has_start(constant) && !has_start(name)) {
            bad_input({"an output has a start value", "no value of '" + name + "'",
                       "write " + name + " = ... under [start], or its constant", whole_file()});
        }
    }
}

void SceneReader::check_fast_start(const Variable& variable) const {
    std::vector<std::string> constants, physical;
    for (const std::string& kind : constant_kinds(variable.role))
        constants.push_back(kind + "." + variable.name);
    for (int k = 0; k < variable.order; ++k) {
        physical.push_back(variable.jet[static_cast<std::size_t>(k)].get_name());
    }
    const auto given = [this](const std::vector<std::string>& names) {
        return std::count_if(names.begin(), names.end(),
                             [this](const std::string& n) { return has_start(n); });
    };
    if (given(constants) > 0 && given(physical) > 0) {
        const auto first = std::find_if(physical.begin(), physical.end(),
                                        [this](const std::string& n) { return has_start(n); });
        bad_input({"a variable starts from its physical values or from constants, not both",
                   "both kinds for '" + variable.name + "'", "remove one kind",
                   place_of(start_of(*first)->source)});
    }
    const std::vector<std::string>& wanted = given(physical) > 0 ? physical : constants;
    for (const std::string& name : wanted) {
        if (has_start(name)) continue;
        bad_input({"a fast variable starts from its amplitude and phase, or from its value and derivatives",
                   "no value of '" + name + "'",
                   "write \"" + name + "\" = ... under [start]" +
                       (canonical_start(name, *scene_.system) == name ? "" : ", or its name in [notation]"),
                   whole_file()});
    }
}

void SceneReader::read_verify() {
    const TomlNode* verify = root_.find("verify");
    for (const std::string& output : scene_.outputs) {
        scene_.verify.claim[output] = scene_.order + 1;
        scene_.verify.expect[output] = Verdict::pass;
    }
    if (verify != nullptr) check_keys(*verify, {"interval", "eps", "claim", "expect"});
    read_interval(verify == nullptr ? nullptr : verify->find("interval"));
    read_ladder(verify == nullptr ? nullptr : verify->find("eps"));
    if (verify != nullptr) read_claims(*verify);
}

void SceneReader::read_interval(const TomlNode* node) {
    VerifyPlan& plan = scene_.verify;
    const Scope scope = scene_.system->constants();
    if (node == nullptr) {
        const int p = scene_.time_scale.value_or(1);
        plan.interval_text = p == 1 ? "1/eps" : "1/eps^" + std::to_string(p);
        plan.interval = GiNaC::pow(scene_.system->eps, -p);
        return;
    }
    plan.interval = expression_of(*node, scope);
    plan.interval_text = node->text;
    const GiNaC::ex sample = fixed(plan.interval).subs(scene_.system->eps == GiNaC::numeric(1, 10)).evalf();
    if (GiNaC::is_a<GiNaC::numeric>(sample) && !GiNaC::ex_to<GiNaC::numeric>(sample).is_positive()) {
        bad_value(*node, "the interval of verification is positive", "write one such as \"1/eps\"");
    }
}

void SceneReader::read_ladder(const TomlNode* node) {
    VerifyPlan& plan = scene_.verify;
    plan.eps_given = node != nullptr;
    if (node == nullptr) {
        plan.eps = default_ladder();
        return;
    }
    if (node->type != TomlNode::Type::array || node->items.empty() || node->items.size() > longest_ladder) {
        bad_value(*node, "'verify.eps' is an array of 1 ... " + std::to_string(longest_ladder) + " numbers",
                  "write eps = [0.1, 0.05, 0.02]");
    }
    for (const TomlNode& item : node->items) {
        const Rational eps = number_of(item);
        if (eps <= 0 || eps > Rational(1) / 2) {
            bad_value(item, "eps of a ladder lies in 0 < eps <= 0.5", "give a small positive number");
        }
        if (std::find(plan.eps.begin(), plan.eps.end(), eps) != plan.eps.end()) {
            bad_value(item, "eps of a ladder is listed once", "remove the second");
        }
        plan.eps.push_back(eps);
    }
    std::sort(plan.eps.begin(), plan.eps.end(), [](const Rational& a, const Rational& b) { return a > b; });
}

void SceneReader::read_claims(const TomlNode& verify) {
    if (const TomlNode* claim = verify.find("claim")) {
        check_table(*claim);
        for (const TomlEntry& entry : claim->entries) {
            check_output(entry);
            scene_.verify.claim[entry.key] = integer_of(entry.value, 1, highest_claim);
        }
    }
    if (const TomlNode* expect = verify.find("expect")) {
        check_table(*expect);
        for (const TomlEntry& entry : expect->entries) {
            check_output(entry);
            scene_.verify.expect[entry.key] = verdict_of(entry.value);
        }
    }
}

void SceneReader::check_output(const TomlEntry& entry) const {
    const std::vector<std::string>& outputs = scene_.outputs;
    if (std::find(outputs.begin(), outputs.end(), entry.key) != outputs.end()) return;
    bad_input({"claims and expectations are about outputs of the scene", in_quotes(entry.key),
               suggest(entry.key, outputs), entry.place});
}

GiNaC::ex SceneReader::fixed(const GiNaC::ex& value) const {
    GiNaC::exmap values;
    for (const Parameter& p : scene_.system->parameters) {
        const auto found = scene_.fix.find(p.name);
        if (found != scene_.fix.end()) values[p.symbol] = exact(found->second);
    }
    return value.subs(values);
}

Place SceneReader::whole_file() const {
    Place place;
    place.file = scene_.file.string();
    return place;
}

} // namespace resonform
