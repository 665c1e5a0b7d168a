// SPDX-License-Identifier: MIT
// A long formula as text that a loop walks: a compiler would take minutes for it as statements. All values
// have places in one array; what a value is made of is told by digits of base 90, the printable characters
// from '#' without '?' and '\'. A place and a number of the list `numbers` has `Digits` of them.
//
//   sum             how many terms are added, how many subtracted, its place, theirs
//   sum_and_number  the same, with a number before its place
//   product         how many factors, its place, theirs
//   scaled_product  the same, with a number before its place
//   reciprocal      its place, that of x
//   root            its degree, its place, that of x
//   function        which one, how many arguments, its place, theirs
//   end
//   long_number     its place, exponent + 4050 in two digits, seven mantissas + 2^53 in nine each:
//                   2^exponent * sum of mantissa_k/2^(53 k), each the whole number next to what is left
#ifndef RESONFORM_RUNTIME_WALK
#define RESONFORM_RUNTIME_WALK

#include "runtime/math.hpp"

#include <array>
#include <cstddef>

namespace resonform {

enum class Walked {
    sum,
    sum_and_number,
    product,
    scaled_product,
    reciprocal,
    root,
    function,
    end,
    long_number
};
enum class WalkedFunction { sin, cos, log, log1p, exp, expm1, asinh, sinh, erf, atan2, hypot };

// A rational number; both parts are exact in every real type.
struct Ratio {
    long long over, under;
};

// Functions: bit k is set if function k occurs, so that a type needs no others.
template <int Digits, unsigned Functions, class Number> class Walk {
public:
    Walk(Number* places, const Ratio* numbers, const char* text)
        : places_(places), numbers_(numbers), at_(text) {}

    void run() {
        for (auto what = static_cast<Walked>(digit()); what != Walked::end;
             what = static_cast<Walked>(digit()))
            take(what);
    }

    // The values at the places listed, one after the other.
    template <class List> void copy_to(List& list) {
        for (Number& x : list) x = next();
    }

private:
    int digit() { return digit_of[static_cast<unsigned char>(*at_++)]; }
    long long digits(int count) {
        long long n = 0;
        for (int k = 0; k < count; ++k) n = 90 * n + digit();
        return n;
    }
    std::size_t index() { return static_cast<std::size_t>(digits(Digits)); }
    Number& next() { return places_[index()]; }
    Number number() {
        using One = typename OneOf<Number>::type;
        const Ratio& ratio = numbers_[index()];
        return Number(One(One(ratio.over) / One(ratio.under)));
    }

    void take(Walked what) {
        switch (what) {
        case Walked::sum: return sum(false);
        case Walked::sum_and_number: return sum(true);
        case Walked::product: return product(false);
        case Walked::scaled_product: return product(true);
        case Walked::long_number: return long_number();
        case Walked::root: return root(digit());
        case Walked::function: return function(digit());
        default: break;
        }
        Number& x = next();
        x = Number(1) / next();
    }
    void sum(bool with_number) {
        const int plus = digit(), minus = digit();
        Number x = with_number ? number() : Number(0);
        Number& to = next();
        const bool starts = !with_number && plus > 0;
        if (starts) x = next();
        for (int k = starts ? 1 : 0; k < plus; ++k) x = x + next();
        for (int k = 0; k < minus; ++k) x = x - next();
        to = x;
    }
    void product(bool with_number) {
        const int factors = digit();
        Number x = with_number ? number() : Number(1);
        Number& to = next();
        if (!with_number) x = next();
        for (int k = with_number ? 0 : 1; k < factors; ++k) x = x * next();
        to = x;
    }
    void long_number() {
        using One = typename OneOf<Number>::type;
        Number& to = next();
        const int exponent = static_cast<int>(digits(2)) - 4050;
        std::array<double, 7> parts{};
        double unit = 1;
        for (double& part : parts) {
            part = static_cast<double>(digits(9) - (1LL << 53)) * unit;
            unit *= 0x1p-53;
        }
        to = Number(math::number<One>(parts, exponent));
    }
    void root(int degree) {
        using math::root;
        using math::sqrt;
        Number& to = next();
        const Number& x = next();
        to = degree == 2 ? Number(sqrt(x)) : Number(root(x, degree));
    }
    static constexpr bool uses(WalkedFunction f) { return (Functions >> static_cast<unsigned>(f) & 1U) != 0; }
    // if constexpr: not every type has every function.
    void function(int which) {
        using namespace math;
        using Of = WalkedFunction;
        const auto f = static_cast<Of>(which);
        const bool two = digit() == 2;
        Number& to = next();
        const Number x = next(), y = two ? next() : x;
        if constexpr (uses(Of::sin))
            if (f == Of::sin) to = sin(x);
        if constexpr (uses(Of::cos))
            if (f == Of::cos) to = cos(x);
        if constexpr (uses(Of::log))
            if (f == Of::log) to = log(x);
        if constexpr (uses(Of::log1p))
            if (f == Of::log1p) to = log1p(x);
        if constexpr (uses(Of::exp))
            if (f == Of::exp) to = exp(x);
        if constexpr (uses(Of::expm1))
            if (f == Of::expm1) to = expm1(x);
        if constexpr (uses(Of::asinh))
            if (f == Of::asinh) to = asinh(x);
        if constexpr (uses(Of::sinh))
            if (f == Of::sinh) to = sinh(x);
        if constexpr (uses(Of::erf))
            if (f == Of::erf) to = erf(x);
        if constexpr (uses(Of::atan2))
            if (f == Of::atan2) to = atan2(x, y);
        if constexpr (uses(Of::hypot))
            if (f == Of::hypot) to = hypot(x, y);
    }

    static constexpr std::array<unsigned char, 256> digit_of = [] {
        std::array<unsigned char, 256> list{};
        unsigned char n = 0;
        for (unsigned char c = '#'; c < 0x7f; ++c)
            if (c != '?' && c != '\\') list[c] = n++;
        return list;
    }();

    Number* places_;
    const Ratio* numbers_;
    const char* at_;
};

} // namespace resonform

#endif
