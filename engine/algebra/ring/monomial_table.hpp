// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers the monomials of a sum in the order of their first arrival, which does not depend on the hash.
#pragma once

#include "algebra/ring/monomial.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace resonform {

class MonomialTable {
public:
    // The hash is additive, hash(a + b) = hash(a) + hash(b) modulo 2^64, so that a product of two sums
    // hashes each operand once. The table looks at its highest bits, to which every field contributes.
    [[nodiscard]] static std::uint64_t hash(const Monomial& m) {
        return m.word[0] * 0x9E3779B97F4A7C15ULL + m.word[1] * 0xBF58476D1CE4E5B9ULL +
               m.word[2] * 0x94D049BB133111EBULL + m.word[3] * 0xD6E8FEB86659FD93ULL;
    }
    static void hash_all(const std::vector<Monomial>& monomials, std::vector<std::uint64_t>& hashes) {
        hashes.resize(monomials.size());
        for (std::size_t k = 0; k < hashes.size(); ++k) hashes[k] = hash(monomials[k]);
    }

    // The number of m; a new one is appended.
    std::size_t index(const Monomial& m, std::uint64_t hash) {
        if (2 * monomials_.size() >= slots_.size()) grow();
        std::size_t s = hash >> shift_;
        while (slots_[s] != 0 && monomials_[slots_[s] - 1] != m) s = (s + 1) & (slots_.size() - 1);
        if (slots_[s] == 0) {
            monomials_.push_back(m);
            slots_[s] = static_cast<std::uint32_t>(monomials_.size());
        }
        return slots_[s] - 1;
    }

    [[nodiscard]] const std::vector<Monomial>& monomials() const& { return monomials_; }
    [[nodiscard]] std::vector<Monomial> monomials() && { return std::move(monomials_); }

private:
    void grow() {
        slots_.assign(slots_.empty() ? 32 : 2 * slots_.size(), 0);
        monomials_.reserve(slots_.size() / 2);
        shift_ = slots_.size() == 32 ? 59 : shift_ - 1;
        for (std::size_t k = 0; k < monomials_.size(); ++k) {
            std::size_t s = hash(monomials_[k]) >> shift_;
            while (slots_[s] != 0) s = (s + 1) & (slots_.size() - 1);
            slots_[s] = static_cast<std::uint32_t>(k + 1);
        }
    }

    std::vector<Monomial> monomials_;
    std::vector<std::uint32_t> slots_; // number plus one; 0: free. 2^(64 - shift_) of them.
    int shift_ = 64;
};

} // namespace resonform
