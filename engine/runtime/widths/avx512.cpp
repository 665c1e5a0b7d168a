// SPDX-License-Identifier: MIT
// The loops compiled for avx512.
#include "runtime/widths/unit.hpp"
