// SPDX-License-Identifier: GPL-3.0-or-later
// A sweep has the numbers of the evaluator, and the same bytes however it was cut, stopped and gathered.
#include "support/command.hpp"
#include "support/documented.hpp"

#include <cmath>
#include <csignal>
#include <cstring>
#include <sstream>

namespace resonform::test {

namespace {

using Json = nlohmann::json;

class Sweep : public SweepOfSpring {
protected:
    [[nodiscard]] Json json(const std::string& name) const { return Json::parse(file(name)); }
};

const std::string grid = "--over 'eps=log(1e-3:1e-1:3)' --over amplitude.x=0.5:1:2 --t 0,1/3,2 ";

std::vector<double> numbers_of(const std::string& npy) {
    const std::size_t head =
        10 + static_cast<unsigned char>(npy[8]) + 256U * static_cast<unsigned char>(npy[9]);
    EXPECT_EQ(head % 64, 0U);
    EXPECT_EQ(npy[head - 1], '\n');
    std::vector<double> numbers((npy.size() - head) / sizeof(double));
    std::memcpy(numbers.data(), npy.data() + head, numbers.size() * sizeof(double));
    return numbers;
}

} // namespace

TEST_F(Sweep, HasTheNumbersOfTheEvaluator) {
    const Outcome outcome = shell("sweep " + grid + "--output a.csv && sweep " + grid + "--output a.npy");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string npy = file("a.npy");
    EXPECT_EQ(npy.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
    EXPECT_EQ(npy.substr(10, 67), "{'descr': '<f8', 'fortran_order': False, 'shape': (3, 2, 3, 1), }  ");
    const std::vector<double> numbers = numbers_of(npy);
    ASSERT_EQ(numbers.size(), 18U);
    std::istringstream lines(file("a.csv"));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "eps,amplitude.x,t,x,status");
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        std::getline(lines, line);
        double eps = 0, amplitude = 0, t = 0, x = 0;
        ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,ok", &eps, &amplitude, &t, &x), 4) << line;
        EXPECT_EQ(eps, (std::vector{0.001, 0.01, 0.1})[i / 6]);
        EXPECT_EQ(amplitude, (std::vector{0.5, 1.0})[i / 3 % 2]);
        EXPECT_EQ(t, (std::vector{0.0, 1.0 / 3, 2.0})[i % 3]);
        EXPECT_EQ(x, numbers[i]);
        const double closed = eps * amplitude * std::cos(t); // order 1
        EXPECT_NEAR(x, closed, 1e-15 * eps);
    }
}

TEST_F(Sweep, TheEndOfTheIntervalIsTheDefaultTime) {
    write(scratch_.path() / "systems/spring/scenes/s.toml",
          "order = 1\n[start]\namplitude.x = 1\nphase.x = 0\n[verify]\ninterval = \"5/eps\"\n");
    ASSERT_EQ(shell("sweep --over eps=0.1,1/64 --output a.csv").code, 0);
    EXPECT_EQ(file("a.csv").substr(0, 29), "eps,t,x,status\n0.100000000000");
    EXPECT_NE(file("a.csv").find("\n0.015625,320,"), std::string::npos) << file("a.csv");
    EXPECT_EQ(json("a.json")["t"], "5/eps");
}

TEST_F(Sweep, JsonIsDocumented) {
    const Outcome outcome = shell("sweep " + grid + "--output a.csv --format json");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Json document = Json::parse(outcome.out);
    EXPECT_EQ(document, json("a.json"));
    EXPECT_EQ(undocumented(document, file_formats()), std::set<std::string>());
    EXPECT_EQ(document["points"], 6);
    EXPECT_EQ(document["done"], 6);
    EXPECT_EQ(document["statuses"], (Json{{"ok", 18}}));
    EXPECT_EQ(document["axes"][0]["values"], (Json{0.001, 0.01, 0.1}));
}

