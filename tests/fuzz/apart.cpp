// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/apart.hpp"

#include <fcntl.h>
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

void write_line(int file, const std::string& text) {
    const std::string line = text + "\n";
    for (std::size_t done = 0; done < line.size();) {
        const ssize_t n = write(file, line.data() + done, line.size() - done);
        if (n < 0 && errno != EINTR) std::_Exit(1);
        if (n > 0) done += static_cast<std::size_t>(n);
    }
}

[[noreturn]] void run(int file, const std::function<void(const Tell&)>& work, double seconds) {
    setpgid(0, 0); // with what it starts
    const auto limit = static_cast<rlim_t>(std::ceil(seconds));
    const rlimit of_processor{limit, limit};
    setrlimit(RLIMIT_CPU, &of_processor);
    if (const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC); nowhere >= 0) {
        dup2(nowhere, STDOUT_FILENO);
        dup2(nowhere, STDERR_FILENO);
    }
    try {
        work([file](const std::string& line) { write_line(file, line); });
    } catch (...) {
        std::_Exit(1);
    }
    std::_Exit(0);
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

// Of finished lines.
std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0, end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
        lines.push_back(text.substr(begin, end - begin));
    return lines;
}

} // namespace

Told told_apart(const std::function<void(const Tell&)>& work, double seconds) {
    Told told;
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) return told;
    const pid_t child = fork();
    if (child == 0) run(ends[1], work, seconds);
    close(ends[1]);
    if (child > 0) {
        std::string text;
        const auto longest = std::chrono::milliseconds(static_cast<long long>(1000 * idle * seconds));
        const bool ended = read_until(ends[0], Clock::now() + longest, text);
        if (!ended) kill(-child, SIGKILL);
        while (waitpid(child, &told.status, 0) < 0 && errno == EINTR) {
        }
        const bool spent = WIFSIGNALED(told.status) &&
                           (WTERMSIG(told.status) == SIGKILL || WTERMSIG(told.status) == SIGXCPU);
        told.lines = lines_of(text);
        told.end = !ended || spent                                           ? Told::End::spent
                   : WIFEXITED(told.status) && WEXITSTATUS(told.status) == 0 ? Told::End::finished
                                                                             : Told::End::crashed;
    }
    close(ends[0]);
    return told;
}

} // namespace resonform::test
