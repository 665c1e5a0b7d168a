// SPDX-License-Identifier: MIT
// Whether each step of a computation stayed in the range of its type. The processor tells: it notes when a
// result is too large, too small to have all its digits, or none, and that costs a computation nothing.
//
//   1e200 * 1e200, 1e-200 * 1e-200, 0.0/0.0   ->   not in range       1e-200 - 1e-200   ->   in range
//
// The caller's floating-point flags and traps are saved before and restored afterwards.
#ifndef RESONFORM_RUNTIME_IN_RANGE
#define RESONFORM_RUNTIME_IN_RANGE

#include "runtime/twice.hpp"

#include <cfenv>
#include <type_traits>

#if defined(__SSE2_MATH__)
#include <xmmintrin.h>
#endif

namespace resonform {

// Types whose every step is one of the processor's, or of a library that notes as the processor does.
template <class Number> inline constexpr bool notes_range = std::is_floating_point_v<Number>;
#ifdef RESONFORM_FLOAT128
template <> inline constexpr bool notes_range<Float128> = true;
#endif
template <class Real> inline constexpr bool notes_range<Twice<Real>> = notes_range<Real>;

#if defined(__GNUC__) && defined(FE_OVERFLOW) && defined(FE_UNDERFLOW) && defined(FE_INVALID) &&             \
    defined(FE_DIVBYZERO)

// From its construction on.
class RangeNotes {
public:
    RangeNotes() { std::feholdexcept(&before_); }
    RangeNotes(const RangeNotes&) = delete;
    RangeNotes& operator=(const RangeNotes&) = delete;
    ~RangeNotes() { std::fesetenv(&before_); }

    [[nodiscard]] bool none() const {
        return std::fetestexcept(FE_OVERFLOW | FE_UNDERFLOW | FE_INVALID | FE_DIVBYZERO) == 0;
    }

private:
    std::fenv_t before_;
};

#if defined(__SSE2_MATH__)
// The same for double: one register instead of the whole environment, which takes ten times as long.
class DoubleRangeNotes {
public:
    DoubleRangeNotes() { _mm_setcsr((before_ & ~unsigned{_MM_EXCEPT_MASK}) | unsigned{_MM_MASK_MASK}); }
    DoubleRangeNotes(const DoubleRangeNotes&) = delete;
    DoubleRangeNotes& operator=(const DoubleRangeNotes&) = delete;
    ~DoubleRangeNotes() { _mm_setcsr(before_); }

    [[nodiscard]] bool none() const {
        constexpr unsigned asked =
            _MM_EXCEPT_OVERFLOW | _MM_EXCEPT_UNDERFLOW | _MM_EXCEPT_INVALID | _MM_EXCEPT_DIV_ZERO;
        return (_mm_getcsr() & asked) == 0;
    }

private:
    unsigned before_ = _mm_getcsr();
};
#else
using DoubleRangeNotes = RangeNotes;
#endif
template <class Number> struct RangeNotesOf {
    using type = std::conditional_t<std::is_same_v<Number, double>, DoubleRangeNotes, RangeNotes>;
};
template <class Real> struct RangeNotesOf<Twice<Real>> : RangeNotesOf<Real> {};

// The compiler does not know what x is from here on, nor may it leave for later what x is made of.
template <class Value> void hide(Value& x) { __asm__ volatile("" : "+m"(x) : : "memory"); }

// Some emulators note nothing.
inline bool range_is_noted() {
    static const bool noted = [] {
        const RangeNotes notes;
        double large = 0x1p1000, small = 0x1p-1000;
        hide(large);
        hide(small);
        large = large * large;
        hide(large);
        const bool overflow = std::fetestexcept(FE_OVERFLOW) != 0;
        small = small * small;
        hide(small);
        return overflow && std::fetestexcept(FE_UNDERFLOW) != 0;
    }();
    return noted;
}

// Sets `result` by compute(inputs ..., result), all of whose steps are in Number. False: one of them was not
// in its range, or nothing can be said; nothing is computed where no type tells.
template <class Number, class Compute, class Result, class... Inputs>
bool in_range(const Compute& compute, Result& result, Inputs... inputs) {
    if constexpr (notes_range<Number>) {
        if (!range_is_noted()) return false;
        const typename RangeNotesOf<Number>::type notes;
        (hide(inputs), ...);
        compute(inputs..., result);
        hide(result);
        return notes.none();
    }
    return false;
}

#else

template <class Number> struct RangeNotesOf {};

template <class Number, class Compute, class Result, class... Inputs>
bool in_range(const Compute&, Result&, const Inputs&...) {
    return false;
}

#endif

} // namespace resonform

#endif
