// SPDX-License-Identifier: GPL-3.0-or-later
// Programs that are run beside this one (a compiler, gnuplot), and the signals that end both.
#pragma once

#include <csignal>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace resonform {

// Holds back the signals that would end the program between two steps that belong together. Those that the
// program ignores stay ignored.
class Uninterrupted {
public:
    Uninterrupted();
    ~Uninterrupted();
    Uninterrupted(const Uninterrupted&) = delete;
    Uninterrupted& operator=(const Uninterrupted&) = delete;

    [[nodiscard]] const sigset_t& held() const { return held_; }
    // The signals that were blocked before.
    [[nodiscard]] const sigset_t& before() const { return before_; }

private:
    sigset_t held_{}, before_{};
};

struct Finished {
    std::string output; // standard output of the command
    int status = -1;    // as waitpid gives it; -1: not started
    bool late = false;  // ended because its time was over
};

// Runs a command of the shell to its end, in a process group of its own. A signal that ends this program
// meanwhile (SIGINT, SIGTERM, SIGHUP), or the end of its time, first ends the whole group and removes
// `drafts`.
Finished run_child(const std::string& command, const std::vector<std::filesystem::path>& drafts,
                   double seconds = std::numeric_limits<double>::infinity());

// A path as one word of such a command.
std::string shell_quoted(const std::filesystem::path& path);

} // namespace resonform
