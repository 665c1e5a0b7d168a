// SPDX-License-Identifier: GPL-3.0-or-later
// The flow of a generator at one point: y(tau) with dy_a/dtau = {y_a, chi}(y), y(0) = w. exp(L_chi) w is
// y(1). The coefficient of t^n in y is a polynomial in tau of degree below n, known by its values at tau = 0,
// 1, 2, ...; its derivative follows from lower weights. No bracket of polynomials is formed, unlike in the
// Lie series that it is compared with.
#pragma once

#include "certify/points/point.hpp"

#include <string>

namespace resonform {

// Whether the coordinates of the plan are y(1) at a point, number `number` of the run, through M; "" if they
// are. Throws UnluckyPoint.
std::string generator_complaint(const CertificatePlan& plan, const NormalForm& normal_form,
                                const PointRun& run, std::size_t number, const Point& point);

} // namespace resonform
