// SPDX-License-Identifier: GPL-3.0-or-later
// Instructions -> the text that a loop walks (runtime/walk.hpp), for functions too long to be compiled as
// statements.
#pragma once

#include "emit/program/straight_line.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

struct CppWalk {
    std::size_t places = 0;
    std::size_t digits = 2;                                          // of a place
    unsigned functions = 0;                                          // bit k: function k of the walk occurs
    std::vector<std::pair<StraightLine::Value, std::size_t>> inputs; // and their places at the beginning
    std::string numbers;                                             // a list, as text
    std::size_t count = 0;                                           // of them
    std::vector<std::string> texts; // one after the other: of a length that every compiler takes
    std::size_t first_texts = 0;    // the first so many compute all values asked for first
    std::map<StraightLine::Value, std::size_t> place_of; // of the roots

    // Places as text, for Walk::copy_to.
    [[nodiscard]] std::string list(const std::vector<StraightLine::Value>& values) const;
};

// Can the walk take such an instruction?
bool can_be_walked(const StraightLine::Instruction& i);

// order: operands before their users, all that the roots need. Inputs are those of it that the caller
// computes: what `known` holds, and numbers that are no ratio of short integers. first: some of the roots,
// before all that they do not need. nullopt: there are data or callables.
std::optional<CppWalk> cpp_walk(const StraightLine& code, const std::vector<StraightLine::Value>& order,
                                const std::set<StraightLine::Value>& known,
                                const std::vector<StraightLine::Value>& roots,
                                const std::vector<StraightLine::Value>& first = {});

// Are numerator and denominator at most 2^48, exact in every real type?
bool is_short(const Rational& value);

} // namespace resonform
