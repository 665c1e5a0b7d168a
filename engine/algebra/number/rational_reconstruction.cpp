// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/rational_reconstruction.hpp"

#include <cln/integer_io.h>

namespace resonform {

namespace {

mpz_class word_to_mpz(std::uint64_t x) {
    mpz_class result;
    mpz_import(result.get_mpz_t(), 1, 1, sizeof x, 0, 0, &x);
    return result;
}

Residue modulo(const mpz_class& x, std::uint64_t prime) {
    static_assert(sizeof(unsigned long) == sizeof(std::uint64_t));
    return mpz_fdiv_ui(x.get_mpz_t(), prime);
}

Rational to_rational(const mpq_class& q) {
    const Integer numerator = q.get_num().get_str().c_str(), denominator = q.get_den().get_str().c_str();
    return Rational(numerator) / denominator;
}

} // namespace

std::optional<std::vector<Rational>> Reconstruction::add(const PrimeField& field,
                                                         const std::vector<Residue>& residues) {
    if (primes_ > 0)
        if (auto found = confirmed(field, residues)) return found;
    values_.resize(residues.size());
    const Residue inverse = field.inverse(modulo(modulus_, field.prime()));
    for (std::size_t k = 0; k < residues.size(); ++k) {
        const Residue step =
            field.multiply(field.subtract(residues[k], modulo(values_[k], field.prime())), inverse);
        values_[k] += modulus_ * word_to_mpz(step);
    }
    modulus_ *= word_to_mpz(field.prime());
    ++primes_;
    return std::nullopt;
}

std::optional<std::vector<Rational>> Reconstruction::confirmed(const PrimeField& field,
                                                               const std::vector<Residue>& residues) const {
    std::vector<Rational> result;
    mpz_class denominator = 1; // of those before: most have the same
    for (std::size_t k = 0; k < residues.size(); ++k) {
        const auto number = reconstruct(values_[k], denominator);
        if (!number) return std::nullopt;
        const Residue below = modulo(number->get_den(), field.prime());
        if (below == 0 || modulo(number->get_num(), field.prime()) != field.multiply(residues[k], below))
            return std::nullopt;
        result.push_back(to_rational(*number));
    }
    return result;
}

// n/d = value modulo M with |n|, d < sqrt(M/2): by Euclid's algorithm, stopped halfway. With the common
// denominator so far multiplied in, the rest is often an integer.
std::optional<mpq_class> Reconstruction::reconstruct(const mpz_class& value, mpz_class& denominator) const {
    const mpz_class bound = sqrt(mpz_class(modulus_ / 2));
    mpz_class scaled = value * denominator % modulus_;
    if (scaled > modulus_ / 2) scaled -= modulus_;
    mpz_class old_r = modulus_, r = scaled < 0 ? mpz_class(scaled + modulus_) : scaled, old_t = 0, t = 1;
    if (abs(scaled) <= bound) {
        r = scaled;
    } else {
        while (r > bound) {
            const mpz_class q = old_r / r;
            mpz_class next = old_r - q * r;
            old_r = r, r = next;
            next = old_t - q * t;
            old_t = t, t = next;
        }
        if (t == 0 || abs(t) > bound) return std::nullopt;
    }
    mpq_class result(r, t * denominator);
    result.canonicalize();
    if (abs(t) > 1) denominator *= abs(t);
    return result;
}

} // namespace resonform
