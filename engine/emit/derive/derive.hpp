// SPDX-License-Identifier: GPL-3.0-or-later
// The output of each stage of `derive`: a page for text and LaTeX, a value for JSON, a script.
// document.hpp chooses among them.
#pragma once

#include "emit/display/json.hpp"
#include "emit/display/page.hpp"
#include "expand/expansion/graded_field.hpp"
#include "normalize/recursion/centre_manifold.hpp"
#include "normalize/recursion/normal_form.hpp"
#include "solve/transgression.hpp"

namespace resonform {

// An equation as the user wrote it, with the values of --set; and what [relations] computes, with a heading.
Formula formula_of(const Equation& equation, const std::vector<Setting>& settings);
void append_relations(Page& page, const System& system);
Json relations_json(const System& system);

// (15), as the file has it. Schema resonform.equations/1.
Page equations_page(const System& system);
Json equations_json(const System& system);

// How the equations of a mechanism come about: (2) of its constraints, or (7)-(10). Schema
// resonform.derivation/1. Precondition: system.derivation.
Page derivation_page(const System& system, bool constraints);
Json derivation_json(const System& system, bool constraints);

// (16), and with a solution (19). Schema resonform.expansion/1.
Page expansion_page(const GradedField& field, int order, const Solution* solution);
Json expansion_json(const GradedField& field, int order);

// (20) and the near-identity map. Schema resonform.normal_form/1 (design 6.1).
Page normal_form_page(const Normalization& normalization, int order, const Solution* solution);
Json normal_form_json(const Normalization& normalization, int order);
// Coefficients written out one by one. Errors (refused): one is longer than ExpansionLimits.
Json normal_form_json(const GraphNormalization& normalization, int order);
// The divisors of each equation with their verdicts, and where those that were divided by vanish. Schema
// resonform.divisors/1; divisors_json is its list, in the document of the normal form too.
Page divisors_page(const GradedField& field, const std::vector<DivisorRecord>& divisors, int order);
Json divisors_document(const GradedField& field, const std::vector<DivisorRecord>& divisors, int order);
Json divisors_json(const GradedField& field, const std::vector<DivisorRecord>& divisors, int order);
// The centre manifold of a normal form. Schema resonform.manifold/1.
Page manifold_page(const CentreManifold& manifold, const Certificate& certificate, int order);
Json manifold_json(const CentreManifold& manifold, const Certificate& certificate, int order);

std::string normal_form_sympy(const Normalization& normalization, int order);
std::string normal_form_maxima(const Normalization& normalization, int order);

// (21) to (23). Schema resonform.solution/1.
Page solution_page(const Solution& solution);
// Puts T = eps*t in front if a formula of the page has T in it.
void define_slow_time(Page& page, const Solution& solution);
Json solution_json(const Solution& solution);
// xi = xi_0 + eps*v*t
Section slow_laws(const Solution& solution);

// Motion on the time 1/eps of the variables constant at eps = 0. Schema resonform.transgression/1.
Page transgression_page(const Transgression& transgression);
Json transgression_json(const Transgression& transgression);

} // namespace resonform
