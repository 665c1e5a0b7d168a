// SPDX-License-Identifier: MIT
// What an evaluator answers beside its numbers.
#ifndef RESONFORM_RUNTIME_STATUS
#define RESONFORM_RUNTIME_STATUS

namespace resonform {

enum class Status : unsigned char {
    ok = 0,
    outside_domain = 1, // a root or logarithm of something not positive, a divisor that is zero or too small
    outside_interval = 2, // t < 0, or eps t beyond the slow time that was asked for or can be tabulated
    bad_argument = 3,     // NaN or infinite t, eps <= 0, NaN parameter
    low_precision = 4,    // the phase exceeds 10^14 or is estimated to be off by more than 10^-9 radians,
                          // or a mode that grows has used up the digits
    overflow = 5,         // a result is not finite
    no_memory = 6,        // for the tables
};

constexpr const char* to_string(Status s) {
    switch (s) {
    case Status::ok: return "ok";
    case Status::outside_domain: return "outside_domain";
    case Status::outside_interval: return "outside_interval";
    case Status::bad_argument: return "bad_argument";
    case Status::low_precision: return "low_precision";
    case Status::overflow: return "overflow";
    case Status::no_memory: return "no_memory";
    }
    return "unknown";
}

// A status and what is behind it, as a reader knows it: a quantity, a divisor, an argument; "" if nothing is.
struct Cause {
    Status status = Status::ok;
    const char* quantity = "";
};

} // namespace resonform

#endif
