// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/scene_run.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>

namespace resonform::test {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double idle = 20; // times as long may a process take that does not get its processor

nlohmann::json packed(const SceneResult& r) {
    return {r.seed, r.roles,        r.order,  r.refused, r.reason,    r.wrong,          r.points,
            r.ulp,  r.ulp_extended, r.ladder, r.change,  r.caught_by, r.without_effect, r.seconds};
}

SceneResult unpacked(const nlohmann::json& j) {
    const auto number = [](const nlohmann::json& n) { // infinity is null
        return n.is_null() ? std::numeric_limits<double>::infinity() : n.get<double>();
    };
    return {j[0],         j[1],         j[2], j[3],  j[4],  j[5],  j[6],
            number(j[7]), number(j[8]), j[9], j[10], j[11], j[12], number(j[13])};
}

void write_line(int file, const std::string& text) {
    const std::string line = text + "\n";
    for (std::size_t done = 0; done < line.size();) {
        const ssize_t n = write(file, line.data() + done, line.size() - done);
        if (n < 0 && errno != EINTR) std::_Exit(1);
        if (n > 0) done += static_cast<std::size_t>(n);
    }
}

// What is under way, line by line; the last line is the result.
[[noreturn]] void answer(int file, std::uint64_t seed, TrialOptions options, double seconds) {
    setpgid(0, 0); // with what it starts
    const auto limit = static_cast<rlim_t>(std::ceil(seconds));
    const rlimit of_processor{limit, limit};
    setrlimit(RLIMIT_CPU, &of_processor);
    options.enter = [file](const std::string& what) { write_line(file, what); };
    SceneResult result;
    try {
        result = try_scene(seed, options);
    } catch (const std::exception& error) {
        result.seed = seed;
        result.wrong = error.what();
    }
    write_line(file, packed(result).dump());
    std::_Exit(0);
}

// Of finished lines.
std::string last_line(const std::string& text) {
    const std::size_t end = text.rfind('\n');
    if (end == std::string::npos || end == 0) return "";
    const std::size_t begin = text.rfind('\n', end - 1);
    return text.substr(begin == std::string::npos ? 0 : begin + 1,
                       end - (begin == std::string::npos ? 0 : begin + 1));
}

// What the process writes until it ends; false: it has not ended in time.
bool read_until(int file, Clock::time_point end, std::string& text) {
    std::array<char, 4096> buffer{};
    for (;;) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        if (left <= 0) return false;
        pollfd ready{file, POLLIN, 0};
        if (poll(&ready, 1, static_cast<int>(std::min<long long>(left, 1'000'000))) <= 0) continue;
        const ssize_t n = read(file, buffer.data(), buffer.size());
        if (n == 0) return true;
        if (n > 0) text.append(buffer.data(), static_cast<std::size_t>(n));
    }
}

SceneResult tried_apart(std::uint64_t seed, const TrialOptions& options, double seconds) {
    SceneResult result;
    result.seed = seed;
    result.wrong = "no process can be started";
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) return result;
    const pid_t child = fork();
    if (child == 0) answer(ends[1], seed, options, seconds);
    close(ends[1]);
    if (child > 0) {
        std::string text;
        const auto longest = std::chrono::milliseconds(static_cast<long long>(1000 * idle * seconds));
        const bool ended = read_until(ends[0], Clock::now() + longest, text);
        if (!ended) kill(-child, SIGKILL);
        int status = 0;
        while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
        }
        const bool spent =
            WIFSIGNALED(status) && (WTERMSIG(status) == SIGKILL || WTERMSIG(status) == SIGXCPU);
        if (!ended || spent) {
            result.wrong = too_long;
            result.reason = last_line(text);
            result.seconds = seconds;
        } else if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
            result = unpacked(nlohmann::json::parse(last_line(text)));
        else
            result.wrong = fmt::format("the process ended with status {} in {}", status, last_line(text));
    }
    close(ends[0]);
    return result;
}

void count(const SceneResult& r, RunSummary& s) {
    ++s.scenes;
    s.refused += static_cast<std::size_t>(r.refused);
    s.points += r.points;
    s.without_effect += static_cast<std::size_t>(r.without_effect);
    s.ulp = std::max(s.ulp, r.ulp);
    s.ulp_extended = std::max(s.ulp_extended, r.ulp_extended);
    if (r.wrong == too_long) {
        ++s.too_long;
    } else if (!r.wrong.empty()) {
        ++s.wrong;
    } else {
        ++s.right;
        ++s.caught_by[r.caught_by];
        if (r.ladder != "pass") ++s.undecided;
    }
}

} // namespace

RunSummary run_scenes(const RunOptions& options, const std::function<void(const SceneResult&)>& tell) {
    RunSummary summary;
    for (const std::uint64_t seed : options.seeds) {
        TrialOptions trial;
        trial.folder = options.folder / fmt::format("scene_{}_{}", getpid(), seed);
        trial.starts = options.starts;
        trial.compiled = options.compiled > 0 && seed % options.compiled == 0;
        std::filesystem::create_directories(trial.folder);
        const SceneResult result = tried_apart(seed, trial, options.seconds);
        std::filesystem::remove_all(trial.folder);
        count(result, summary);
        tell(result);
    }
    return summary;
}

std::string to_line(const SceneResult& r) {
    std::string line = fmt::format(
        "{:>5}  order {}  {:<28} {:>2} refused  {:>5} points  {:>8.3g} {:>8.3g} ulp  {:>5.1f} s  ", r.seed,
        r.order, r.roles, r.refused, r.points, r.ulp, r.ulp_extended, r.seconds);
    if (r.wrong == too_long)
        return fmt::format("{:>5}  ended after {:.0f} s in {}", r.seed, r.seconds, r.reason);
    if (!r.wrong.empty()) return line + "WRONG: " + r.wrong;
    line += fmt::format("{}: {}", r.caught_by, r.change);
    return r.ladder == "pass" ? line : line + "; ladder " + r.ladder;
}

std::string to_text(const RunSummary& s) {
    std::string text = fmt::format(
        "{} scenes: {} right, {} wrong, {} ended after their time; {} others were refused, {} ladders are "
        "undecided\n"
        "{} points, at most {:.3g} ulp in double and {:.3g} in long double\nchanges caught:",
        s.scenes, s.right, s.wrong, s.too_long, s.refused, s.undecided, s.points, s.ulp, s.ulp_extended);
    for (const auto& [check, times] : s.caught_by) text += fmt::format(" {} by {},", times, check);
    return text + fmt::format(" {} others were without effect\n", s.without_effect);
}

} // namespace resonform::test
