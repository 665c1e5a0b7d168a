// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mechanics/derivation_lines.hpp"

#include "model/exact/written_form.hpp"
#include "model/mechanics/frobenius.hpp"

#include <algorithm>

namespace resonform {

namespace {

using GiNaC::ex;

class DerivationLines {
public:
    DerivationLines(const MechanicalSteps& steps, const std::vector<MechanicalEquations::Former>& formers)
        : steps_(steps), formers_(formers), form_(steps.motion.form()) {}

    Derivation run() {
        write_constraints();
        write_accelerations();
        return std::move(result_);
    }

private:
    [[nodiscard]] const Mechanism& mechanism() const { return steps_.motion.mechanism(); }
    [[nodiscard]] const Coordinate& independent(std::size_t i) const {
        return mechanism().coordinates[steps_.constraints.independent[i]];
    }
    [[nodiscard]] const Coordinate& dependent(std::size_t d) const {
        return mechanism().coordinates[steps_.constraints.dependent[d]];
    }
    // The prescribed motions at eps = 0.
    [[nodiscard]] std::string unperturbed_motion();
    void write_constraints();
    void write_coefficients(DerivationSection& section, const Constant& constant);
    void write_change();
    void write_accelerations();
    void write_equations();
    void write_quasi_velocities();
    void print(const std::vector<DerivationSection>& sections);

