// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/coverage.hpp"

#include "cli/complaint.hpp"
#include "cli/pipeline.hpp"
#include "fuzz/apart.hpp"
#include "fuzz/random_system.hpp"
#include "model/files/read_scene.hpp"
#include "verify/judging/ladder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <limits>

namespace resonform::test {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double megabytes = 4096;
constexpr std::size_t starts_of_emitted = 10;

constexpr int refused_by_watch = 3; // the exit code of a process that a Watch has ended

Scene written_scene(const WrittenScene& written, const fs::path& folder) {
    const fs::path system = folder / "random", file = system / "scenes" / "s.toml";
    fs::create_directories(file.parent_path());
    std::ofstream(system / "system.toml") << written.system;
    std::ofstream(file) << written.scene;
    return read_scene(file, folder);
}

bool is_of_the_list(const Error& error) {
    const Reason reason = error.diagnostic().reason;
    return error.kind() == ErrorKind::refused && reason != Reason::by_kind && reason != Reason::fault;
}

std::string word_of(const Error& error) { return to_string(error.diagnostic().reason, error.kind()); }

bool all_have_values(const Scene& scene) {
    const System& system = *scene.system;
    return std::all_of(system.parameters.begin(), system.parameters.end(), [&](const Parameter& p) {
        return scene.fix.count(p.name) > 0 ||
               std::any_of(system.relations.begin(), system.relations.end(),
                           [&](const ParameterRelation& r) { return r.parameter == p.name; });
    });
}

// What `generate` does.
Json derived(const WrittenScene& written, const fs::path& folder, const Tell& tell) {
    Json answer{{"outcome", "emitted"}, {"word", ""}, {"rule", ""}, {"what", ""}, {"values", false}};
    try {
        tell("reading");
        Scene scene = written_scene(written, folder);
        answer["values"] = all_have_values(scene);
        Watch watch({unlimited, megabytes, unlimited, false});
        tell("derivation and solution");
        const SceneLine line = solve_scene(std::move(scene), watch);
        tell("emission");
        header_of(line, watch);
    } catch (...) {
        const Error error = error_of(std::current_exception());
        answer["outcome"] = is_of_the_list(error) ? "refused" : "fault";
        answer["word"] = word_of(error);
        answer["rule"] = error.diagnostic().rule;
        answer["what"] = error.what();
    }
    return answer;
}

// A verdict: the worst of the scene.
Json verified(const WrittenScene& written, const fs::path& folder) {
    try {
        Watch watch({unlimited, megabytes, unlimited, false});
        const SceneLine line = solve_scene(written_scene(written, folder), watch);
        VerifyOptions options;
        options.cache = folder;
        options.compiled = false;
        options.emitted_starts = starts_of_emitted;
        const Verification done = verify(line.expanded.first_order, line.scene, line.solution, options);
        Json answer{{"word", "pass"}, {"what", ""}};
        const auto judge = [&](Verdict verdict, const std::string& what) {
            if (verdict == Verdict::pass || answer["word"] == "fault") return;
            answer = {{"word", verdict == Verdict::fail ? "fault" : "undecided"}, {"what", what}};
        };
        for (const auto* outputs : {&done.outputs, &done.defects})
            for (const OutputVerdict& output : *outputs)
                judge(output.verdict, fmt::format("ladder of {}: {}", output.name, output.reason));
        judge(done.emitted.verdict, to_text(done.emitted));
        return answer;
    } catch (...) {
        const Error error = error_of(std::current_exception());
        return {{"word", is_of_the_list(error) ? word_of(error) : "fault"}, {"what", error.what()}};
    }
}

void derive_apart(const WrittenScene& written, const CoverageOptions& options, const fs::path& folder,
                  Covered& system) {
    const Told told =
        told_apart([&](const Tell& tell) { tell(derived(written, folder, tell).dump()); }, options.seconds);
    const bool by_watch = WIFEXITED(told.status) && WEXITSTATUS(told.status) == refused_by_watch;
    system.what = told.last();
    if (told.end == Told::End::finished) {
        const Json answer = Json::parse(told.last());
        system.outcome = answer["outcome"] == "emitted"   ? Outcome::emitted
                         : answer["outcome"] == "refused" ? Outcome::refused
                                                          : Outcome::fault;
        system.reason = answer["word"];
        system.rule = answer["rule"];
        system.what = answer["what"];
        system.has_values = answer["values"];
    } else if (told.end == Told::End::spent) {
        system.outcome = Outcome::too_long;
    } else if (by_watch) {
        system.outcome = Outcome::refused;
        system.reason = to_string(Reason::memory, ErrorKind::refused);
    } else {
        system.reason = fmt::format("the process ended with status {}", told.status);
    }
}

void verify_apart(const WrittenScene& written, const CoverageOptions& options, const fs::path& folder,
                  Covered& system) {
    const Told told =
        told_apart([&](const Tell& tell) { tell(verified(written, folder).dump()); }, options.verify_seconds);
    if (told.end == Told::End::finished) {
        const Json answer = Json::parse(told.last());
        system.verification = answer["word"];
        system.what = answer["what"];
    } else {
        system.verification = told.end == Told::End::spent ? "too long" : "fault";
        system.what = fmt::format("the verification ended with status {}", told.status);
    }
}

void count(const Covered& system, Coverage& all) {
    ++all.systems;
    switch (system.outcome) {
    case Outcome::emitted: ++all.emitted; break;
    case Outcome::refused: all.refused[system.reason].push_back(system.seed); break;
    case Outcome::too_long: all.refused["too long"].push_back(system.seed); break;
    case Outcome::fault: all.faults[system.reason + ": " + system.rule].push_back(system.seed);
    }
    if (system.verification == "fault") all.faults["verification"].push_back(system.seed);
    if (!system.verification.empty()) ++all.verified[system.verification];
}

std::size_t judged(const Coverage& all) {
    std::size_t n = 0;
    for (const auto& [verdict, systems] : all.verified) n += verdict == "too long" ? 0 : systems;
    return n;
}

std::string table(const Coverage::Seeds& all) {
    constexpr std::size_t shown_seeds = 8;
    std::string text;
    for (const auto& [reason, seeds] : all) {
        const auto end = seeds.begin() + static_cast<std::ptrdiff_t>(std::min(seeds.size(), shown_seeds));
        text += fmt::format("{:>6}  {:<16}  {}{}\n", seeds.size(), reason,
                            fmt::join(seeds.begin(), end, ", "), end == seeds.end() ? "" : ", ...");
    }
    return text;
}

std::string in_one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

} // namespace

