// SPDX-License-Identifier: GPL-3.0-or-later
// The signs that a real expression may have where parameters and slow variables lie in their domain: by its
// structure (sign_prover.cpp), and by its polynomial in atoms (polynomial_in_atoms.cpp);
// docs/design/20_signs.md.
#pragma once

#include "algebra/signs/sign_set.hpp"
#include "model/system/system_file.hpp"

#include <map>

namespace resonform {

class SignProver {
public:
    explicit SignProver(const System& system) : system_(system) {}

    // The value is real and has one of these signs everywhere in the domain; all signs: nothing is known.
    [[nodiscard]] SignSet signs(const GiNaC::ex& e) const;
    // Even where it may be complex: (a - b)^(1/2) where a - b is not zero.
    [[nodiscard]] bool nonzero(const GiNaC::ex& e) const;
    // Proved: no root in it is of a negative number, no logarithm of a number <= 0, no inverse of zero.
    [[nodiscard]] bool real(const GiNaC::ex& e) const;

private:
    [[nodiscard]] SignSet find_signs(const GiNaC::ex& e) const;
    [[nodiscard]] SignSet declared(const GiNaC::ex& e) const;
    [[nodiscard]] SignSet by_structure(const GiNaC::ex& e) const;
    [[nodiscard]] SignSet of_power(const GiNaC::ex& e) const;
    [[nodiscard]] SignSet of_sum(const GiNaC::ex& e) const;
    [[nodiscard]] SignSet of_function(const GiNaC::ex& e) const;
    [[nodiscard]] SignSet in_atoms(const GiNaC::ex& e) const;

    const System& system_;
    mutable std::map<GiNaC::ex, SignSet, GiNaC::ex_is_less> signs_; // of expressions asked before
};

// true: e > 0 wherever parameters and slow variables lie in their declared domain; false: not proved.
//   xi^2 + r^2, g/sqrt(xi^2 + r^2), exp(tau), sqrt(g^2 + r) - g, with r, g > 0;   2 + 2*tau where 1 + tau is
//   declared;   sin(tau) - 4*cos(tau) + 6
bool provably_positive(const GiNaC::ex& e, const System& system);
// true: e != 0 there.   tau where tau^2 - 2 is declared
bool provably_nonzero(const GiNaC::ex& e, const System& system);

} // namespace resonform
