// SPDX-License-Identifier: GPL-3.0-or-later
// Each command on the first system: exit code, where output goes, the shape of its JSON.
#include "support/shell.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace resonform::test {

namespace {

using Json = nlohmann::json;

const std::string scenes = "systems/almost_holonomic_pendulum/scenes/";

std::string output_of(const std::string& command) {
    const Outcome outcome = run(command, RESONFORM_SOURCE_DIR);
    EXPECT_EQ(outcome.code, 0) << command << "\n" << outcome.err;
    return outcome.out;
}

Json json_of(const std::string& command) { return Json::parse(output_of(command + " --format json")); }

} // namespace

TEST(Commands, HelpAndVersion) {
    EXPECT_NE(output_of("resonform derive --help").find("--order 1..99=3"), std::string::npos);
    EXPECT_NE(output_of("resonform --help").find("Exit codes: 0 done"), std::string::npos);
    EXPECT_EQ(output_of("resonform --version"), "resonform 0.1.0\n");
    for (const char* command : {"derive", "generate", "verify", "certify", "compare", "stability", "sweep",
                                "regenerate", "list", "evaluate"})
        EXPECT_NE(output_of(std::string("resonform ") + command + " --help").find("--format"),
                  std::string::npos);
}

TEST(Commands, ListNamesSystemsAndScenes) {
    const Json list = json_of("resonform list");
    EXPECT_EQ(list["schema"], "resonform.list/1");
    EXPECT_EQ(list["systems"][0]["name"], "adiabatic_oscillator");
    EXPECT_EQ(list["systems"][1]["name"], "airy");
    EXPECT_EQ(list["systems"][1]["scenes"][0]["name"], "waves");
}

TEST(Commands, DeriveInEveryStageAndFormat) {
    for (const char* stage : {"equations", "expand", "normal_form", "divisors", "solution"})
        for (const char* format : {"text", "latex", "json"})
            EXPECT_NE(output_of(std::string("resonform derive almost_holonomic_pendulum --stage ") + stage +
                                " --format " + format),
                      "");
    const Json form = json_of("resonform derive almost_holonomic_pendulum --order 2");
    EXPECT_EQ(form["schema"], "resonform.normal_form/1");
    EXPECT_EQ(form["order"], 2);
    EXPECT_EQ(form["certificate"]["holds"], true);
    EXPECT_EQ(form["certificate"]["through_weight"], 2);
}

TEST(Commands, OrdersMayBeFractions) {
    const Json form = json_of("resonform derive brusselator --order 5/2");
    EXPECT_EQ(form["order"], "5/2");
    EXPECT_EQ(form["certificate"]["through_weight"], "5/2");
    EXPECT_EQ(json_of("resonform certify brusselator --order 1.5")["through_weight"], "3/2");
    const Json solution =
        json_of("resonform derive brusselator --stage solution --order 1/2 --truncation 3/2");
    EXPECT_EQ(solution["order"], "1/2");
    EXPECT_EQ(solution["truncation"], "3/2");
}

// The stages before the normal form want nothing of it: no modes for the equations, no later weight for their
// expansion.
TEST(Commands, EarlyStagesDependOnNothingLater) {
    const Scratch scratch;
    for (const char* equation : {"x'' = x^2", "x''' + x'' + x' + 2*x = x^2", "x'' + w*x = 0"}) {
        write(scratch.path() / "t/system.toml",
              "[system]\nname = \"t\"\n[parameters]\nw = {}\n[variables]\nx = { role = \"fast\" }\n"
              "[equations]\nx = \"" +
                  std::string(equation) + "\"\n");
        const Outcome outcome = run("resonform derive t --stage equations", scratch.path());
        EXPECT_EQ(outcome.out, std::string("equations of t\n\n") + equation + "\n") << outcome.err;
    }
    write(
        scratch.path() / "t/system.toml",
        "[system]\nname = \"t\"\n[variables]\nx = { role = \"fast\", weight = 2 }\nd = { role = \"drift\" }\n"
        "[equations]\nx = \"x'' + x = x^2\"\nd = \"d' = eps\"\n");
    const Outcome heavy = run("resonform derive t --stage expand --order 4", scratch.path());
    EXPECT_NE(heavy.out.find("expanded through weight 4"), std::string::npos) << heavy.err;
    EXPECT_NE(output_of("resonform derive henon_heiles --stage expand --order 99 --time-limit 20"), "");
    EXPECT_NE(
        output_of("resonform derive almost_holonomic_pendulum --stage expand").find("without the known"),
        std::string::npos);
}

