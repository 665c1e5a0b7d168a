// SPDX-License-Identifier: MIT
// The loops compiled for avx2.
#include "runtime/widths/unit.hpp"
