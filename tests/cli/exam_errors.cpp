// SPDX-License-Identifier: GPL-3.0-or-later
// With --format json an error is a document, whatever is wrong; the text on standard error stays.
#include "support/command.hpp"
#include "support/documented.hpp"

namespace resonform::test {

namespace {

using Json = nlohmann::json;

const std::string oscillator =
    "[system]\nname = \"duffing\"\n[variables]\nx = { role = \"fast\" }\n[equations]\n";

class Errors : public Command {
protected:
    Errors() {
        write(scratch_.path() / "systems/duffing/system.toml", oscillator + "x = \"x'' + x + x^3 = 0\"\n");
    }
    // The document of a command that fails, after the text of its message was found on standard error.
    [[nodiscard]] Json document(const std::string& command, int code = 2) const {
        const Outcome plain = said(command), outcome = said(command + " --format json");
        EXPECT_EQ(outcome.code, code) << command << "\n" << outcome.err;
        EXPECT_EQ(plain.code, code) << command;
        EXPECT_EQ(plain.out, "") << command;
        EXPECT_EQ(plain.err, outcome.err) << command;
        const Json json = Json::parse(outcome.out, nullptr, false);
        EXPECT_FALSE(json.is_discarded()) << command << "\n" << outcome.out;
        EXPECT_EQ(json["schema"], "resonform.error/1");
        EXPECT_EQ(json["exit_code"], code);
        EXPECT_EQ(keys_of(json), (std::set<std::string>{"schema", "exit_code", "reason", "rule", "found",
                                                        "hint", "file", "line", "column", "key"}));
        EXPECT_NE(outcome.err.find(json["rule"].get<std::string>()), std::string::npos);
        const std::string row =
            "| `" + json["reason"].get<std::string>() + "` | " + std::to_string(code) + " |";
        EXPECT_NE(file_formats().find(row), std::string::npos) << "undocumented: " << row;
        return json;
    }
    void equation(const std::string& text) const {
        write(scratch_.path() / "systems/bad/system.toml",
              "[system]\nname = \"bad\"\n[parameters]\na = {}\n[variables]\nx = { role = \"fast\" "
              "}\n[equations]\nx = \"" +
                  text + "\"\n");
    }
};
using SlowErrors = Errors;

} // namespace

TEST_F(Errors, HaveTheirParts) {
    equation("x'' + x + z^3 = 0");
    const Json json = document("derive bad");
    EXPECT_EQ(json["reason"], "name");
    EXPECT_EQ(json["rule"], "unknown symbol");
    EXPECT_EQ(json["found"], "z");
    EXPECT_EQ(json["hint"], "did you mean 'a'? Known are: a, eps, x");
    EXPECT_EQ(json["file"], "systems/bad/system.toml");
    EXPECT_EQ(json["line"], 8);
    EXPECT_EQ(json["column"], 16);
    EXPECT_EQ(json["key"], "equations.x");
}

TEST_F(Errors, WithoutAPlaceHaveNull) {
    EXPECT_EQ(document("derive")["key"], "SYSTEM");
    const Json json = document("derve");
    EXPECT_EQ(json["reason"], "command_line");
    for (const char* key : {"file", "line", "column", "key"}) EXPECT_TRUE(json[key].is_null()) << key;
}

// Also where the command line itself cannot be understood, and however the format is written.
TEST_F(Errors, OfTheCommandLine) {
    EXPECT_EQ(document("derve duffing")["reason"], "command_line");
    EXPECT_EQ(document("derive duffing --ordr 3")["found"], "--ordr");
    EXPECT_EQ(document("derive duffing --order 0")["key"], "--order");
    EXPECT_EQ(Json::parse(said("derive duffing --ordr 3 --format=json").out)["reason"], "command_line");
    EXPECT_EQ(Json::parse(said("--format json derive duffing").out)["reason"], "command_line");
    EXPECT_EQ(said("derive nope --format text").out, "");
    EXPECT_EQ(said("derive nope --style json").out, "");
}

// The columns of a setting count in its word, from 1.
TEST_F(Errors, OfSettings) {
    equation("x'' + x + a*x^3 = 0");
    const std::vector<std::pair<std::string, int>> wrong = {{"a=)1", 3}, {"a=1)", 4}, {"a=2*(1+b)", 8}};
    for (const auto& [word, column] : wrong) {
        const Json json = document("derive bad --set '" + word + "'");
        EXPECT_EQ(json["key"], "--set") << word;
        EXPECT_EQ(json["found"], word);
        EXPECT_EQ(json["column"], column) << word;
        EXPECT_TRUE(json["file"].is_null());
    }
    const std::string said_of_it = said("derive bad --set 'a=1)'").err;
    EXPECT_NE(said_of_it.find("resonform: --set: a ')' closes nothing\n    a=1)\n       ^\n  found: a=1)\n"),
              std::string::npos)
        << said_of_it;
}

// An empty text was found; null is what was not there.
TEST_F(Errors, OfEmptyTexts) {
    for (const char* options : {"--order ''", "--stage ''", "--style ''", "--set ''"})
        EXPECT_EQ(document(std::string("derive duffing ") + options)["found"], "''") << options;
    EXPECT_EQ(document("derive ''")["found"], "''");
    EXPECT_TRUE(document("derive")["found"].is_null());
    const std::string scene = "systems/duffing/scenes/s.toml";
    const std::string begins = "[start]\namplitude.x = 1\nphase.x = 0\n";
    for (const std::string& text :
         {std::string("order = \"\"\n"), std::string("outputs = [\"\"]\n"), std::string("\"\" = 1\n"),
          std::string("[start]\namplitude.x = \"\"\n"), begins + "[verify]\ninterval = \"\"\n",
          begins + "[verify]\neps = [\"\"]\n"}) {
        write(scratch_.path() / scene, text);
        EXPECT_EQ(document("evaluate " + scene + " --eps 0.1 --t 1")["found"], "\"\"") << text;
    }
}

// What comes of a key of the scene has its line, though it is found when the truncation is counted.
TEST_F(Errors, OfOrdersHaveALine) {
    const std::string scene = "systems/duffing/scenes/s.toml";
    const std::string begins = "[start]\namplitude.x = 1\nphase.x = 0\n";
    write(scratch_.path() / scene, "title = \"t\"\norder = 95\ntime_scale = 9\n" + begins);
    const Json size = document("evaluate " + scene + " --eps 0.1 --t 1", 3);
    EXPECT_EQ(size["reason"], "size");
    EXPECT_EQ(size["file"], scene);
    EXPECT_EQ(size["key"], "order");
    EXPECT_EQ(size["line"], 2);
    EXPECT_EQ(size["column"], 9);
    write(scratch_.path() / "systems/slow/system.toml",
          "[system]\nname = \"slow\"\n[variables]\nx = { role = \"fast\" }\ns = { role = \"slow\" }\n"
          "[equations]\nx = \"x'' + x + s*x^3 = 0\"\ns = \"s' = eps\"\n");
    write(scratch_.path() / "systems/slow/scenes/s.toml",
          "order = 2\n\ntime_scale = 2\n" + begins + "s = 1\n");
    const Json driven = document("evaluate systems/slow/scenes/s.toml --eps 0.1 --t 1", 3);
    EXPECT_EQ(driven["rule"], "on a time scale beyond 1/eps the slow variables stay in a compact set");
    EXPECT_EQ(driven["reason"], "too_fast");
    EXPECT_EQ(driven["key"], "time_scale");
    EXPECT_EQ(driven["line"], 3);
    write(scratch_.path() / "systems/slow/system.toml",
          "[system]\nname = \"slow\"\n[variables]\nx = { role = \"fast\" }\n"
          "[equations]\nx = \"x'' + 2*eps*x' + x + x^3 = 0\"\n");
    write(scratch_.path() / "systems/slow/scenes/s.toml", "order = 2\ntime_scale = 2\n" + begins);
    const Json flow = document("evaluate systems/slow/scenes/s.toml --eps 0.1 --t 1", 3);
    EXPECT_EQ(flow["rule"], "on a time scale beyond 1/eps slow flow and drifts go a finite way");
    EXPECT_EQ(flow["line"], 2);
}

// A hint ends with its command, however many names stand before it.
TEST_F(Errors, HintsEndWithTheirCommand) {
    for (int i = 10; i < 40; ++i) {
        const auto folder = scratch_.path() / "systems" / ("a_system_of_long_name_" + std::to_string(i));
        write(folder / "system.toml", "");
        write(folder / "scenes/s.toml", "");
    }
    const auto ends_with = [](const Json& hint, const std::string& end) {
        const auto text = hint.get<std::string>();
        return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
    };
    const Json system = document("derive a_system_of_long_nam")["hint"];
    EXPECT_TRUE(ends_with(system, ", ...; all systems: resonform list")) << system;
    const Json scene = document("verify s")["hint"];
    EXPECT_TRUE(ends_with(scene, " or another? All scenes: resonform list")) << scene;
}

TEST_F(Errors, HaveAReasonOfTheList) {
    EXPECT_EQ(document("derive nope")["reason"], "file");
    EXPECT_EQ(document("verify no/such.toml")["reason"], "file");
    EXPECT_EQ(document("evaluate nothing.toml --eps 0.1 --t 1")["file"], "nothing.toml");
    EXPECT_EQ(document("verify systems")["found"], "no regular file");
    EXPECT_EQ(document("derive duffing --set q=1")["reason"], "command_line");
    equation("x'' + x + = 0");
    EXPECT_EQ(document("derive bad")["reason"], "syntax");
    equation("x'' + x + x^2/(x - x) = 0");
    EXPECT_EQ(document("derive bad")["reason"], "syntax");
    equation("x'' + x + 1 = 0");
    EXPECT_EQ(document("derive bad")["reason"], "value");
    equation("x'' + a*x = 0");
    EXPECT_EQ(document("derive bad", 3)["reason"], "undecided");
    equation("x''' + x' + a*x + x^2 = 0");
    EXPECT_EQ(document("derive bad", 3)["reason"], "eigenvalues");
    equation("x'' + x + abs(x) = 0");
    EXPECT_EQ(document("derive bad")["reason"], "name");
    write(scratch_.path() / "systems/bad/system.toml", "[system\n");
    EXPECT_EQ(document("derive bad")["reason"], "syntax");
    write(scratch_.path() / "systems/bad/system.toml", oscillator + "x = \"x'' + x = 0\"\n[domian]\n");
    EXPECT_EQ(document("derive bad")["reason"], "name");
    EXPECT_EQ(document("derive duffing --stage manifold", 3)["reason"], "unsupported");
}

// What mathematics refuses, in a word for each cause.
TEST_F(Errors, SayWhyASystemIsRefused) {
    equation("x'' + 2*x' + x + x^3 = 0");
    EXPECT_EQ(document("derive bad", 3)["reason"], "not_semisimple");
    equation("x'' + x + x*acosh(1 + x) = 0");
    EXPECT_EQ(document("derive bad", 3)["reason"], "singular");
    const auto system = [&](const std::string& variables, const std::string& equations) {
        write(scratch_.path() / "systems/bad/system.toml",
              "[system]\nname = \"bad\"\n[variables]\n" + variables + "[equations]\n" + equations);
    };
    system("x = { role = \"fast\", weight = 0 }\n", "x = \"x' = -x - x^2\"\n");
    EXPECT_EQ(document("derive bad", 3)["reason"], "nonlinear_layer");
    system("p = { role = \"angle\" }\n", "p = \"p' = 2 + sin(p)\"\n");
    EXPECT_EQ(document("derive bad", 3)["reason"], "nonlinear_layer");
    system("x = { role = \"fast\", weight = 2 }\ny = { role = \"fast\" }\n",
           "x = \"x' = -x + eps\"\ny = \"y'' + y + x = 0\"\n");
    EXPECT_EQ(document("derive bad", 3)["reason"], "too_fast");
    system("x = { role = \"fast\" }\np = { role = \"angle\" }\n",
           "x = \"x'' + x = eps*cos(p)\"\np = \"p' = 1\"\n");
    EXPECT_EQ(document("derive bad", 3)["reason"], "resonance");
}

// ... and a solution, of what can be derived.
TEST_F(Errors, SayWhyASceneIsRefused) {
    const std::string scene = "systems/bad/scenes/s.toml",
                      evaluate = "evaluate " + scene + " --eps 0.1 --t 1";
    write(scratch_.path() / scene, "order = 1\n[start]\nx = 0\n\"x'\" = \"eps\"\n");
    equation("x'' + 2*x' + x + x^3 = 0\"\n[normal_form]\nstyle = \"inner_product");
    EXPECT_EQ(document(evaluate, 3)["reason"], "not_semisimple");
    write(scratch_.path() / "systems/bad/system.toml",
          "[system]\nname = \"bad\"\n[functions]\nf = { of = [\"s\"], positive = true }\n[variables]\ns = { "
          "role = "
          "\"slow\" }\nx = { role = \"fast\" }\n[equations]\ns = \"s' = eps\"\nx = \"x'' + f(s)*x = 0\"\n");
    write(scratch_.path() / "systems/bad/scenes/f.csv",
          "s,f\n0,1\n0.5,1.1\n1,1.2\n1.5,1.3\n2,1.4\n2.5,1.5\n3,1.6\n");
    write(scratch_.path() / scene,
          "order = 3\n[functions]\nf = { data = \"f.csv\", columns = [\"s\", \"f\"], degree = 3 }\n"
          "[start]\ns = 0\nx = 0\n\"x'\" = \"eps\"\n");
    EXPECT_EQ(document(evaluate, 3)["reason"], "not_smooth");
}

// A function that the caller of emitted code gives has no numbers here.
TEST_F(Errors, OfCallables) {
    write(
        scratch_.path() / "systems/bad/system.toml",
        "[system]\nname = \"bad\"\n[functions]\nf = { of = [\"s\"] }\n[variables]\ns = { role = \"slow\" }\n"
        "x = { role = \"fast\" }\n[equations]\ns = \"s' = eps\"\nx = \"x'' + x = eps*f(s)*x\"\n");
    write(scratch_.path() / "systems/bad/scenes/s.toml",
          "order = 1\n[functions]\nf = { callable = true }\n[start]\ns = 0\nx = 0\n\"x'\" = \"eps\"\n");
    const std::string scene = "systems/bad/scenes/s.toml";
    EXPECT_NE(printed("generate " + scene).find("Callable<Function_f> f;"), std::string::npos);
    for (const std::string& command :
         {"evaluate " + scene + " --eps 0.1 --t 1", "verify " + scene, "compare " + scene,
          "stability " + scene, "sweep " + scene + " --over eps=0.1,0.2 --output f.npy"}) {
        const Json json = document(command, 2);
        EXPECT_EQ(json["key"], "functions.f") << command;
        EXPECT_EQ(json["found"], "callable = true") << command;
    }
}

TEST_F(Errors, OfTheLimits) {
    EXPECT_EQ(document("derive duffing --term-limit 1", 3)["reason"], "terms");
    // From another thread, which ends the program.
    const Json json = Json::parse(said("derive duffing --order 61 --time-limit 0.01 --format json").out);
    EXPECT_EQ(json["reason"], "time");
    EXPECT_EQ(json["exit_code"], 3);
    EXPECT_EQ(json["key"], "--time-limit");
    EXPECT_EQ(Json::parse(said("derive duffing --memory-limit 1 --format json").out)["reason"], "memory");
}

TEST_F(Errors, OfTheCompiler) {
    write(scratch_.path() / "systems/duffing/scenes/s.toml",
          "order = 1\n[start]\namplitude.x = 1\nphase.x = 0\n[verify]\ninterval = 5\neps = [0.1, 0.05, "
          "0.02]\n");
    const Outcome outcome = run(
        "CXX=no-such-compiler resonform verify systems/duffing/scenes/s.toml --format json", scratch_.path());
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(Json::parse(outcome.out)["reason"], "compiler");
}

// What cannot be text is replaced, and what is long is cut.
TEST_F(Errors, AreJsonWhateverTheUserWrote) {
    const Outcome outcome = said("derive $'n\\xffo' --format json");
    EXPECT_EQ(Json::parse(outcome.out)["reason"], "file");
    write(scratch_.path() / "systems/duffing/scenes/\xff.toml", "title = \"named as no text can be\"\n");
    EXPECT_EQ(Json::parse(printed("list --format json"))["systems"][0]["scenes"][0]["title"],
              "named as no text can be");
    std::filesystem::remove(scratch_.path() / "systems/duffing/scenes/\xff.toml");
    const Outcome longer =
        said("evaluate systems/duffing/system.toml --t 1 --eps $(printf 'x%.0s' {1..5000}) --format json");
    EXPECT_LT(Json::parse(longer.out)["found"].get<std::string>().size(), 500U);
}

// A report that fails behind the verdicts brings no second document.
TEST_F(SlowErrors, AreNoSecondDocument) {
    write(scratch_.path() / "systems/duffing/scenes/s.toml",
          "order = 1\n[start]\namplitude.x = 1\nphase.x = 0\n[verify]\ninterval = 5\neps = [0.1, 0.05, "
          "0.02]\n");
    // gnuplot is there when it is asked for, and prints nothing when it is to draw.
    write(scratch_.path() / "bin/gnuplot", "#!/bin/sh\nexit 0\n");
    const Outcome outcome = run("chmod +x bin/gnuplot; PATH=$PWD/bin:$PATH resonform verify "
                                "systems/duffing/scenes/s.toml --report here --format json",
                                scratch_.path());
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_EQ(Json::parse(outcome.out)["schema"], "resonform.verification/1");
    EXPECT_NE(outcome.err.find("gnuplot printed no plot"), std::string::npos) << outcome.err;
}

} // namespace resonform::test
