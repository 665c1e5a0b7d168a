// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "verify/symbolic/integral.hpp"

namespace resonform {

// By how much the flow has turned variable k, a mode, at T: arguments are added up in steps that leave no
// doubt.
Wide turned(const SymbolicFrame& frame, const SymbolicIntegral& integral, std::size_t k, const Wide& T);

} // namespace resonform
