// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/build_plan.hpp"

#include "certify/flow.hpp"
#include "certify/hamiltonian.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

namespace {

void add_linear_part(CertificatePlan& plan, const GradedField& field) {
    CertificateProgram& p = plan.program;
    const Slot i = p.generator(Ring::imaginary_unit, 1);
    const auto check = [&](SeriesName rate, Slot lead, int weight, std::string sentence) {
        plan.checks.push_back(
            {p.difference(p.value(rate, Side::itself), lead), weight, false, 0, std::move(sentence)});
    };
    for (std::size_t k = 0; k < field.modes.size(); ++k) {
        const Mode& m = field.modes[k];
        plan.growth.push_back(p.value(m.growth));
        plan.omega.push_back(p.value(m.omega));
        const Slot lambda = p.add(plan.growth.back(), p.multiply(i, plan.omega.back()));
        Slot lead = p.multiply(lambda, p.generator(m.z, 1));
        for (const ModeCoupling& c : field.couplings(k))
            lead = p.add(lead, p.multiply(p.number(c.factor), p.generator(field.modes[c.mode].z, 1)));
        check({SeriesName::mode_rate, k}, lead, field.ring->generator(m.z).weight,
              fmt::format("the linear part of {}' is not lambda*{}{}", m.name, m.name,
                          field.couplings(k).empty() ? "" : " with its couplings"));
    }
    for (std::size_t k = 0; k < field.angles.size(); ++k) {
        plan.angle.push_back(p.value(field.angles[k].frequency));
        check({SeriesName::angle_rate, k}, plan.angle.back(), 0,
              fmt::format("{}' does not begin with its frequency", field.angles[k].name));
    }
}

// Adds the residuals of the equations, and psi' along the normal form minus d/dt psi.
void add_residuals(CertificatePlan& plan, const System& system, const Jets& jets, CertificateRoots& roots) {
    const auto substituted = [&](const GiNaC::ex& e, const Equation& equation) {
        return substitute(plan.program, roots, jets.values, equation, e);
    };
    for (const auto& [variable, defect] : jets.velocity_defects) {
        const std::string& name = system.variables[variable].name;
        plan.checks.push_back(
            {defect, 0, true, 0, fmt::format("d/dt of {} along the normal form is not {}'", name, name)});
    }
    for (const Equation& equation : system.equations) {
        plan.checks.push_back(
            {substituted(equation.residual, equation), 0, true, 0,
             fmt::format("the residual of the equation of {} is not zero", equation.variable)});
        plan.jacobian.emplace_back();
        for (const Variable& v : system.variables)
            plan.jacobian.back().push_back(
                substituted(equation.residual.diff(v.jet[static_cast<std::size_t>(v.order)]), equation));
    }
}

std::vector<bool> needed_slots(const CertificatePlan& plan) {
    std::vector<Slot> results;
    for (const VanishingCheck& check : plan.checks) results.push_back(check.slot);
    for (const auto& row : plan.jacobian) results.insert(results.end(), row.begin(), row.end());
    for (const auto* list : {&plan.growth, &plan.omega, &plan.angle})
        results.insert(results.end(), list->begin(), list->end());
    for (const CertificatePlan::Coordinate& c : plan.coordinates) results.push_back(c.mapped);
    for (const auto& [id, slope] : plan.unknown) results.push_back(slope);
    return plan.program.needed(results);
}

std::vector<CertificatePlan::Reading> readings_of(const CertificatePlan& plan) {
    std::vector<CertificatePlan::Reading> readings;
    const std::vector<Instruction>& steps = plan.program.steps();
    for (std::size_t k = 0; k < steps.size(); ++k) {
        const Instruction& step = steps[k];
        const bool slope = step.operation == Operation::slope;
        if (!plan.needed[k] || (!slope && step.operation != Operation::value)) continue;
        auto reading = std::find_if(readings.begin(), readings.end(),
                                    [&](const auto& r) { return r.series == step.series; });
        if (reading == readings.end()) reading = readings.insert(readings.end(), {step.series, {}});
        auto& sides = reading->sides;
        auto of_side =
            std::find_if(sides.begin(), sides.end(), [&](const auto& s) { return s.side == step.side; });
        if (of_side == sides.end()) of_side = sides.insert(sides.end(), {step.side, -1, {}});
        if (slope)
            of_side->slopes.emplace_back(step.index, static_cast<Slot>(k));
        else
            of_side->value = static_cast<Slot>(k);
    }
    return readings;
}

} // namespace

void settle_readings(CertificatePlan& plan) {
    plan.needed = needed_slots(plan);
    plan.readings = readings_of(plan);
}

CertificatePlan plan_certificate(const GradedField& field, const HamiltonianForm* hamiltonian) {
    CertificatePlan plan;
    CertificateRoots roots(field);
    const Jets jets = jets_along(plan.program, roots, field);
    add_linear_part(plan, field);
    add_residuals(plan, field.system(), jets, roots);
    if (hamiltonian != nullptr) add_canonical_checks(plan, field, *hamiltonian, jets, roots);
    plan.unknown = jets.unknown;
    settle_readings(plan);
    return plan;
}

CertificatePlan plan_frequencies(const GradedField& field) {
    CertificatePlan plan;
    for (const Mode& m : field.modes) {
        plan.growth.push_back(plan.program.value(m.growth));
        plan.omega.push_back(plan.program.value(m.omega));
    }
    for (const AngleVariable& a : field.angles) plan.angle.push_back(plan.program.value(a.frequency));
    settle_readings(plan);
    return plan;
}

} // namespace resonform
