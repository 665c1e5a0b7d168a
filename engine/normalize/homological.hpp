// SPDX-License-Identifier: GPL-3.0-or-later
// One homological equation, weight by weight (design 2.3). For a function u of the old variables,
// u = u_new + c(w, wbar, eps; zeta), with rate [F] along the field and N along the normal form:
//
//   D(alpha) c_alpha = R_alpha - N_alpha,
//   R_n = [F]_n - sum_j ( d_w c_j . N_{n+1-j} + d_wbar c_j . Nbar_{n+1-j} + d_zeta c_j . zeta'_{n-j} )
//
// where the linear part N_1 = i omega w of the modes is in D, not in the sum.
#pragma once

#include "algebra/fractions.hpp"
#include "normalize/divisor.hpp"
#include "normalize/normal_form.hpp"

#include <deque>
#include <set>
#include <vector>

namespace resonform {

// The rates along which corrections are transported: N and Nbar of every mode and the slow rates.
// Weights below the current one are complete, the linear part of the modes is left out.
struct Transport {
    std::vector<Series> mode, conjugate;
    std::vector<Series> slow;
};

class HomologicalEquation {
public:
    // mode: index of the mode, or -1 for a drift variable.
    HomologicalEquation(const GradedField& field, int mode, std::string variable, Place place);

    // The frequencies k.omega by which solve() has to divide and cannot: what it left is not the solution.
    [[nodiscard]] const std::vector<Polynomial>& missing_divisors() const { return divisors_.missing(); }

    // Solves weight n, given [F]_n of the composed field; weights must come in order.
    void solve(int weight, const Polynomial& field_part, const Transport& transport);

    [[nodiscard]] const Series& correction() const { return correction_; } // c
    [[nodiscard]] const Series& rate() const { return rate_; }             // N without the linear part
    [[nodiscard]] std::vector<DivisorRecord>& records() { return records_; }

private:
    [[nodiscard]] Polynomial right_hand_side(int weight, const Polynomial& field_part,
                                             const Transport& transport) const;
    // The terms of one weight that one divisor belongs to.
    struct Share {
        const Divisor* divisor;
        Fractions part;
    };
    using Shares = std::deque<Share>;
    Share& share_of(const Monomial& outer, int weight, Shares& shares);
    [[nodiscard]] Polynomial without_vanishing(const Polynomial& p) const;
    void remember_derivatives(int weight);

    const GradedField& field_;
    std::string variable_;
    Place place_; // of the equation of the variable
    DivisorTable divisors_;
    std::vector<GeneratorId> outer_; // modes and eps: what a monomial is made of
    Series correction_, rate_;
    // derivatives of the correction, each computed once: by [mode or slow variable]
    std::vector<Series> by_mode_, by_conjugate_, by_slow_;
    std::vector<DivisorRecord> records_;
    std::set<Monomial> seen_; // monomials that have a record
};

} // namespace resonform
