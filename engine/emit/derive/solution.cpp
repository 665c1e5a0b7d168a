// SPDX-License-Identifier: GPL-3.0-or-later
// (21) to (23): amplitude and phase, drift, and the outputs in sines and cosines.
#include "emit/derive/derive.hpp"
#include "emit/derive/flow.hpp"
#include "emit/display/display.hpp"
#include "emit/display/drift_frame.hpp"
#include "emit/display/free_name.hpp"
#include "emit/display/normal_form_parts.hpp"
#include "emit/display/page.hpp"
#include "emit/display/slow_rate.hpp"
#include "emit/display/solution_display.hpp"

#include <fmt/format.h>
#include <utility>

namespace resonform {

namespace {

// w' = w (a + i b) with w = Delta e^{i theta}:  Delta' = a Delta,  theta' = b. In both the generator z
// stands for Delta afterwards.
Polynomial polar_rate(const GradedField& field, const Polynomial& rate, bool phase) {
    const Ring& ring = *field.ring;
    const Mode& mode = field.modes.front();
    std::vector<Term> terms;
    for (const Term& term : rate.terms()) {
        std::vector<int> exponents = ring.exponents(term.monomial);
        const auto exponent = [&](GeneratorId id) -> int& { return exponents[static_cast<std::size_t>(id)]; };
        if ((exponent(Ring::imaginary_unit) != 0) != phase) continue;
        exponent(Ring::imaginary_unit) = 0;
        exponent(mode.z) += exponent(mode.zbar) - (phase ? 1 : 0);
        exponent(mode.zbar) = 0;
        terms.push_back({ring.monomial(exponents), term.coefficient});
    }
    return Polynomial::from_terms(std::move(terms));
}

class SolutionPage {
public:
    explicit SolutionPage(const Solution& solution)
        : solution_(solution), ring_(*solution.ring), field_(*solution.normalization->normal_form.field),
          substitutes_(solution_substitutes(solution)), amplitude_(free_name(solution.system(), "Delta")),
          phase_(phase_name(solution)) {}

    [[nodiscard]] Section amplitude_and_phase() const {
        Section section{"amplitude and phase", {}};
        if (solution_.modes.empty()) return section;
        const ModeSolution& mode = solution_.modes.front();
        const Polynomial rate = solution_.normalization->normal_form.mode.front().total(solution_.truncation);
        const Polynomial growth = polar_rate(field_, rate, false), speed = polar_rate(field_, rate, true);
        const SeriesWriter write(field_.ring, field_.eps, {field_.modes.front().z, field_.eps},
                                 only_rate_with_eps(field_), {growth, speed});
        define(section, field_.modes.front().name, polar_form());
        define(section, amplitude_ + "'", polar_side(growth, write));
        define(section, phase_ + "'", polar_side(speed, write));
        define(section, amplitude_, envelope(mode));
        define(section, phase_, phase_integral(mode));
        return section;
    }

    [[nodiscard]] Section drift() const {
        Section section{"drift", {}};
        const std::vector<DriftFrame> frames = drift_frames(field_, &solution_);
        for (const DriftSolution& drift : solution_.drift) {
            const std::string& name = solution_.system().variables[drift.variable].name;
            for (const DriftFrame& frame : frames) {
                if (frame.variable != name) continue;
                define(section, frame.normal, drift_side(drift, frame.removed));
                define_frame(section, frame);
            }
        }
        return section;
    }

    // A drift variable is its mean motion plus an oscillating part f, as in (23).
    [[nodiscard]] Section outputs() const {
        Section section{"outputs through order " + std::to_string(solution_.order), {}};
        for (const SolutionOutput& output : solution_.outputs) {
            const Variable* variable = solution_.system().variable(output.name);
            const bool split = variable != nullptr && variable->role == Role::drift;
            Side mean, oscillation;
            for (int n = 0; n <= output.value.through(); ++n) {
                std::vector<Harmonic> constant, rest;
                for (Harmonic& harmonic : harmonics(solution_, output.value.part(n)))
                    (split && harmonic.multiple != 0 ? rest : constant).push_back(std::move(harmonic));
                mean.groups.push_back(display_harmonics(solution_, constant));
                oscillation.groups.push_back(display_harmonics(solution_, rest));
            }
            add_output(section, output.name, std::move(mean), std::move(oscillation));
        }
        return section;
    }

private:
    // Delta*exp(I*theta)
    [[nodiscard]] DisplaySum polar_form() const {
        DisplaySum angle = symbol_sum(phase_);
        angle.terms.front().imaginary = true;
        DisplaySum form = symbol_sum(amplitude_);
        form.terms.front().tail.push_back(function_factor("exp", std::move(angle)));
        return form;
    }

