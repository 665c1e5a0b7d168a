// SPDX-License-Identifier: MIT
// The loops of runtime/kernel in the width that the processor has: target resonform::batch. The environment
// variable RESONFORM_SIMD (baseline, avx2, avx512) lowers the width, and never raises it.
#ifndef RESONFORM_RUNTIME_BATCH
#define RESONFORM_RUNTIME_BATCH

#include "runtime/kernel/view.hpp"

#include <cstddef>

namespace resonform {

enum class Simd { baseline, avx2, avx512, neon };

Simd simd() noexcept;
bool force_simd(Simd width) noexcept; // false: the processor lacks it, or this build

namespace kernel {

struct Loops {
    BatchReport (*batch)(const View&, const double* t, std::size_t n, double* const* outputs, Status*,
                         const Direct*) noexcept;
    BatchReport (*grid)(const View&, double t0, double dt, std::size_t n, double* const* outputs, Status*,
                        const Direct*) noexcept;
    Status (*one)(const View&, double t, double* values) noexcept;
};

const Loops& loops() noexcept; // of the width in use

} // namespace kernel
} // namespace resonform

#endif
