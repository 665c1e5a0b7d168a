// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/packing.hpp"

#include "algebra/number/error.hpp"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace resonform {

Packing::Packing(int fields)
    : per_word_(std::max(4, (fields + 3) / 4)), bits_(64 / per_word_),
      mask_((std::uint64_t{1} << bits_) - 1) {
    for (std::size_t f = 0; f < words_.size(); ++f) {
        const auto place = std::div(static_cast<int>(f), per_word_);
        words_[f] = static_cast<std::uint8_t>(place.quot);
        shifts_[f] = static_cast<std::uint8_t>(bits_ * place.rem);
    }
    for (int f = 0; f < per_word_; ++f) {
        half_ |= std::uint64_t{1} << (bits_ * f + bits_ - 1);
        quarter_ |= std::uint64_t{1} << (bits_ * f + bits_ - 2);
    }
}

Monomial Packing::power(int field, long exponent) const {
    if (exponent > largest() || exponent < -largest()) overflow();
    Monomial m;
    m.word[word_of(field)] = static_cast<std::uint64_t>(exponent) << shift_of(field);
    return m;
}

Monomial Packing::pack(const std::vector<int>& exponents) const {
    Monomial m;
    int field = 0;
    for (int e : exponents) m = m + power(field++, e);
    return m;
}

std::vector<int> Packing::unpack(const Monomial& m, int fields) const {
    std::vector<int> exponents;
    exponents.reserve(static_cast<std::size_t>(fields));
    for (int f = 0; f < fields; ++f) exponents.push_back(exponent(m, f));
    return exponents;
}

Monomial Packing::scaled(const Monomial& m, long factor) const {
    if (factor == 1) return m;
    if (factor > largest() || factor < -largest()) overflow();
    Monomial out;
    for (int f = 0; f < fields(); ++f) out = out + power(f, factor * exponent(m, f));
    return out;
}

void Packing::overflow() const {
    refuse(
        Reason::size,
        {.rule = "an exponent of a monomial is at most " + std::to_string(largest()) +
                 " in this ring of up to " + std::to_string(fields()) + " generators",
         .value = "a product exceeds it",
         .hint = "ask for a lower order, or use fewer parameters and variables (up to 16 generators: 16383)",
         .place = {}});
}

} // namespace resonform
