// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/run/child.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <utility>

namespace resonform {

namespace {

bool is_ignored(int signal) {
    struct sigaction action {};
    return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    operator int() const { return number_; }
    void close() {
        if (number_ >= 0) ::close(std::exchange(number_, -1));
    }

private:
    int number_;
};

// -1: no process could be made. Nothing is called between fork and exec that may not be there.
pid_t start(const std::string& command, int output, const sigset_t& mask) {
    const pid_t child = fork();
    if (child == 0) {
        setpgid(0, 0);
        sigprocmask(SIG_SETMASK, &mask, nullptr);
        dup2(output, STDOUT_FILENO);
        execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
        _exit(127);
    }
    if (child > 0) setpgid(child, child); // whoever is first
    return child;
}

class Deadline {
public:
    explicit Deadline(double seconds) : seconds_(seconds) {}
    // As poll takes them; -1: without end.
    [[nodiscard]] int milliseconds_left() const {
        if (!std::isfinite(seconds_)) return -1;
        const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - begin_;
        return static_cast<int>(std::ceil(1000 * std::clamp(seconds_ - gone.count(), 0.0, 1e6)));
    }

private:
    double seconds_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

// Why a child was ended early: a signal, or its time was over.
struct Cut {
    int signal = 0;
    bool late = false;
    explicit operator bool() const { return signal != 0 || late; }
};

int read_signal(int signals) {
    signalfd_siginfo info{};
    return read(signals, &info, sizeof info) == sizeof info ? static_cast<int>(info.ssi_signo) : 0;
}

// Reads until the end of `output`.
Cut read_all(int output, int signals, const Deadline& deadline, std::string& text) {
    std::array<pollfd, 2> waits{{{output, POLLIN, 0}, {signals, POLLIN, 0}}};
    std::array<char, 4096> buffer{};
    for (;;) {
        const int ready = poll(waits.data(), waits.size(), deadline.milliseconds_left());
        if (ready < 0 && errno != EINTR) return {};
        if (ready == 0) return {0, true};
        if (ready < 0) continue;
        if ((waits[1].revents & POLLIN) != 0)
            if (const int signal = read_signal(signals); signal != 0) return {signal, false};
        if (waits[0].revents == 0) continue;
        const ssize_t n = read(output, buffer.data(), buffer.size());
        if (n == 0 || (n < 0 && errno != EINTR)) return {};
        if (n > 0) text.append(buffer.data(), static_cast<std::size_t>(n));
    }
}

// Waits for the end of a child, which may have closed its output long before.
Cut wait_for(pid_t child, int signals, const Deadline& deadline, int& status) {
    constexpr int tick = 1; // ms
    pollfd wait{signals, POLLIN, 0};
    for (;;) {
        const pid_t ended = waitpid(child, &status, WNOHANG);
        if (ended == child || (ended < 0 && errno != EINTR)) return {};
        if (deadline.milliseconds_left() == 0) return {0, true};
        if (poll(&wait, 1, tick) > 0)
            if (const int signal = read_signal(signals); signal != 0) return {signal, false};
    }
}

int reap(pid_t child) {
    int status = -1;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

} // namespace

Uninterrupted::Uninterrupted() {
    sigemptyset(&held_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        if (!is_ignored(signal)) sigaddset(&held_, signal);
    pthread_sigmask(SIG_BLOCK, &held_, &before_);
}

Uninterrupted::~Uninterrupted() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

Finished run_child(const std::string& command, const std::vector<std::filesystem::path>& drafts,
                   double seconds) {
    Finished finished;
    Cut cut;
    {
        const Uninterrupted until_done;
        std::array<int, 2> ends{};
        if (pipe2(ends.data(), O_CLOEXEC) != 0) return finished;
        const Descriptor output(ends[0]);
        Descriptor input(ends[1]);
        const Descriptor signals(signalfd(-1, &until_done.held(), SFD_CLOEXEC));
        const Deadline deadline(seconds);
        const pid_t child = start(command, input, until_done.before());
        if (child < 0) return finished;
        input.close();
        cut = read_all(output, signals, deadline, finished.output);
        if (!cut) cut = wait_for(child, signals, deadline, finished.status);
        if (cut) {
            kill(-child, cut.late ? SIGKILL : SIGTERM);
            finished.status = reap(child);
        }
    }
    if (!cut) return finished;
    finished.late = cut.late;
    std::error_code ignored;
    for (const std::filesystem::path& draft : drafts) std::filesystem::remove(draft, ignored);
    if (cut.signal != 0) raise(cut.signal); // and end, as if nothing had been running
    return finished;
}

std::string shell_quoted(const std::filesystem::path& path) {
    std::string out = "'";
    for (const char c : path.string()) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

} // namespace resonform
