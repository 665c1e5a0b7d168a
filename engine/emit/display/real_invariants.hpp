// SPDX-License-Identifier: GPL-3.0-or-later
// The energy of a Hamiltonian normal form in real invariants: actions, and real and imaginary parts of
// resonant monomials.
//
//   K = z1 z2/2 + 3/32 z1^2 z2^2   ->   K = I1 + 3/8 I1^2,   z1 z2 = 2 I1
//   K = c z1^2 z4 + conj           ->   2 Re c Re(z1^2 z4) - 2 Im c Im(z1^2 z4)
//   K = c z1 z4 + conj             ->   likewise: eigenvalues lambda, -lambda of z1, z4, and their conjugates
#pragma once

#include "normalize/recursion/normal_form.hpp"

#include <string>
#include <vector>

namespace resonform {

// left right = product * name. Of a pair z, zbar with {z, zbar} = i b, b > 0, it is I >= 0 with z zbar = b I,
// its angle conjugate to it; with b < 0, z zbar = -b I, and I stands in H_2 with a minus sign. Where the sign
// is not known, as if b > 0. Of two real modes with {left, right} = b, left right = b I. Of complex ones that
// are not conjugate left right is complex: they have no action.
struct Action {
    std::string name; // "I1"
    GeneratorId left, right;
    Polynomial product;
};

struct InvariantTerm {
    enum class Part { whole, real, imaginary }; // of the resonant monomial
    Polynomial coefficient;                     // real
    std::vector<int> powers;                    // of the actions
    Monomial resonant;                          // powers of modes
    Part part;
    int eps; // power of the small generator
    int weight;
};

struct RealInvariants {
    std::vector<Action> actions;
    std::vector<InvariantTerm> energy; // by weight
};

// K through the weight that belongs to `order` in the rates. Precondition: style hamiltonian.
RealInvariants real_invariants(const NormalForm& normal_form, int order);

// The weight of the energy that gives rates of weight `order`.
int energy_weight(const GradedField& field, int order);

} // namespace resonform
