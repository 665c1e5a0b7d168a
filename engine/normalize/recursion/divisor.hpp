// SPDX-License-Identifier: GPL-3.0-or-later
// Small divisors: the divisor of each monomial in a homological equation, and whether it may be divided by.
//
//   D(alpha) = <alpha, lambda> - lambda_j = a + i b,
//   <alpha, lambda> = sum_m (alpha_m lambda_m + alphabar_m conj(lambda_m)) + i sum_l k_l omega_l
//
// with harmonics k_l of the angles; 1/D = (a - i b)/(a^2 + b^2).
#pragma once

#include "algebra/series/number_domain.hpp"
#include "algebra/series/ring_domain.hpp"
#include "normalize/recursion/normal_form.hpp"

#include <map>
#include <vector>

namespace resonform {

template <class Part> struct Divisor {
    Polynomial value;
    DivisorVerdict verdict;
    Part inverse; // only where the verdict is removed; empty: the ring does not hold it yet
};

// In numbers: the balls do not tell whether a divisor is zero, or as small as `near`; more bits may.
struct UndecidedDivisor {
    std::string divisor; // D(z1^2) of z3 = i*(2*omega_x - omega_y)
    bool near;
    Place place = {}; // of the equation
};

// The divisors of one equation. This is the only place where the normaliser divides: a divisor has an inverse
// only if the ring proves that it is a unit, or, in a graph, that it does not vanish identically, or, in
// numbers, if zero is not in its ball.
template <class Domain> class DivisorTable {
public:
    using Part = typename Domain::Part;

    // mode: index of the mode whose equation it is, or -1 for another variable (lambda = 0).
    DivisorTable(const GradedField& field, Domain domain, int mode);

    // The divisor of a monomial in GradedField::outer() (other exponents zero).
    // Errors (refused): proved neither to vanish nor not to vanish identically (ambiguous); in numbers
    // UndecidedDivisor is thrown.
    const Divisor<Part>& of(const Monomial& monomial);
    // The norms for which the ring lacks an inverse, among the divisors asked for: a or b where the other
    // vanishes, else a^2 + b^2.
    [[nodiscard]] const std::vector<Polynomial>& missing() const { return missing_; }

private:
    // Multiples of the growth and of the frequency of each mode, of the frequency of each angle.
    using Multiples = std::vector<int>;
    [[nodiscard]] Multiples multiples_of(const Monomial& monomial) const;
    struct Asked {
        const Monomial& monomial; // the first with these multiples
        Multiples multiples;
    };
    [[nodiscard]] Divisor<Part> make(const Asked& asked);
    // The divisor growth + i frequency, of which not both vanish identically.
    [[nodiscard]] Divisor<Part> judged(const Polynomial& growth, const Polynomial& frequency,
                                       const Asked& asked);
    // For messages.
    [[nodiscard]] std::string spell(const Asked& asked) const;
    [[nodiscard]] std::string spell(const Monomial& monomial) const;
    // |D| <= near, where D is a number. Errors (refused): that cannot be told (ambiguous).
    [[nodiscard]] bool is_near(const Asked& asked) const;

    const GradedField& field_;
    Domain domain_;
    int mode_;
    std::map<Multiples, Divisor<Part>> known_;
    std::vector<Polynomial> missing_;
};

} // namespace resonform
