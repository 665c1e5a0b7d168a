// SPDX-License-Identifier: GPL-3.0-or-later
// Every source in the tree is compiled: a test that is moved into a folder of its own must not drop out of
// the build in silence.
#include "house/tree.hpp"
#include "support/shell.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <fstream>
#include <set>

namespace resonform::test {

namespace {

namespace fs = std::filesystem;

const std::string rivals = "tests/bench/rivals/"; // bench_normal_form compiles them when it runs

// What the compiler is given in a build folder; of a unit that joins sources, these.
std::set<std::string> compiled_in(const fs::path& build, const fs::path& root) {
    std::set<std::string> compiled;
    for (const auto& command : nlohmann::json::parse(std::ifstream(build / "compile_commands.json"))) {
        const fs::path file = command.at("file").get<std::string>();
        std::vector<fs::path> sources{file};
        if (file.parent_path().filename() == "Unity") {
            sources.clear();
            std::ifstream unit(file);
            for (std::string line; std::getline(unit, line);)
                if (const auto source = included_file(line)) sources.emplace_back(*source);
        }
        for (const fs::path& source : sources) compiled.insert(fs::relative(source, root).string());
    }
    return compiled;
}

std::vector<std::string> left_out(const std::vector<SourceFile>& files,
                                  const std::set<std::string>& compiled) {
    std::vector<std::string> missing;
    for (const SourceFile& file : files)
        if (compiled.count(file.path) == 0 && file.path.compare(0, rivals.size(), rivals) != 0)
            missing.push_back(file.path);
    return missing;
}

} // namespace

TEST(Built, IsEverySourceOfTheTree) {
    const auto sources = files_below({"engine", "tests"}, {".cpp"});
    ASSERT_GT(sources.size(), 300U);
#ifdef RESONFORM_MPI
    const std::vector<std::string> expected;
#else
    const std::vector<std::string> expected{"engine/mpi/main.cpp"}; // CMake found no MPI
#endif
    EXPECT_EQ(left_out(sources, compiled_in(RESONFORM_BINARY_DIR, RESONFORM_SOURCE_DIR)), expected);
}

TEST(Built, IsASourceTwoLevelsDeep) {
    const Scratch scratch;
    const auto file = [&](const std::string& name, const std::string& text) {
        fs::create_directories((scratch.path() / name).parent_path());
        write(scratch.path() / name, text);
    };
    file("CMakeLists.txt", "cmake_minimum_required(VERSION 3.25)\nproject(planted LANGUAGES CXX)\n"
                           "set(CMAKE_EXPORT_COMPILE_COMMANDS ON)\n"
                           "include(" RESONFORM_SOURCE_DIR "/cmake/rooms.cmake)\nadd_room(algebra)\n");
    file("engine/algebra/ring/packed/word.cpp", "int word() { return 0; }\n");
    file("tests/algebra/ring/check_word.cpp", "int check() { return 0; }\n");
    const Outcome configured = run("cmake -G Ninja -B build -DCMAKE_UNITY_BUILD=ON .", scratch.path());
    ASSERT_EQ(configured.code, 0) << configured.err;
    const std::vector<std::string> expected{"tests/algebra/ring/check_word.cpp"}; // of no target here
    EXPECT_EQ(left_out(files_below(scratch.path(), {"engine", "tests"}, {".cpp"}),
                       compiled_in(scratch.path() / "build", scratch.path())),
              expected);
}

} // namespace resonform::test
