// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mechanical_equations.hpp"

#include "model/canonical.hpp"
#include "model/change_of_variables.hpp"
#include "model/exact_solution.hpp"
#include "model/expression.hpp"
#include "model/frobenius.hpp"
#include "model/gibbs_appell.hpp"
#include "model/growth.hpp"
#include "model/multipliers.hpp"
#include "model/quasi_velocities.hpp"
#include "model/substitution.hpp"
#include "model/written_form.hpp"
#include "model/zero_test.hpp"

#include <algorithm>

namespace resonform {

namespace {

using GiNaC::ex;

class Deriver {
public:
    Deriver(const Mechanism& mechanism, const System& system)
        : mechanism_(mechanism), system_(system), form_(system), motion_(mechanism, system, form_) {
        look_at_parts();
        constraints_ = solve_constraints(motion_);
        require_integrable_unperturbed(constraints_, motion_);
        constants_ = find_constants(constraints_, motion_);
        appell_ = appell_equations(motion_, constraints_);
        check_by_multipliers(mechanism_, form_, constraints_, appell_);
        if (!mechanism_.quasi_velocities.empty()) quasi_ = quasi_equations(motion_, constraints_, appell_);
        first_order_ = quasi_velocities_are_variables();
    }

    MechanicalEquations run() {
        const ChangeOfVariables change(motion_, constraints_, constants_);
        require_rank(change);
        require_regular(change);
        write_prescribed();
        if (first_order_)
            write_first_order(change);
        else
            write_independent(change);
        write_constants(change);
        write_constraints();
        write_accelerations();
        return std::move(result_);
    }

private:
    [[nodiscard]] const Coordinate& independent(std::size_t i) const {
        return mechanism_.coordinates[constraints_.independent[i]];
    }
    [[nodiscard]] const Coordinate& dependent(std::size_t d) const {
        return mechanism_.coordinates[constraints_.dependent[d]];
    }
    void look_at_parts();
    void require_rank(const ChangeOfVariables& change);
    void require_regular(const ChangeOfVariables& change);
    void write_prescribed();
    [[nodiscard]] bool quasi_velocities_are_variables() const;
    void write_independent(const ChangeOfVariables& change);
    std::vector<std::string> texts_of(const std::vector<ex>& residuals,
                                      const std::vector<Coordinate>& unknowns);
    std::vector<std::string> texts_of_exact(std::vector<ex> residuals,
                                            const std::vector<Coordinate>& unknowns);
    std::vector<std::string> solved_texts(const std::vector<ExactRow>& rows,
                                          const std::vector<Coordinate>& unknowns);
    void write_first_order(const ChangeOfVariables& change);
    [[nodiscard]] ex rate_of_constant(std::size_t k, const ChangeOfVariables& change);
    [[nodiscard]] bool depends(const ex& e, const GiNaC::symbol& symbol);
    void write_constants(const ChangeOfVariables& change);
    // What is prescribed, at eps = 0.
    [[nodiscard]] std::string unperturbed_motion();
    void write_constraints();
    void write_coefficients(DerivationSection& section, const Constant& constant);
    void write_change();
    void write_accelerations();
    void write_equations();
    void write_quasi_velocities();
    void print(const std::vector<DerivationSection>& sections);
    void derived(const std::string& variable, const std::string& text);
    [[nodiscard]] ex without_content(const ex& residual);
    // Linear equations in accelerations: the coefficients, and minus the rest.
    std::vector<ExactRow> rows_of(const std::vector<ex>& residuals, const std::vector<Coordinate>& unknowns);

