// SPDX-License-Identifier: GPL-3.0-or-later
// docs/results: every scene in it is one of systems/, has its page and its line in the summary; one of them
// is made anew.
#include "support/documented.hpp"
#include "support/shell.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace resonform::test {

namespace {

namespace fs = std::filesystem;

const fs::path source_folder = RESONFORM_SOURCE_DIR, kept = source_folder / "docs/results";
constexpr std::uintmax_t largest = 10'000'000; // bytes of all together, a picture for each input
const std::string quick_scene = "van_der_pol/to_the_cycle";

std::vector<fs::path> results_documents() {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(kept))
        if (entry.path().filename() == "results.json") found.push_back(entry.path());
    return found;
}

} // namespace

TEST(KeptResults, AreOfScenesThatThereAre) {
    const std::string summary = read(kept / "README.md");
    ASSERT_GE(results_documents().size(), 3U);
    for (const fs::path& file : results_documents()) {
        const auto json = nlohmann::json::parse(read(file));
        const std::string system = json.at("system"), scene = json.at("scene");
        EXPECT_EQ(fs::relative(file, kept), fs::path(system) / scene / "results.json");
        EXPECT_TRUE(fs::exists(source_folder / "systems" / system / "scenes" / (scene + ".toml"))) << file;
        EXPECT_NE(summary.find("](" + system + "/" + scene + "/report.md)"), std::string::npos) << file;
        EXPECT_EQ(undocumented(json, file_formats()), std::set<std::string>()) << file;
        const std::string page = read(file.parent_path() / "report.md");
        const std::regex figure("\\]\\((figures/[^)]+)\\)");
        for (std::sregex_iterator at(page.begin(), page.end(), figure), end; at != end; ++at)
            EXPECT_TRUE(fs::exists(file.parent_path() / (*at)[1].str())) << file << (*at)[1];
    }
}

TEST(KeptResults, AreSmall) {
    std::uintmax_t bytes = 0;
    for (const auto& entry : fs::recursive_directory_iterator(kept))
        if (entry.is_regular_file()) bytes += entry.file_size();
    EXPECT_GT(bytes, 0U);
    EXPECT_LE(bytes, largest);
}

TEST(SlowKeptResults, AreFoundAnew) {
    const Outcome outcome = run("resonform results docs/results " + quick_scene + " --check", source_folder);
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    EXPECT_NE(outcome.out.find("same"), std::string::npos) << outcome.out;
}

} // namespace resonform::test
