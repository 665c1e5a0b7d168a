// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/verify_reader.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/number.hpp"
#include "model/files/interval_length.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/eps_powers.hpp"
#include "model/text/nearest.hpp"
#include "model/text/toml_values.hpp"

#include <algorithm>

namespace resonform {

namespace {

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

Rational ladder_value(const TomlNode& node) {
    const Rational eps = number_of(node);
    if (to_double(eps) < smallest_eps || to_double(eps) > largest_eps) {
        bad_value(node, eps_rule, "give a small positive number");
    }
    return eps;
}

std::vector<Rational> read_ladder(const TomlNode& node) {
    if (node.type != TomlNode::Type::array || node.items.empty() || node.items.size() > longest_ladder) {
        bad_value(node, "'verify.eps' is an array of 1 ... " + std::to_string(longest_ladder) + " numbers",
                  "write eps = [0.1, 0.05, 0.02]");
    }
    std::vector<Rational> ladder;
    for (const TomlNode& item : node.items) {
        const Rational eps = ladder_value(item);
        if (std::find(ladder.begin(), ladder.end(), eps) != ladder.end()) {
            bad_value(item, "the ladder lists an eps twice", "remove the second");
        }
        ladder.push_back(eps);
    }
    std::sort(ladder.begin(), ladder.end(), [](const Rational& a, const Rational& b) { return a > b; });
    return ladder;
}

void read_interval(const TomlNode* node, const Scene& scene, VerifyPlan& plan) {
    if (node == nullptr) {
        const int held = scene.slow_power();
        const Rational p = scene.system->weight(held);
        plan.interval_text = held == 0 ? "1" : p == 1 ? "1/eps" : "1/" + spell_eps_power(p);
        plan.interval = GiNaC::pow(scene.system->eps, -held);
        return;
    }
    plan.interval = expression_of(*node, scene.constants());
    plan.interval_text = node->text;
    plan.interval_source = node->source;
    const Estimate estimate = scene.estimate(plan.interval);
    if (estimate != Estimate::positive && estimate != Estimate::unknown) {
        if (const std::string why = scene.why_unreal(plan.interval); !why.empty())
            bad_input({"the interval of verification is not a real number for eps > 0",
                       excerpt(node->text) + ", where " + why, "write one such as \"1/eps\"",
                       place_of(node->source)});
        bad_value(*node, "the interval of verification is not positive, or not finite in double precision",
                  "write one such as \"1/eps\"");
    }
}

// At every eps of the ladder, once [fix] gives every parameter in it.
void check_lengths(Scene scene, const VerifyPlan& plan) {
    const GiNaC::ex fixed = scene.fixed(plan.interval);
    for (const Parameter& p : scene.system->parameters)
        if (fixed.has(p.symbol)) return;
    scene.verify = plan;
    for (const Rational& eps : plan.eps) (void)interval_length(scene, eps);
}

void read_ulp(const TomlNode& verify, VerifyPlan& plan) {
    if (const TomlNode* node = verify.find("ulp")) {
        plan.ulp = to_double(number_of(*node));
        if (!(plan.ulp >= 1 && plan.ulp <= largest_ulp))
            bad_value(*node, "'verify.ulp' is a number in 1 ... 1000000", "write ulp = 16, the default");
    }
    const TomlNode* reason = verify.find("ulp_reason");
    if (reason == nullptr) return;
    plan.ulp_reason = line_of(*reason);
    if (plan.ulp <= default_ulp)
        bad_value(*reason, "'verify.ulp_reason' says why 'verify.ulp' is above 16", "remove it");
}

void check_output(const TomlEntry& entry, const Scene& scene) {
    const std::vector<std::string>& outputs = scene.outputs;
    if (std::find(outputs.begin(), outputs.end(), entry.key) != outputs.end()) return;
    bad_input(Reason::name, {"claims and expectations are about outputs of the scene", in_quotes(entry.key),
                             suggest(entry.key, outputs), entry.place});
}

Verdict verdict_of(const TomlNode& node) {
    const std::string verdict = string_of(node);
    for (Verdict v : {Verdict::pass, Verdict::fail, Verdict::undecided}) {
        if (verdict == to_string(v)) return v;
    }
    bad_value(node, "unknown verdict: pass, fail or undecided can be expected",
              suggest(verdict, {"pass", "fail", "undecided"}));
}

// "psi" or "y(x)", each an output.
void check_drawn(const TomlEntry& entry, const Scene& scene) {
    const std::size_t open = entry.key.find('(');
    const bool path = open != std::string::npos && entry.key.back() == ')';
    const std::string over = path ? entry.key.substr(open + 1, entry.key.size() - open - 2) : "";
    const std::string drawn = path ? entry.key.substr(0, open) : entry.key;
    if (scene.wants(drawn) && (!path || scene.wants(over))) return;
    bad_input(Reason::name, {"'verify.figures' is about an output, as psi, or one over another, as \"y(x)\"",
                             in_quotes(entry.key), suggest(drawn, scene.outputs), entry.place});
}

std::vector<int> figure_numbers(const TomlNode& node) {
    constexpr int highest = 1000;
    std::vector<int> numbers;
    for (const TomlNode& item : node.items) {
        const Rational number = number_of(item);
        if (cln::denominator(number) != 1 || number < 1 || number > highest) break;
        numbers.push_back(static_cast<int>(to_double(number)));
    }
    if (numbers.empty() || numbers.size() != node.items.size() || numbers.size() > drawn_eps.size())
        bad_value(node,
                  "figures have whole numbers in 1 ... 1000, the first at eps = 0.1, a second at eps = 0.01",
                  "write psi = [4, 5]");
    return numbers;
}

} // namespace

VerifyPlan read_verify(const TomlNode* table, const Scene& scene) {
    const TomlNode empty;
    const TomlNode& verify = table == nullptr ? empty : *table;
    check_keys(verify, {"interval", "eps", "claim", "expect", "ulp", "ulp_reason", "figures"});
    VerifyPlan plan;
    read_interval(verify.find("interval"), scene, plan);
    const TomlNode* ladder = verify.find("eps");
    plan.eps_given = ladder != nullptr;
    plan.eps = ladder == nullptr ? default_ladder() : read_ladder(*ladder);
    check_lengths(scene, plan);
    for (const std::string& output : scene.outputs) {
        plan.expect[output] = Verdict::pass;
    }
    const auto each = [&](const char* key, auto&& check, auto&& read) {
        const TomlNode* node = verify.find(key);
        if (node == nullptr) return;
        check_table(*node);
        for (const TomlEntry& entry : node->entries) {
            check(entry, scene);
            read(entry);
        }
    };
    each("claim", check_output, [&](const TomlEntry& e) {
        plan.claim[e.key] = held_weight_of(e.value, scene.system->eps_root, 1, highest_claim);
    });
    each("expect", check_output, [&](const TomlEntry& e) { plan.expect[e.key] = verdict_of(e.value); });
    each("figures", check_drawn, [&](const TomlEntry& e) { plan.figures[e.key] = figure_numbers(e.value); });
    read_ulp(verify, plan);
    return plan;
}

} // namespace resonform
