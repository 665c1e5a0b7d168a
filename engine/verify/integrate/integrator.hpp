// SPDX-License-Identifier: GPL-3.0-or-later
// An integration that is set up once and run many times, for `compare` to measure. All buffers stand before
// the first run, and only the wanted states are kept.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace resonform {

enum class Method {
    taylor,
    cvode_adams,
    cvode_bdf,
    arkode_explicit,
    arkode_implicit,
    dopri5,
    fehlberg78,
    bulirsch_stoer,
    riccati
};

// The rates of the states, as functions of C. jacobian: d(rate i)/d(state k) to matrix[k * states + i]; null:
// methods that want it take differences.
struct RightHandSide {
    void (*call)(const void* context, const double* state, double* rates);
    const void* context;
    void (*jacobian)(const void* context, const double* state, double* matrix) = nullptr;
};

// The start of an integration, and the states whose values are wanted.
struct Start {
    std::vector<double> state;
    double tolerance; // relative, and absolute against the scale of each start value (1 where that is zero)
    std::vector<std::size_t> wanted;
};

struct Run {
    std::size_t steps = 0, evaluations = 0;
    std::string failure; // empty if the method reached the last time
};

class Integrator {
public:
    Integrator() = default;
    virtual ~Integrator() = default;
    Integrator(const Integrator&) = delete;
    Integrator& operator=(const Integrator&) = delete;

    // From t = 0 to the last of ascending times. values[k][i] is wanted state k at time i: as long as
    // `times`.
    virtual Run run(const std::vector<double>& times, std::vector<std::vector<double>>& values) = 0;
};

} // namespace resonform
