// SPDX-License-Identifier: GPL-3.0-or-later
// Every mistake on the command line of a sweep: one message, exit code 2, nothing written.
#include "support/command.hpp"

namespace resonform::test {

namespace {

class SweepInput : public Command {
protected:
    SweepInput() {
        write(scratch_.path() / "systems/spring/system.toml",
              "[system]\nname = \"spring\"\n[parameters]\nk = { positive = true }\nh = {}\n[variables]\n"
              "x = { role = \"fast\" }\n[equations]\nx = \"x'' + x + k*x^3 + h*x^5 = 0\"\n");
        write(scratch_.path() / "systems/spring/scenes/s.toml",
              "order = 3\n[fix]\nh = 1\n[start]\namplitude.x = 1\nphase.x = 0\n");
    }
    void expect_message(const std::string& words, const std::string& message) const {
        expect_bad_input("sweep " + words, message);
        for (const char* left : {"o.npy", "o.json", "o.parts"})
            EXPECT_FALSE(std::filesystem::exists(scratch_.path() / left)) << words;
    }
    void of_scene(const std::string& words, const std::string& message) const {
        expect_message("systems/spring/scenes/s.toml --output o.npy " + words, message);
    }
};

} // namespace

TEST_F(SweepInput, Axes) {
    of_scene("", "--over: sweep needs it, once for each axis\n");
    of_scene("--over eps", "--over: an axis must be NAME=LO:HI:N");
    of_scene("--over eps=0.2:0.1:3",
             "--over: the ends of a range must be LO <= HI\n  found: eps=0.2:0.1:3\n");
    of_scene("--over 'eps=log(0:1:3)'", "--over: a logarithmic range must have LO > 0");
    of_scene("--over eps=0.1:0.2:0", "--over: N of LO:HI:N must be an integer from 1");
    of_scene("--over eps=0.1 --over eps=0.2", "--over: each name must be given once\n  found: eps\n");
    of_scene("--over eps=0.1:0.7:3", "--over: eps lies in 1e-12 <= eps <= 0.5");
    of_scene("--over k=1", "--over: one of the axes must be eps\n");
    of_scene("--over eps=0.1 --over h=1",
             "--over: an axis must not be a parameter that [fix] gives a value\n  found: h\n");
    of_scene("--over eps=0.1 --over k=1 --over psi=1",
             "--over: an axis must be eps, a parameter or a start value of the scene\n  found: psi\n"
             "  hint:  known are: eps, k, amplitude.x, phase.x");
    of_scene("--over eps=1e-3:0.5:1000000 --over k=1:2:1000000 --over phase.x=0:1:1000000",
             "--over: a sweep has at most 2^40 numbers: points x times x outputs\n");
    of_scene("--over eps=0.1",
             "systems/spring/scenes/s.toml:2:1: fix: a sweep needs an axis or a value for every "
             "parameter that the outputs depend on\n");
}

TEST_F(SweepInput, OtherOptions) {
    const std::string axes = "--over eps=0.1 --over k=1 ";
    of_scene(axes + "--t 1,-2", "--t: times must be >= 0 and finite\n");
    of_scene(axes + "--t nan", "--t: times must be >= 0 and finite\n");
    of_scene(axes + "--t 1,x", "--t: times must be decimal numbers or fractions, separated by commas\n"
                               "  found: x\n");
    of_scene(axes + "--t '1, 2'", "--t: times must be decimal numbers or fractions, separated by commas\n"
                                  "  found: ' 2'\n");
    for (const char* shard : {"0/4", "5/4", "1", "1/0", "a/4", "1/4x"})
        of_scene(axes + "--shard " + shard, "--shard: must be I/N with 1 <= I <= N <= 1000000\n");
    of_scene(axes + "--jobs 0", "--jobs: must be an integer from 1 to 1024\n");
    of_scene(axes + "--sample 0", "--sample: must be an integer from 1 to 16777216\n");
    of_scene(axes + "--seed 3", "--seed: must be given with --sample");
    of_scene(axes + "--what value", "--what: must be one of values, verify, validity, stability\n");
    of_scene(axes + "--what validity --tolerance 0",
             "--tolerance: must be a decimal number or a fraction > 0");
    of_scene(axes + "--what validity --tolerance none",
             "--tolerance: must be a decimal number or a fraction > 0\n");
    of_scene(axes + "--tolerance 1", "--tolerance: must be given with --what validity");
    for (const char* what : {"verify", "stability"})
        of_scene(axes + "--tolerance 1 --what " + what, "--tolerance: must be given with --what validity");
    for (const char* what : {"verify", "validity", "stability"})
        of_scene(axes + "--t 1 --what " + what, std::string("--t: must not be given with --what ") + what);
    of_scene(axes + "--map o.png", "--map: must end in .svg\n");
    of_scene(axes + "--map o.svg --shard 1/2", "--map: is of a whole sweep");
    of_scene(axes + "--map o.svg",
             "--map: a map must be of one or two axes of a grid with several values\n  found: 0 of them\n");
    of_scene("--over eps=0.1:0.2 --over k=1:2 --sample 5 --map o.svg",
             "--map: a map must be of one or two axes");
    of_scene("--over eps=0.1,0.3,0.2 --over k=1 --map o.svg",
             "--map: the values of an axis of a map must rise or fall\n");
    of_scene(axes + "--gather o", "--gather: reads what is swept from F.parts/, and takes no other option\n");
}

// Through order 1 the outputs do not depend on k; the motion does.
TEST_F(SweepInput, ErrorsNeedEveryParameterOfTheEquations) {
    write(scratch_.path() / "systems/spring/scenes/s.toml",
          "order = 1\n[fix]\nh = 1\n[start]\namplitude.x = 1\nphase.x = 0\n");
    of_scene("--over eps=0.1 --what verify",
             "systems/spring/scenes/s.toml:2:1: fix: verification needs a value for every parameter\n");
}

TEST_F(SweepInput, Files) {
    const std::string scene = "systems/spring/scenes/s.toml --over eps=0.1 --over k=1 ";
    expect_message("--over eps=0.1 --output o.npy", "SCENE: sweep needs it, the path of a scene file\n");
    expect_message(scene, "--output: sweep needs it, the file to be written\n");
    expect_message(scene + "--output o.txt", "--output: must end in .npy, .h5 or .csv\n  found: o.txt\n");
    expect_message(scene + "--output .npy", "--output: must end in .npy, .h5 or .csv\n");
    expect_message(scene + "--output nowhere/o.npy",
                   "nowhere/o.npy: the output must be a file in a folder that exists and can be written\n");
    expect_message("--gather o", "o.parts/sweep.json: the blocks of a sweep must be described by sweep.json");
    std::filesystem::create_directory(scratch_.path() / "o.csv");
    expect_message(scene + "--output o.csv", "o.csv: the output must be a file");
}

} // namespace resonform::test
