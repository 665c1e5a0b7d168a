// SPDX-License-Identifier: MIT
// A number with an exponent of its own, mantissa * 2^(600 exponent): powers and products of arguments are
// formed in it that need not have a place in Number, though what becomes of them has.
//
//   in double, K = 1e8:   K^40 / K^41  ->  inf or 0       Scaled: 1e-8
//
// Within 2^-300 ... 2^300 the exponent is 0 and every operation that of Number, to the last bit.
#ifndef RESONFORM_RUNTIME_SCALED
#define RESONFORM_RUNTIME_SCALED

#include "runtime/digits.hpp"
#include "runtime/math.hpp"
#include "runtime/status.hpp"

#include <array>
#include <cstddef>
#include <type_traits>

namespace resonform {

template <class Number> struct Scaled {
    Number mantissa{};
    long exponent = 0; // of 2^600; 0 where the mantissa is 0 or not finite

    Scaled() = default;
    template <class Other> explicit Scaled(const Other& x) : Scaled(Number(x), 0) {}
    Scaled(const Number& m, long e) : mantissa(m), exponent(e) {
        const Number size = math::magnitude(m);
        if (!(size < Number(0x1p300) && size > Number(0x1p-300))) put_in_range();
    }

    // Moves powers of 2^600 from the mantissa to the exponent. Zero, NaN and infinity get the exponent 0.
    void put_in_range() {
        using math::scaled_by;
        const auto size = [this] { return math::magnitude(mantissa); };
        if (!math::finite(mantissa) || mantissa == Number(0)) {
            exponent = 0;
            return;
        }
        for (; size() > Number(0x1p300); ++exponent) mantissa = scaled_by(mantissa, 0x1p-600);
        for (; size() < Number(0x1p-300); --exponent) mantissa = scaled_by(mantissa, 0x1p600);
    }

    // As a Number; false: it is not finite, or has no place there with all its digits.
    bool fits(Number& x) const {
        using math::scaled_by;
        x = mantissa;
        const bool large = exponent > 0;
        for (long left = large ? exponent : -exponent; left > 0; --left) {
            const Number next = scaled_by(x, large ? 0x1p600 : 0x1p-600);
            if (!math::finite(next) || !(scaled_by(next, large ? 0x1p-600 : 0x1p600) == x)) return false;
            x = next;
        }
        return math::finite(x);
    }

    // The same, not a number where there is no place.
    [[nodiscard]] Number value() const {
        Number x;
        return fits(x) ? x : math::not_a_number<Number>();
    }

    friend Scaled operator-(Scaled a) {
        a.mantissa = -a.mantissa;
        return a;
    }
    friend Scaled operator*(const Scaled& a, const Scaled& b) {
        return {Number(a.mantissa * b.mantissa), a.exponent + b.exponent};
    }
    friend Scaled operator/(const Scaled& a, const Scaled& b) {
        return {Number(a.mantissa / b.mantissa), a.exponent - b.exponent};
    }
    friend Scaled operator+(const Scaled& a, const Scaled& b) {
        if (a.exponent == b.exponent) return {Number(a.mantissa + b.mantissa), a.exponent};
        if (a.mantissa == Number(0)) return b;
        if (b.mantissa == Number(0)) return a;
        const long e = a.exponent < b.exponent ? b.exponent : a.exponent;
        return {Number(a.at(e) + b.at(e)), e};
    }
    friend Scaled operator-(const Scaled& a, const Scaled& b) {
        if (a.exponent == b.exponent) return {Number(a.mantissa - b.mantissa), a.exponent};
        return a + (-b);
    }
    friend bool operator>(const Scaled& a, const Scaled& b) { return (a - b).mantissa > Number(0); }

    // In units of 2^(600 e), e >= exponent.
    [[nodiscard]] Number at(long e) const {
        using math::scaled_by;
        if (e == exponent) return mantissa;
        return scaled_by(mantissa, e == exponent + 1 ? 0x1p-600 : 0.0); // what is not finite stays so
    }
};

template <class Number> Scaled<Number> magnitude(const Scaled<Number>& x) {
    return {Number(math::magnitude(x.mantissa)), x.exponent};
}

// A function of Number at x: what is too small for Number is 0, what is too large is not a number.
template <class Function, class Number> Scaled<Number> of_number(const Function& f, const Scaled<Number>& x) {
    Number value;
    if (x.fits(value)) return Scaled<Number>(f(value));
    return Scaled<Number>(x.exponent < 0 ? f(Number(0)) : math::not_a_number<Number>());
}

namespace math {
template <class Number> inline constexpr int digits<Scaled<Number>> = digits<Number>;

template <class Number> Scaled<Number> root(const Scaled<Number>& x, int k) {
    long whole = x.exponent / k, rest = x.exponent % k;
    if (rest < 0) {
        rest += k;
        --whole;
    }
    const int shift = static_cast<int>(600 * rest / k), below = static_cast<int>(600 * rest % k);
    const Number size = root(Number(x.mantissa * power(Number(2), below)), k);
    return {Number(size * power(Number(2), shift)), whole};
}
} // namespace math

template <class Number> Scaled<Number> sqrt(const Scaled<Number>& x) {
    using math::sqrt;
    const long odd = x.exponent % 2 == 0 ? 0 : 1;
    return {Number(sqrt(x.mantissa) * Number(odd == 0 ? 1.0 : 0x1p300)), (x.exponent - odd) / 2};
}

// An argument that has no place in Number is too close to 0 to differ from it, or has no digits left.
template <class Number> Scaled<Number> sin(const Scaled<Number>& x) {
    using math::sin;
    Number value;
    if (x.fits(value)) return Scaled<Number>(sin(value));
    return x.exponent < 0 ? x : Scaled<Number>(math::not_a_number<Number>());
}

template <class Number> Scaled<Number> cos(const Scaled<Number>& x) {
    using math::cos;
    Number value;
    if (x.fits(value)) return Scaled<Number>(cos(value));
    return Scaled<Number>(x.exponent < 0 ? Number(1) : math::not_a_number<Number>());
}

// exp(x/2^n)^(2^n)
template <class Number> Scaled<Number> exp(const Scaled<Number>& x) {
    using math::exp;
    Number value;
    if (!x.fits(value)) return cos(x); // 1, or not a number
    if (!(math::magnitude(value) < Number(0x1p30))) return Scaled<Number>(math::not_a_number<Number>());
    int halvings = 0;
    for (; !(math::magnitude(value) < Number(600)); ++halvings) value = value / Number(2);
    Scaled<Number> result{Number(exp(value))};
    for (; halvings > 0; --halvings) result = result * result;
    return result;
}

template <class Number> Scaled<Number> log(const Scaled<Number>& x) {
    using math::log;
    Scaled<Number> result{Number(log(x.mantissa))};
    if (x.exponent == 0) return result;
    return result +
           Scaled<Number>(Number(static_cast<double>(x.exponent)) * Number(600) * Number(log(Number(2))));
}

template <class Number> Scaled<Number> expm1(const Scaled<Number>& x) {
    using math::expm1;
    Number value;
    if (!x.fits(value)) return x.exponent < 0 ? x : Scaled<Number>(math::not_a_number<Number>());
    if (math::magnitude(value) < Number(600)) return Scaled<Number>(Number(expm1(value)));
    return exp(x) - Scaled<Number>(Number(1));
}

template <class Number> Scaled<Number> log1p(const Scaled<Number>& x) {
    using math::log1p;
    if (x.exponent == 0) return Scaled<Number>(Number(log1p(x.mantissa)));
    return x.exponent < 0 ? x : log(x);
}

template <class Number> Scaled<Number> asinh(const Scaled<Number>& x) {
    using math::asinh;
    if (x.exponent == 0) return Scaled<Number>(asinh(x.mantissa));
    if (x.exponent < 0) return x;
    const Scaled<Number> size = magnitude(x), result = log(size + size);
    return x.mantissa < Number(0) ? -result : result;
}

template <class Number> Scaled<Number> sinh(const Scaled<Number>& x) {
    using math::sinh;
    Number value;
    if (!x.fits(value)) return x.exponent < 0 ? x : Scaled<Number>(math::not_a_number<Number>());
    if (math::magnitude(value) < Number(600)) return Scaled<Number>(sinh(value));
    const Scaled<Number> half{Number(Number(1) / Number(2))};
    return value > Number(0) ? exp(x) * half : -(exp(-x) * half);
}

template <class Number> Scaled<Number> erf(const Scaled<Number>& x) {
    using math::erf;
    using math::sqrt;
    Number value;
    if (x.fits(value)) return Scaled<Number>(Number(erf(value)));
    if (x.exponent < 0) return x * Scaled<Number>(Number(Number(2) / Number(sqrt(math::pi<Number>()))));
    return Scaled<Number>(Number(x.mantissa > Number(0) ? 1 : -1));
}

template <class Number> Scaled<Number> hypot(const Scaled<Number>& x, const Scaled<Number>& y) {
    using math::hypot;
    if (x.mantissa == Number(0)) return magnitude(y);
    if (y.mantissa == Number(0)) return magnitude(x);
    const long e = x.exponent < y.exponent ? y.exponent : x.exponent;
    return {Number(hypot(x.at(e), y.at(e))), e};
}

template <class Number> Scaled<Number> atan2(const Scaled<Number>& y, const Scaled<Number>& x) {
    using math::atan2;
    if (y.mantissa == Number(0) || x.mantissa == Number(0))
        return Scaled<Number>(atan2(y.mantissa, x.mantissa));
    if (y.exponent < x.exponent && x.mantissa > Number(0)) return y / x;
    const long e = x.exponent < y.exponent ? y.exponent : x.exponent;
    return Scaled<Number>(atan2(y.at(e), x.at(e)));
}

// Of an array's elements from `first` on, the first that is not > 0, by its name.
template <class List, std::size_t Count>
Cause first_not_positive(const List& list, std::size_t first, const std::array<const char*, Count>& names) {
    using Number = std::remove_cvref_t<decltype(list[0])>;
    for (std::size_t k = 0; k < Count; ++k)
        if (!(list[first + k] > Number(0))) return {Status::outside_domain, names[k]};
    return {};
}

// Constants on their way into Number; `cause` names the first that has no place there.
struct Keeper {
    Cause cause;
    template <class Wide, class Number>
    [[gnu::noinline]] void operator()(const Scaled<Wide>& from, Number& to, const char* quantity) {
        Number mantissa;
        if constexpr (std::is_same_v<Wide, Number>)
            mantissa = from.mantissa;
        else // Wide is twice a shorter type
            mantissa = Number(from.mantissa.high) + Number(from.mantissa.low);
        if (!Scaled<Number>(mantissa, from.exponent).fits(to))
            note(math::finite(mantissa) ? Status::overflow : Status::outside_domain, quantity);
    }
    // That was in range on its way.
    template <class From, class Number>
    [[gnu::noinline]] void operator()(const From& from, Number& to, const char* quantity) {
        to = static_cast<Number>(from);
        if (!math::finite(to)) note(Status::outside_domain, quantity);
    }
    // Elements of two arrays from the first on in runs: of each run two digits tell the name of its elements,
    // the last one that they are not kept, and one how many they are (runtime/digits.hpp).
    template <class From, class To, std::size_t Count>
    void operator()(const From& from, To& to, const std::array<const char*, Count>& names, const char* runs) {
        for (std::size_t k = 0; *runs != '\0';) {
            const auto name = static_cast<std::size_t>(read_digits(runs, 2));
            const std::size_t end = k + static_cast<std::size_t>(read_digits(runs, 1));
            for (; k < end; ++k)
                if (name < Count) (*this)(from[k], to[k], names[name]);
        }
    }

private:
    void note(Status status, const char* quantity) {
        if (cause.status == Status::ok) cause = {status, quantity};
    }
};

} // namespace resonform

#endif
