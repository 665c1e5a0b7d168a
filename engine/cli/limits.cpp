// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/limits.hpp"

#include "cli/arguments.hpp"

#include <unistd.h>

#include <algorithm>

namespace resonform {

DerivationLimits default_limits() {
    constexpr double usual = 4096;
    const double machine =
        static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
    return {120, machine > 0 ? std::min(usual, 0.75 * machine) : usual, 1e7, false};
}

LimitOptions::LimitOptions(CLI::App& command)
    : command_(&command), seconds_(add_text(command, "--time-limit", "SECONDS|none",
                                            "the derivation is refused when it takes longer; default: 120")),
      megabytes_(add_text(command, "--memory-limit", "MB|none",
                          "it is refused when it needs more; default: 4096, at most 3/4 of the machine's")),
      terms_(add_text(command, "--term-limit", "NUMBER|none",
                      "it is refused when normal form and map have more; default: 10000000")) {}

DerivationLimits LimitOptions::value() const {
    DerivationLimits limits = default_limits();
    if (!seconds_->empty()) limits.seconds = read_limit("--time-limit", *seconds_);
    if (!megabytes_->empty()) limits.megabytes = read_limit("--memory-limit", *megabytes_);
    if (!terms_->empty()) limits.terms = read_count_limit("--term-limit", *terms_);
    limits.json = command_->get_option("--format")->as<std::string>() == "json";
    return limits;
}

} // namespace resonform