TEST(Commands, ASystemIsAFolderAFileOrAName) {
    const std::string by_name = output_of("resonform derive almost_holonomic_pendulum");
    EXPECT_EQ(output_of("resonform derive systems/almost_holonomic_pendulum"), by_name);
    EXPECT_EQ(output_of("resonform derive systems/almost_holonomic_pendulum/system.toml"), by_name);
}

TEST(Commands, Certify) {
    const Json certificate = json_of("resonform certify almost_holonomic_pendulum --order 4");
    EXPECT_EQ(certificate["schema"], "resonform.certificate/1");
    EXPECT_EQ(certificate["holds"], true);
    EXPECT_EQ(certificate["through_weight"], 4);
    EXPECT_LT(certificate["error_probability"].get<double>(), 1e-20);
}

TEST(Commands, EvaluateAnswersOutsideItsDomainWithAStatus) {
    const Json values =
        json_of("resonform evaluate " + scenes + "third_order.toml --eps 0.1 --t 0,10,nan,-1,11");
    EXPECT_EQ(values["schema"], "resonform.values/1");
    EXPECT_EQ(values["status"], Json({"ok", "ok", "bad_argument", "outside_interval", "outside_interval"}));
    EXPECT_TRUE(values["outputs"]["psi"][2].is_null());
    EXPECT_TRUE(values["t"][2].is_null());
    // (23) at t = 0 with (24): y = C_Y + 1 - eps^2 (1 + 1)/2 + f_y, and f_y vanishes with xi and theta
    EXPECT_NEAR(values["outputs"]["y"][0].get<double>(), 2 - 0.01, 1e-12);
}

TEST(Commands, EvaluatePrintsCsv) {
    const std::string csv = output_of("resonform evaluate " + scenes + "xy_only.toml --eps 0.1 --t 0,-1");
    EXPECT_EQ(csv.substr(0, csv.find('\n')), "t,x,y,status");
    EXPECT_NE(csv.find("\n-1,,,outside_interval\n"), std::string::npos) << csv;
}

// y = eps^2/3*e^t + ...
TEST(Commands, EvaluateSaysWhichModeLosesItsDigits) {
    const Scratch scratch;
    write(scratch.path() / "systems/s/system.toml",
          "[system]\nname = \"s\"\n[variables]\nx = { role = \"fast\" }\ny = { role = \"fast\" }\n"
          "[equations]\nx = \"x' = -x\"\ny = \"y' = y + x^2\"\n");
    write(scratch.path() / "systems/s/scenes/s.toml",
          "order = 2\noutputs = [\"y\"]\n[start]\nx = \"eps\"\ny = 0\n");
    const Outcome outcome =
        run("resonform evaluate systems/s/scenes/s.toml --eps 1e-4 --t 12", scratch.path());
    EXPECT_NE(outcome.err.find("resonform: low_precision: chi_2 (z2 of y)\n"), std::string::npos)
        << outcome.err;
}

// |x(order 4) - x(order 3)|: (23) lacks terms of eps^4.
TEST(Commands, EvaluateEstimatesErrors) {
    const std::string command = "resonform evaluate " + scenes + "xy_only.toml --t 0,10,-1 --errors --eps ";
    const Json rough = json_of(command + "0.1"), fine = json_of(command + "0.05");
    for (const char* name : {"x", "y"}) {
        const Json &r = rough["error_estimate"][name], &f = fine["error_estimate"][name];
        ASSERT_EQ(r.size(), 3U);
        EXPECT_TRUE(r[2].is_null());
        const double most = std::max(r[0].get<double>(), r[1].get<double>());
        EXPECT_GT(most, 1e-5) << name;
        EXPECT_LT(most, 1e-3) << name;
        EXPECT_LT(std::max(f[0].get<double>(), f[1].get<double>()), most / 8) << name;
    }
    const std::string csv = output_of(command + "0.1");
    EXPECT_EQ(csv.substr(0, csv.find('\n')), "t,x,y,status,error_x,error_y");
    EXPECT_NE(csv.find("\n-1,,,outside_interval,,\n"), std::string::npos) << csv;
}