Coverage covered(const CoverageOptions& options, const std::function<void(const Covered&)>& tell) {
    Coverage all;
    for (std::size_t k = 0; k < options.systems; ++k) {
        const auto begin = std::chrono::steady_clock::now();
        Covered system;
        system.seed = options.first + k;
        const WrittenScene written = random_system(system.seed);
        system.roles = written.roles;
        system.order = written.order;
        const fs::path folder = options.folder / fmt::format("system_{}_{}", getpid(), system.seed);
        fs::create_directories(folder);
        derive_apart(written, options, folder, system);
        system.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        const bool due = judged(all) * options.systems < options.verified * (k + 1);
        if (due && system.outcome == Outcome::emitted && system.has_values)
            verify_apart(written, options, folder, system);
        fs::remove_all(folder);
        count(system, all);
        tell(system);
    }
    return all;
}

std::string to_line(const Covered& system) {
    const std::string line = fmt::format("{:>6}  order {}  {:<40} {:>6.1f} s  ", system.seed, system.order,
                                         system.roles, system.seconds);
    switch (system.outcome) {
    case Outcome::emitted: break;
    case Outcome::refused: return line + fmt::format("{}: {}", system.reason, in_one_line(system.what));
    case Outcome::too_long: return line + "too long: " + system.what;
    case Outcome::fault: return line + fmt::format("FAULT: {}: {}", system.reason, in_one_line(system.what));
    }
    if (system.verification.empty()) return line + "emitted";
    return line + fmt::format("emitted, verified: {} {}", system.verification, in_one_line(system.what));
}

std::string to_text(const Coverage& all) {
    std::string text =
        fmt::format("{} systems: {} emitted\nrefused:\n", all.systems, all.emitted) + table(all.refused);
    if (!all.faults.empty()) text += "FAULTS:\n" + table(all.faults);
    if (all.verified.empty()) return text;
    text += fmt::format("{} verified:", judged(all));
    for (const auto& [verdict, systems] : all.verified) text += fmt::format(" {} {},", systems, verdict);
    text.back() = '\n';
    return text;
}

} // namespace resonform::test
