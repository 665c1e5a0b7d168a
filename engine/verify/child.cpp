// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/child.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
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

// Reads until the end of `output` or a signal; the signal, or 0.
int read_all(int output, int signals, std::string& text) {
    std::array<pollfd, 2> waits{{{output, POLLIN, 0}, {signals, POLLIN, 0}}};
    std::array<char, 4096> buffer{};
    for (;;) {
        if (poll(waits.data(), signals < 0 ? 1 : 2, -1) < 0 && errno != EINTR) return 0;
        signalfd_siginfo info{};
        if ((waits[1].revents & POLLIN) != 0 && read(signals, &info, sizeof info) == sizeof info)
            return static_cast<int>(info.ssi_signo);
        if (waits[0].revents == 0) continue;
        const ssize_t n = read(output, buffer.data(), buffer.size());
        if (n == 0 || (n < 0 && errno != EINTR)) return 0;
        if (n > 0) text.append(buffer.data(), static_cast<std::size_t>(n));
    }
}

int wait_for(pid_t child) {
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

Finished run_child(const std::string& command, const std::vector<std::filesystem::path>& drafts) {
    Finished finished;
    int signal = 0;
    {
        const Uninterrupted until_done;
        std::array<int, 2> ends{};
        if (pipe2(ends.data(), O_CLOEXEC) != 0) return finished;
        const Descriptor output(ends[0]);
        Descriptor input(ends[1]);
        const Descriptor signals(signalfd(-1, &until_done.held(), SFD_CLOEXEC));
        const pid_t child = start(command, input, until_done.before());
        if (child < 0) return finished;
        input.close();
        signal = read_all(output, signals, finished.output);
        if (signal != 0) kill(-child, SIGTERM);
        finished.status = wait_for(child);
    }
    if (signal == 0) return finished;
    std::error_code ignored;
    for (const std::filesystem::path& draft : drafts) std::filesystem::remove(draft, ignored);
    raise(signal); // and end, as if nothing had been running
    return finished;
}

} // namespace resonform
