// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/accumulator.hpp"

#include <algorithm>
#include <utility>

namespace resonform {

std::size_t Accumulator::slot(const Monomial& monomial) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t s = MonomialHash{}(monomial)&mask;
    while (slots_[s] != 0 && terms_[slots_[s] - 1].monomial != monomial) s = (s + 1) & mask;
    return s;
}

void Accumulator::grow() {
    slots_.assign(std::max<std::size_t>(32, 2 * slots_.size()), 0);
    for (std::size_t i = 0; i < terms_.size(); ++i) {
        slots_[slot(terms_[i].monomial)] = static_cast<std::uint32_t>(i + 1);
    }
}

void Accumulator::add(const Monomial& monomial, const Rational& coefficient) {
    if (2 * terms_.size() >= slots_.size()) grow();
    std::uint32_t& entry = slots_[slot(monomial)];
    if (entry == 0) {
        terms_.push_back({monomial, coefficient});
        entry = static_cast<std::uint32_t>(terms_.size());
    } else {
        Rational& sum = terms_[entry - 1].coefficient;
        sum = sum + coefficient;
    }
}

std::vector<Term> Accumulator::take() {
    slots_.clear();
    return std::exchange(terms_, {});
}

} // namespace resonform
