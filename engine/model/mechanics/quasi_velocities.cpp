// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mechanics/quasi_velocities.hpp"

#include "algebra/number/error.hpp"
#include "model/exact/solution.hpp"
#include "model/exact/substitution.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"

namespace resonform {

namespace {

using GiNaC::ex;

class Transition {
public:
    Transition(const Motion& motion, const SolvedConstraints& constraints, const AppellEquations& appell)
        : motion_(motion), form_(motion.form()), constraints_(constraints), appell_(appell),
          all_(motion.mechanism().quasi_velocities) {
        require_number();
        for (const QuasiVelocity& u : all_) forms_.push_back(put(u.form.value, constraints.velocities));
        solve_for_velocities();
    }

    QuasiEquations run() {
        find_equations();
        solve_for_accelerations();
        check_by_coordinates();
        return std::move(result_);
    }

private:
    [[nodiscard]] const Coordinate& independent(std::size_t i) const {
        return motion_.mechanism().coordinates[constraints_.independent[i]];
    }
    [[nodiscard]] Place place() const { return place_of(all_.front().form.source); }
    void require_number() const;
    [[nodiscard]] ExactRow row_of(std::size_t k) const;
    void require_independent(const std::vector<ExactRow>& rows) const;
    void solve_for_velocities();
    void find_equations();
    void solve_for_accelerations();
    void check_by_coordinates() const;
    void require_zero(std::size_t k, const ex& difference) const;
    [[nodiscard]] ex in_quasi_velocities(const ex& e) const {
        return form_.simplified(put(put(e, constraints_.velocities), result_.velocities));
    }

