// SPDX-License-Identifier: GPL-3.0-or-later
// What cmake --install puts down is found by others, and by the program itself.
#include "support/shell.hpp"

#include <gtest/gtest.h>

namespace resonform::test {

// Not under sanitizers, whose libraries the user's program would have to link. (docs/first_hour.md has the
// headers alone.)
TEST(SlowInstall, LoopsAreLinkedAndTheProgramFindsItsOwnFiles) {
    const Scratch scratch;
    const auto here = [&](const std::string& command) {
        const Outcome outcome = run(command, scratch.path());
        EXPECT_EQ(outcome.code, 0) << command << '\n' << outcome.out << outcome.err;
        return outcome;
    };
    here("cmake --install " RESONFORM_BINARY_DIR " --prefix installed");
    write(scratch.path() / "main.cpp",
          "#include \"generated/henon_heiles/third_order.hpp\"\n#include \"runtime/batch.hpp\"\n#include "
          "<cstdio>\n"
          "int main() {\n    const resonform::generated::henon_heiles::third_order::Evaluator<double> "
          "e(0.01);\n"
          "    double t = 10, x = 0, y = 0;\n    if (!resonform::force_simd(resonform::Simd::baseline)) "
          "return 1;\n"
          "    std::printf(\"%zu\", e.batch(&t, 1, &x, &y).count);\n}\n");
    write(scratch.path() / "CMakeLists.txt",
          "cmake_minimum_required(VERSION 3.25)\nproject(user LANGUAGES CXX)\n"
          "find_package(resonform 0.1.0 EXACT REQUIRED)\nadd_executable(main main.cpp)\n"
          "target_link_libraries(main PRIVATE resonform::batch)\n");
    here("cmake -G Ninja -S . -B out -DCMAKE_PREFIX_PATH=$PWD/installed && cmake --build out");
    EXPECT_EQ(here("out/main").out, "0");

    const Outcome list = here("installed/bin/resonform list");
    EXPECT_NE(list.err.find((scratch.path() / "installed/share/resonform/systems").string()),
              std::string::npos)
        << list.err;
    here("rm installed/include/resonform/runtime/status.hpp"); // the program's own, not those of the source
                                                               // tree
    const Outcome verified =
        run("RESONFORM_CACHE=$PWD/cache installed/bin/resonform verify "
            "installed/share/resonform/systems/nonholonomic_particle/scenes/uniform_rise.toml",
            scratch.path());
    EXPECT_EQ(verified.code, 3) << verified.out << verified.err;
    EXPECT_NE(verified.err.find("installed/include/resonform/runtime/"), std::string::npos) << verified.err;
}

} // namespace resonform::test
