// SPDX-License-Identifier: GPL-3.0-or-later
// The document of a normal form (schema resonform.normal_form/1), for coefficients of any representation.
#pragma once

#include "emit/display/json.hpp"
#include "normalize/recursion/normal_form.hpp"

#include <string>
#include <vector>

namespace resonform {

Json normal_form_document(const GradedField& field, int order, int truncation, Style style, Json normal_form,
                          Json map, const std::vector<DivisorRecord>& divisors,
                          const Certificate& certificate);

// The member "certificate".
Json certificate_json(const Certificate& certificate);

} // namespace resonform