// Against the estimates that evaluate prints: below the tolerance up to there, and above it right behind.
TEST_F(Sweep, ValidityEndsWhereTheEstimateExceedsTheTolerance) {
    const std::string validity = "sweep --over eps=0.1,0.01 --what validity --output ";
    ASSERT_EQ(shell(validity + "a.npy --tolerance 1e-3").code, 0);
    const std::vector<double> end = numbers_of(file("a.npy"));
    ASSERT_EQ(end.size(), 2U);
    const std::string t = std::to_string(end[0] - 0.003) + "," + std::to_string(end[0] + 0.003);
    const Json errors = Json::parse(
        shell("resonform evaluate systems/spring/scenes/s.toml --eps 0.1 --errors --format json --t " + t)
            .out);
    EXPECT_LT(errors["error_estimate"]["x"][0], 1e-3);
    EXPECT_GT(errors["error_estimate"]["x"][1], 1e-3);
    EXPECT_GT(end[0], 2);
    EXPECT_EQ(end[1], 5); // the interval
    EXPECT_EQ(json("a.json")["tolerance"], 1e-3);
    EXPECT_EQ(undocumented(json("a.json"), file_formats()), std::set<std::string>());
}

// The pendulum's y starts with an error of the next order, its psi and x without one.
TEST_F(Sweep, ValidityIsZeroWhereTheErrorExceedsTheToleranceFromTheStart) {
    ASSERT_EQ(shell("resonform sweep " RESONFORM_SOURCE_DIR
                    "/systems/almost_holonomic_pendulum/scenes/third_order.toml "
                    "--over eps=0.1 --what validity --tolerance 1e-8 --output a.npy")
                  .code,
              0);
    const std::vector<double> end = numbers_of(file("a.npy"));
    ASSERT_EQ(end.size(), 3U);
    EXPECT_GT(end[0], 0);
    EXPECT_GT(end[1], 0);
    EXPECT_EQ(end[2], 0);
}

// In the order 1 of this spring the error of x is 3/8 eps^3 t sin t, about.
TEST_F(Sweep, ErrorsHaveTwoQuantities) {
    const std::string errors = "--over eps=0.1,0.05 --over amplitude.x=0.5,1 --what verify ";
    const Outcome outcome =
        shell("sweep " + errors + "--output a.csv && sweep " + errors +
              "--output b.npy --shard 2/2 >said && rm a.parts/00000002.block && sweep " + errors +
              "--output b.npy >said && sweep " + errors + "--output a.npy >said && cmp a.npy b.npy");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string npy = file("a.npy");
    EXPECT_EQ(npy.substr(10, 67), "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2, 2, 1), }  ");
    const std::vector<double> numbers = numbers_of(npy);
    ASSERT_EQ(numbers.size(), 8U);
    for (std::size_t i = 0; i < 4; ++i) {
        const double eps = i < 2 ? 0.1 : 0.05, amplitude = i % 2 == 0 ? 0.5 : 1;
        EXPECT_NEAR(numbers[2 * i] / std::pow(eps * amplitude, 3), 1.8, 0.1);
        EXPECT_EQ(numbers[2 * i + 1], 3);
    }
    EXPECT_EQ(file("a.csv").substr(0, 40), "eps,amplitude.x,quantity,t,x,status\n0.10");
    EXPECT_NE(file("a.csv").find(",order,5,3,ok\n"), std::string::npos) << file("a.csv");
    EXPECT_EQ(json("a.json")["quantities"], (Json{"error", "order"}));
    EXPECT_EQ(json("a.json")["statuses"], (Json{{"ok", 8}}));
    EXPECT_EQ(undocumented(json("a.json"), file_formats()), std::set<std::string>());
    const Outcome other =
        shell("sed -i 's/x^3/x^3 + x^5/' systems/spring/system.toml; sweep " + errors + "--output a.npy");
    EXPECT_EQ(other.code, 2); // the emitted code is the same, its error is not
    EXPECT_NE(other.err.find("found: blocks of another 'code'\n"), std::string::npos) << other.err;
}

