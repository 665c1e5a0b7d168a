// SPDX-License-Identifier: GPL-3.0-or-later
// Integrations that would take days are given up at once.
#pragma once

#include <cstddef>

namespace resonform {

struct StepBudget {
    std::size_t most;
    std::size_t pilot; // how often the whole way is estimated

    // Whether the way to `end` takes more than `most` steps if the rest is like the way to t. The estimate
    // may be off by the factor `doubt`, where motions slow down.
    [[nodiscard]] bool is_spent(std::size_t steps, double t, double end) const {
        constexpr double doubt = 4;
        if (steps >= most) return true;
        return steps % pilot == 0 &&
               static_cast<double>(steps) * (end / t) > doubt * static_cast<double>(most);
    }
};

// Of integrations in double that `compare` times: some seconds.
constexpr StepBudget rival_budget{10'000'000, 10'000};

} // namespace resonform
