// SPDX-License-Identifier: GPL-3.0-or-later
// Homogeneous parts of series as lists of keys (outer_keys.hpp) with real coefficients of any type, and the
// operations that need of the coefficients c.negative() and c == d only.
#pragma once

#include "algebra/graph/outer_keys.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace resonform {

// sum_k coefficient_k * monomial_k, keys ascending, no zero. Coefficients are real: i stands in the keys.
template <class Word, class Value> struct KeyedPart {
    std::vector<Word> keys;
    std::vector<Value> coefficients;
    bool real = true; // equal to its conjugate

    [[nodiscard]] bool empty() const { return keys.empty(); }
    [[nodiscard]] std::size_t size() const { return keys.size(); }
    void append(Word key, Value coefficient) {
        keys.push_back(key);
        coefficients.push_back(std::move(coefficient));
    }
    friend bool operator==(const KeyedPart&, const KeyedPart&) = default;
};

// Terms with different keys in any order; `real` is not determined.
template <class Word, class Value> KeyedPart<Word, Value> part_of(std::vector<std::pair<Word, Value>> terms) {
    std::sort(terms.begin(), terms.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    KeyedPart<Word, Value> part{{}, {}, terms.empty()};
    for (auto& [key, coefficient] : terms) part.append(key, std::move(coefficient));
    return part;
}

// conj(c i^e m) = (-1)^e c i^e conj(m)
template <class Word, class Value>
std::pair<Word, Value> mirrored(const OuterKeysOf<Word>& keys, Word key, const Value& c) {
    return {keys.mirror(key), OuterKeysOf<Word>::has_i(key) ? c.negative() : c};
}

template <class Word, class Value>
KeyedPart<Word, Value> conjugated(const OuterKeysOf<Word>& keys, const KeyedPart<Word, Value>& p) {
    if (p.real) return p;
    std::vector<std::pair<Word, Value>> terms;
    for (std::size_t k = 0; k < p.size(); ++k) terms.push_back(mirrored(keys, p.keys[k], p.coefficients[k]));
    return part_of(std::move(terms));
}

// A real part, given one of each two conjugate terms; one that is minus its own conjugate vanishes.
template <class Word, class Value>
KeyedPart<Word, Value> with_mirrored(const OuterKeysOf<Word>& keys, const KeyedPart<Word, Value>& half) {
    std::vector<std::pair<Word, Value>> terms;
    for (std::size_t k = 0; k < half.size(); ++k) {
        const bool alone = keys.mirror(half.keys[k]) == half.keys[k];
        if (alone && OuterKeysOf<Word>::has_i(half.keys[k])) continue;
        terms.emplace_back(half.keys[k], half.coefficients[k]);
        if (!alone) terms.push_back(mirrored(keys, half.keys[k], half.coefficients[k]));
    }
    KeyedPart<Word, Value> part = part_of(std::move(terms));
    part.real = true;
    return part;
}

template <class Word, class Value>
bool equals_its_conjugate(const OuterKeysOf<Word>& keys, const KeyedPart<Word, Value>& p) {
    for (std::size_t k = 0; k < p.size(); ++k) {
        const auto [mirror, conjugate] = mirrored(keys, p.keys[k], p.coefficients[k]);
        const auto found = std::lower_bound(p.keys.begin(), p.keys.end(), mirror);
        if (found == p.keys.end() || *found != mirror) return false;
        if (!(p.coefficients[static_cast<std::size_t>(found - p.keys.begin())] == conjugate)) return false;
    }
    return true;
}

// d/d(field), not a phase; times(k, c) = k c.
template <class Word, class Value, class Times>
KeyedPart<Word, Value> derivative_of(const OuterKeysOf<Word>& keys, const KeyedPart<Word, Value>& p,
                                     int field, const Times& times) {
    const Word one = keys.power(field, 1);
    KeyedPart<Word, Value> result;
    for (std::size_t k = 0; k < p.size(); ++k)
        if (const int exponent = keys.exponent(p.keys[k], field); exponent != 0)
            result.append(p.keys[k] - one, times(exponent, p.coefficients[k]));
    result.real = equals_its_conjugate(keys, result);
    return result;
}

// d/d theta: e^{i k theta} becomes i k e^{i k theta}.
template <class Word, class Value, class Times>
KeyedPart<Word, Value> angle_derivative_of(const OuterKeysOf<Word>& keys, const KeyedPart<Word, Value>& p,
                                           int field, const Times& times) {
    std::vector<std::pair<Word, Value>> terms;
    for (std::size_t k = 0; k < p.size(); ++k) {
        const int exponent = keys.exponent(p.keys[k], field);
        if (exponent == 0) continue;
        Word key = p.keys[k] + OuterKeysOf<Word>::imaginary;
        const bool minus = OuterKeysOf<Word>::take_square_of_i(key);
        terms.emplace_back(key, times(minus ? -exponent : exponent, p.coefficients[k]));
    }
    KeyedPart<Word, Value> result = part_of(std::move(terms));
    result.real = equals_its_conjugate(keys, result);
    return result;
}

// The terms by the number that share_of(key) gives them.
template <class Word, class Value, class ShareOf>
std::vector<KeyedPart<Word, Value>> shares_of(const KeyedPart<Word, Value>& p, const ShareOf& share_of) {
    std::vector<KeyedPart<Word, Value>> shares;
    for (std::size_t k = 0; k < p.size(); ++k) {
        const std::size_t share = share_of(p.keys[k]);
        if (share >= shares.size()) shares.resize(share + 1, KeyedPart<Word, Value>{{}, {}, false});
        shares[share].append(p.keys[k], p.coefficients[k]);
    }
    return shares;
}

} // namespace resonform
