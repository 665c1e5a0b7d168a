// SPDX-License-Identifier: MIT
// What a call for many points answers.
#ifndef RESONFORM_RUNTIME_REPORT
#define RESONFORM_RUNTIME_REPORT

#include "runtime/status.hpp"

#include <cstddef>

namespace resonform {

// The worst status, how many are not ok, the first with the worst one (the number of points if all are ok).
struct BatchReport {
    Status worst = Status::ok;
    std::size_t count = 0, first = 0;
};

// ok < low_precision < outside_interval < outside_domain < overflow < bad_argument < no_memory
constexpr int badness(Status s) {
    switch (s) {
    case Status::ok: return 0;
    case Status::low_precision: return 1;
    case Status::outside_interval: return 2;
    case Status::outside_domain: return 3;
    case Status::overflow: return 4;
    case Status::bad_argument: return 5;
    case Status::no_memory: return 6;
    }
    return 6;
}

constexpr Status worse(Status a, Status b) { return badness(a) < badness(b) ? b : a; }

// One more point of a report; those of better times are not even looked at.
constexpr void note(BatchReport& report, Status s, std::size_t i) {
    if (s == Status::ok) return;
    ++report.count;
    if (badness(s) <= badness(report.worst)) return;
    report.worst = s;
    report.first = i;
}

} // namespace resonform

#endif
