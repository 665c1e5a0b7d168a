// SPDX-License-Identifier: MIT
#include "runtime/batch.hpp"

#include <array>
#include <atomic>
#include <cstdlib>
#include <cstring>

namespace resonform {

namespace kernel {
namespace batch_baseline {
extern const Loops of_this_width;
}
#ifdef RESONFORM_X86_WIDTHS
namespace batch_avx2 {
extern const Loops of_this_width;
}
namespace batch_avx512 {
extern const Loops of_this_width;
}
#endif
} // namespace kernel

namespace {

constexpr std::array names{"baseline", "avx2", "avx512"};

bool has(Simd width) {
#ifdef RESONFORM_X86_WIDTHS
    if (width == Simd::avx2) return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    if (width == Simd::avx512)
        return has(Simd::avx2) && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512vl");
#endif
    return width == Simd::baseline;
}

Simd widest() {
    Simd most = Simd::baseline;
    for (const Simd width : {Simd::avx2, Simd::avx512})
        if (has(width)) most = width;
    if (const char* wish = std::getenv("RESONFORM_SIMD"))
        for (std::size_t i = 0; i < names.size(); ++i)
            if (std::strcmp(wish, names[i]) == 0 && static_cast<Simd>(i) < most) most = static_cast<Simd>(i);
    return most;
}

std::atomic<Simd>& chosen() {
    static std::atomic<Simd> width{widest()};
    return width;
}

} // namespace

Simd simd() noexcept { return chosen().load(std::memory_order_relaxed); }

bool force_simd(Simd width) noexcept {
    if (!has(width)) return false;
    chosen().store(width, std::memory_order_relaxed);
    return true;
}

const kernel::Loops& kernel::loops() noexcept {
#ifdef RESONFORM_X86_WIDTHS
    if (simd() == Simd::avx512) return batch_avx512::of_this_width;
    if (simd() == Simd::avx2) return batch_avx2::of_this_width;
#endif
    return batch_baseline::of_this_width;
}

} // namespace resonform
