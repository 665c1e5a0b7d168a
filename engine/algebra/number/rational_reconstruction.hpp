// SPDX-License-Identifier: GPL-3.0-or-later
// Rational numbers from their residues modulo several primes (Chinese remainders, then Wang's
// reconstruction).
#pragma once

#include "algebra/number/flint.hpp"
#include "algebra/number/modular.hpp"
#include "algebra/number/number.hpp"

#include <optional>
#include <vector>

namespace resonform {

class Reconstruction {
public:
    // Residues of the same numbers modulo one more prime. Returns all of them once numbers that were found
    // from the primes before have these residues: the prime is fresh, and confirms.
    std::optional<std::vector<Rational>> add(const PrimeField& field, const std::vector<Residue>& residues);
    [[nodiscard]] std::size_t primes() const { return primes_; }

private:
    [[nodiscard]] std::optional<std::vector<Rational>> confirmed(const PrimeField& field,
                                                                 const std::vector<Residue>& residues) const;
    [[nodiscard]] std::optional<Rational> reconstruct(const Whole& value, Whole& denominator) const;

    Whole modulus_{1};
    std::vector<Whole> values_; // modulo the product of the primes
    std::size_t primes_ = 0;
};

} // namespace resonform
