// SPDX-License-Identifier: MIT
// What a unit of one width holds: nothing that the linker could take for another width.
#define RESONFORM_BATCH_UNIT
#include "runtime/batch.hpp"
#include "runtime/kernel/grid.hpp"
#include "runtime/kernel/one.hpp"

namespace resonform::kernel {
inline namespace RESONFORM_WIDTH {

extern const Loops of_this_width;
const Loops of_this_width{&batch, &grid, &one};

} // namespace RESONFORM_WIDTH
} // namespace resonform::kernel
