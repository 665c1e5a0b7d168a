// SPDX-License-Identifier: GPL-3.0-or-later
// What a certificate checks of the style hamiltonian besides the equations, at one random point. With the
// brackets B of the normal form, y all modal coordinates and u = T y the variables of the file:
//
//   {q, p} = 1, other brackets of u zero     with y = w: B is the canonical structure in modes
//   {y_a, y_b} = B_ab for y = w + h(w)       the map is canonical, through M - w
//   H(u(w)) = K(w)                           through M + w, by the energy of the file
//   N_a = {w_a, K}                           through M
//   y_a = exp(L_chi) w_a                     through M (certificate_lie.hpp)
//
// (w in weights: that of the modes.) With a generator that has no kernel component they have one solution.
#pragma once

#include "normalize/certificate_point.hpp"
#include "normalize/certificate_roots.hpp"

#include <string>

namespace resonform {

// Precondition: normal_form.hamiltonian. "" if nothing is wrong, else a sentence.
std::string canonical_complaint(const NormalForm& normal_form, const NearIdentityMap& map,
                                CertificateRoots& roots, const Point& point);

// The energy of the file as the equation evaluator takes it: it names what a message is about.
Equation energy_as_equation(const System& system);

// J: the bracket of two states of the first-order system, 1 for coordinate and momentum.
int canonical_bracket(const FirstOrderSystem& system, std::size_t left, std::size_t right);

} // namespace resonform
