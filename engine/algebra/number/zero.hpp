// SPDX-License-Identifier: GPL-3.0-or-later
// The answer of a zero test.
#pragma once

namespace resonform {

enum class Zero { yes, no, unknown };

} // namespace resonform
