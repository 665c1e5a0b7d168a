// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/solve.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/functions.hpp"
#include "algebra/number/number.hpp"
#include "solve/amplitude_phase.hpp"
#include "solve/drift.hpp"
#include "solve/flow/frame.hpp"
#include "solve/quadrature.hpp"
#include "solve/route.hpp"
#include "solve/substitution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace resonform {

namespace {

void check_moves(const GradedField& field) {
    for (const SlowVariable& slow : field.slow)
        if (!slow.driven && slow.rate.empty())
            refuse({"the slow variable does not move", slow.name + "' = 0",
                    "declare " + slow.name + " as a parameter", field.system().place_of(slow.variable)});
}

void check_supported(const Normalization& normalization, const SolveOptions& options) {
    const NormalForm& normal_form = normalization.normal_form;
    const GradedField& field = *normal_form.field;
    const System& system = field.system();
    const auto text = [&](int held) { return to_string(system.weight(held)); };
    if (options.order < 1 || options.truncation < options.order)
        bad_input({"1 <= order <= truncation",
                   fmt::format("order = {}, truncation = {}", text(options.order), text(options.truncation)),
                   "raise the truncation, or leave it out",
                   {system.file.string(), 0, 0, "truncation", ""}});
    if (normal_form.through < options.truncation || normalization.map.through < options.truncation)
        bad_input({"normal form and map reach the weight that the solution uses",
                   fmt::format("truncation = {}, normal form through {}", text(options.truncation),
                               text(normal_form.through)),
                   "normalise through a higher weight",
                   {system.file.string(), 0, 0, "truncation", ""}});
    for (GeneratorId id = 0; id < field.ring->size(); ++id)
        if (const Generator& g = field.ring->generator(id); g.kind == GeneratorKind::function &&
                                                            g.of.function == Function::named &&
                                                            !system.function(g.of.symbol)->is_opaque())
            refuse(
                {"a solution is for functions that have values",
                 g.name,
                 "give " + g.of.symbol + " a value under [functions] of a scene, or derive the normal form",
                 {system.file.string(), 0, 0, "equations", ""}});
    const int degree = options.truncation / system.eps_root + 1;
    for (const NamedFunction& f : system.functions)
        if (f.data != nullptr && f.data->degree < degree)
            refuse(Reason::not_smooth,
                   {fmt::format(
                        "data are smooth enough: a spline of degree d has an error of eps^d, and weights "
                        "through {} ask for degree {}",
                        text(options.truncation), degree | 1),
                    fmt::format("{} is a spline of degree {}", f.name, f.data->degree),
                    fmt::format("write degree = {} in [functions] of the scene, or ask for a lower order",
                                degree | 1),
                    {system.file.string(), 0, 0, "functions." + f.name, ""}});
    check_moves(field);
}

// z = w + h cut at a weight, by powers of eps.
Series oscillation(const Draft& draft, int through) {
    const GradedField& field = *draft.normal_form().field;
    const Polynomial w = field.ring->gen(field.modes.front().z);
    return Substitution(draft, through)(w + draft.solution.normalization->map.mode.front().total(through));
}

// f(z_n) for every part.
template <class Function> Series transform(const Series& s, Function f) {
    Series result;
    for (int n = 0; n <= s.through(); ++n) result.set(n, f(s.part(n)));
    return result;
}

// psi = (z + zbar)/2
Series position(const Draft& draft, const Series& z) {
    return transform(z,
                     [&](const Polynomial& p) { return Rational(1) / 2 * (p + draft.ring().conjugate(p)); });
}

// psi' = i omega (z - zbar)/2
Series velocity(const Draft& draft, const Series& z) {
    const Ring& ring = draft.ring();
    const Polynomial omega = draft.lift(draft.normal_form().field->modes.front().omega);
    const Polynomial factor = Rational(1) / 2 * ring.multiply(ring.imaginary(), omega);
    return transform(z, [&](const Polynomial& p) { return ring.multiply(factor, p - ring.conjugate(p)); });
}

// X = Z + l, Z as solved, l cut at a weight.
Series displaced(const Draft& draft, std::size_t drift, int through) {
    const Substitution put(draft, through);
    const Series l = put(draft.solution.normalization->map.drift[drift].total(through));
    Series result;
    for (int n = 0; n <= through; ++n) result.set(n, draft.solution.drift[drift].value.part(n) + l.part(n));
    return result;
}

// x = c + ..., where the oscillator is measured from c.
Series from_origin(const Draft& draft, Series state, int derivative) {
    const GradedField& field = *draft.normal_form().field;
    const Polynomial shift = field.shift(field.modes.front().variable, derivative);
    const Series parts = Series::split(*field.ring, shift, state.through()); // without modes: powers of eps
    for (int n = 0; n <= state.through(); ++n) state.set(n, state.part(n) + draft.lift(parts.part(n)));
    return state;
}

std::size_t index_of_drift(const Solution& solution, std::size_t variable) {
    std::size_t d = 0;
    while (solution.drift[d].variable != variable) ++d;
    return d;
}

void fill_outputs(Draft& draft) {
    Solution& solution = draft.solution;
    const System& system = solution.system();
    for (std::size_t v = 0; v < system.variables.size(); ++v) {
        const Variable& variable = system.variables[v];
        if (variable.role == Role::fast)
            solution.outputs.push_back(
                {variable.name, from_origin(draft, position(draft, oscillation(draft, solution.order)), 0)});
        if (variable.role == Role::drift)
            solution.outputs.push_back(
                {variable.name, displaced(draft, index_of_drift(solution, v), solution.order)});
    }
}

void fill_state(Draft& draft) {
    Solution& solution = draft.solution;
    const System& system = solution.system();
    for (const State& state : draft.normal_form().field->first_order->states) {
        const Role role = system.variables[state.variable].role;
        if (role == Role::drift)
            solution.state.push_back({state.name, displaced(draft, index_of_drift(solution, state.variable),
                                                            solution.truncation)});
        if (role != Role::fast) continue;
        const Series z = oscillation(draft, solution.truncation);
        solution.state.push_back(
            {state.name, from_origin(draft, state.derivative == 0 ? position(draft, z) : velocity(draft, z),
                                     state.derivative)});
    }
}

Solution solved_as_flow(std::shared_ptr<const Normalization> normalization, const SolveOptions& options) {
    Solution solution;
    solution.order = options.order;
    solution.truncation = options.truncation;
    solution.flow = std::make_shared<const SlowFlow>(slow_flow(*normalization, options));
    solution.normalization = std::move(normalization);
    return solution;
}

Solution solved_by_quadratures(std::shared_ptr<const Normalization> normalization,
                               const SolveOptions& options) {
    const EnvelopePlan plan = plan_envelope(normalization->normal_form);
    Draft draft(std::move(normalization), options, plan.refinements());
    solve_amplitude_and_phase(draft, plan);
    solve_drift(draft);
    fill_outputs(draft);
    fill_state(draft);
    return std::move(draft.solution);
}

void check_projected(const Solution& solution, const SolveOptions& options) {
    if (options.growing == Growing::project && !(solution.flow && solution.flow->grows()))
        bad_input({"a start is projected where a mode grows at eps = 0",
                   "growing = \"project\", and none grows",
                   "remove growing",
                   {solution.system().file.string(), 0, 0, "growing", ""}});
}

} // namespace

bool solves_by_quadratures(const NormalForm& normal_form, int time_scale) {
    const GradedField& field = *normal_form.field;
    const auto relaxes = [&](const SlowVariable& slow) { return explicit_law(field, slow)->relaxes(); };
    return solves_by_quadratures(field) && !field.system().has_opaque_functions() &&
           (time_scale < 2 || (amplitude_is_constant(normal_form) &&
                               std::none_of(field.slow.begin(), field.slow.end(), relaxes)));
}

Solution solve(std::shared_ptr<const Normalization> normalization, const SolveOptions& options) {
    check_supported(*normalization, options);
    const bool has_flow =
        options.at_zero || !solves_by_quadratures(normalization->normal_form, options.time_scale);
    Solution solution = has_flow ? solved_as_flow(std::move(normalization), options)
                                 : solved_by_quadratures(std::move(normalization), options);
    check_projected(solution, options);
    return solution;
}

} // namespace resonform
