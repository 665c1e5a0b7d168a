// SPDX-License-Identifier: GPL-3.0-or-later
// Every scene in systems/: what its evaluator gives is as accurate as it claims (or as its file expects).
#include "support/shell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace resonform {
namespace {

namespace fs = std::filesystem;

const fs::path source = RESONFORM_SOURCE_DIR;

std::vector<fs::path> scenes() {
    std::vector<fs::path> found;
    for (const auto& system : fs::directory_iterator(source / "systems"))
        if (fs::is_directory(system.path() / "scenes"))
            for (const auto& scene : fs::directory_iterator(system.path() / "scenes"))
                if (scene.path().extension() == ".toml") found.push_back(fs::relative(scene.path(), source));
    std::sort(found.begin(), found.end());
    return found;
}

class Scenes : public testing::TestWithParam<fs::path> {};

TEST_P(Scenes, AreAsAccurateAsTheyClaim) {
    const test::Outcome outcome = test::run("resonform verify " + GetParam().string(), source);
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

std::string name_of(const testing::TestParamInfo<fs::path>& scene) {
    return scene.param.parent_path().parent_path().filename().string() + "_" + scene.param.stem().string();
}

INSTANTIATE_TEST_SUITE_P(Slow, Scenes, testing::ValuesIn(scenes()), name_of);

} // namespace
} // namespace resonform
