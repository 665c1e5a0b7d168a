// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mechanics/constraints.hpp"

#include "algebra/number/error.hpp"
#include "model/exact/solution.hpp"
#include "model/exact/written_form.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"

#include <algorithm>
#include <optional>

namespace resonform {

namespace {

using GiNaC::ex;

struct ConstraintRow {
    const Constraint* constraint;
    ExactRow entries; // coefficients of the velocities, then the term without them
    std::optional<std::size_t> pivot;
};

class Elimination {
public:
    explicit Elimination(const Motion& motion)
        : motion_(motion), coordinates_(motion.mechanism().coordinates) {
        for (const bool late : {false, true})
            for (std::size_t i = 0; i < coordinates_.size(); ++i)
                if (stays_if_possible(i) == late) candidates_.push_back(i);
    }

    SolvedConstraints solve() {
        const auto& constraints = motion_.mechanism().constraints;
        if (!constraints.empty() && constraints.size() >= coordinates_.size())
            bad_input({"the mechanism has as many constraints as coordinates, or more",
                       std::to_string(constraints.size()) + " constraints, " +
                           std::to_string(coordinates_.size()) + " coordinates",
                       "leave out constraints, or prescribe coordinates",
                       place_of(constraints.back().condition.source)});
        for (const Constraint& constraint : constraints) {
            rows_.push_back(row_of(constraint));
            reduce(rows_.back());
            rows_.back().pivot = pivot_of(rows_.back());
            normalise(rows_.back());
        }
        return solved();
    }

private:
    // Fast variables, angles, and coordinates that new variables replace.
    [[nodiscard]] bool stays_if_possible(std::size_t coordinate) const {
        const Mechanism& mechanism = motion_.mechanism();
        if (const Variable* v = motion_.system().variable(coordinates_[coordinate].name))
            return v->role == Role::fast || v->role == Role::angle;
        for (const Change& change : mechanism.changes)
            for (const Coordinate& fresh : mechanism.fresh)
                if (change.coordinate == coordinate && change.value.value.has(fresh.at)) return true;
        return false;
    }

    ConstraintRow row_of(const Constraint& constraint) const;
    ex nonlinear_term(const Constraint& constraint) const;
    void require_velocity(const ConstraintRow& row) const;
    void reduce(ConstraintRow& row) const;
    std::size_t pivot_of(const ConstraintRow& row) const;
    void normalise(ConstraintRow& row);
    SolvedConstraints solved() const;
    void subtract(ConstraintRow& from, const ConstraintRow& row) const;