    [[nodiscard]] Side polar_side(const Polynomial& rate, const SeriesWriter& write) const {
        const Substitutes substitutes{{field_.modes.front().z, symbol_factor(amplitude_)}};
        Side result;
        for (const Polynomial& part : field_.ring->by_weight(rate, solution_.truncation))
            result.groups.push_back(write(part, substitutes));
        return result;
    }

    [[nodiscard]] Side envelope(const ModeSolution& mode) const {
        const Polynomial leading = ring_.multiply(ring_.multiply(ring_.gen(solution_.eps), mode.envelope),
                                                  ring_.gen(mode.amplitude));
        Side result;
        for (int n = 0; n <= mode.factor.through(); ++n)
            result.groups.push_back(
                display(ring_, ring_.multiply(leading, mode.factor.part(n)), substitutes_));
        return result;
    }

    [[nodiscard]] Side phase_integral(const ModeSolution& mode) const {
        DisplaySum integrand;
        for (int n = 0; n <= mode.phase_rate.through(); ++n)
            integrand = integrand + display(ring_, mode.phase_rate.part(n), substitutes_);
        DisplayFactor integral =
            integral_factor({std::move(integrand), symbol_sum("t"), DisplaySum{}, symbol_sum("t")});
        return {{symbol_sum(mode.phase_name), factor_sum(std::move(integral))}};
    }

    // By powers of eps; without the primitive of the known rate, only the constant is left of part 0.
    [[nodiscard]] Side drift_side(const DriftSolution& drift, bool removed) const {
        Side result;
        for (int n = 0; n <= drift.value.through(); ++n)
            result.groups.push_back(n == 0 && removed ? symbol_sum(drift.constant_name)
                                                      : display(ring_, drift.value.part(n), substitutes_));
        return result;
    }

    void add_output(Section& section, const std::string& name, Side mean, Side oscillation) const {
        bool oscillates = false;
        for (const DisplaySum& group : oscillation.groups) oscillates = oscillates || !group.terms.empty();
        const std::string part = free_name(solution_.system(), "f_" + name);
        if (oscillates) mean.groups.push_back(symbol_sum(part));
        define(section, name, std::move(mean));
        if (oscillates) define(section, part, std::move(oscillation));
    }

    const Solution& solution_;
    const Ring& ring_;
    const GradedField& field_;
    Substitutes substitutes_;
    std::string amplitude_, phase_;
};

} // namespace

Section slow_laws(const Solution& solution) {
    Section section;
    for (const SlowLaw& law : solution.slow) {
        const std::string& name = solution.system().variables[law.variable].name;
        const auto over_time = [&](const Polynomial& p) {
            return solution.ring->multiply(solution.ring->gen(solution.eps), p);
        };
        define(section, name,
               path_sum(*solution.ring, name, {over_time(law.path.drive), over_time(law.path.decline)}));
    }
    return section;
}

Page solution_page(const Solution& solution) {
    Page page;
    page.title = fmt::format("solution of {} through order {} (normal form and map through weight {})",
                             solution.system().name_with_settings(),
                             to_string(solution.system().weight(solution.order)),
                             to_string(solution.system().weight(solution.truncation)));
    if (solution.flow) {
        page.sections = flow_sections(solution, solution.flow->outputs);
        return page;
    }
    const SolutionPage parts(solution);
    append_sections(page, {slow_laws(solution), parts.amplitude_and_phase(), parts.drift(), parts.outputs()});
    return page;
}

void define_slow_time(Page& page, const Solution& solution) {
    if (solution.flow) return;
    const std::string name = slow_time_name(solution);
    bool used = false;
    for (const Section& section : page.sections)
        for (const Formula& formula : section.formulas)
            for (const DisplaySum& group : formula.right.groups) used = used || mentions(group, name);
    if (!used) return;
    if (!page.sections.front().heading.empty()) page.sections.insert(page.sections.begin(), Section{});
    define(page.sections.front(), name, slow_time_sum()); // T = eps*t
}

} // namespace resonform