TEST_F(Sweep, StabilityIsTheWorstUlp) {
    ASSERT_EQ(shell("sweep --over eps=0.1,1e-9 --over amplitude.x=1,1e200 --what stability --output a.csv && "
                    "resonform sweep --gather a.npy")
                  .code,
              0);
    const std::vector<double> ulp = numbers_of(file("a.npy"));
    ASSERT_EQ(ulp.size(), 4U);
    for (const std::size_t i : {0U, 2U}) EXPECT_TRUE(ulp[i] > 0 && ulp[i] < 4) << ulp[i];
    EXPECT_TRUE(std::isnan(ulp[1]));
    EXPECT_EQ(json("a.json")["quantities"], Json::array({"ulp"}));
    EXPECT_EQ(json("a.json")["statuses"]["ok"], 2);
    EXPECT_EQ(undocumented(json("a.json"), file_formats()), std::set<std::string>());
}

TEST_F(Sweep, WhatIsNoNumberIsNaN) {
    ASSERT_EQ(shell("sweep --over eps=0.1 --over amplitude.x=1,1e200 --t 1 --output a.npy").code, 0);
    const std::vector<double> numbers = numbers_of(file("a.npy"));
    ASSERT_EQ(numbers.size(), 2U);
    EXPECT_TRUE(std::isfinite(numbers[0]));
    EXPECT_TRUE(std::isnan(numbers[1]));
    EXPECT_EQ(json("a.json")["statuses"]["ok"], 1);
}

TEST_F(Sweep, ShardsAndThreadsChangeNoByte) {
    const std::string sample = "--over eps=1e-4:0.5 --over phase.x=-1:1 --sample 3000 --seed 5 ";
    const Outcome outcome =
        shell("sweep " + sample +
              "--output whole.npy --jobs 1\n"
              "for i in 3 1 2; do sweep " +
              sample +
              "--output cut.npy --jobs 3 --shard $i/3; done\n"
              "ls cut.npy 2>/dev/null; rm cut.json; resonform sweep --gather cut >said && cat cut.json");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(file("whole.npy"), file("cut.npy"));
    EXPECT_EQ(Json::parse(outcome.out.substr(outcome.out.find("\n{") + 1))["done"], 3000);
    ASSERT_EQ(shell("resonform sweep --gather cut.csv").code, 0); // the same blocks, another form
    EXPECT_EQ(file("cut.csv").substr(0, 23), "eps,phase.x,t,x,status\n");
}

TEST_F(Sweep, GatheringSaysWhatIsMissing) {
    const Outcome outcome = shell("sweep --over eps=1e-4:0.5:1000 --t 1 --output a.npy --shard 2/2 >said\n"
                                  "resonform sweep --gather a");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("resonform: --gather: all blocks of the sweep must be there\n"
                               "  found: 125 of 250; block 0 is the first that is missing\n"),
              std::string::npos)
        << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(scratch_.path() / "a.npy"));
    EXPECT_EQ(json("a.json")["done"], 500);
}

// Killed twice in the middle, one block cut and one taken away: computed are those which are missing.
TEST_F(Sweep, GoesOnAfterAKill) {
    const std::string points = "--over eps=1e-4:0.5:1000 --over phase.x=0:6:300 --t 7 --jobs 1 ";
    const auto killed = [&](const std::string& signal, const std::string& block) {
        return "set -m; sweep " + points +
               "--output k.npy & pid=$!\n"
               "until [ -e k.parts/" +
               block +
               ".block ]; do :; done\n"
               "kill -" +
               signal + " -$pid; wait $pid; echo ended $?\n";
    };
    const Outcome outcome = shell("sweep " + points + "--output whole.npy >said\n" +
                                  killed("TERM", "00000005") + killed("KILL", "00000040") +
                                  "ls k.npy k.json 2>/dev/null\n"
                                  "rm k.parts/00000001.block; truncate -s -1 k.parts/00000002.block\n"
                                  "touch before; sleep 0.05\n"
                                  "sweep " +
                                  points +
                                  "--output k.npy >said\n"
                                  "find k.parts -name '0000000[0-5].block' -newer before | sort\n"
                                  "ls k.parts | grep -c part$\n");
    EXPECT_EQ(outcome.out, "ended 143\nended 137\n"
                           "k.parts/00000001.block\nk.parts/00000002.block\n0\n")
        << outcome.err;
    EXPECT_TRUE(file("k.npy") == file("whole.npy"));
    EXPECT_EQ(json("k.json")["done"], 300000);
}