    const Mechanism& mechanism_;
    const System& system_;
    ExactForm form_;
    Motion motion_;
    SolvedConstraints constraints_;
    std::vector<Constant> constants_;
    AppellEquations appell_;
    std::optional<QuasiEquations> quasi_;
    bool first_order_ = false; // quasi-velocities are variables of the system
    MechanicalEquations result_;
};

// What has no exact form is found where it stands in the file; what comes of several, at [coordinates].
void Deriver::look_at_parts() {
    ExactForm trial = form_;
    for (const Written& part : mechanism_.parts) {
        trial.set_place(place_of(part.source));
        trial.fraction(part.value);
    }
    form_.set_place(place_of(mechanism_.source));
}

// Where a dependent velocity has a pole at the origin, and the equations or the rate of a constant have it,
// too.
void Deriver::require_rank(const ChangeOfVariables& change) {
    const auto has_pole = [&](const ex& e) {
        const ex denominator = form_.meaning(form_.fraction(e).denominator);
        return form_.vanishes(change.at_origin(denominator)) == Zero::yes;
    };
    bool matters = std::any_of(appell_.equations.begin(), appell_.equations.end(), has_pole);
    for (std::size_t k = 0; k < constants_.size(); ++k) matters = matters || has_pole(change.rate(k));
    if (!matters) return;
    for (std::size_t d = 0; d < constraints_.dependent.size(); ++d) {
        const ex velocity = constraints_.velocities.at(dependent(d).velocity);
        if (!has_pole(velocity)) continue;
        const Written& condition = mechanism_.constraints[d].condition;
        refuse({"the rank of the constraints does not fall at the origin, where the equations are expanded",
                excerpt(dependent(d).name + "' = " + written(form_, velocity)),
                "choose another origin by [change], or another constraint", place_of(condition.source)});
    }
}

void Deriver::require_regular(const ChangeOfVariables& change) {
    const std::size_t n = constraints_.independent.size();
    GiNaC::matrix masses(static_cast<unsigned>(n), static_cast<unsigned>(n));
    for (unsigned r = 0; r < n; ++r)
        for (unsigned c = 0; c < n; ++c)
            masses(r, c) = change.at_origin(appell_.equations[r].diff(independent(c).acceleration));
    const Zero zero = form_.vanishes(masses.determinant());
    const Place place = place_of(mechanism_.source);
    if (zero == Zero::yes)
        bad_input({"the matrix of the accelerations is regular where the equations are expanded",
                   "its determinant is zero there", "choose other coordinates, or another point by [change]",
                   place});
    if (zero == Zero::unknown)
        refuse({"the matrix of the accelerations is seen to be regular where the equations are expanded",
                "its determinant can be told neither zero nor nonzero", "choose other coordinates", place});
}

void Deriver::derived(const std::string& variable, const std::string& text) {
    SourceText source = mechanism_.source;
    source.verbatim = false; // the text stands in no file
    result_.equations.push_back({variable, text, source});
}

void Deriver::write_prescribed() {
    for (const Prescribed& p : mechanism_.prescribed)
        result_.equations.push_back({p.coordinate.name, p.law.text, p.law.source});
}

// Divided by a number and by what is declared not zero, multiplied by a denominator that moves.
ex Deriver::without_content(const ex& residual) {
    const ExactForm::Fraction f = form_.fraction(residual);
    if (f.numerator.is_zero()) return residual;
    const bool moves = std::any_of(form_.generators().begin(), form_.generators().end(), [&](const auto& g) {
        return g.kind <= ExactForm::Kind::rate && f.denominator.has(g.symbol);
    });
    if (moves) return without_content(form_.meaning(f.numerator));
    ex factor = f.denominator.integer_content() / f.numerator.integer_content();
    const auto divide_by = [&](const ex& symbol) {
        factor *= GiNaC::pow(symbol, f.denominator.ldegree(symbol) - f.numerator.ldegree(symbol));
    };
    divide_by(system_.eps);
    for (const Parameter& p : system_.parameters)
        if (p.nonzero) divide_by(p.symbol);
    for (const Variable& v : system_.variables)
        if (v.nonzero) divide_by(v.jet.front());
    return form_.simplified(residual * factor);
}

std::vector<ExactRow> Deriver::rows_of(const std::vector<ex>& residuals,
                                       const std::vector<Coordinate>& unknowns) {
    GiNaC::exmap none;
    for (const Coordinate& c : unknowns) none[c.acceleration] = 0;
    std::vector<ExactRow> rows;
    for (const ex& residual : residuals) {
        ExactRow row;
        for (const Coordinate& c : unknowns) row.push_back(form_.simplified(residual.diff(c.acceleration)));
        row.push_back(form_.simplified(-residual.subs(none, GiNaC::subs_options::no_pattern)));
        rows.push_back(std::move(row));
    }
    return rows;
}

// As they are where each holds its own acceleration only, else solved; those whose solution is longer than a
// text may be are solved by whoever reads them. What a change of variables would make too long when it is
// multiplied out stands as the change leaves it.
void Deriver::write_independent(const ChangeOfVariables& change) {
    std::vector<ex> residuals;
    std::vector<Coordinate> unknowns;
    for (std::size_t i = 0; i < appell_.equations.size(); ++i) {
        residuals.push_back(change(appell_.equations[i]));
        unknowns.push_back(change.variable(i));
    }
    const std::vector<std::string> texts = texts_of(residuals, unknowns);
    for (std::size_t i = 0; i < texts.size(); ++i) derived(unknowns[i].name, texts[i]);
}

std::vector<std::string> Deriver::texts_of(const std::vector<ex>& residuals,
                                           const std::vector<Coordinate>& unknowns) {
    constexpr double shortest_term = 10; // bytes
    double exact = 0, as_put_in = 0;
    for (const ex& residual : residuals) {
        exact = std::max(exact, terms_in_exact_form(residual));
        as_put_in = std::max(as_put_in, of_expression(residual).terms);
    }
    if (exact * shortest_term <= static_cast<double>(Limits{}.length) || as_put_in > Limits{}.terms)
        return texts_of_exact(residuals, unknowns);
    std::vector<std::string> texts;
    for (const ex& residual : residuals) texts.push_back(spell(residual) + " = 0");
    return texts;
}

std::vector<std::string> Deriver::texts_of_exact(std::vector<ex> residuals,
                                                 const std::vector<Coordinate>& unknowns) {
    for (ex& residual : residuals) residual = form_.simplified(residual);
    std::vector<std::string> texts = solved_texts(rows_of(residuals, unknowns), unknowns);
    if (texts.empty())
        for (const ex& residual : residuals)
            texts.push_back(written(form_, without_content(residual)) + " = 0");
    return texts;
}

// Nothing where they are not coupled, or too long.
std::vector<std::string> Deriver::solved_texts(const std::vector<ExactRow>& rows,
                                               const std::vector<Coordinate>& unknowns) {
    bool coupled = false;
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t k = 0; k < unknowns.size(); ++k)
            coupled = coupled || (i != k && form_.vanishes(rows[i][k]) != Zero::yes);
    if (!coupled) return {};
    std::vector<std::string> texts;
    for (const ex& solution : solve_if_short(rows, form_, place_of(mechanism_.source))) {
        texts.push_back(unknowns[texts.size()].name + "'' = " + written(form_, solution));
        if (texts.back().size() > Limits{}.length || of_expression(solution).terms > Limits{}.terms)
            return {};
    }
    return texts;
}

bool Deriver::quasi_velocities_are_variables() const {
    const auto& all = mechanism_.quasi_velocities;
    const auto is_variable = [&](const QuasiVelocity& u) { return system_.variable(u.name) != nullptr; };
    if (std::none_of(all.begin(), all.end(), is_variable)) return false;
    const auto missing = std::find_if_not(all.begin(), all.end(), is_variable);
    if (missing == all.end()) return true;
    bad_input({"all quasi-velocities are variables, or none", in_quotes(missing->name) + " is none",
               "declare it under [variables], too", missing->place});
}

// x' = sum of B_k u_k, u' = ...
void Deriver::write_first_order(const ChangeOfVariables& change) {
    for (std::size_t i = 0; i < constraints_.independent.size(); ++i) {
        const Coordinate &old = independent(i), &variable = change.variable(i);
        const ex rate = form_.simplified(change(quasi_->velocities.at(old.velocity)));
        derived(variable.name,
                variable.name == old.name
                    ? variable.name + "' = " + written(form_, rate)
                    : written(form_, without_content(form_.simplified(change(old.velocity) - rate))) +
                          " = 0");
    }
    for (std::size_t k = 0; k < quasi_->equations.size(); ++k) {
        const std::string& name = mechanism_.quasi_velocities[k].name;
        derived(name,
                quasi_->accelerations.empty()
                    ? written(form_, without_content(form_.simplified(change(quasi_->equations[k])))) + " = 0"
                    : name + "' = " + written(form_, form_.simplified(change(quasi_->accelerations[k]))));
    }
}

// In velocities of variables, or in quasi-velocities.
ex Deriver::rate_of_constant(std::size_t k, const ChangeOfVariables& change) {
    if (!first_order_) return change.rate(k);
    const ex rate = put(motion_.derivative(constants_[k].integral), constraints_.velocities);
    return form_.simplified(change(put(rate, quasi_->velocities)));
}

// Does a symbol in it not cancel?
bool Deriver::depends(const ex& e, const GiNaC::symbol& symbol) {
    if (!e.has(symbol)) return false;
    const ex slope = e.diff(symbol);
    return differs_from_zero(slope) || form_.vanishes(slope) != Zero::yes;
}

void Deriver::write_constants(const ChangeOfVariables& change) {
    std::vector<ex> others, rates; // what may depend on a constant
    for (const ex& equation : first_order_ ? quasi_->equations : appell_.equations)
        others.push_back(change(equation));
    if (first_order_)
        for (std::size_t i = 0; i < constraints_.independent.size(); ++i)
            others.push_back(change(quasi_->velocities.at(independent(i).velocity)));
    for (std::size_t k = 0; k < constants_.size(); ++k) rates.push_back(rate_of_constant(k, change));
    others.insert(others.end(), rates.begin(), rates.end());
    for (std::size_t k = 0; k < constants_.size(); ++k) {
        const Coordinate& c = constants_[k].coordinate;
        const bool slow =
            std::any_of(others.begin(), others.end(), [&](const ex& e) { return depends(e, c.at); });
        const bool fixed = slow && form_.vanishes(rates[k]) == Zero::yes;
        result_.constants.push_back(
            {c, dependent(constants_[k].dependent).name, slow ? Role::slow : Role::drift, fixed});
        if (!fixed) derived(c.name, c.name + "' = " + written(form_, rates[k]));
    }
}

// q' = eps*(sum of c_q_x x' + c_q_0), in the coordinates before a change
void Deriver::write_coefficients(DerivationSection& section, const Constant& constant) {
    GiNaC::exmap values, none;
    for (const Constant& other : constants_)
        if (!other.itself) values[dependent(other.dependent).at] = other.value;
    for (std::size_t i = 0; i < constraints_.independent.size(); ++i) none[independent(i).velocity] = 0;
    const ex rate = motion_.with_laws(motion_.derivative(constant.integral)
                                          .subs(constraints_.velocities, GiNaC::subs_options::no_pattern)
                                          .subs(values, GiNaC::subs_options::no_pattern));
    const auto add = [&](const std::string& name, const ex& part) {
        if (form_.vanishes(part) != Zero::yes)
            section.equations.push_back("c_" + constant.coordinate.name + "_" + name + " = " +
                                        written(form_, part / system_.eps));
    };
    for (std::size_t i = 0; i < constraints_.independent.size(); ++i)
        add(independent(i).name, rate.diff(independent(i).velocity));
    add("0", rate.subs(none, GiNaC::subs_options::no_pattern));
}

std::string Deriver::unperturbed_motion() {
    std::string laws;
    for (const Prescribed* p : motion_.moving())
        laws += (laws.empty() ? "with " : ", ") + p->coordinate.name +
                "' = " + written(form_, motion_.unperturbed(p->rate));
    return laws.empty() ? "what is prescribed at rest" : laws;
}

void Deriver::write_constraints() {
    Derivation& derivation = result_.derivation;
    if (constants_.empty()) {
        derivation.remarks.push_back("no constraints: every coordinate is independent");
        write_change();
        return;
    }
    DerivationSection solved{"constraints", {}}, rest{"at eps = 0, " + unperturbed_motion(), {}},
        integrals{"constants of these", {}},
        coefficients{"(2): q' = eps*(sum of c_q_x*x' + c_q_0), with", {}};
    for (const Constant& constant : constants_) {
        const Coordinate& d = dependent(constant.dependent);
        const ex velocity = constraints_.velocities[d.velocity];
        solved.equations.push_back(d.name + "' = " + written(form_, velocity));
        rest.equations.push_back(d.name + "' = " + written(form_, motion_.unperturbed(velocity)));
        if (!constant.itself)
            integrals.equations.push_back(constant.coordinate.name + " = " +
                                          written(form_, constant.integral));
        write_coefficients(coefficients, constant);
    }
    derivation.constraints = {solved, rest};
    if (!integrals.equations.empty()) derivation.constraints.push_back(integrals);
    write_change();
    if (!coefficients.equations.empty()) derivation.constraints.push_back(coefficients);
    derivation.remarks.push_back(integrable_for_every_eps(constraints_, motion_)
                                     ? "holonomic after all: the constraints are integrable for every eps"
                                     : "weakly nonholonomic: the constraints are integrable at eps = 0");
    for (const MechanicalEquations::Former& former : result_.constants)
        derivation.remarks.push_back(former.coordinate.name +
                                     (former.fixed                ? " is constant for every eps: a parameter"
                                      : former.role == Role::slow ? " is slow: something depends on it"
                                                                  : " is a drift: nothing depends on it"));
}

// (14), and dependent coordinates by their constants.
void Deriver::write_change() {
    DerivationSection section{"change of variables", {}};
    for (const Change& change : mechanism_.changes)
        section.equations.push_back(mechanism_.coordinates[change.coordinate].name + " = " +
                                    change.value.text);
    for (const Constant& constant : constants_) {
        const std::size_t coordinate = constraints_.dependent[constant.dependent];
        const bool told = std::any_of(mechanism_.changes.begin(), mechanism_.changes.end(),
                                      [&](const Change& c) { return c.coordinate == coordinate; });
        if (!constant.itself && !told)
            section.equations.push_back(dependent(constant.dependent).name + " = " +
                                        written(form_, constant.value));
    }
    if (!section.equations.empty()) result_.derivation.constraints.push_back(section);
}

void Deriver::write_accelerations() {
    std::vector<DerivationSection>& sections = result_.derivation.accelerations;
    sections.push_back({"energy of accelerations", {"S = " + written(form_, appell_.energy)}});
    if (!constants_.empty()) {
        DerivationSection differentiated{"the constraints, differentiated", {}};
        for (std::size_t d = 0; d < constraints_.dependent.size(); ++d)
            differentiated.equations.push_back(
                dependent(d).name +
                "'' = " + written(form_, appell_.differentiated[dependent(d).acceleration]));
        sections.push_back(std::move(differentiated));
        sections.push_back(
            {"energy of accelerations with the constraints", {"S = " + written(form_, appell_.constrained)}});
    }
    if (quasi_)
        write_quasi_velocities();
    else
        write_equations();
    result_.derivation.agreement.push_back(
        constants_.empty() ? "the equations of Lagrange agree, identically"
                           : "the equations of d'Alembert and Lagrange with multipliers agree, identically");
}

void Deriver::write_equations() {
    DerivationSection equations{"equations of Gibbs and Appell", {}}, solved{"accelerations", {}};
    for (const ex& equation : appell_.equations)
        equations.equations.push_back(written(form_, without_content(equation)) + " = 0");
    for (const ex& acceleration : appell_.accelerations)
        solved.equations.push_back(independent(solved.equations.size()).name +
                                   "'' = " + written(form_, acceleration));
    print({equations, solved});
}

void Deriver::write_quasi_velocities() {
    DerivationSection definitions{"quasi-velocities", {}}, velocities{"velocities in these", {}},
        energy{"energy of accelerations in these", {"S = " + written(form_, quasi_->energy)}},
        equations{"equations of Gibbs and Appell", {}}, solved{"accelerations", {}};
    for (const Coordinate& c : mechanism_.coordinates)
        velocities.equations.push_back(c.name + "' = " + written(form_, quasi_->velocities.at(c.velocity)));
    for (std::size_t k = 0; k < quasi_->equations.size(); ++k) {
        const QuasiVelocity& u = mechanism_.quasi_velocities[k];
        definitions.equations.push_back(u.name + " = " + written(form_, u.form.value));
        equations.equations.push_back(written(form_, without_content(quasi_->equations[k])) + " = 0");
        if (!quasi_->accelerations.empty())
            solved.equations.push_back(u.name + "' = " + written(form_, quasi_->accelerations[k]));
    }
    print({definitions, velocities, energy, equations, solved});
}

// The last section is empty where it is too long.
void Deriver::print(const std::vector<DerivationSection>& sections) {
    for (const DerivationSection& section : sections)
        if (!section.equations.empty()) result_.derivation.accelerations.push_back(section);
    if (sections.back().equations.empty())
        result_.derivation.agreement.push_back(
            "the accelerations are not written: solved, the equations are longer than a text may be");
}

} // namespace

MechanicalEquations equations_of(const Mechanism& mechanism, const System& system) {
    return Deriver(mechanism, system).run();
}

} // namespace resonform