TEST(Commands, GenerateWritesTheCommittedHeader) {
    const Scratch scratch;
    const std::string file = (scratch.path() / "xy.hpp").string();
    const Json made = json_of("resonform generate " + scenes + "xy_only.toml -o " + file);
    EXPECT_EQ(made["schema"], "resonform.generation/1");
    const auto committed =
        std::filesystem::path(RESONFORM_SOURCE_DIR) / "generated/almost_holonomic_pendulum/xy_only.hpp";
    EXPECT_EQ(read(file), read(committed));
    EXPECT_EQ(output_of("resonform generate " + scenes + "xy_only.toml"), read(committed));
}

// xy_only with another [emit]
std::string scene_with(const Scratch& scratch, const std::string& emit) {
    scratch.copy_systems();
    const auto file = scratch.path() / "systems/almost_holonomic_pendulum/scenes/xy_only.toml";
    write(file, read(file) + "\n[emit]\n" + emit + "\n");
    return file.string();
}

TEST(Commands, ASceneChoosesTheFormOfManyPoints) {
    const Json tables = json_of("resonform generate " + scenes + "xy_only.toml");
    EXPECT_EQ(tables["form"], "tables");
    EXPECT_EQ(tables["bytes"], tables["header"].get<std::string>().size());
    EXPECT_NE(tables["header"].get<std::string>().find("struct Rows"), std::string::npos);
    const Scratch scratch;
    const Json direct = json_of("resonform generate " + scene_with(scratch, "form = \"direct\""));
    EXPECT_EQ(direct["form"], "direct");
    EXPECT_EQ(direct["operations_by_form"], tables["operations_by_form"]);
    EXPECT_GT(direct["operations_by_form"]["direct"], direct["operations_by_form"]["tables"]);
    EXPECT_EQ(direct["header"].get<std::string>().find("struct Rows"), std::string::npos);
    EXPECT_NE(direct["header"].get<std::string>().find("one by one): as the scene wants it"),
              std::string::npos);
    const Scratch other;
    const Json atoms = json_of("resonform generate " + scene_with(other, "form = \"atoms\""));
    EXPECT_EQ(atoms["form"], "atoms");
    EXPECT_EQ(atoms["operations_by_form"], tables["operations_by_form"]);
    EXPECT_NE(atoms["header"].get<std::string>().find("Kind::multiply_add"), std::string::npos);
}

TEST(Commands, AnUnknownFormIsNamed) {
    const Scratch scratch;
    const Outcome outcome =
        run("resonform generate " + scene_with(scratch, "form = \"table\""), scratch.path());
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("did you mean 'tables'?"), std::string::npos) << outcome.err;
}

TEST(Commands, TheInlinedRuntimeIsWhole) {
    const Scratch scratch;
    write(scratch.path() / "main.cpp", "#include \"xy.hpp\"\nint main() {}\n");
    output_of("resonform generate " + scenes + "xy_only.toml --inline-runtime -o " +
              (scratch.path() / "xy.hpp").string());
    const Outcome outcome =
        run(RESONFORM_CXX_COMPILER " -std=c++20 -Wall -Wextra -Werror main.cpp -o main && ./main",
            scratch.path());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
}

TEST(Commands, SameInputSameBytes) {
    for (const char* format : {"text", "latex", "json"}) {
        const std::string command =
            std::string("resonform derive almost_holonomic_pendulum --order 5 --format ") + format;
        EXPECT_EQ(output_of(command), output_of(command));
    }
}

} // namespace resonform::test
