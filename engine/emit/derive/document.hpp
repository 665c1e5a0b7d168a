// SPDX-License-Identifier: GPL-3.0-or-later
// Whole documents for `resonform derive`: one stage of the line in one format. Each ends with a newline.
//
//   print_normal_form(pendulum, 3, Format::text, &solution)   ->   z1' = I*sqrt(g)/(r^2 + xi^2)^(1/4)*z1 -
//   ...
//
// Unsupported combinations (Maxima of a solution, say) are bad input; the hint lists those supported.
#pragma once

#include "expand/expansion/graded_field.hpp"
#include "normalize/recursion/normal_form.hpp"
#include "solve/solution.hpp"

#include <string>
#include <string_view>

namespace resonform {

enum class Format { text, latex, json, sympy, maxima };
enum class Stage {
    constraints,
    accelerations,
    equations,
    expand,
    normal_form,
    divisors,
    manifold,
    solution,
    transgression
};

const char* to_string(Format format); // "text", "latex", ...
const char* to_string(Stage stage);   // "equations", "expand", "normal_form", ...
// The inverse of to_string. Errors: bad_input, with the nearest known name.
Format parse_format(std::string_view name);
Stage parse_stage(std::string_view name);

// Throws bad_input when `stage` cannot be printed in `format`: call it before the work.
// Every stage has text, latex, json; sympy and maxima exist for normal_form only.
void require_printable(Stage stage, Format format);

// The equations as read, e.g. (15).
std::string print_equations(const System& system, Format format);

// The derivation of a mechanism's equations: its constraints (2), or its energy of accelerations (7)-(10).
// Errors: bad_input: the file has the equations.
std::string print_derivation(const System& system, Stage stage, Format format);

// The equations expanded through weight `order` (1 ... 99) with their remainders, (16); in text and
// LaTeX, with a solution at hand, also without the known weight-1 drift, (19). eps v is written as
// xi' where eps enters only through that rate. JSON keeps the variables as written, rates substituted.
std::string print_expansion(const GradedField& field, int order, Format format,
                            const Solution* solution = nullptr);

// Normal form and near-identity map through weight `order` <= normal_form.through, (20); `solution`
// as above. JSON: schema resonform.normal_form/1.
// Errors: bad_input: order < 1 or beyond the weight of the normalisation.
std::string print_normal_form(const Normalization& normalization, int order, Format format,
                              const Solution* solution = nullptr);

// With coefficients in a graph: JSON, the same schema.
std::string print_normal_form(const GraphNormalization& normalization, int order);

// The divisors of the homological equations, removed and kept, through weight `order`.
std::string print_divisors(const GradedField& field, const std::vector<DivisorRecord>& divisors, int order,
                           Format format);

// The centre manifold with its flow and fibres, through weight `order`. Errors: centre_manifold's.
std::string print_manifold(const Normalization& normalization, int order, Format format);

// Amplitude and phase (21), the drift, and the outputs by powers of eps, (22), (23).
std::string print_solution(const Solution& solution, Format format);

// The motion, on the time 1/eps, of the variables that are constant at eps = 0.
// Errors: bad_input: there are none (require_former_constants, to be called before the work).
std::string print_transgression(const Solution& solution, Format format);
void require_former_constants(const System& system);

} // namespace resonform
