// SPDX-License-Identifier: GPL-3.0-or-later
// Files whose text goes into emitted code: the build writes the source (cmake/embedded_text.cmake).
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace resonform {

// The runtime's headers, for emitted headers that are to include nothing of ours: in the order of their
// includes, without SPDX lines and includes of each other.
const std::vector<std::string_view>& runtime_texts();

// Text common to all classes and libraries. A word between two @ is a placeholder.
namespace frames {
extern const std::string_view at_end, batch, by_tables, call, called, called_members, constructors, course,
    divided_rates, ensemble, errors, estimates, fields, further, keep_constants, keep_finely,
    keep_phase_constants, lies, library, library_end, library_ensemble, library_loops, library_many,
    library_names, library_state, look_up, rates, recipe, rows, shorten, start_holds, why;
} // namespace frames

std::string filled(std::string_view frame,
                   const std::vector<std::pair<std::string_view, std::string>>& holes);

} // namespace resonform
