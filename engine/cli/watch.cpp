// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/watch.hpp"

#include "cli/complaint.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>

namespace resonform {

namespace {

constexpr std::chrono::milliseconds tick(20);

// 0 where the system does not tell.
double resident_megabytes() {
    std::ifstream statm("/proc/self/statm");
    double size = 0, resident = 0;
    statm >> size >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

Diagnostic exceeded(Reason reason, const std::string& option, const std::string& limit,
                    const std::string& where, const std::string& larger) {
    Place place;
    place.key = option;
    return {limit, where,
            fmt::format("simplify the system, ask for a lower order, or give {} {}", option, larger), place,
            reason};
}

// The limit to suggest: ten times the limit or, if that would soon be passed as well (the limit was at most
// half of the time used), ten times the time used, in whole seconds.
std::string larger_time(double limit, double used) {
    if (limit > used / 2) return fmt::format("{:g}", 10 * limit);
    return fmt::format("{:.0f}", std::ceil(10 * used));
}

// Signals are for the first thread, which may hold them back while it writes a file.
std::thread without_signals(const std::function<void()>& run) {
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    std::thread thread(run);
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    return thread;
}

} // namespace

Watch::Watch(const DerivationLimits& limits) : limits_(limits), thread_(without_signals([this] { run(); })) {}

Watch::~Watch() {
    {
        const std::lock_guard lock(mutex_);
        over_ = true;
    }
    changed_.notify_one();
    thread_.join();
}

void Watch::enter(const std::string& step) {
    const std::lock_guard lock(mutex_);
    step_ = step;
}

void Watch::certified(const std::string& weight) {
    certified_ = fmt::format("weight {} reached and certified", weight);
    enter(certified_);
}

void Watch::go_on_with(const std::string& step) { enter(fmt::format("{}, {} under way", certified_, step)); }

void Watch::print() {
    go_on_with("what is printed");
    const std::lock_guard lock(mutex_);
    if (const std::optional<Diagnostic> found = excess()) refuse(*found);
    begin_ = std::chrono::steady_clock::now();
    what_ = "printing it";
}

void Watch::reached(const Rational& weight, const Rational& next, std::size_t terms) {
    const std::string step = fmt::format("weight {} reached with {} terms", to_string(weight), terms);
    if (static_cast<double>(terms) > limits_.terms)
        refuse(exceeded(Reason::terms, "--term-limit",
                        fmt::format("normal form and map have at most {:.0f} terms", limits_.terms), step,
                        fmt::format("{:.0f}", 10 * limits_.terms)));
    enter(step + fmt::format(", weight {} under way", to_string(next)));
}

std::optional<Diagnostic> Watch::excess() {
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin_;
    if (time.count() > limits_.seconds)
        return exceeded(Reason::time, "--time-limit",
                        fmt::format("{} takes at most {:g} s", what_, limits_.seconds), step_,
                        larger_time(limits_.seconds, time.count()));
    if (const double used = resident_megabytes(); used > limits_.megabytes)
        return exceeded(Reason::memory, "--memory-limit",
                        fmt::format("a derivation takes at most {:g} MB", limits_.megabytes),
                        fmt::format("{:.0f} MB, {}", used, step_), fmt::format("{:.0f}", 2 * used));
    return std::nullopt;
}

void Watch::finish() {
    const std::lock_guard lock(mutex_);
    if (const std::optional<Diagnostic> found = excess()) refuse(*found);
}

// The first thread cannot be asked to stop, so the program ends here, without destroying the objects in use.
void Watch::run() {
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, tick, [this] { return over_; })) {
        const std::optional<Diagnostic> found = excess();
        if (!found) continue;
        tell_error(Error(ErrorKind::refused, *found), limits_.json);
        std::_Exit(static_cast<int>(ErrorKind::refused));
    }
}

} // namespace resonform
