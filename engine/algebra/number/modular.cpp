// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/modular.hpp"

#include <cln/integer.h>
#include <flint/ulong_extras.h>

#include <algorithm>
#include <optional>

namespace resonform {

namespace {

__extension__ using UnsignedWide = unsigned __int128;
__extension__ using SignedWide = __int128;

} // namespace

std::uint64_t random_prime(std::mt19937_64& random) {
    constexpr std::uint64_t top = std::uint64_t{1} << 60;
    while (true) {
        // Bits 2 ... 59 at random; the last two are 01, bit 60 is set.
        const std::uint64_t candidate = top | (random() & (top - 4)) | 1;
        if (n_is_prime(candidate)) return candidate; // proved below 2^64
    }
}

Residue PrimeField::power(Residue a, std::int64_t exponent) const {
    if (exponent < 0) return power(inverse(a), -exponent);
    return raise(a, static_cast<std::uint64_t>(exponent));
}

Residue PrimeField::raise(Residue a, std::uint64_t exponent) const {
    return nmod_pow_ui(a, exponent, modulus_);
}

Residue PrimeField::inverse(Residue a) const {
    Residue result = 0;
    n_gcdinv(&result, a, prime());
    return result;
}

Residue PrimeField::from(std::int64_t n) const {
    const auto p_signed = static_cast<std::int64_t>(prime());
    if (-p_signed < n && n < p_signed) return static_cast<Residue>(n < 0 ? n + p_signed : n);
    const auto p = static_cast<SignedWide>(prime());
    const SignedWide r = n % p;
    return static_cast<Residue>(r < 0 ? r + p : r);
}

std::optional<Residue> PrimeField::from(const Rational& value) const {
    const auto reduced = [&](const Integer& n) {
        if (cln::integer_length(n) < 63) return from(static_cast<std::int64_t>(cln::cl_I_to_long(n)));
        return Residue{cln::cl_I_to_UQ(cln::mod(n, Integer(static_cast<unsigned long>(prime()))))};
    };
    const Residue numerator = reduced(cln::numerator(value));
    const Integer& denominator = cln::denominator(value);
    if (denominator == 1) return numerator;
    const Residue divisor = reduced(denominator);
    if (divisor == 0) return std::nullopt;
    return multiply(numerator, inverse(divisor));
}

bool PrimeField::is_square(Residue a) const { return n_jacobi_unsigned(a, prime()) >= 0; }

std::optional<Residue> PrimeField::root(Residue a, int k) const {
    if (a == 0) return Residue{0};
    // k = product of prime powers; a root of coprime indices may be taken one after the other.
    for (int factor = 2; k > 1; ++factor) {
        int times = 0;
        for (; k % factor == 0; k /= factor) ++times;
        if (times == 0) continue;
        const std::optional<Residue> x = prime_power_root(a, static_cast<std::uint64_t>(factor), times);
        if (!x) return std::nullopt;
        a = *x;
    }
    return a;
}

// With q = factor^times, p - 1 = factor^e t and 1 + t v = q u:  (a^u)^q = a (a^t)^v, and a^t lies in the
// subgroup of order factor^e, where roots are read off discrete logarithms, digit by digit in base
// `factor` (Pohlig and Hellman; Adleman, Manders and Miller, 1977). With t = q s + r and w = a^s both powers
// are short ones: a^t = w^q a^r, a^u = w^v a^((1 + r v)/q).
std::optional<Residue> PrimeField::prime_power_root(Residue a, std::uint64_t factor, int times) const {
    std::uint64_t q = 1;
    for (int j = 0; j < times; ++j) q *= factor;
    std::uint64_t cofactor = prime() - 1, order = 1;
    for (; cofactor % factor == 0; cofactor /= factor) order *= factor;
    if (factor == 2 && order > 1 && !is_square(a)) return std::nullopt; // seen soonest
    const Residue w = raise(a, cofactor / q);
    const std::uint64_t r = cofactor % q;
    const Residue in_subgroup = multiply(raise(w, q), raise(a, r)); // a^cofactor
    if (raise(in_subgroup, order / std::min(q, order)) != 1) return std::nullopt;

    std::uint64_t v = 0;
    while ((1 + static_cast<UnsignedWide>(r) * v) % q != 0) ++v;
    const auto above = static_cast<std::uint64_t>((1 + static_cast<UnsignedWide>(r) * v) / q);
    const Residue first = multiply(raise(w, v), raise(a, above));
    if (order <= q) return first; // a^cofactor = 1
    // `first` is short of a root by a factor whose q-th power is `rest`, an element of the subgroup.
    const Residue rest = raise(in_subgroup, order - v); // v < q < order
    const Residue generator = sylow_generator(factor, cofactor);
    const Residue of_order_factor = raise(generator, order / factor);
    std::uint64_t logarithm = 0;
    for (std::uint64_t digit = 1; digit < order; digit *= factor) {
        const Residue remaining = multiply(rest, raise(generator, order - logarithm));
        const Residue target = raise(remaining, order / digit / factor);
        for (Residue x = 1; x != target; x = multiply(x, of_order_factor)) logarithm += digit;
    }
    return multiply(first, raise(generator, logarithm / q));
}

Residue PrimeField::sylow_generator(std::uint64_t factor, std::uint64_t cofactor) const {
    for (Residue x = 2;; ++x)
        if (factor == 2 ? !is_square(x) : raise(x, (prime() - 1) / factor) != 1) return raise(x, cofactor);
}

// x^((p - 1)/4) for the first x that is no square.
Residue PrimeField::imaginary_unit() const {
    Residue x = 2;
    while (is_square(x)) ++x;
    return raise(x, (prime() - 1) / 4);
}

Residue PrimeField::random_unit(std::mt19937_64& random) const {
    // Rejection keeps it uniform; the standard distributions differ between libraries.
    while (true) {
        const std::uint64_t x = random() >> 2;
        const std::uint64_t whole = (std::uint64_t{1} << 62) / (prime() - 1) * (prime() - 1);
        if (x < whole) return 1 + x % (prime() - 1);
    }
}

} // namespace resonform
