// SPDX-License-Identifier: GPL-3.0-or-later
// The jets of the old variables along the normal form: z = w + h, phi = theta + m, xi = zeta + k, X = Z + l,
// u = T(xi) z, and time derivatives by the chain rule  s' = sum over generators g of (ds/dg) g',  with
//   w' = N,  wbar' = conj N,  zeta' = N,  (e^{i theta})' = i e^{i theta} N,  eps' = 0,
//   sigma' = P'/(k sigma^(k-1)).
// Independent of Ring's products, derivatives and conjugation: only exponents and coefficients are read.
#pragma once

#include "certify/equation.hpp"
#include "expand/expansion/graded_field.hpp"

#include <optional>

namespace resonform {

// The values to substitute into the equations, and the defects psi' - d/dt psi, which must vanish as well.
struct Jets {
    Substituted values;
    std::vector<std::pair<std::size_t, Slot>> velocity_defects; // by variable
    // The derivatives of the followed series by the last derivative of a function known by its name. The ring
    // does not hold its rate, so they must vanish.
    std::vector<std::pair<GeneratorId, Slot>> unknown;
};

Jets jets_along(CertificateProgram& program, CertificateRoots& roots, const GradedField& field);

} // namespace resonform
