// SPDX-License-Identifier: GPL-3.0-or-later
// A sum of many terms, collected in a hash table: the inner loop of every product.
// The terms come out in the order of their first arrival, which does not depend on the hash.
#pragma once

#include "algebra/polynomial.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace resonform {

class Accumulator {
public:
    void add(const Monomial& monomial, const Rational& coefficient);
    // The collected terms in any order, zeros included; the accumulator is empty afterwards.
    [[nodiscard]] std::vector<Term> take();

private:
    void grow();
    [[nodiscard]] std::size_t slot(const Monomial& monomial) const; // its slot, or the free one for it

    std::vector<Term> terms_;
    std::vector<std::uint32_t> slots_; // index into terms_ plus one; 0: free. Size a power of two.
};

} // namespace resonform
