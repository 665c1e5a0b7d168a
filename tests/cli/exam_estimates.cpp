// SPDX-License-Identifier: GPL-3.0-or-later
// error_estimate = true: the emitted code knows its error, as `evaluate --errors` does.
#include "support/command.hpp"

#include <nlohmann/json.hpp>

#include <sstream>

namespace resonform::test {

namespace {

class EmittedEstimate : public Command {
protected:
    EmittedEstimate() {
        write(scratch_.path() / "systems/spring/system.toml",
              "[system]\nname = \"spring\"\n[parameters]\nk = {}\n[variables]\nx = { role = \"fast\" }\n"
              "[equations]\nx = \"x'' + x + x^3 + k*x^4 = 0\"\n");
    }
    // With values of x and x' as start, or with constants of the solution.
    void scene(const std::string& more, const std::string& start = "x = \"eps\"\n\"x'\" = 0\n") const {
        write(scratch_.path() / "systems/spring/scenes/s.toml",
              "order = 3\ntime_scale = 1\nerror_estimate = true\n[start]\n" + start + more);
    }
    // What a program with the header prints, a number in each line.
    [[nodiscard]] std::vector<double> numbers(const std::string& body) const {
        write(scratch_.path() / "main.cpp", "#include \"spring.hpp\"\n#include <cstdio>\n"
                                            "using resonform::generated::spring::s::Evaluator;\n"
                                            "using resonform::Status;\nint main() {\n" +
                                                body + "}\n");
        const Outcome outcome =
            run("resonform generate systems/spring/scenes/s.toml -o spring.hpp 2>/dev/null "
                "&& " RESONFORM_CXX_COMPILER
                " -std=gnu++20 -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror -I" RESONFORM_SOURCE_DIR
                "/engine main.cpp -o main -lquadmath && ./main",
                scratch_.path());
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        std::istringstream lines(outcome.out);
        return {std::istream_iterator<double>(lines), {}};
    }
    // Of such a program: x and its estimated error at t, of an evaluator e of type E.
    [[nodiscard]] static std::string prints_x_and_error(const std::string& t) {
        return "        E::Values value, error;\n"
               "        if (e(" +
               t + ", value) != Status::ok || e.error_estimate(" + t +
               ", error) != Status::ok) return 1;\n"
               "        std::printf(\"%.17g\\n%.17g\\n\", value.x, error.x);\n";
    }
};

} // namespace

TEST_F(EmittedEstimate, IsThatOfTheCommand) {
    scene("[fix]\nk = \"1/2\"\n");
    const auto json = nlohmann::json::parse(
        printed("evaluate systems/spring/scenes/s.toml --eps 0.1 --t 0,1,5,9.5 --errors --format json"));
    const auto emitted =
        numbers("    const Evaluator<long double> e(0.1L);\n"
                "    const long double t[] = {0, 1, 5, 9.5, 10.5};\n"
                "    long double all[5];\n    Status status[5];\n"
                "    const auto report = e.error_batch(t, 5, all, status);\n"
                "    for (int i = 0; i < 4; ++i) {\n"
                "        Evaluator<long double>::Values error;\n"
                "        if (e.error_estimate(t[i], error) != Status::ok || all[i] != error.x) return 1;\n"
                "        std::printf(\"%.17Lg\\n\", error.x);\n    }\n"
                "    if (status[4] != Status::outside_interval || all[4] == all[4]) return 2;\n"
                "    if (report.count != 1 || report.first != 4) return 3;\n"
                "    Evaluator<long double>::Values last;\n"
                "    const auto copy = e;\n"
                "    if (copy.error_estimate(9.5L, last) != Status::ok || last.x != all[3]) return 4;\n");
    ASSERT_EQ(emitted.size(), 4U);
    const double scale = json["error_estimate"]["x"][3];
    EXPECT_GT(scale, 1e-7);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(emitted[i], json["error_estimate"]["x"][i].get<double>(), 1e-6 * scale) << i;
}

// k*x^4 is first seen by the weight that is left out: it moves the estimate, and not the outputs.
TEST_F(EmittedEstimate, HasTheParametersOfTheNextWeight) {
    scene("", "amplitude.x = 1\nphase.x = 0\n");
    const auto found = numbers("    for (const double k : {0.0, 3.0}) {\n"
                               "        using E = Evaluator<>;\n"
                               "        const E e(0.1, {.k = k});\n" +
                               prints_x_and_error("3") + "    }\n");
    ASSERT_EQ(found.size(), 4U);
    EXPECT_EQ(found[0], found[2]);
    EXPECT_GT(found[3], 1.5 * found[1]);
}

// So does a function that the user of the class gives.
TEST_F(EmittedEstimate, CallsTheFunctionsOfTheNextWeight) {
    write(scratch_.path() / "systems/spring/system.toml",
          "[system]\nname = \"spring\"\n[functions]\nc = { of = [\"s\"] }\n[variables]\n"
          "x = { role = \"fast\" }\ns = { role = \"slow\" }\n[equations]\n"
          "x = \"x'' + x + eps^2*c(s)*x = 0\"\ns = \"s' = eps\"\n");
    write(scratch_.path() / "systems/spring/scenes/s.toml",
          "order = 1\nerror_estimate = true\n[functions]\nc = { callable = true }\n[start]\n"
          "amplitude.x = 1\nphase.x = 0\ns = 0\n");
    const auto found = numbers(
        "    for (const double size : {1.0, 3.0}) {\n"
        "        const auto c = [size](int derivative, const auto& s) {\n"
        "            using Number = std::decay_t<decltype(s)>;\n"
        "            return derivative > 1 ? Number(0) : Number(size) * (derivative == 1 ? Number(1) : s);\n"
        "        };\n"
        "        using E = Evaluator<double, std::decay_t<decltype(c)>>;\n"
        "        const E e(0.1, E::Parameters{}, c);\n" +
        prints_x_and_error("9") + "    }\n");
    ASSERT_EQ(found.size(), 4U);
    EXPECT_EQ(found[0], found[2]);
    EXPECT_NEAR(found[3], 3 * found[1], 0.2 * found[3]);
}

TEST_F(EmittedEstimate, IsLeftOutUnlessItIsAskedFor) {
    scene("");
    EXPECT_NE(printed("generate systems/spring/scenes/s.toml").find("error_estimate"), std::string::npos);
    write(scratch_.path() / "systems/spring/scenes/s.toml", "order = 3\n[start]\nx = \"eps\"\n\"x'\" = 0\n");
    EXPECT_EQ(printed("generate systems/spring/scenes/s.toml").find("error_estimate"), std::string::npos);
    scene("");
    write(scratch_.path() / "systems/spring/scenes/s.toml", "order = 3\nerror_estimate = 1\n");
    const Outcome outcome = said("generate systems/spring/scenes/s.toml");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("error_estimate"), std::string::npos) << outcome.err;
}

} // namespace resonform::test
