// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the equations of the file into the plan of a certificate.
#pragma once

#include "certify/points/plan.hpp"

namespace resonform {

// `hamiltonian`: its brackets are read, and its checks added (hamiltonian.hpp).
// Errors (refused): an equation with constructs that cannot be substituted.
CertificatePlan plan_certificate(const GradedField& field, const HamiltonianForm* hamiltonian);

// A plan of the frequencies of modes and angles only; it checks nothing.
CertificatePlan plan_frequencies(const GradedField& field);

// Sets `needed` and `readings` from all that the plan checks and notes.
void settle_readings(CertificatePlan& plan);

} // namespace resonform
