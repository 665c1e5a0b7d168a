// SPDX-License-Identifier: GPL-3.0-or-later
// verify --report: whose report may be overwritten, and what becomes of it without gnuplot.
#include "support/command.hpp"

namespace resonform::test {

namespace {

class SlowReport : public CommandOfSpring {
protected:
    SlowReport() {
        const std::filesystem::path scenes = scratch_.path() / "systems/spring/scenes";
        write(scenes / "two.toml", read(scenes / "s.toml"));
        // Everything but gnuplot.
        run("mkdir bin; for p in sh bash g++ c++ cc gcc as ld rm " RESONFORM_CXX_COMPILER
            "; do ln -s $(command -v $p) bin/; done",
            scratch_.path());
    }
    [[nodiscard]] Outcome reported(const std::string& scene, const std::string& environment = "") const {
        return run(environment + " resonform verify systems/spring/scenes/" + scene + ".toml --report here",
                   scratch_.path());
    }
    [[nodiscard]] std::string without_gnuplot() const {
        return "PATH=" + std::filesystem::path(RESONFORM_COMMAND).parent_path().string() + ":$PWD/bin";
    }
};

} // namespace

TEST_F(SlowReport, OfAnotherSceneIsNotOverwritten) {
    ASSERT_EQ(reported("s", without_gnuplot()).code, 0);
    const std::string html = file("here/report.html");
    const Outcome other = reported("two", without_gnuplot());
    EXPECT_EQ(other.code, 2);
    EXPECT_EQ(other.out, "");
    EXPECT_NE(other.err.find("resonform: --report: the folder must not hold the report of another scene\n"
                             "  found: here/report.md of spring/s\n"
                             "  hint:  give another folder, or delete that report\n"),
              std::string::npos)
        << other.err;
    EXPECT_EQ(file("here/report.html"), html);
    EXPECT_EQ(reported("s", without_gnuplot()).code, 0) << "its own is";
    write(scratch_.path() / "here/report.md", "a report of mine\n");
    EXPECT_EQ(reported("s", without_gnuplot()).code, 2) << "nor what is no report of ours";
    EXPECT_EQ(file("here/report.md"), "a report of mine\n");
}

TEST_F(SlowReport, WithoutGnuplotHasNoFiguresAndSaysSo) {
    const Outcome outcome = reported("s", without_gnuplot());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    // Before any work.
    EXPECT_EQ(
        outcome.err.rfind(
            "resonform: gnuplot cannot be run, so the report will have no figures (Debian: gnuplot-nox)\n",
            0),
        0U)
        << outcome.err;
    const std::string page = file("here/report.md");
    EXPECT_NE(page.find("| figures | gnuplot could not be run |"), std::string::npos) << page;
    EXPECT_NE(page.find("## Order of accuracy"), std::string::npos);
    EXPECT_EQ(page.find("!["), std::string::npos) << "a figure that is not there";
    EXPECT_EQ(file("here/report.html").find("<figure>"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(scratch_.path() / "here/figures")) << "a folder of nothing";
}

// A gnuplot that never ends is as good as none.
TEST_F(SlowReport, WithAGnuplotThatHangs) {
    write(scratch_.path() / "bin/gnuplot", "#!/bin/sh\nexec sleep 300\n");
    const Outcome outcome = run("chmod +x bin/gnuplot; ln -s $(command -v sleep) bin/; " + without_gnuplot() +
                                    " resonform verify systems/spring/scenes/s.toml --report here",
                                scratch_.path());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("resonform: gnuplot does not answer within 10 s, so the report will have no "
                                "figures (Debian: gnuplot-nox)\n",
                                0),
              0U)
        << outcome.err;
}

// What is written of a report stands or falls together.
TEST_F(SlowReport, IsWholeOrNotThere) {
    ASSERT_EQ(reported("s", without_gnuplot()).code,
              0); // fills the cache, so that the next run writes the report only
    std::filesystem::remove_all(scratch_.path() / "here");
    const Outcome outcome = reported("s", "ulimit -f 4; " + without_gnuplot());
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("File too large"), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(scratch_.path() / "here"));
}

} // namespace resonform::test
