// SPDX-License-Identifier: GPL-3.0-or-later
// The runtime's headers as text, for emitted headers that are to include nothing of ours. The build writes
// the source (cmake/runtime_text.cmake).
#pragma once

#include <string_view>
#include <vector>

namespace resonform {

// In the order of their includes, without SPDX lines, #pragma once and includes of each other.
const std::vector<std::string_view>& runtime_texts();

} // namespace resonform
