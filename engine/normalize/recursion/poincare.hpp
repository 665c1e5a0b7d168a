// SPDX-License-Identifier: GPL-3.0-or-later
// Poincare normal form: h and l have no resonant component (design 2.3).
#pragma once

#include "normalize/recursion/normal_form.hpp"
#include "normalize/recursion/options.hpp"

namespace resonform {

// Errors (bad_input): a weight (System::weight) that is not within 1 ... 99, or below that of a fast
// variable.
void check_order(const GradedField& field, int through);

// `through` as System::weight() reads it, 1 ... 99. The certificate is left empty: certify() is a second
// route in its own file.
Normalization normalize_poincare(std::shared_ptr<const GradedField> field, int through,
                                 const NormalizeOptions& options = {});

// The same with coefficients in a graph, which divides by any small divisor: for several symbolic
// frequencies. Errors (refused): coefficients that are no rational functions of independent symbols.
GraphNormalization normalize_in_graph(std::shared_ptr<const GradedField> field, int through,
                                      const NormalizeOptions& options = {});

// The same over numbers of some precision (normalize/recursion/numbers.hpp). Throws UndecidedDivisor.
NormalizationOf<NumberPart> normalize_over(const std::shared_ptr<const GradedField>& field, int through,
                                           const NumberDomain& domain, const NormalizeOptions& options = {});

// Whether a graph is the better place for the coefficients: two symbolic frequencies or more, none a multiple
// of another, an order from which on the inverse divisors multiply, and nothing that a graph refuses.
bool suits_graph(const GradedField& field, int through);

} // namespace resonform
