// SPDX-License-Identifier: MIT
// The loops compiled for baseline.
#include "runtime/widths/unit.hpp"
