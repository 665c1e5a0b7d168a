// SPDX-License-Identifier: GPL-3.0-or-later
// One battery of laws for every folder in systems/: adding a system adds it here. Random systems go through
// the same laws in tests/normalize.
#include "certify/certificate.hpp"
#include "emit/derive/derive.hpp"
#include "literature/point_in_doubles.hpp"
#include "model/files/read_system.hpp"
#include "model/files/settings.hpp"
#include "normalize/recursion/inverse_map.hpp"
#include "normalize/styles/normalize.hpp"
#include "support/exact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

namespace resonform {
namespace {

constexpr int largest_weight = 4;

std::vector<std::string> systems() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(test::source_dir() / "systems"))
        if (std::filesystem::exists(entry.path() / "system.toml")) names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
}

std::string text_of(const std::string& name) {
    std::ifstream file(test::source_dir() / "systems" / name / "system.toml");
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

// Through the highest order whose divisors a ring holds.
Normalization normalized(const std::string& toml) {
    for (int order = largest_weight;; --order) {
        try {
            Normalization n = normalize(test::field_from(toml), order);
            n.certificate = certify(n.normal_form, n.map);
            return n;
        } catch (const Error& e) {
            if (order == 1 || e.diagnostic().reason != Reason::size) throw;
        }
    }
}

// Without the equilibrium, which is spelled in the order of the user's names.
std::string json(const Normalization& n) {
    Json document = normal_form_json(n, n.normal_form.through);
    document.erase("equilibrium");
    return document.dump(1);
}

std::string replaced(const std::string& text, const std::string& name, const std::string& by) {
    return std::regex_replace(text, std::regex("\\b" + name + "\\b"), by);
}

class EverySystem : public ::testing::TestWithParam<std::string> {};

TEST_P(EverySystem, IsCertified) {
    const Normalization n = normalized(text_of(GetParam()));
    EXPECT_TRUE(n.certificate.holds) << n.certificate.complaint;
    EXPECT_LE(n.certificate.error_probability, 1e-30);
}

TEST_P(EverySystem, GivesTheSameBytesAgain) {
    EXPECT_EQ(json(normalized(text_of(GetParam()))), json(normalized(text_of(GetParam()))));
}

// What is real stays real: rates and maps of angles, slow and drift variables.
TEST_P(EverySystem, IsReal) {
    const Normalization n = normalized(text_of(GetParam()));
    const Ring& ring = *n.normal_form.field->ring;
    for (const auto* list : {&n.normal_form.angle, &n.normal_form.slow, &n.normal_form.drift, &n.map.angle,
                             &n.map.slow, &n.map.drift})
        for (const Series& series : *list)
            for (int k = 0; k <= series.through(); ++k)
                EXPECT_EQ(ring.conjugate(series.part(k)), series.part(k)) << "weight " << k;
}

// y = Y + g, Y = y + c(y): g + c(Y + g) = 0.
TEST_P(EverySystem, HasAnInverseMap) {
    const Normalization n = normalized(text_of(GetParam()));
    const NearIdentityMap inverse = invert(n.normal_form, n.map);
    const auto check = [&](const std::vector<Series>& g, const std::vector<Series>& c) {
        ASSERT_EQ(g.size(), c.size());
        for (std::size_t k = 0; k < g.size(); ++k) {
            const Series composed = compose(*n.normal_form.field, c[k], inverse, n.map.through);
            for (int w = 0; w <= n.map.through; ++w)
                EXPECT_TRUE((g[k].part(w) + composed.part(w)).empty()) << w;
        }
    };
    check(inverse.mode, n.map.mode);
    check(inverse.angle, n.map.angle);
    check(inverse.slow, n.map.slow);
    check(inverse.drift, n.map.drift);
}

// Other names of parameters and variables, so that everything that sorts by name or hash sorts anew.
TEST_P(EverySystem, DoesNotDependOnNames) {
    // The unit m is none of them.
    const std::string text =
        std::regex_replace(text_of(GetParam()), std::regex("unit = \"[^\"]*\""), "unit = \"\"");
    const Normalization n = normalized(text);
    const System& system = n.normal_form.field->system();
    std::vector<std::string> names;
    for (const Parameter& p : system.parameters) names.push_back(p.name);
    for (const Variable& v : system.variables) names.push_back(v.name);
    std::string renamed = text;
    for (std::size_t k = 0; k < names.size(); ++k)
        renamed = replaced(renamed, names[k], "q" + std::to_string(names.size() - k) + "_" + names[k]);
    std::string back = json(normalized(renamed));
    for (std::size_t k = 0; k < names.size(); ++k)
        back = replaced(back, "q" + std::to_string(names.size() - k) + "_" + names[k], names[k]);
    EXPECT_EQ(json(n), back);
}

// Values of the parameters that no relation gives.
std::map<std::string, Rational> values_of(const System& system) {
    static const int primes[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};
    std::map<std::string, Rational> values;
    for (const Parameter& p : system.parameters) {
        const std::size_t k = values.size();
        values[p.name] = Rational(primes[k + 1]) / Rational(primes[k]);
    }
    return values;
}

// The same, and slow variables at 5/4, or as often doubled, or halved, as [domain] wants.
std::map<std::string, double> point_of(const System& system) {
    std::map<std::string, double> point;
    GiNaC::exmap at;
    const auto put = [&](const std::string& name, const GiNaC::symbol& symbol, double value) {
        point[name] = value;
        at[symbol] = value;
    };
    const auto values = values_of(system);
    for (const Parameter& p : system.parameters) put(p.name, p.symbol, cln::double_approx(values.at(p.name)));
    const auto holds = [&](const Declaration& d) {
        const GiNaC::ex value = d.value.subs(at).evalf();
        return !GiNaC::is_a<GiNaC::numeric>(value) || value > 0;
    };
    double up = 1.25, down = up;
    for (bool inside = false; !inside && up < 1000; up *= 2, down /= 2)
        for (const double slow : {up, down}) {
            for (const Variable& v : system.variables)
                if (v.role == Role::slow) put(v.name, v.jet[0], slow);
            inside = std::all_of(system.positive.begin(), system.positive.end(), holds);
            if (inside) break;
        }
    return point;
}

// With numbers for the parameters from the start: other rings, other roots.
TEST_P(EverySystem, AgreesWithNumbersForItsParameters) {
    const Normalization symbolic = normalized(text_of(GetParam()));
    const std::map<std::string, Rational> values = values_of(symbolic.normal_form.field->system());
    std::vector<Setting> settings;
    for (const auto& [name, value] : values)
        settings.push_back(read_setting(name + "=" + to_string(value), "--set"));
    const System numbers =
        with_settings(read_system_text(text_of(GetParam()), "test/system.toml"), settings, "--set");
    const Normalization numeric =
        normalize(std::make_shared<const GradedField>(expand(test::first_order_of(numbers))),
                  symbolic.normal_form.through);
    EXPECT_TRUE(certify(numeric.normal_form, numeric.map).holds);
    test::expect_same_values(symbolic, numeric, point_of(symbolic.normal_form.field->system()));
}

// The table of parameters read from below.
TEST_P(EverySystem, DoesNotDependOnTheOrderOfItsParameters) {
    const std::string text = text_of(GetParam());
    const std::size_t table = text.find("[parameters]\n");
    if (table == std::string::npos) return;
    const std::size_t begin = text.find('\n', table) + 1, end = text.find("\n\n", table) + 1;
    std::istringstream lines(text.substr(begin, end - begin));
    std::string line, reversed;
    while (std::getline(lines, line)) reversed = line + "\n" + reversed;
    const Normalization n = normalized(text);
    test::expect_same_values(n, normalized(text.substr(0, begin) + reversed + text.substr(end)),
                             point_of(n.normal_form.field->system()));
}

INSTANTIATE_TEST_SUITE_P(All, EverySystem, ::testing::ValuesIn(systems()),
                         [](const auto& name) { return name.param; });

} // namespace
} // namespace resonform
