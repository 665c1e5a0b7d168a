// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/rational_reconstruction.hpp"

#include <flint/fmpq.h>

namespace resonform {

std::optional<std::vector<Rational>> Reconstruction::add(const PrimeField& field,
                                                         const std::vector<Residue>& residues) {
    if (primes_ > 0)
        if (auto found = confirmed(field, residues)) return found;
    values_.resize(residues.size());
    const Residue inverse = field.inverse(fmpz_fdiv_ui(modulus_.get(), field.prime()));
    for (std::size_t k = 0; k < residues.size(); ++k) {
        const Residue known = fmpz_fdiv_ui(values_[k].get(), field.prime());
        const Residue step = field.multiply(field.subtract(residues[k], known), inverse);
        fmpz_addmul_ui(values_[k].get(), modulus_.get(), step);
    }
    fmpz_mul_ui(modulus_.get(), modulus_.get(), field.prime());
    ++primes_;
    return std::nullopt;
}

std::optional<std::vector<Rational>> Reconstruction::confirmed(const PrimeField& field,
                                                               const std::vector<Residue>& residues) const {
    std::vector<Rational> result;
    Whole denominator(1); // of those before: most have the same
    for (std::size_t k = 0; k < residues.size(); ++k) {
        const auto number = reconstruct(values_[k], denominator);
        if (!number || field.from(*number) != residues[k]) return std::nullopt;
        result.push_back(*number);
    }
    return result;
}

// n/d = value modulo M with |n|, d < sqrt(M/2). With the common denominator so far multiplied in, the rest is
// often an integer.
std::optional<Rational> Reconstruction::reconstruct(const Whole& value, Whole& denominator) const {
    Whole scaled, above, below;
    fmpz_mul(scaled.get(), value.get(), denominator.get());
    fmpz_mod(scaled.get(), scaled.get(), modulus_.get());
    if (_fmpq_reconstruct_fmpz(above.get(), below.get(), scaled.get(), modulus_.get()) == 0)
        return std::nullopt;
    fmpz_mul(denominator.get(), denominator.get(), below.get());
    return above.value() / denominator.value();
}

} // namespace resonform
