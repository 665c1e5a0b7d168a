// SPDX-License-Identifier: GPL-3.0-or-later
// The rules by which signs are proved (model/exact/positivity.hpp): by the structure of an expression
// (sign_prover.cpp), of sums by comparing (sign_of_sums.cpp), and what vanishes nowhere (nowhere_zero.cpp).
#pragma once

#include "model/system/system_file.hpp"

#include <map>

namespace resonform {

// Ordered, so that the weakest of several is their minimum.
enum class ProvedSign { unknown, nonnegative, positive };

// Comparing divides and multiplies polynomials; no honest one has more operands than this.
constexpr std::size_t largest_compared = 60;
// And none grows to more terms, by an upper bound of their number, before they are collected.
bool is_comparable(const GiNaC::ex& e);

// What is proved holds wherever parameters and slow variables lie in their domain.
class SignProver {
public:
    explicit SignProver(const System& system) : system_(system) {}

    [[nodiscard]] ProvedSign sign(const GiNaC::ex& e) const;
    [[nodiscard]] bool nonzero(const GiNaC::ex& e) const;
    // No root of what may be negative, no logarithm of what may not be positive, no inverse of what may
    // vanish.
    [[nodiscard]] bool real(const GiNaC::ex& e) const;

private:
    // comparisons: how many of them may follow one from another.
    ProvedSign sign(const GiNaC::ex& e, int comparisons) const;
    ProvedSign find_sign(const GiNaC::ex& e, int comparisons) const;
    bool declared_positive(const GiNaC::ex& e) const;
    ProvedSign by_structure(const GiNaC::ex& e, int comparisons) const;
    ProvedSign of_symbol(const GiNaC::ex& e) const;
    ProvedSign of_power(const GiNaC::ex& e, int comparisons) const;
    ProvedSign of_function(const GiNaC::ex& e) const;
    ProvedSign of_product(const GiNaC::ex& e, int comparisons) const;
    ProvedSign of_negative(const GiNaC::ex& part, int comparisons) const;

    ProvedSign of_sum(const GiNaC::ex& e, int comparisons) const;
    ProvedSign by_independent_part(const GiNaC::ex& e, int comparisons) const;
    GiNaC::ex without_squares(const GiNaC::ex& e, int comparisons) const;
    ProvedSign by_root(const GiNaC::ex& e, int comparisons) const;
    ProvedSign by_one_atom(const GiNaC::ex& e) const;
    ProvedSign by_bounds(const GiNaC::ex& e, int comparisons) const;
    ProvedSign by_pairs(const GiNaC::ex& e, int comparisons) const;
    ProvedSign by_discriminant(const GiNaC::ex& e, int comparisons) const;
    ProvedSign by_declaration(const GiNaC::ex& e, int comparisons) const;
    ProvedSign by_division(const GiNaC::ex& e, const GiNaC::ex& declared, int comparisons) const;

    bool find_nonzero(const GiNaC::ex& e) const;
    bool declared_nonzero(const GiNaC::ex& symbol) const;
    bool has_no_zero(const GiNaC::ex& e) const;
    bool is_excluded(const GiNaC::ex& e) const;
    bool is_excluded_by(const GiNaC::ex& declared, const GiNaC::ex& e) const;

    template <class Answer> using Known = std::map<GiNaC::ex, Answer, GiNaC::ex_is_less>;

    const System& system_;
    // What was asked before: a proof asks for the same parts on many ways.
    mutable std::map<int, Known<ProvedSign>> signs_; // by comparisons
    mutable Known<bool> nonzero_;
};

} // namespace resonform
