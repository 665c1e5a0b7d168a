// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mechanics/equations_of.hpp"

#include "algebra/number/error.hpp"
#include "model/exact/substitution.hpp"
#include "model/exact/written_form.hpp"
#include "model/mechanics/change_of_variables.hpp"
#include "model/mechanics/constraints.hpp"
#include "model/mechanics/derivation_lines.hpp"
#include "model/mechanics/frobenius.hpp"
#include "model/mechanics/gibbs_appell.hpp"
#include "model/mechanics/integrals.hpp"
#include "model/mechanics/multipliers.hpp"
#include "model/mechanics/quasi_velocities.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/zero_test.hpp"

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
        result_.derivation =
            derivation_of({motion_, constraints_, constants_, appell_, quasi_, texts_}, result_.constants);
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
    void write_first_order(const ChangeOfVariables& change);
    [[nodiscard]] ex rate_of_constant(std::size_t k, const ChangeOfVariables& change);
    [[nodiscard]] bool depends(const ex& e, const GiNaC::symbol& symbol);
    void write_constants(const ChangeOfVariables& change);
    void derived(const std::string& variable, const std::string& text);

    const Mechanism& mechanism_;
    const System& system_;
    ExactForm form_;
    Motion motion_;
    SolvedConstraints constraints_;
    std::vector<Constant> constants_;
    AppellEquations appell_;
    std::optional<QuasiEquations> quasi_;
    bool first_order_ = false; // quasi-velocities are variables of the system
    EquationTexts texts_{system_, form_, place_of(mechanism_.source)};
    MechanicalEquations result_;
};

// Converts each expression of the file, so that errors name its place. Later errors name [coordinates].
void Deriver::look_at_parts() {
    ExactForm trial = form_;
    for (const Written& part : mechanism_.parts) {
        trial.set_place(place_of(part.source));
        trial.fraction(part.value);
    }
    form_.set_place(place_of(mechanism_.source));
}

// Refuses a dependent velocity with a pole at the origin if the equations or the rate of a constant have a
// pole there, too.
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
        refuse({"the rank of the constraints falls at the origin, where the equations are expanded",
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
        bad_input({"the matrix of the accelerations is singular where the equations are expanded",
                   "its determinant is zero there", "choose other coordinates, or another point by [change]",
                   place});
    if (zero == Zero::unknown)
        refuse(Reason::undecided,
               {"the matrix of the accelerations is seen to be regular where the equations are expanded",
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

void Deriver::write_independent(const ChangeOfVariables& change) {
    std::vector<ex> residuals;
    std::vector<GiNaC::symbol> unknowns;
    for (std::size_t i = 0; i < appell_.equations.size(); ++i) {
        residuals.push_back(change(appell_.equations[i]));
        unknowns.push_back(change.variable(i).acceleration);
    }
    const std::vector<std::string> texts = texts_.of(residuals, unknowns);
    for (std::size_t i = 0; i < texts.size(); ++i) derived(change.variable(i).name, texts[i]);
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
                    : written(form_, texts_.without_content(form_.simplified(change(old.velocity) - rate))) +
                          " = 0");
    }
    for (std::size_t k = 0; k < quasi_->equations.size(); ++k) {
        const std::string& name = mechanism_.quasi_velocities[k].name;
        derived(name,
                quasi_->accelerations.empty()
                    ? written(form_, texts_.without_content(form_.simplified(change(quasi_->equations[k])))) +
                          " = 0"
                    : name + "' = " + written(form_, form_.simplified(change(quasi_->accelerations[k]))));
    }
}

// The rate of the k-th constant, in velocities of variables or in quasi-velocities.
ex Deriver::rate_of_constant(std::size_t k, const ChangeOfVariables& change) {
    if (!first_order_) return change.rate(k);
    const ex rate = put(motion_.derivative(constants_[k].integral), constraints_.velocities);
    return form_.simplified(change(put(rate, quasi_->velocities)));
}

// Whether e depends on the symbol: it may also cancel.
bool Deriver::depends(const ex& e, const GiNaC::symbol& symbol) {
    if (!e.has(symbol)) return false;
    const ex slope = e.diff(symbol);
    return differs_from_zero(slope) || form_.vanishes(slope) != Zero::yes;
}

void Deriver::write_constants(const ChangeOfVariables& change) {
    std::vector<ex> others, rates; // expressions that may depend on a constant
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

} // namespace

MechanicalEquations equations_of(const Mechanism& mechanism, const System& system) {
    return Deriver(mechanism, system).run();
}

} // namespace resonform
