// SPDX-License-Identifier: GPL-3.0-or-later
// Errors at some of many times: those at which a reference is integrated.
#pragma once

#include "verify/judging/trial.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace resonform {

using OutputValues = std::vector<std::vector<double>>; // [output][point]

struct JudgedTimes {
    std::vector<double> all;         // ascending
    std::vector<std::size_t> judged; // which of them
};

// Evenly spread over [0, interval], both ends included, and up to 2001 of them judged; one point: the end.
std::shared_ptr<const JudgedTimes> evenly_judged(double interval, std::size_t points);

// |values - reference| in double-double. Nothing is integrated before the first error is wanted.
class ErrorsAgainstReference {
public:
    // `from`: errors at earlier times do not count. The trial must outlive this.
    ErrorsAgainstReference(const Trial& trial, TrialPoint at, double from)
        : trial_(trial), at_(std::move(at)), from_(from) {}

    // Errors will be wanted at the judged ones of these.
    void expect(const JudgedTimes& times);
    // The largest of each output. Precondition: the times were expected.
    std::vector<double> largest(const JudgedTimes& times, const OutputValues& values);

private:
    const Trial& trial_;
    TrialPoint at_;
    double from_;
    std::vector<double> times_; // of the reference: ascending, all different
    std::optional<Reference> reference_;
};

} // namespace resonform
