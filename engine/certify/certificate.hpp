// SPDX-License-Identifier: GPL-3.0-or-later
// The second route (design section 3): map and normal form are substituted into the ORIGINAL
// equations of the file at random points modulo several primes, and the normal form is scanned.
//
//   z = w + h, X = Z + l, w' = N, Z' = N_X, xi' as given, psi = (z + zbar)/2:
//   (a) psi' = d/dt psi, and equation_k(psi'', psi', psi, X', xi', xi, eps) = 0, through weight M
//   (b) every monomial of N is resonant, none of h and l is; N = i omega w + weights 2 ... M
//       (style inner_product: N = lambda w + n w + ..., and N and h obey inner_product.hpp)
//
// Style hamiltonian: (b) of N and of the generator instead of h, and the checks of hamiltonian.hpp.
//
// (a) and (b) have one solution, so that any wrong coefficient through M is found. Only exponents and
// coefficients are read from the ring; no product, relation, derivative or conjugation of it is used.
#pragma once

#include "normalize/recursion/normal_form.hpp"

#include <cstdint>

namespace resonform {

// Checks through M = normal_form.through. `seed` chooses points and primes; the default is fixed, so
// that the same input gives the same answer. There are at least 2 points, and as many as bring
// error_probability, the probability that a wrong normal form would be passed (derivation:
// bound.hpp), to 1e-30. Cost: linear in the number of terms.
//
// A normal form that fails is no error: holds = false, and `complaint` says where.
// Errors (refused): an equation with constructs that cannot be substituted;
// roots in the ring that are not proved independent; equations that do not determine their highest
// derivatives at weight 0, so that a vanishing residual proves less than its weight.
Certificate certify(const NormalForm& normal_form, const NearIdentityMap& map, std::uint64_t seed = 1);

// The same for several normal forms of one field: the equations are read once, when it is made. (Style
// hamiltonian: each time, because the plan contains the brackets of the normal form.)
class Certifier {
public:
    explicit Certifier(std::shared_ptr<const GradedField> field);
    Certificate operator()(const NormalForm& normal_form, const NearIdentityMap& map,
                           std::uint64_t seed = 1) const;

private:
    std::shared_ptr<const GradedField> field_;
    std::shared_ptr<const struct CertificatePlan> plan_;
};

// With coefficients in a graph: they are evaluated at each point. The probability of an error by which the
// graph took two coefficients for equal is in GraphBounds; nothing of it is trusted here.
Certificate certify(const GraphNormalization& normalization, std::uint64_t seed = 1);

} // namespace resonform
