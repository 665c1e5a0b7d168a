// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/modular.hpp"

#include "algebra/number/montgomery.hpp"

#include <cln/integer.h>
#include <gmp.h>

#include <algorithm>
#include <array>
#include <bit>
#include <optional>

namespace resonform {

namespace {

__extension__ using UnsignedWide = unsigned __int128;
__extension__ using SignedWide = __int128;

// Arithmetic modulo any n.
class Division {
public:
    explicit Division(std::uint64_t n) : n_(n) {}
    [[nodiscard]] std::uint64_t enter(std::uint64_t a) const { return a % n_; }
    [[nodiscard]] std::uint64_t negate(std::uint64_t a) const { return a == 0 ? 0 : n_ - a; }
    [[nodiscard]] std::uint64_t multiply(std::uint64_t a, std::uint64_t b) const {
        return static_cast<std::uint64_t>(static_cast<UnsignedWide>(a) * b % n_);
    }

private:
    std::uint64_t n_;
};

// base^exponent for each base, side by side, as each product waits for the one before.
template <std::size_t Count, class Arithmetic>
std::array<std::uint64_t, Count> powers_of(const Arithmetic& modulo, std::array<std::uint64_t, Count> base,
                                           std::uint64_t exponent) {
    std::array<std::uint64_t, Count> x;
    x.fill(modulo.enter(1));
    for (; exponent != 0; exponent >>= 1)
        for (std::size_t k = 0; k < Count; ++k) {
            if ((exponent & 1) != 0) x[k] = modulo.multiply(x[k], base[k]);
            base[k] = modulo.multiply(base[k], base[k]);
        }
    return x;
}

// n - 1 = odd * 2^twos: for each base a^odd is 1, or one of its first `twos` squares is -1.
template <std::size_t Count, class Arithmetic>
bool is_strong_probable_prime(const Arithmetic& modulo, std::uint64_t n,
                              const std::array<std::uint64_t, Count>& bases) {
    const int twos = std::countr_zero(n - 1);
    const std::uint64_t one = modulo.enter(1), minus_one = modulo.negate(one), odd = (n - 1) >> twos;
    std::array<std::uint64_t, Count> base;
    for (std::size_t k = 0; k < Count; ++k) base[k] = modulo.enter(bases[k] % n);
    std::array<std::uint64_t, Count> x = powers_of(modulo, base, odd);
    for (std::size_t k = 0; k < Count; ++k) {
        bool found = base[k] == 0 || x[k] == one || x[k] == minus_one;
        for (int j = 1; j < twos && !found; ++j) {
            x[k] = modulo.multiply(x[k], x[k]);
            found = x[k] == minus_one;
        }
        if (!found) return false;
    }
    return true;
}

// nullopt: none of these divides n.
template <std::uint64_t... Primes> std::optional<bool> by_trial(std::uint64_t n) {
    if (((n == Primes) || ...)) return true;
    return ((n % Primes == 0) || ...) ? std::optional(false) : std::nullopt;
}

// Strong probable primes below 2^64 for all of these bases are primes (J. Sinclair, 2011).
template <class Arithmetic> bool passes_all_bases(const Arithmetic& modulo, std::uint64_t n) {
    return is_strong_probable_prime(modulo, n, std::array<std::uint64_t, 1>{2}) &&
           is_strong_probable_prime(
               modulo, n, std::array<std::uint64_t, 6>{325, 9375, 28178, 450775, 9780504, 1795265022});
}

} // namespace

bool is_prime(std::uint64_t n) {
    if (n < 2) return false;
    if (const std::optional<bool> known =
            by_trial<2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67, 71, 73>(n))
        return *known;
    return n >> 62 != 0 ? passes_all_bases(Division(n), n) : passes_all_bases(Montgomery(PrimeField(n)), n);
}

std::uint64_t random_prime(std::mt19937_64& random) {
    constexpr std::uint64_t top = std::uint64_t{1} << 60;
    while (true) {
        // Bits 2 ... 59 at random; the last two are 01, bit 60 is set.
        const std::uint64_t candidate = top | (random() & (top - 4)) | 1;
        if (is_prime(candidate)) return candidate;
    }
}

PrimeField::PrimeField(std::uint64_t prime)
    : prime_(prime), bits_(static_cast<int>(std::bit_width(prime))),
      reciprocal_((UnsignedWide{1} << (2 * bits_)) / prime) {}

Residue PrimeField::from_limbs(const std::uint64_t* limbs, std::size_t count) const {
    Residue value = 0;
    const Residue base = static_cast<Residue>((UnsignedWide{1} << 64) % prime_);
    for (std::size_t k = count; k-- > 0;) value = add(multiply(value, base), limbs[k] % prime_);
    return value;
}

Residue PrimeField::power(Residue a, std::int64_t exponent) const {
    if (exponent < 0) return power(inverse(a), -exponent);
    return raise(a, static_cast<std::uint64_t>(exponent));
}

Residue PrimeField::raise(Residue a, std::uint64_t exponent) const {
    constexpr std::uint64_t large = 1024; // Montgomery's form is worth while
    if (exponent < large) return power_of(*this, a, exponent);
    const Montgomery m(*this);
    return m.leave(power_of(m, m.enter(a), exponent));
}

Residue PrimeField::inverse(Residue a) const {
    // Invariant of Euclid's algorithm: old_x * a = old_r, x * a = r (mod p).
    std::int64_t old_r = static_cast<std::int64_t>(a), r = static_cast<std::int64_t>(prime_);
    std::int64_t old_x = 1, x = 0;
    while (r != 0) {
        const std::int64_t q = old_r / r;
        const std::int64_t next_r = old_r - q * r, next_x = old_x - q * x;
        old_r = r, r = next_r;
        old_x = x, x = next_x;
    }
    return from(old_x);
}

Residue PrimeField::from(std::int64_t n) const {
    const auto p_signed = static_cast<std::int64_t>(prime_);
    if (-p_signed < n && n < p_signed) return static_cast<Residue>(n < 0 ? n + p_signed : n);
    const auto p = static_cast<SignedWide>(prime_);
    const SignedWide r = n % p;
    return static_cast<Residue>(r < 0 ? r + p : r);
}

std::optional<Residue> PrimeField::from(const Rational& value) const {
    const auto reduced = [&](const Integer& n) {
        if (cln::integer_length(n) < 63) return from(static_cast<std::int64_t>(cln::cl_I_to_long(n)));
        return Residue{cln::cl_I_to_UQ(cln::mod(n, Integer(static_cast<unsigned long>(prime_))))};
    };
    const Residue numerator = reduced(cln::numerator(value));
    const Integer& denominator = cln::denominator(value);
    if (denominator == 1) return numerator;
    const Residue divisor = reduced(denominator);
    if (divisor == 0) return std::nullopt;
    return multiply(numerator, inverse(divisor));
}

// Legendre's symbol, without a power.
bool PrimeField::is_square(Residue a) const {
    mpz_t above, below;
    const mp_limb_t a_limb = a, p_limb = prime_;
    return mpz_jacobi(mpz_roinit_n(above, &a_limb, 1), mpz_roinit_n(below, &p_limb, 1)) >= 0;
}

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
    std::uint64_t cofactor = prime_ - 1, order = 1;
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
    // What `first` must be multiplied with has q-th power `rest`, an element of the subgroup.
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
        if (factor == 2 ? !is_square(x) : raise(x, (prime_ - 1) / factor) != 1) return raise(x, cofactor);
}

// x^((p - 1)/4) for the first x that is no square.
Residue PrimeField::imaginary_unit() const {
    Residue x = 2;
    while (is_square(x)) ++x;
    return raise(x, (prime_ - 1) / 4);
}

Residue PrimeField::random_unit(std::mt19937_64& random) const {
    // Rejection keeps it uniform; the standard distributions differ between libraries.
    while (true) {
        const std::uint64_t x = random() >> 2;
        const std::uint64_t whole = (std::uint64_t{1} << 62) / (prime_ - 1) * (prime_ - 1);
        if (x < whole) return 1 + x % (prime_ - 1);
    }
}

} // namespace resonform