    const Motion& motion_;
    ExactForm& form_;
    const SolvedConstraints& constraints_;
    const AppellEquations& appell_;
    const std::vector<QuasiVelocity>& all_;
    std::vector<ex> forms_; // in independent velocities
    QuasiEquations result_;
};

void Transition::require_number() const {
    const std::size_t freedom = constraints_.independent.size();
    if (all_.size() == freedom) return;
    bad_input({"the mechanism has neither as many quasi-velocities as degrees of freedom nor none",
               std::to_string(all_.size()) + " quasi-velocities, " + std::to_string(freedom) +
                   " degrees of freedom",
               "name velocities of coordinates, too, as in w = \"theta'\"", place()});
}

// sum of A_ki x_i' = u_k - a_k
ExactRow Transition::row_of(std::size_t k) const {
    ExactRow row;
    ex rest = forms_[k];
    for (std::size_t i = 0; i < constraints_.independent.size(); ++i) {
        const ex slope = form_.simplified(forms_[k].diff(independent(i).velocity));
        for (std::size_t other = 0; other < constraints_.independent.size(); ++other)
            if (slope.has(independent(other).velocity))
                bad_input({"the quasi-velocity is neither linear nor affine in the velocities",
                           excerpt(all_[k].form.text), "write it as a*x' + b*y' with a, b free of velocities",
                           place_of(all_[k].form.source)});
        row.push_back(slope);
        rest = rest.subs(independent(i).velocity == 0);
    }
    row.push_back(all_[k].velocity - form_.simplified(rest));
    return row;
}

void Transition::require_independent(const std::vector<ExactRow>& rows) const {
    GiNaC::matrix slopes(static_cast<unsigned>(rows.size()), static_cast<unsigned>(rows.size()));
    for (unsigned r = 0; r < slopes.rows(); ++r)
        for (unsigned c = 0; c < slopes.cols(); ++c) slopes(r, c) = rows[r][c];
    const Zero zero = form_.vanishes(slopes.determinant());
    if (zero == Zero::yes)
        bad_input({"quasi-velocities are independent of each other and of the constraints",
                   "the determinant of their coefficients is zero", "replace one of them", place()});
    if (zero == Zero::unknown)
        refuse(Reason::undecided,
               {"quasi-velocities are seen to be independent of each other and of the constraints",
                "the determinant of their coefficients can be told neither zero nor nonzero",
                "write them in a plainer form", place()});
}

void Transition::solve_for_velocities() {
    std::vector<ExactRow> rows;
    for (std::size_t k = 0; k < all_.size(); ++k) rows.push_back(row_of(k));
    require_independent(rows);
    const std::vector<ex> solution = solve_exactly(std::move(rows), form_, place());
    for (std::size_t i = 0; i < solution.size(); ++i)
        result_.velocities[independent(i).velocity] = solution[i];
    GiNaC::exmap dependent;
    for (const auto& [velocity, value] : constraints_.velocities)
        dependent[velocity] = form_.simplified(put(value, result_.velocities));
    result_.velocities.insert(dependent.begin(), dependent.end());
}

// x'' of the independent coordinates by u', put into S; the force on u_k is sum of Q_i dx_i'/du_k.
void Transition::find_equations() {
    GiNaC::exmap accelerations;
    std::vector<ex> forces;
    for (std::size_t i = 0; i < constraints_.independent.size(); ++i) {
        const Coordinate& c = independent(i);
        accelerations[c.acceleration] =
            in_quasi_velocities(motion_.derivative(result_.velocities.at(c.velocity)));
        forces.push_back(appell_.constrained.diff(c.acceleration) - appell_.equations[i]);
    }
    result_.energy = in_quasi_velocities(put(appell_.constrained, accelerations));
    for (const QuasiVelocity& u : all_) {
        ex force = 0;
        for (std::size_t i = 0; i < forces.size(); ++i)
            force += forces[i] * result_.velocities.at(independent(i).velocity).diff(u.velocity);
        result_.equations.push_back(
            form_.simplified(result_.energy.diff(u.acceleration) - in_quasi_velocities(force)));
    }
}

void Transition::solve_for_accelerations() {
    GiNaC::exmap none;
    for (const QuasiVelocity& u : all_) none[u.acceleration] = 0;
    std::vector<ExactRow> rows;
    for (const ex& equation : result_.equations) {
        ExactRow row;
        for (const QuasiVelocity& u : all_) row.push_back(form_.simplified(equation.diff(u.acceleration)));
        row.push_back(-put(equation, none));
        rows.push_back(std::move(row));
    }
    result_.accelerations = solve_if_short(std::move(rows), form_, place());
}

// Checks that the equations in coordinates, along dx_i'/du_k, are those in quasi-velocities, and that the u'
// solved for satisfy them.
void Transition::check_by_coordinates() const {
    GiNaC::exmap accelerations;
    for (const std::size_t i : constraints_.independent) {
        const Coordinate& c = motion_.mechanism().coordinates[i];
        accelerations[c.acceleration] = motion_.derivative(result_.velocities.at(c.velocity));
    }
    GiNaC::exmap solved;
    for (std::size_t k = 0; k < result_.accelerations.size(); ++k)
        solved[all_[k].acceleration] = result_.accelerations[k];
    for (std::size_t k = 0; k < all_.size(); ++k) {
        ex other = 0;
        for (std::size_t i = 0; i < constraints_.independent.size(); ++i)
            other += put(appell_.equations[i], accelerations) *
                     result_.velocities.at(independent(i).velocity).diff(all_[k].velocity);
        require_zero(k, put(put(other, constraints_.velocities), result_.velocities) - result_.equations[k]);
        if (!solved.empty()) require_zero(k, put(result_.equations[k], solved));
    }
}

void Transition::require_zero(std::size_t k, const ex& difference) const {
    const Zero zero = form_.vanishes(difference);
    if (zero == Zero::yes) return;
    refuse(Reason::undecided,
           {"the equations in quasi-velocities and those in coordinates agree",
            all_[k].name + (zero == Zero::no ? "' differs" : "' is not seen to be the same"),
            zero == Zero::no ? "report this: one of the two routes is wrong"
                             : "write the mechanism in a plainer form",
            place_of(all_[k].form.source)});
}

} // namespace

QuasiEquations quasi_equations(const Motion& motion, const SolvedConstraints& constraints,
                               const AppellEquations& appell) {
    return Transition(motion, constraints, appell).run();
}

} // namespace resonform
