// SPDX-License-Identifier: GPL-3.0-or-later
// Deletes what stands in an emitted header, statement by statement:
//
//   c.c_2 = Number(1) / eps;      ->   if (!gone(3)) { c.c_2 = Number(1) / eps; }
//   return {c_1, c_3 * T};        ->   return {(gone(4) ? Number(0) : Number(c_1)), ...};    the rows'
//   amplitudes const Number k_1 = c_2 * T;   ->   as it is: without it what uses k_1 does not compile
#pragma once

#include <string>
#include <vector>

namespace resonform::test {

struct Deletions {
    std::string text;                // the header; statement n of `places` is skipped where gone(n)
    std::vector<std::string> places; // of n = 1, 2, ...: the statements
    std::vector<std::string> unused; // declarations whose name stands nowhere else
};

// runtime: the text of the headers that the code is used by, in which its names may stand.
Deletions planted_deletions(const std::string& header, const std::string& runtime);

} // namespace resonform::test
