// SPDX-License-Identifier: GPL-3.0-or-later
// --digits: what is printed, in which formats, and what is refused.
#include "support/command.hpp"

#include <nlohmann/json.hpp>

namespace resonform::test {

namespace {

using Json = nlohmann::json;

class Numbers : public Command {
protected:
    Numbers() {
        write(scratch_.path() / "systems/two/system.toml",
              "[system]\nname = \"two\"\n[parameters]\nk = { positive = true }\n[variables]\nx = { role = "
              "\"fast\" }\ny = { role = \"fast\" }\n[equations]\nx = \"x'' = -x - x^2*y + k*x*y\"\ny = "
              "\"y'' = -3*y + x^2 - y^3\"\n");
        write(
            scratch_.path() / "systems/chain/system.toml",
            "[system]\nname = \"chain\"\n[variables]\na = { role = \"fast\" }\nb = { role = \"fast\" }\nc = "
            "{ role = \"fast\" }\n[equations]\na = \"a'' = -2*a + b - a^2\"\nb = \"b'' = -3*b + a + "
            "c\"\nc = \"c'' = -5*c + b + c^2\"\n");
    }
};

} // namespace

TEST_F(Numbers, AreWrittenWithTheDigitsAskedFor) {
    const std::string text = printed("derive two --digits 20 --set k=1/3");
    EXPECT_EQ(text.rfind("normal form of two with k = 1/3", 0), 0U) << text;
    EXPECT_NE(text.find("1.7320508075688772935"), std::string::npos) << text; // sqrt(3)
    EXPECT_NE(text.find("all residuals are small"), std::string::npos) << text;
    const Json json = Json::parse(printed("derive two --digits 20 --set k=1/3 --format json"));
    EXPECT_EQ(json["digits"], 20);
    EXPECT_EQ(json["fast"][1]["eigenvalue"], "1.7320508075688772935*I");
    EXPECT_EQ(json["certificate"]["holds"], true);
    EXPECT_TRUE(json["certificate"]["error_probability"].is_null());
    EXPECT_EQ(json["certificate"]["route"], "substitution, balls");
    EXPECT_NE(printed("derive two --digits 8 --set k=1/3 --format latex").find("1.7320508"),
              std::string::npos);
}

TEST_F(Numbers, FindModesWithoutClosedForm) {
    EXPECT_EQ(said("derive chain").code, 3);
    const Json json = Json::parse(printed("derive chain --digits 30 --format json"));
    EXPECT_EQ(json["fast"].size(), 3U);
    EXPECT_EQ(printed("derive chain --digits 30 --format json"),
              printed("derive chain --digits 30 --format json"));
    EXPECT_NE(printed("certify chain --order 3 --digits 12").find("The certificate holds"),
              std::string::npos);
    EXPECT_NE(printed("derive chain --digits 12 --stage divisors").find("removed"), std::string::npos);
}

// lambda^2 = -s, s^3 - 6 s^2 + 9 s - 3 = 0, and the same for lambda/2: that 2 w1 = w2 no digits prove.
TEST_F(Numbers, WhatIsZeroInAllDigitsIsSaidToBe) {
    write(
        scratch_.path() / "systems/doubled/system.toml",
        "[system]\nname = \"doubled\"\n[normal_form]\nnear = 1e-6\n[variables]\na = { role = \"fast\" }\nb = "
        "{ "
        "role = \"fast\" }\nc = { role = \"fast\" }\np = { role = \"fast\" }\nq = { role = \"fast\" }\nr = { "
        "role = \"fast\" }\n[equations]\na = \"a'' = b + a*b\"\nb = \"b'' = c\"\nc = \"c'' = -3*a - 9*b - "
        "6*c\"\np = \"p'' = q + a^2\"\nq = \"q'' = r\"\nr = \"r'' = -192*p - 144*q - 24*r\"\n");
    const std::string text = printed("derive doubled --order 2 --digits 12 --stage divisors");
    EXPECT_NE(text.find("kept near (zero in all digits, for no reason that is known):\n"), std::string::npos)
        << text;
    EXPECT_EQ(text.find("below the threshold"), std::string::npos) << text;
}

// Where the parameter is declared, for whoever reads the document and not the text.
TEST_F(Numbers, ThatAreMissingAreSaidAtTheParameter) {
    const Json json = Json::parse(said("derive two --digits 20 --format json").out);
    EXPECT_EQ(json["found"], "k");
    EXPECT_EQ(json["file"], "systems/two/system.toml");
    EXPECT_EQ(json["line"], 4);
    EXPECT_EQ(json["key"], "parameters.k");
}

TEST_F(Numbers, ThatCannotBeAreSaid) {
    const auto code = [&](const std::string& options) {
        const Outcome outcome = said("derive two " + options);
        EXPECT_EQ(outcome.out, "") << options;
        EXPECT_NE(outcome.err.find("hint:"), std::string::npos) << options << outcome.err;
        return outcome.code;
    };
    EXPECT_EQ(code("--digits 20"), 2); // k
    for (const char* digits : {"0", "3", "1001", "abc", "1e2", "-5", "2.5"})
        EXPECT_EQ(code("--set k=1 --digits " + std::string(digits)), 2) << digits;
    EXPECT_EQ(code("--set k=1 --digits 20 --format sympy"), 2);
    EXPECT_EQ(code("--set k=1 --digits 20 --stage solution"), 2);
    EXPECT_EQ(code("--set k=1 --digits 20 --coefficients graph"), 2);
    EXPECT_EQ(code("--set k=1 --digits 20 --style inner_product"), 3);
    EXPECT_EQ(code("--set k=-1 --digits 20"), 2);
}

} // namespace resonform::test
