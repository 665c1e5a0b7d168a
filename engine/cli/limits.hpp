// SPDX-License-Identifier: GPL-3.0-or-later
// --time-limit, --memory-limit, --term-limit of the commands that derive.
#pragma once

#include "cli/command.hpp"
#include "cli/watch.hpp"

namespace resonform {

class LimitOptions {
public:
    explicit LimitOptions(CLI::App& command);
    // Errors (bad_input): neither a number > 0 nor "none".
    [[nodiscard]] DerivationLimits value() const;

private:
    const CLI::App* command_; // asked for --format
    Text seconds_, megabytes_, terms_;
};

// The defaults: 120 s; 4096 MB, or three quarters of the machine's memory if that is less; ten million terms.
DerivationLimits default_limits();

} // namespace resonform
