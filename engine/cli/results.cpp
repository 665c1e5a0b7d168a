// SPDX-License-Identifier: GPL-3.0-or-later
// resonform results DIR [SCENE ...] [--check]: the results of all scenes, as they are kept in docs/results.
#include "verify/report/results.hpp"
#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/complaint.hpp"
#include "cli/limits.hpp"
#include "cli/locations.hpp"
#include "cli/origin.hpp"
#include "cli/output.hpp"
#include "cli/pipeline.hpp"
#include "cli/scene_report.hpp"
#include "model/text/diagnostic.hpp"
#include "verify/judging/ladder.hpp"
#include "verify/report/page.hpp"
#include "verify/report/report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

struct ResultsRequest {
    fs::path folder;
    std::vector<std::string> scenes; // empty: all
    bool check;
    DerivationLimits limits;
};

struct Kept {
    std::string scene; // "system/scene"
    std::string state; // "written", "up to date"; "same", "different", "missing"; "failed"
    std::vector<std::string> differences = {};
};

struct SceneFile {
    fs::path file;
    std::string name; // "system/scene"
};

std::vector<SceneFile> all_scenes(const Home& home) {
    std::vector<SceneFile> all;
    for (const SystemFiles& files : list_systems(home))
        for (const fs::path& scene : files.scenes)
            all.push_back(
                {scene, files.system.parent_path().filename().string() + "/" + scene.stem().string()});
    return all;
}

// Those that were named, by path or as system/scene.
std::vector<SceneFile> asked_for(const ResultsRequest& request, const Home& home) {
    std::vector<SceneFile> all = all_scenes(home), named;
    if (request.scenes.empty()) return all;
    for (const std::string& text : request.scenes) {
        std::error_code ignored;
        const auto found = std::find_if(all.begin(), all.end(), [&](const SceneFile& scene) {
            return scene.name == text || fs::equivalent(scene.file, text, ignored);
        });
        if (found == all.end())
            bad_argument("SCENE", "results are kept of the scenes in systems/", text,
                         "give a name such as van_der_pol/to_the_cycle, or the path of its file");
        named.push_back(*found);
    }
    return named;
}

// nullopt: there are none, or they cannot be read.
std::optional<Json> kept_results(const fs::path& folder) {
    std::error_code ignored;
    if (!fs::exists(folder / "results.json", ignored)) return std::nullopt;
    Json json = Json::parse(read_file(folder / "results.json"), nullptr, false);
    if (!json.is_object() || json.value("schema", "") != "resonform.results/1") return std::nullopt;
    return json;
}

// A line a value, as document_text(), but half as long: for files that are kept.
std::string without_indents(const Json& json) {
    return json.dump(0, ' ', false, Json::error_handler_t::replace) + "\n";
}

class Results {
public:
    Results(const ResultsRequest& request, const Home& home)
        : request_(request), home_(home), cache_(home), drawn_(!request.check && figures_can_be_drawn()) {}

    Kept of(const SceneFile& scene) {
        const fs::path folder = request_.folder / scene.name;
        const std::optional<Json> kept = kept_results(folder);
        if (request_.check && !kept) return {scene.name, "missing"};
        // A program of the same commit gives the same: so a run that was ended goes on where it was.
        if (!request_.check && kept && kept->value("commit", "") == source_commit())
            return {scene.name, "up to date"};
        const SceneLine line = solve_scene(scene.file.string(), home_, request_.limits);
        const VerifyOptions options = verify_options(cache_, request_.limits);
        const report::Findings found = findings_of(
            line, verify(line.expanded.first_order, line.scene, line.solution, options), cache_,
            origin_of(fmt::format("resonform results {} {}", request_.folder.string(), scene.name)),
            !request_.check);
        if (request_.check) {
            std::vector<std::string> differences =
                report::differences(*kept, report::results_of(found, false));
            const char* state = differences.empty() ? "same" : "different";
            return {scene.name, state, std::move(differences)};
        }
        std::vector<TextFile> files =
            markdown_files(folder, report::make_report(found, options, drawn_, report::Extent::kept));
        files.push_back({folder / "results.json", without_indents(report::results_of(found))});
        write_files(files);
        return {scene.name, "written"};
    }

    // The summary of whatever is kept of the scenes of systems/.
    void summarize() const {
        std::vector<Json> all;
        for (const SceneFile& scene : all_scenes(home_))
            if (std::optional<Json> kept = kept_results(request_.folder / scene.name))
                all.push_back(std::move(*kept));
        const report::Page page = report::summary_page(all);
        write_files({{request_.folder / "README.md", report::to_markdown(page)},
                     {request_.folder / "index.html", report::to_html(page)}});
    }

private:
    const ResultsRequest& request_;
    const Home& home_;
    CacheFolder cache_;
    bool drawn_;
};

void print(const std::vector<Kept>& all, bool good, const std::string& format) {
    Json scenes = Json::array();
    for (const Kept& kept : all) {
        if (format == "text") {
            put("{:<56}{}\n", kept.scene, kept.state);
            for (const std::string& difference : kept.differences) put("  {}\n", difference);
        }
        scenes.push_back({{"scene", kept.scene}, {"state", kept.state}, {"differences", kept.differences}});
    }
    if (format == "json")
        put("{}",
            document_text(Json{{"schema", "resonform.results_made/1"}, {"good", good}, {"scenes", scenes}}));
}

int run_results(const ResultsRequest& request, const std::string& format) {
    const Home home = find_home();
    const std::vector<SceneFile> scenes = asked_for(request, home);
    if (!request.check) require_writable_folder(request.folder);
    Results results(request, home);
    Complaints complaints;
    std::vector<Kept> all;
    const auto begin = std::chrono::steady_clock::now();
    for (const SceneFile& scene : scenes) {
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
        show_progress(fmt::format("{} of {}, {:.0f} min so far: {}", all.size() + 1, scenes.size(),
                                  spent.count() / 60, scene.name));
        Kept kept{scene.name, "failed"};
        complaints.attempt([&] { kept = results.of(scene); });
        all.push_back(std::move(kept));
    }
    if (!request.check) results.summarize();
    const bool good = std::none_of(all.begin(), all.end(), [](const Kept& kept) {
        return kept.state == "different" || kept.state == "missing";
    });
    const int code = std::max<int>(complaints.code, good ? done : check_failed);
    print(all, code == done, format);
    return code;
}

} // namespace

void add_results(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand(
        "results", "the results of all scenes, to be kept: verdicts, run times, stability");
    const Text folder = add_required(*command, "DIR", "", "where they are kept: docs/results");
    const auto scenes = std::make_shared<std::vector<std::string>>();
    command->add_option("SCENE", *scenes,
                        "scenes as SYSTEM/SCENE, or the paths of their files; default: all");
    const auto check = std::make_shared<bool>(false);
    command->add_flag(
        "--check", *check,
        "write nothing; verify anew, and exit 1 where verdicts, orders, constants or ulp differ");
    const FormatOption format(*command, {"text", "json"});
    const LimitOptions limits(*command);
    on_choice(*command, action, [=] {
        return run_results({*folder, *scenes, *check, limits.value()}, format.value());
    });
}

} // namespace resonform
