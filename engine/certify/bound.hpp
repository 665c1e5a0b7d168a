// SPDX-License-Identifier: GPL-3.0-or-later
// How probable it is that a wrong normal form passes at one random point.
//
// Let f be a coefficient of t^n, n <= M, of a quantity that must vanish, and f != 0. With c = Q f the
// denominators are cleared: f is a polynomial of degree <= D with integer coefficients of total size
// <= 2^B, where a root sigma^k = P counts as degree P / k. Its norm over the field of i and of the roots
// (of degree K = 2 k_1 ... k_s, because the roots are independent) is the resultant
//   F = Res(i^2 + 1, Res(sigma^k - P, c)),  F != 0,  deg F <= K D,  bits of F <= K (B + D log2 |P|_1 / k),
// a polynomial in the quantities that are drawn at random: parameters, slow variables, functions, w0, wbar0,
// e0 (for sin and cos, the t of sin = 2 t/(1 + t^2) and cos = (1 - t^2)/(1 + t^2)); and c = 0 modulo p at a
// point implies F = 0 modulo p there. Hence
//   (1) F vanishes modulo p identically for at most bits(F)/60 of the 1.3e16 primes p > 2^60;
//   (2) else, for a random point, with probability at most K D / 2^60            (Schwartz and Zippel);
//   (3) points are drawn until all roots exist modulo p, which happens with probability at least
//       1/(2K) (Lang and Weil; Chebotarev), and conditioning on it multiplies by at most 2K:
//   Pr(f passes at a point) <= 2 K (K D / 2^60 + bits(F) / 60 / 1.3e16).
// Points are independent, so the bounds multiply. D and B are found by running the program of the
// certificate with bounds of degree and height instead of numbers.
#pragma once

#include "certify/points/plan.hpp"
#include "certify/points/survey.hpp"

namespace resonform {

double point_error_bound(const CertificatePlan& plan, const NormalForm& normal_form,
                         const NearIdentityMap& map, Surveyor& surveys);

} // namespace resonform