TEST_F(Sweep, MapsOneOrTwoAxes) {
    if (run("gnuplot -e 'set terminal svg'", scratch_.path()).code != 0) GTEST_SKIP() << "no gnuplot";
    const Outcome outcome = shell("sweep --over 'eps=log(1e-3:0.1:300)' --over amplitude.x=1 --t 1 --output "
                                  "line.npy --map line.svg >said &&\n"
                                  "sweep --over 'eps=log(1e-3:0.1:3)' --over amplitude.x=1,3,4 --t 1 "
                                  "--output map.npy --map map.svg >said &&\n"
                                  "cp map.svg before.svg && rm map.svg &&\n"
                                  "sweep --over 'eps=log(1e-3:0.1:3)' --over amplitude.x=1,3,4 --t 1 "
                                  "--output map.npy --map map.svg >said &&\n"
                                  "cmp map.svg before.svg");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(file("line.svg").find("x at t = 1"), std::string::npos);
    const std::string map = file("map.svg");
    for (const char* text : {"x at t = 1", "ε", "amplitude.x"})
        EXPECT_NE(map.find(text), std::string::npos) << text;
    std::size_t cells = 0; // each a polygon, besides the 128 of the colour box
    for (std::size_t at = 0; (at = map.find("<polygon", at)) != std::string::npos; ++at) ++cells;
    EXPECT_EQ(cells, 128U + 9U);
    const Outcome empty = shell("sweep --over eps=0.1,0.2 --over amplitude.x=1e300 --t 1 --output no.npy "
                                "--map no.svg");
    EXPECT_EQ(empty.code, 2);
    EXPECT_EQ(empty.out, "");
    EXPECT_NE(
        empty.err.find("resonform: --map: a map must have a number to show\n"
                       "  found: none at the 2 points that are drawn\n"
                       "  hint:  leave out --map: what is computed is kept, and the statuses say why\n"),
        std::string::npos)
        << empty.err;
    for (const char* name : {"no.npy", "no.svg", "no.json"}) EXPECT_EQ(file(name), "") << name;
}

TEST_F(Sweep, BlocksOfAnotherSweepAreRefused) {
    ASSERT_EQ(
        shell(
            "sweep --over eps=0.1,0.2 --t 1 --output a.npy && sweep --over eps=0.1,0.3 --t 1 --output b.npy")
            .code,
        0);
    const auto refused = [&](const std::string& commands, const std::string& found) {
        const Outcome outcome = shell(commands);
        EXPECT_EQ(outcome.code, 2) << commands;
        EXPECT_NE(outcome.err.find("found: " + found + "\n"), std::string::npos) << outcome.err;
    };
    refused("sweep --over eps=0.1,0.3 --t 1 --output a.npy", "blocks of another 'grid'");
    refused("sweep --over eps=0.1,0.2 --t 2 --output a.npy", "blocks of another 't'");
    refused("sed -i 's/order = 1/order = 2/' systems/spring/scenes/s.toml; sweep --over eps=0.1,0.2 --t 1 "
            "--output a.npy",
            "blocks of another 'code'");
    refused("cp b.parts/00000001.block a.parts/; resonform sweep --gather a", "a block of another sweep");
    EXPECT_EQ(shell("sed -i 's/order = 2/order = 1/' systems/spring/scenes/s.toml; rm -r a.parts/*.block\n"
                    "sweep --over eps=1/10,2e-1 --t 1.0 --output a.csv")
                  .code,
              0); // the same, written otherwise
}

} // namespace resonform::test
