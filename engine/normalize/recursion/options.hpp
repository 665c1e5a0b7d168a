// SPDX-License-Identifier: GPL-3.0-or-later
// How a normal form is asked for.
#pragma once

#include <cstddef>
#include <functional>

namespace resonform {

struct NormalizeOptions {
    // Called after each weight with (weight, terms so far); may throw to stop.
    std::function<void(int, std::size_t)> progress;
};

} // namespace resonform
