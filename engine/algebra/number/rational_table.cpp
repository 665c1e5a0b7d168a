// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/rational_table.hpp"

#include <utility>

namespace resonform {

RationalTable::RationalTable() : values_{0, 0} { intern(1); }

RationalId RationalTable::intern(const Rational& value) {
    if (cln::zerop(value)) return zero;
    const auto known = ids_.find(value);
    if (known != ids_.end()) return known->second;
    const auto id = static_cast<RationalId>(values_.size());
    values_.push_back(value);
    values_.push_back(-value);
    ids_.emplace(value, id);
    ids_.emplace(-value, id + 1);
    return id;
}

RationalId RationalTable::remembered(Memory& results, RationalId a, RationalId b, bool multiplied) {
    if (a < b) std::swap(a, b);
    const std::uint64_t operands = (std::uint64_t{a} << 32) | b;
    Remembered& entry = results[(operands * 0x9E3779B97F4A7C15ULL) >> 52];
    static_assert(memory == std::size_t{1} << (64 - 52));
    if (entry.operands != operands)
        entry = {operands, intern(multiplied ? values_[a] * values_[b] : values_[a] + values_[b])};
    return entry.result;
}

} // namespace resonform