    const MechanicalSteps& steps_;
    const std::vector<MechanicalEquations::Former>& formers_;
    ExactForm& form_;
    Derivation result_;
};

// q' = eps*(sum of c_q_x x' + c_q_0), in the coordinates before a change
void DerivationLines::write_coefficients(DerivationSection& section, const Constant& constant) {
    GiNaC::exmap values, none;
    for (const Constant& other : steps_.constants)
        if (!other.itself) values[dependent(other.dependent).at] = other.value;
    for (std::size_t i = 0; i < steps_.constraints.independent.size(); ++i) none[independent(i).velocity] = 0;
    const ex rate =
        steps_.motion.with_laws(steps_.motion.derivative(constant.integral)
                                    .subs(steps_.constraints.velocities, GiNaC::subs_options::no_pattern)
                                    .subs(values, GiNaC::subs_options::no_pattern));
    const auto add = [&](const std::string& name, const ex& part) {
        if (form_.vanishes(part) != Zero::yes)
            section.equations.push_back("c_" + constant.coordinate.name + "_" + name + " = " +
                                        written(form_, part / steps_.motion.system().eps));
    };
    for (std::size_t i = 0; i < steps_.constraints.independent.size(); ++i)
        add(independent(i).name, rate.diff(independent(i).velocity));
    add("0", rate.subs(none, GiNaC::subs_options::no_pattern));
}

std::string DerivationLines::unperturbed_motion() {
    std::string laws;
    for (const Prescribed* p : steps_.motion.moving())
        laws += (laws.empty() ? "with " : ", ") + p->coordinate.name +
                "' = " + written(form_, steps_.motion.unperturbed(p->rate));
    return laws.empty() ? "what is prescribed at rest" : laws;
}

void DerivationLines::write_constraints() {
    if (steps_.constants.empty()) {
        result_.remarks.push_back("no constraints: every coordinate is independent");
        write_change();
        return;
    }
    DerivationSection solved{"constraints", {}}, rest{"at eps = 0, " + unperturbed_motion(), {}},
        integrals{"constants of these", {}},
        coefficients{"(2): q' = eps*(sum of c_q_x*x' + c_q_0), with", {}};
    for (const Constant& constant : steps_.constants) {
        const Coordinate& d = dependent(constant.dependent);
        const ex velocity = steps_.constraints.velocities.at(d.velocity);
        solved.equations.push_back(d.name + "' = " + written(form_, velocity));
        rest.equations.push_back(d.name + "' = " + written(form_, steps_.motion.unperturbed(velocity)));
        if (!constant.itself)
            integrals.equations.push_back(constant.coordinate.name + " = " +
                                          written(form_, constant.integral));
        write_coefficients(coefficients, constant);
    }
    result_.constraints = {solved, rest};
    if (!integrals.equations.empty()) result_.constraints.push_back(integrals);
    write_change();
    if (!coefficients.equations.empty()) result_.constraints.push_back(coefficients);
    result_.remarks.push_back(integrable_for_every_eps(steps_.constraints, steps_.motion)
                                  ? "holonomic after all: the constraints are integrable for every eps"
                                  : "weakly nonholonomic: the constraints are integrable at eps = 0");
    for (const MechanicalEquations::Former& former : formers_)
        result_.remarks.push_back(former.coordinate.name +
                                  (former.fixed                ? " is constant for every eps: a parameter"
                                   : former.role == Role::slow ? " is slow: something depends on it"
                                                               : " is a drift: nothing depends on it"));
}

// (14), and dependent coordinates by their constants.
void DerivationLines::write_change() {
    DerivationSection section{"change of variables", {}};
    for (const Change& change : mechanism().changes)
        section.equations.push_back(mechanism().coordinates[change.coordinate].name + " = " +
                                    change.value.text);
    for (const Constant& constant : steps_.constants) {
        const std::size_t coordinate = steps_.constraints.dependent[constant.dependent];
        const bool told = std::any_of(mechanism().changes.begin(), mechanism().changes.end(),
                                      [&](const Change& c) { return c.coordinate == coordinate; });
        if (!constant.itself && !told)
            section.equations.push_back(dependent(constant.dependent).name + " = " +
                                        written(form_, constant.value));
    }
    if (!section.equations.empty()) result_.constraints.push_back(section);
}

void DerivationLines::write_accelerations() {
    std::vector<DerivationSection>& sections = result_.accelerations;
    sections.push_back({"energy of accelerations", {"S = " + written(form_, steps_.appell.energy)}});
    if (!steps_.constants.empty()) {
        DerivationSection differentiated{"the constraints, differentiated", {}};
        for (std::size_t d = 0; d < steps_.constraints.dependent.size(); ++d)
            differentiated.equations.push_back(
                dependent(d).name +
                "'' = " + written(form_, steps_.appell.differentiated.at(dependent(d).acceleration)));
        sections.push_back(std::move(differentiated));
        sections.push_back({"energy of accelerations with the constraints",
                            {"S = " + written(form_, steps_.appell.constrained)}});
    }
    if (steps_.quasi)
        write_quasi_velocities();
    else
        write_equations();
    result_.agreement.push_back(
        steps_.constants.empty()
            ? "the equations of Lagrange agree, identically"
            : "the equations of d'Alembert and Lagrange with multipliers agree, identically");
}

void DerivationLines::write_equations() {
    DerivationSection equations{"equations of Gibbs and Appell", {}}, solved{"accelerations", {}};
    for (const ex& equation : steps_.appell.equations)
        equations.equations.push_back(written(form_, steps_.texts.without_content(equation)) + " = 0");
    for (const ex& acceleration : steps_.appell.accelerations)
        solved.equations.push_back(independent(solved.equations.size()).name +
                                   "'' = " + written(form_, acceleration));
    print({equations, solved});
}

void DerivationLines::write_quasi_velocities() {
    DerivationSection definitions{"quasi-velocities", {}}, velocities{"velocities in these", {}},
        energy{"energy of accelerations in these", {"S = " + written(form_, steps_.quasi->energy)}},
        equations{"equations of Gibbs and Appell", {}}, solved{"accelerations", {}};
    for (const Coordinate& c : mechanism().coordinates)
        velocities.equations.push_back(c.name +
                                       "' = " + written(form_, steps_.quasi->velocities.at(c.velocity)));
    for (std::size_t k = 0; k < steps_.quasi->equations.size(); ++k) {
        const QuasiVelocity& u = mechanism().quasi_velocities[k];
        definitions.equations.push_back(u.name + " = " + written(form_, u.form.value));
        equations.equations.push_back(
            written(form_, steps_.texts.without_content(steps_.quasi->equations[k])) + " = 0");
        if (!steps_.quasi->accelerations.empty())
            solved.equations.push_back(u.name + "' = " + written(form_, steps_.quasi->accelerations[k]));
    }
    print({definitions, velocities, energy, equations, solved});
}

// Prints the sections that are not empty; the last one is empty if it would be too long.
void DerivationLines::print(const std::vector<DerivationSection>& sections) {
    for (const DerivationSection& section : sections)
        if (!section.equations.empty()) result_.accelerations.push_back(section);
    if (sections.back().equations.empty())
        result_.agreement.push_back(
            "the accelerations are not written: solved, the equations are longer than a text may be");
}

} // namespace

Derivation derivation_of(const MechanicalSteps& steps,
                         const std::vector<MechanicalEquations::Former>& formers) {
    return DerivationLines(steps, formers).run();
}

} // namespace resonform
