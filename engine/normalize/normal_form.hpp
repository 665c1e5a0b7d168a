// SPDX-License-Identifier: GPL-3.0-or-later
// The results of normalisation: normal form, near-identity map, divisors.
//   z = w + h(w, wbar, eps; zeta),   w' = i omega w + N(w, wbar, eps; zeta),   X = Z + l(...)
// In all series the generators of the modes stand for the new variables w.
#pragma once

#include "expand/graded_field.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace resonform {

enum class DivisorVerdict { removed, kept_exact, kept_near, ambiguous };
const char* to_string(DivisorVerdict verdict);

struct DivisorRecord {
    std::string variable; // "z1", "x"
    Monomial monomial;    // powers of modes and eps
    int weight;
    Polynomial divisor; // <alpha, lambda> - lambda_j
    DivisorVerdict verdict;
};

// rates[...] through weight `through`, the linear part included (weight 1 of a mode: i omega w).
struct NormalForm {
    std::shared_ptr<const GradedField> field;
    int through = 0; // M
    std::string style = "poincare";
    std::vector<Series> mode; // N of each mode (of a conjugate pair only the first)
    std::vector<Series> slow; // rates of the slow variables, as given
    std::vector<Series> drift;
};

// The old variable minus the new one.
struct NearIdentityMap {
    int through = 0;
    std::vector<Series> mode;  // h, weights 2 ... through; at weight 1 a pure eps term may stand
    std::vector<Series> drift; // l, weights 1 ... through
};

struct Certificate {
    bool holds = false;            // substitution and scan
    bool residual_zero = false;    // (a)
    bool normal_form_scan = false; // (b)
    int through_weight = 0;
    std::string route = "substitution, modular";
    int points = 0;
    std::vector<std::uint64_t> primes;
    double error_probability = 1;
    std::string complaint; // empty when it holds: which equation, which weight
};

struct Normalization {
    NormalForm normal_form;
    NearIdentityMap map;
    std::vector<DivisorRecord> divisors;
    Certificate certificate; // filled by certify()
};

} // namespace resonform
