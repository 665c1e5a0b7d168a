// SPDX-License-Identifier: GPL-3.0-or-later
// A sweep by four ranks has the bytes of one by a single program, also after a rank was killed.
#include "support/command.hpp"

#include <filesystem>

namespace resonform::test {

namespace {

class SweepMpi : public CommandOfSpring {
protected:
    void SetUp() override {
#ifndef RESONFORM_MPI
        GTEST_SKIP()
            << "resonform_mpi is not built: CMake found no MPI (Debian: libopenmpi-dev, openmpi-bin)";
#endif
    }
    // Leaks are those of Open MPI.
    [[nodiscard]] Outcome shell(const std::string& commands) const {
        return run("export ASAN_OPTIONS=detect_leaks=0\n"
                   "export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1\n"
                   "mpi() { mpirun -n 4 --oversubscribe \"$@\"; }\nS=systems/spring/scenes/s.toml\n" +
                       commands,
                   scratch_.path());
    }
};

std::string sweep_of(int phases) {
    return " sweep $S --over eps=1e-4:0.5:1000 --over phase.x=0:6:" + std::to_string(phases) + " --t 7 ";
}

} // namespace

TEST_F(SweepMpi, FourRanksAreAsOneProgram) {
    const std::string points = sweep_of(300);
    const Outcome outcome = shell("resonform" + points +
                                  "--output one.npy >said\n"
                                  "mpi resonform_mpi" +
                                  points +
                                  "--output four.npy\n"
                                  "cmp one.npy four.npy && cmp one.npy four.npy && echo same");
    EXPECT_NE(outcome.out.find("done     300000\n"), std::string::npos) << outcome.out << outcome.err;
    EXPECT_EQ(outcome.out.substr(outcome.out.size() - 5), "same\n") << outcome.out << outcome.err;
    EXPECT_EQ(outcome.out.find("done"), outcome.out.rfind("done")); // one rank speaks
}

// Killed when the first block is there: a second's work for all ranks is left.
TEST_F(SweepMpi, GoesOnAfterARankWasKilled) {
    if (!std::filesystem::exists("/proc/thread-self/children"))
        GTEST_SKIP() << "the kernel does not list the children of a process";
    const std::string points = sweep_of(1500);
    const Outcome outcome =
        shell("resonform" + points +
              "--output one.npy >said\n"
              "mpirun -n 4 --oversubscribe resonform_mpi" +
              points +
              "--output k.npy >said 2>&1 & pid=$!\n"
              "until [ -e k.parts/00000000.block ] || ! kill -0 $pid; do sleep 0.01; done\n"
              "kill -9 $(cut -d' ' -f 3 /proc/$pid/task/$pid/children)\n"
              "wait $pid; [ $? != 0 ] && echo ended; ls k.npy 2>/dev/null\n"
              "mpi resonform_mpi" +
              points + "--output k.npy >said 2>&1; echo $?; cmp one.npy k.npy && echo same");
    EXPECT_EQ(outcome.out, "ended\n0\nsame\n") << outcome.err;
}

TEST_F(SweepMpi, BadInputIsSaidOnce) {
    const Outcome outcome = shell(
        "mpi resonform_mpi sweep $S --over eps=0.9 --output a.npy 2>said; echo $?; grep -c ^resonform: said");
    EXPECT_EQ(outcome.out, "2\n1\n") << file("said");
}

TEST_F(SweepMpi, TheOtherProgramIsNamed) {
    const Outcome outcome = shell("mpi resonform sweep $S --over eps=0.1 --output a.npy");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(
        outcome.err.find("resonform: a sweep by the ranks of mpirun needs the program that is made for it\n"
                         "  found: resonform on 4 ranks\n"
                         "  hint:  write mpirun -n 4 resonform_mpi sweep ...\n"),
        std::string::npos)
        << outcome.err;
}

} // namespace resonform::test
