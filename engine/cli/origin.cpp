// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/origin.hpp"

#include "verify/run/machine.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <utility>

namespace resonform {

report::Origin origin_of(std::string command) {
    return {RESONFORM_VERSION, source_commit(), fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr))),
            std::move(command), this_machine()};
}

} // namespace resonform
