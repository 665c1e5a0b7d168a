// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output.hpp"

#include "algebra/number/error.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

namespace resonform {

namespace {

[[noreturn]] void results_lost(int error) {
    Place place;
    place.key = "standard output";
    bad_input(Reason::file, {"the results must be writable", std::strerror(error),
                             "free space, or redirect them elsewhere", place});
}

} // namespace

void hold_streams() {
    // A file that grows too large makes its write fail and does not end the program.
    std::signal(SIGXFSZ, SIG_IGN); // NOLINT(cert-err33-c): without it all is as it was
    // open() takes the lowest free number, that of the closed stream. Reading from standard error and writing
    // to the others fails, as with the closed stream.
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) == -1 &&
            open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) != stream)
            results_lost(EBADF);
}

void print_result(std::string_view text) {
    errno = 0;
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) results_lost(errno);
}

void finish_results() {
    errno = 0;
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) results_lost(errno);
}

void say(std::string_view line) noexcept {
    std::fwrite(line.data(), 1, line.size(), stderr);
    std::fputc('\n', stderr);
}

void show_progress(const std::string& line) { say("  " + line); }

} // namespace resonform
