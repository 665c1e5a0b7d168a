// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/report/results.hpp"

#include "emit/display/json.hpp"
#include "verify/report/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace resonform::report {

namespace {

using Json = nlohmann::ordered_json;

constexpr double slope_tolerance = 0.01, constant_tolerance = 0.01, ulp_share = 0.5, ulp_more = 1;

// What is compared of results, by names that a reader knows.
struct Compared {
    std::map<std::string, std::string> same; // verdicts, orders
    std::map<std::string, double> slopes, constants, ulps;

    void add(std::map<std::string, double>& numbers, const std::string& name, const Json& value) {
        if (value.is_number()) numbers[name] = value.get<double>();
    }
};

Compared compared(const Json& results) {
    Compared c;
    const Json &verification = results.at("verification"), &stability = results.at("stability");
    for (const Json& o : verification.at("outputs")) {
        const std::string name = o.at("name").get<std::string>();
        for (const char* key : {"verdict", "expected", "claimed_order", "guaranteed_order", "found_order"})
            c.same[fmt::format("{} of {}", key, name)] = o.at(key).dump();
        c.add(c.slopes, "slope of " + name, o.at("slope"));
        c.add(c.constants, "constant of " + name, o.at("constant"));
    }
    const Json& emitted = verification.at("emitted_equals_symbolic");
    c.same["verdict of emitted = symbolic"] = emitted.at("verdict").dump();
    c.add(c.ulps, "ulp of emitted = symbolic", verification.at("emitted_against_symbolic_ulp"));
    c.same["verdict of the stability sweep"] = stability.at("verdict").dump();
    for (const Json& worst : stability.at("worst")) {
        const std::string name = "ulp of the stability sweep, " + worst.at("output").get<std::string>();
        if (c.ulps.count(name) == 0) c.add(c.ulps, name, worst.at("ulp")); // the largest comes first
    }
    return c;
}

template <class Value, class Near>
void add_differences(const std::map<std::string, Value>& kept, const std::map<std::string, Value>& anew,
                     const Near& near, std::vector<std::string>& found) {
    for (const auto& [name, value] : kept) {
        const auto now = anew.find(name);
        if (now == anew.end())
            found.push_back(fmt::format("{}: kept {}, now there is none", name, value));
        else if (!near(value, now->second))
            found.push_back(fmt::format("{}: kept {}, now {}", name, value, now->second));
    }
    for (const auto& [name, value] : anew)
        if (kept.count(name) == 0) found.push_back(fmt::format("{}: none is kept, now {}", name, value));
}

} // namespace

Json results_of(const Findings& f, bool timed) {
    const System& system = *f.scene->system;
    const Origin& o = f.origin;
    Json json{{"schema", "resonform.results/1"},
              {"system", system.name},
              {"scene", f.scene->name},
              {"title", system.title + ": " + f.scene->title},
              {"order", json_rational(system.weight(f.scene->order))},
              {"version", o.version},
              {"commit", o.commit},
              {"date", o.date},
              {"command", o.command},
              {"verification", to_json(f.verification)},
              {"stability", to_json(f.stability)}};
    if (!timed) return json;
    json["comparison"] = to_json(f.comparison);
    for (const char* bulky : {"rows", "by_eps"}) json["comparison"].erase(bulky);
    return json;
}

std::vector<std::string> differences(const Json& kept, const Json& anew) {
    const Compared a = compared(kept), b = compared(anew);
    std::vector<std::string> found;
    const auto within = [](double share, double more) {
        return [=](double x, double y) {
            return std::abs(x - y) <= share * std::max(std::abs(x), std::abs(y)) + more;
        };
    };
    add_differences(
        a.same, b.same, [](const auto& x, const auto& y) { return x == y; }, found);
    add_differences(a.slopes, b.slopes, within(0, slope_tolerance), found);
    add_differences(a.constants, b.constants, within(constant_tolerance, 0), found);
    add_differences(a.ulps, b.ulps, within(ulp_share, ulp_more), found);
    return found;
}

} // namespace resonform::report
