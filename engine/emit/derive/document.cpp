// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/derive/document.hpp"

#include "algebra/number/error.hpp"
#include "emit/derive/derive.hpp"
#include "emit/display/json.hpp"
#include "emit/display/names_apart.hpp"
#include "emit/display/page.hpp"
#include "model/mechanics/derivation.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/nearest.hpp"
#include "normalize/recursion/centre_manifold.hpp"
#include "solve/transgression.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace resonform {

namespace {

// In the order of the enumerations.
constexpr std::array format_names = {"text", "latex", "json", "sympy", "maxima"};
constexpr std::array stage_names = {"constraints", "accelerations", "equations",
                                    "expand",      "normal_form",   "divisors",
                                    "manifold",    "solution",      "transgression"};

template <class Choice, std::size_t N>
Choice parse(const char* what, std::string_view name, const std::array<const char*, N>& names) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<Choice>(found - names.begin());
    const std::string near = nearest(std::string(name), {names.begin(), names.end()});
    bad_input({fmt::format("{} is one of {}", what, fmt::join(names, ", ")),
               std::string(name),
               near.empty() ? "name one of these" : "write " + near,
               {}});
}

void require_order(int order, int largest, const char* of) {
    if (order < 1 || order > largest)
        bad_input({fmt::format("1 <= order <= {} ({})", largest, of),
                   std::to_string(order),
                   "choose an order in this range",
                   {}});
}

std::string render(const Page& page, Format format) {
    return format == Format::latex ? page_latex(with_names_apart(page)) : page_text(page);
}

// Adds the definition of T to a page that uses it.
Page defined(Page page, const Solution* solution) {
    if (solution != nullptr) define_slow_time(page, *solution);
    return page;
}

} // namespace

const char* to_string(Format format) { return format_names[static_cast<std::size_t>(format)]; }

const char* to_string(Stage stage) { return stage_names[static_cast<std::size_t>(stage)]; }

Format parse_format(std::string_view name) { return parse<Format>("a format", name, format_names); }

Stage parse_stage(std::string_view name) { return parse<Stage>("a stage", name, stage_names); }

void require_printable(Stage stage, Format format) {
    const bool script = format == Format::sympy || format == Format::maxima;
    if (script && stage != Stage::normal_form)
        bad_input({"the formats of stage " + std::string(to_string(stage)) + " are text, latex, json",
                   to_string(format),
                   "choose one of these, or stage normal_form",
                   {}});
}

std::string print_equations(const System& system, Format format) {
    require_printable(Stage::equations, format);
    return format == Format::json ? json_document(equations_json(system))
                                  : render(equations_page(system), format);
}

std::string print_derivation(const System& system, Stage stage, Format format) {
    require_printable(stage, format);
    if (!system.derivation || !system.derivation->is_of_mechanism())
        bad_input({"stage " + std::string(to_string(stage)) + " is one of a mechanism",
                   "the file has the equations themselves", "ask for stage equations",
                   whole_file(system.file)});
    const bool constraints = stage == Stage::constraints;
    return format == Format::json ? json_document(derivation_json(system, constraints))
                                  : render(derivation_page(system, constraints), format);
}

std::string print_expansion(const GradedField& field, int order, Format format, const Solution* solution) {
    require_printable(Stage::expand, format);
    require_order(order, 99 * field.system().eps_root, "weights of an expansion");
    return format == Format::json ? json_document(expansion_json(field, order))
                                  : render(defined(expansion_page(field, order, solution), solution), format);
}

std::string print_normal_form(const Normalization& normalization, int order, Format format,
                              const Solution* solution) {
    require_order(order, normalization.normal_form.through, "weight of the normal form");
    switch (format) {
    case Format::json: return json_document(normal_form_json(normalization, order));
    case Format::sympy: return normal_form_sympy(normalization, order);
    case Format::maxima: return normal_form_maxima(normalization, order);
    case Format::text:
    case Format::latex: break;
    }
    return render(defined(normal_form_page(normalization, order, solution), solution), format);
}

std::string print_normal_form(const GraphNormalization& normalization, int order) {
    require_order(order, normalization.result.normal_form.through, "weight of the normal form");
    return json_document(normal_form_json(normalization, order));
}

std::string print_divisors(const GradedField& field, const std::vector<DivisorRecord>& divisors, int order,
                           Format format) {
    require_printable(Stage::divisors, format);
    return format == Format::json ? json_document(divisors_document(field, divisors, order))
                                  : render(divisors_page(field, divisors, order), format);
}

std::string print_manifold(const Normalization& normalization, int order, Format format) {
    require_printable(Stage::manifold, format);
    const CentreManifold manifold = centre_manifold(normalization);
    const Certificate& certificate = normalization.certificate;
    return format == Format::json ? json_document(manifold_json(manifold, certificate, order))
                                  : render(manifold_page(manifold, certificate, order), format);
}

std::string print_solution(const Solution& solution, Format format) {
    require_printable(Stage::solution, format);
    return format == Format::json ? json_document(solution_json(solution))
                                  : render(defined(solution_page(solution), &solution), format);
}

void require_former_constants(const System& system) {
    if (has_former_constants(system)) return;
    bad_input({"stage transgression is of what is constant at eps = 0: slow variables and drifts",
               "the system has neither", "ask for another stage", whole_file(system.file)});
}

std::string print_transgression(const Solution& solution, Format format) {
    require_printable(Stage::transgression, format);
    require_former_constants(solution.system());
    const Transgression laws = transgression(solution);
    return format == Format::json ? json_document(transgression_json(laws))
                                  : render(defined(transgression_page(laws), &laws.law), format);
}

} // namespace resonform
