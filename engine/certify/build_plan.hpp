// SPDX-License-Identifier: GPL-3.0-or-later
// From the equations of the file to what a certificate computes.
#pragma once

#include "certify/plan.hpp"

namespace resonform {

// `hamiltonian`: its brackets are read, and its checks added (certificate_hamiltonian.hpp).
// Errors (refused): an equation with constructs that cannot be substituted.
CertificatePlan plan_certificate(const GradedField& field, const HamiltonianForm* hamiltonian);

// The frequencies of modes and angles only, without anything to be checked.
CertificatePlan plan_frequencies(const GradedField& field);

} // namespace resonform
