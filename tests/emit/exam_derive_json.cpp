// SPDX-License-Identifier: GPL-3.0-or-later
// The JSON of `derive` against the example of the design, entry by entry.
#include "emit/derive/derive.hpp"
#include "printed.hpp"

#include <fstream>
#include <gtest/gtest.h>

#include <limits>
#include <map>

namespace resonform::test {
namespace {

Json example() {
    std::ifstream file(source_dir() / "tests" / "emit" / "almost_holonomic_pendulum_order_3.json");
    return Json::parse(file);
}

TEST(DeriveJson, EqualsTheExampleOfTheDesign) {
    const Json expected = example();
    const Json made = Json::parse(print_normal_form(*pendulum(3), 3, Format::json));
    for (const char* key : {"schema", "system", "order", "truncation", "style", "fast"})
        EXPECT_EQ(made[key].dump(), expected[key].dump()) << key;
    ASSERT_EQ(made["normal_form"].size(), expected["normal_form"].size());
    for (std::size_t i = 0; i < expected["normal_form"].size(); ++i)
        EXPECT_EQ(made["normal_form"][i].dump(), expected["normal_form"][i].dump()) << "entry " << i;
}

TEST(DeriveJson, KeysInTheOrderOfTheContract) {
    const Json made = normal_form_json(*pendulum(3), 3);
    std::vector<std::string> keys, certificate;
    for (const auto& [key, value] : made.items()) keys.push_back(key);
    for (const auto& [key, value] : made["certificate"].items()) certificate.push_back(key);
    EXPECT_EQ(keys, (std::vector<std::string>{"schema", "system", "order", "truncation", "style", "fast",
                                              "normal_form", "map", "divisors", "certificate"}));
    EXPECT_EQ(certificate, (std::vector<std::string>{"holds", "through_weight", "normal_form_scan", "route",
                                                     "error_probability", "points", "primes"}));
    EXPECT_EQ(made["certificate"]["holds"], true);
    EXPECT_EQ(made["certificate"]["through_weight"], 3);
    for (const Json& prime : made["certificate"]["primes"]) EXPECT_TRUE(prime.is_number_unsigned());
    EXPECT_TRUE(made["certificate"]["error_probability"].is_number_float());
}

TEST(DeriveJson, AHigherNormalisationGivesTheSameLowerOrder) {
    const auto high = pendulum(4);
    const Json made = normal_form_json(*high, 3);
    EXPECT_EQ(made["truncation"], 4);
    EXPECT_EQ(made["normal_form"].dump(), example()["normal_form"].dump());
    for (const char* list : {"normal_form", "map", "divisors"})
        for (const Json& entry : made[list])
            if (entry.contains("weight")) {
                EXPECT_LE(entry["weight"], 3);
            }
    // The weight-4 term that (22) lacks.
    const Json full = normal_form_json(*high, 4);
    const std::string term = R"x({"variable":"z1","exponents":{"z1":1,"eps":3},"weight":4,)x"
                             R"x("coefficient":"v**3*xi*(2*r**2 - xi**2)/(128*g*(r**2 + xi**2)**(5/2))"})x";
    bool found = false;
    for (const Json& entry : full["normal_form"]) found = found || entry.dump() == term;
    EXPECT_TRUE(found);
}

TEST(DeriveJson, MapAndDivisors) {
    const Json made = normal_form_json(*pendulum(3), 3);
    std::vector<std::string> variables;
    for (const Json& entry : made["map"]) {
        EXPECT_GE(entry["weight"], entry["variable"] == "z1" ? 2 : 1);
        if (variables.empty() || variables.back() != entry["variable"])
            variables.push_back(entry["variable"]);
    }
    EXPECT_EQ(variables, (std::vector<std::string>{"z1", "x", "y"}));
    ASSERT_FALSE(made["divisors"].empty());
    for (const Json& entry : made["divisors"]) {
        const std::string verdict = entry["verdict"];
        EXPECT_TRUE(verdict == "removed" || verdict == "kept exact") << verdict;
        EXPECT_EQ(verdict == "kept exact", entry["divisor"] == "0") << entry.dump();
    }
}

TEST(DeriveJson, EveryMonomialThatIsShownHasAVerdict) {
    const Json made = normal_form_json(*pendulum(4), 4);
    std::map<std::string, std::string> verdicts;
    const auto key = [](const Json& entry) {
        return entry["variable"].get<std::string>() + entry["exponents"].dump();
    };
    for (const Json& entry : made["divisors"])
        EXPECT_TRUE(verdicts.emplace(key(entry), entry["verdict"]).second) << "twice: " << entry.dump();
    for (const Json& entry : made["normal_form"])
        EXPECT_EQ(verdicts[key(entry)], "kept exact") << entry.dump();
    for (const Json& entry : made["map"]) EXPECT_EQ(verdicts[key(entry)], "removed") << entry.dump();
    EXPECT_EQ(verdicts.count(R"(z1{"z1":1})"), 1U);
    EXPECT_EQ(verdicts.count(R"(xi{"eps":1})"), 1U);
}

TEST(DeriveJson, OtherStages) {
    const auto field = field_named("almost_holonomic_pendulum");
    const Json equations = Json::parse(print_equations(field->system(), Format::json));
    EXPECT_EQ(equations["variables"][1].dump(), R"({"name":"xi","role":"slow","equation":"xi' = eps*v"})");
    const Json expansion = Json::parse(print_expansion(*field, 3, Format::json));
    EXPECT_EQ(expansion["equations"][0]["terms"][0].dump(),
              R"({"variable":"psi","exponents":{"psi''":1},"weight":1,"coefficient":"r**2 + xi**2"})");
    EXPECT_EQ(expansion["equations"][0]["next_weight"], 5);
}

TEST(JsonDocument, OneElementPerLineAndNullForWhatIsNoNumber) {
    const Json value = {
        {"a", 1},
        {"list",
         {{{"x", 0.1}, {"y", json_number(std::numeric_limits<double>::quiet_NaN())}}, {{"x", 1e-30}}}},
        {"numbers", json_numbers({0.5, -std::numeric_limits<double>::infinity()})}};
    EXPECT_EQ(json_document(value), "{\n  \"a\": 1,\n  \"list\": [\n    {\"x\":0.1,\"y\":null},\n"
                                    "    {\"x\":1e-30}\n  ],\n  \"numbers\": [0.5,null]\n}\n");
    EXPECT_EQ(Json::parse(json_document(value)), value);
}

TEST(JsonNumber, ReadsBackTheSameDouble) {
    for (double x : {0.1, 1.0 / 3, 2.53e-3, 5e-324, 1.7976931348623157e308, 123456789.123456789})
        EXPECT_EQ(Json::parse(json_number(x).dump()).get<double>(), x);
}

} // namespace
} // namespace resonform::test
