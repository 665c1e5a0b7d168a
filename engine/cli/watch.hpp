// SPDX-License-Identifier: GPL-3.0-or-later
// The limits of a derivation. Exact algebra may take any time and memory, and the library that reads
// expressions cannot be interrupted: a second thread looks at the clock and at the memory, and ends the
// program with one message and exit code 3. Nothing is half-written then, because files and standard
// output are written when no Watch stands any more.
#pragma once

#include "algebra/number/error.hpp"
#include "algebra/number/number.hpp"

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace resonform {

struct DerivationLimits {
    double seconds = 0;   // for one derivation, and as many again to print its result; infinite: none
    double megabytes = 0; // resident memory of the program; infinite: none
    double terms = 0;     // of normal form and map together; infinite: none
    bool json = false;    // --format json: the error that ends the program is printed as a document, too
};

class Watch {
public:
    // One at a time.
    explicit Watch(const DerivationLimits& limits);
    ~Watch();
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

    // The step under way, for the message: "the expansion".
    void enter(const std::string& step);
    // The same for a step after the certificate: "the solution".
    void go_on_with(const std::string& step);
    // The derivation is done and printing begins: the clock starts again at 0.
    // Errors (refused): the limits were passed since the clock was last looked at.
    void print();
    // A normal form has its certificate. `weight` as the user counts it.
    void certified(const std::string& weight);
    // A weight is complete, and `next` is the one under way. Errors (refused): more terms than the limit.
    void reached(const Rational& weight, const Rational& next, std::size_t terms);
    // Errors (refused): the limits were passed since the clock was last looked at.
    void finish();

private:
    void run();
    std::optional<Diagnostic> excess(); // under mutex_

    DerivationLimits limits_;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
    std::mutex mutex_;
    std::condition_variable changed_;
    std::string step_ = "reading the file";
    std::string certified_;             // the message of certified(), a prefix for go_on_with()
    std::string what_ = "a derivation"; // the clock runs for
    bool over_ = false;
    std::thread thread_; // last: it uses the others
};

// Runs derive(watch) under a watch that ends with it.
template <class Derive> auto watched(const DerivationLimits& limits, const Derive& derive) {
    Watch watch(limits);
    auto derived = derive(watch);
    watch.finish();
    return derived;
}

} // namespace resonform
