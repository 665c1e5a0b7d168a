// SPDX-License-Identifier: MIT
// A long formula as text that a loop walks: a compiler would take minutes for it as statements. The text is
// digits (runtime/digits.hpp). Values that are used more than once have places in one array; all others stand
// where they are used, as operators before their operands:
//
//   place value                           a step: what goes there
//   end                                   of the steps
//
// A value is
//
//   place                                 `Digits` digits, the first of them less than `firsts`
//   number k                              of a list, k by `Digits` digits
//   long_number                           exponent + 4050 in two digits, seven mantissas + 2^53 in nine each:
//                                         2^exponent * sum of mantissa_k/2^(53 k); each mantissa is the whole
//                                         number nearest to what those before it leave
//   sum 9 p + q, p + q values             p that are added, q that are subtracted; or 81 and both in two
//   product k, k values                   or 89 and k in two digits
//   two_factors, two values
//   reciprocal value
//   root degree value
//   function which, one or two values
#ifndef RESONFORM_RUNTIME_WALK
#define RESONFORM_RUNTIME_WALK

#include "runtime/digits.hpp"
#include "runtime/math.hpp"

#include <array>
#include <cstddef>

namespace resonform {

namespace walk {
inline constexpr int base = 90;
// First digits from here on are no places.
enum Mark { sum = 80, product, two_factors, reciprocal, root, function, long_number, number, end };
inline constexpr int firsts = sum, number_digits = 8;                  // at most, of a part of a number
inline constexpr int long_sum = 81, most_added = 9, long_product = 89; // counts
enum class Function { sin, cos, log, log1p, exp, expm1, asinh, sinh, erf, atan2, hypot };
} // namespace walk

// A rational number; both parts are exact in every real type.
struct Ratio {
    long long over, under;
};

// Of each number N/D: 8 (m - 1) + n - 1, m digits 2 |N| + (N < 0), n digits D.
template <std::size_t Count> constexpr std::array<Ratio, Count> ratios(const char* text) {
    std::array<Ratio, Count> list{};
    for (Ratio& ratio : list) {
        const long long lengths = read_digits(text, 1);
        const long long over = read_digits(text, static_cast<int>(lengths / walk::number_digits) + 1);
        ratio = {over % 2 == 0 ? over / 2 : -(over / 2),
                 read_digits(text, static_cast<int>(lengths % walk::number_digits) + 1)};
    }
    return list;
}

// Functions: bit k is set if function k occurs, so that a type needs no others.
template <int Digits, unsigned Functions, class Number> class Walk {
public:
    Walk(Number* places, const Ratio* numbers, const char* text)
        : places_(places), numbers_(numbers), at_(text) {}

    void run() {
        for (int first = digit(); first != walk::end; first = digit()) {
            const std::size_t to = place(first);
            places_[to] = value();
        }
    }

    // The values at the places listed, one after the other.
    template <class List> void copy_to(List& list) {
        for (Number& x : list) x = value();
    }

private:
    int digit() { return digit_values[static_cast<unsigned char>(*at_++)]; }
    long long digits(int count) { return read_digits(at_, count); }
    std::size_t place(int first) {
        long long n = first;
        for (int k = 1; k < Digits; ++k) n = walk::base * n + digit();
        return static_cast<std::size_t>(n);
    }

    // use(the next value), where it stands if it has a place.
    template <class Use> void take(const Use& use) {
        const int first = digit();
        first < walk::firsts ? use(places_[place(first)]) : use(inner(first));
    }
    Number value() {
        const int first = digit();
        return first < walk::firsts ? places_[place(first)] : inner(first);
    }
    Number inner(int first) {
        switch (first) {
        case walk::sum: return sum();
        case walk::product: return product();
        case walk::two_factors: return product(2);
        case walk::reciprocal: return Number(1) / value();
        case walk::root: return root(digit());
        case walk::function: return function(static_cast<walk::Function>(digit()));
        case walk::long_number: return long_number();
        default: break; // a number
        }
        using One = typename OneOf<Number>::type;
        const Ratio& ratio = numbers_[place(digit())];
        return Number(One(One(ratio.over) / One(ratio.under)));
    }
    Number sum() {
        const int counts = digit();
        const bool is_long = counts == walk::long_sum;
        const long long plus = is_long ? digits(2) : counts / walk::most_added,
                        minus = is_long ? digits(2) : counts % walk::most_added;
        Number x = plus > 0 ? value() : Number(0);
        for (long long k = 1; k < plus; ++k) take([&](const Number& y) { x = x + y; });
        for (long long k = 0; k < minus; ++k) take([&](const Number& y) { x = x - y; });
        return x;
    }
    Number product() {
        const int count = digit();
        return product(count == walk::long_product ? digits(2) : count);
    }
    Number product(long long count) {
        Number x = value();
        for (long long k = 1; k < count; ++k) take([&](const Number& y) { x = x * y; });
        return x;
    }
    Number long_number() {
        using One = typename OneOf<Number>::type;
        const int exponent = static_cast<int>(digits(2)) - 4050;
        std::array<double, 7> parts{};
        double unit = 1;
        for (double& part : parts) {
            part = static_cast<double>(digits(9) - (1LL << 53)) * unit;
            unit *= 0x1p-53;
        }
        return Number(math::number<One>(parts, exponent));
    }
    Number root(int degree) {
        using math::root;
        using math::sqrt;
        const Number x = value();
        return degree == 2 ? Number(sqrt(x)) : Number(root(x, degree));
    }
    // if constexpr: not every type has every function.
    Number function(walk::Function which) {
        using namespace math;
        using Of = walk::Function;
        constexpr auto uses = [](Of f) { return (Functions >> static_cast<unsigned>(f) & 1U) != 0; };
        const Number x = value();
        if constexpr (uses(Of::sin))
            if (which == Of::sin) return sin(x);
        if constexpr (uses(Of::cos))
            if (which == Of::cos) return cos(x);
        if constexpr (uses(Of::log))
            if (which == Of::log) return log(x);
        if constexpr (uses(Of::log1p))
            if (which == Of::log1p) return log1p(x);
        if constexpr (uses(Of::exp))
            if (which == Of::exp) return exp(x);
        if constexpr (uses(Of::expm1))
            if (which == Of::expm1) return expm1(x);
        if constexpr (uses(Of::asinh))
            if (which == Of::asinh) return asinh(x);
        if constexpr (uses(Of::sinh))
            if (which == Of::sinh) return sinh(x);
        if constexpr (uses(Of::erf))
            if (which == Of::erf) return erf(x);
        const Number y = value();
        if constexpr (uses(Of::atan2))
            if (which == Of::atan2) return atan2(x, y);
        if constexpr (uses(Of::hypot))
            if (which == Of::hypot) return hypot(x, y);
        return y;
    }

    Number* places_;
    const Ratio* numbers_;
    const char* at_;
};

} // namespace resonform

#endif