    const Motion& motion_;
    const std::vector<Coordinate>& coordinates_;
    std::vector<std::size_t> candidates_;
    std::vector<ConstraintRow> rows_;
};

ConstraintRow Elimination::row_of(const Constraint& constraint) const {
    ConstraintRow row{&constraint, {}, std::nullopt};
    ex rest = constraint.condition.value.expand();
    for (const Coordinate& c : coordinates_) {
        const ex slope = motion_.form().simplified(constraint.condition.value.diff(c.velocity));
        for (const Coordinate& other : coordinates_)
            if (slope.has(other.velocity))
                refuse({"the constraint is neither linear nor affine in the velocities",
                        excerpt(spell(nonlinear_term(constraint))),
                        "write constraints a*x' + b*y' + c = 0, with a, b, c free of velocities",
                        place_of(constraint.condition.source)});
        row.entries.push_back(slope);
        rest = rest.subs(c.velocity == 0);
    }
    row.entries.push_back(motion_.form().simplified(rest));
    require_velocity(row);
    return row;
}

// The first addend that is not linear in the velocities; the whole condition, if no addend is to blame.
ex Elimination::nonlinear_term(const Constraint& constraint) const {
    ex condition = constraint.condition.value.expand();
    const auto is_linear = [&](const ex& e) {
        for (const Coordinate& c : coordinates_)
            for (const Coordinate& other : coordinates_)
                if (!e.diff(c.velocity).diff(other.velocity).is_zero()) return false;
        return true;
    };
    if (GiNaC::is_a<GiNaC::add>(condition))
        for (const ex& term : operands(condition))
            if (!is_linear(term)) return term;
    return condition;
}

void Elimination::require_velocity(const ConstraintRow& row) const {
    const bool none = std::all_of(coordinates_.begin(), coordinates_.end(), [&](const Coordinate& c) {
        return !row.constraint->condition.value.has(c.velocity);
    });
    if (none)
        bad_input({"the constraint holds no velocity", in_quotes(row.constraint->name) + " holds none",
                   "differentiate it: x = f(y) is x' = f'(y)*y', with the integral x - f(y)",
                   place_of(row.constraint->condition.source)});
}

void Elimination::subtract(ConstraintRow& from, const ConstraintRow& row) const {
    const ex factor = from.entries[*row.pivot];
    if (factor.is_zero()) return;
    for (std::size_t k = 0; k < from.entries.size(); ++k)
        from.entries[k] = motion_.form().simplified(from.entries[k] - factor * row.entries[k]);
}

void Elimination::reduce(ConstraintRow& row) const {
    for (const ConstraintRow& earlier : rows_)
        if (&earlier != &row) subtract(row, earlier);
}

std::size_t Elimination::pivot_of(const ConstraintRow& row) const {
    const Place place = place_of(row.constraint->condition.source);
    const std::string name = in_quotes(row.constraint->name);
    bool every_zero = true, zero_at_rest = true;
    for (const std::size_t i : candidates_) {
        const Zero at_rest = motion_.form().vanishes(motion_.unperturbed(row.entries[i]));
        if (at_rest == Zero::no) return i;
        zero_at_rest = zero_at_rest && at_rest == Zero::yes;
        every_zero = every_zero && motion_.form().vanishes(row.entries[i]) == Zero::yes;
    }
    if (every_zero && motion_.form().vanishes(row.entries.back()) != Zero::yes)
        bad_input({"constraints do not contradict each other", name + " contradicts those before it",
                   "correct it", place});
    if (every_zero)
        bad_input({"constraints are independent of each other", name + " follows from those before it",
                   "leave it out, or correct it", place});
    if (zero_at_rest)
        refuse({"constraints are independent at eps = 0", name + " holds no velocity there",
                "divide it by a power of eps", place});
    refuse(Reason::undecided, {"constraints are seen to be independent", name + " can be told neither",
                               "write it in a plainer form", place});
}

// Its pivot becomes 1, and 0 in the rows before.
void Elimination::normalise(ConstraintRow& row) {
    const ex divisor = row.entries[*row.pivot];
    for (ex& entry : row.entries) entry = motion_.form().simplified(entry / divisor);
    for (ConstraintRow& earlier : rows_)
        if (&earlier != &row) subtract(earlier, row);
}

SolvedConstraints Elimination::solved() const {
    SolvedConstraints result;
    for (const ConstraintRow& row : rows_) result.dependent.push_back(*row.pivot);
    for (std::size_t i = 0; i < coordinates_.size(); ++i)
        if (std::find(result.dependent.begin(), result.dependent.end(), i) == result.dependent.end())
            result.independent.push_back(i);
    for (const ConstraintRow& row : rows_) {
        std::vector<ex> slopes;
        ex velocity = -row.entries.back();
        for (const std::size_t i : result.independent) {
            slopes.push_back(-row.entries[i]);
            velocity -= row.entries[i] * coordinates_[i].velocity;
        }
        result.slope.push_back(std::move(slopes));
        result.rest.push_back(-row.entries.back());
        result.velocities[coordinates_[*row.pivot].velocity] = velocity;
    }
    return result;
}

} // namespace

SolvedConstraints solve_constraints(const Motion& motion) { return Elimination(motion).solve(); }

} // namespace resonform
