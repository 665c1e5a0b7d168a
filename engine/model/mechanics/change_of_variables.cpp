// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mechanics/change_of_variables.hpp"

#include "algebra/number/error.hpp"
#include "model/exact/invertible.hpp"
#include "model/exact/solution.hpp"
#include "model/exact/substitution.hpp"
#include "model/exact/written_form.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/regular.hpp"

#include <algorithm>

namespace resonform {

namespace {

using GiNaC::ex;

const Change* change_of(const Mechanism& mechanism, std::size_t coordinate) {
    for (const Change& change : mechanism.changes)
        if (change.coordinate == coordinate) return &change;
    return nullptr;
}

std::string names_of(const std::vector<Coordinate>& all) {
    std::string names;
    for (const Coordinate& c : all) names += (names.empty() ? "" : ", ") + c.name;
    return names.empty() ? "none" : names;
}

} // namespace

ChangeOfVariables::ChangeOfVariables(const Motion& motion, const SolvedConstraints& constraints,
                                     const std::vector<Constant>& constants)
    : motion_(motion), constraints_(constraints) {
    const auto& coordinates = motion.mechanism().coordinates;
    choose_variables();
    find_positions(constants);
    require_invertible();
    for (const Coordinate& c : coordinates) {
        const auto found = positions_.find(c.at);
        if (found == positions_.end()) continue;
        all_[c.at] = found->second;
        all_[c.velocity] = motion.derivative(found->second);
        all_[c.acceleration] = motion.derivative(all_[c.velocity]);
    }
    find_rates(constants);
}

// The value of a replaced coordinate may hold other replaced ones: they are put in until none is left.
void ChangeOfVariables::find_positions(const std::vector<Constant>& constants) {
    const auto& coordinates = motion_.mechanism().coordinates;
    GiNaC::exmap values;
    for (const std::size_t i : constraints_.independent)
        if (const Change* change = change_of(motion_.mechanism(), i))
            values[coordinates[i].at] = change->value.value;
    for (const Constant& constant : constants)
        if (!constant.itself)
            values[coordinates[constraints_.dependent[constant.dependent]].at] = constant.value;
    for (const Coordinate& c : coordinates) {
        if (values.count(c.at) == 0) continue;
        const auto value = put_through(c.at, values);
        if (!value) in_a_circle(values);
        positions_[c.at] = *value;
    }
}

void ChangeOfVariables::in_a_circle(const GiNaC::exmap& values) const {
    const auto holds_one = [&](const ex& e) {
        return std::any_of(values.begin(), values.end(), [&](const auto& v) { return e.has(v.first); });
    };
    const auto& changes = motion_.mechanism().changes;
    const auto change = std::find_if(changes.begin(), changes.end(),
                                     [&](const Change& c) { return holds_one(c.value.value); });
    std::string circle;
    for (const Coordinate& c : motion_.mechanism().coordinates)
        if (const auto found = values.find(c.at); found != values.end() && holds_one(found->second))
            circle += (circle.empty() ? "" : ", ") + c.name + " = " +
                      excerpt(written(motion_.form(), found->second));
    bad_input({"what a change of variables replaces a coordinate by does not depend on this coordinate",
               circle, "write it in new variables, constants of the constraints and coordinates that stay",
               place_of((change == changes.end() ? changes.front() : *change).value.source)});
}

void ChangeOfVariables::choose_variables() {
    const Mechanism& mechanism = motion_.mechanism();
    std::size_t used = 0, changed = 0;
    for (const std::size_t i : constraints_.independent) {
        const bool stays = change_of(mechanism, i) == nullptr;
        if (!stays) ++changed;
        if (stays)
            variables_.push_back(mechanism.coordinates[i]);
        else if (used < mechanism.fresh.size())
            variables_.push_back(mechanism.fresh[used++]);
    }
    if (changed == mechanism.fresh.size()) return;
    const Place place = mechanism.fresh.empty() ? place_of(mechanism.source) : mechanism.fresh.front().place;
    bad_input({"each variable of a mechanism is a coordinate, prescribed, an integral, a quasi-velocity, or "
               "new in [change], which "
               "has one new variable for each coordinate that it replaces",
               "new: " + names_of(mechanism.fresh) + "; coordinates replaced: " + std::to_string(changed),
               "correct the names, or write [change]", place});
}

void ChangeOfVariables::require_invertible() const {
    const auto& fresh = motion_.mechanism().fresh;
    const auto& coordinates = motion_.mechanism().coordinates;
    std::vector<ex> values;
    for (const std::size_t i : constraints_.independent)
        if (change_of(motion_.mechanism(), i) != nullptr) values.push_back(positions_.at(coordinates[i].at));
    if (values.empty()) return;
    std::vector<GiNaC::symbol> variables;
    for (const Coordinate& c : fresh) variables.push_back(c.at);
    resonform::require_invertible(at_origin(determinant_of_slopes(values, variables)), motion_.form(),
                                  motion_.system(),
                                  place_of(motion_.mechanism().changes.front().value.source));
}

// R' = F + sum of G R' where a change of variables holds constants: G is of order eps, as these rates are.
void ChangeOfVariables::find_rates(const std::vector<Constant>& constants) {
    GiNaC::exmap laws; // motions that go on at eps = 0 cancel only by their laws
    for (const Prescribed* p : motion_.moving()) laws[p->coordinate.velocity] = p->rate;
    std::vector<ExactRow> rows;
    bool coupled = false;
    for (const Constant& constant : constants) {
        const ex old = put(motion_.derivative(constant.integral), constraints_.velocities);
        ex rate = put(put(old, all_), laws);
        ExactRow row;
        for (const Constant& other : constants) {
            const GiNaC::symbol& velocity = other.coordinate.velocity;
            const ex part = motion_.form().simplified(rate.diff(velocity));
            coupled = coupled || !part.is_zero();
            row.push_back((&other == &constant ? 1 : 0) - part);
        }
        for (const Constant& other : constants) rate = rate.subs(other.coordinate.velocity == 0);
        row.push_back(motion_.form().simplified(rate));
        rows.push_back(std::move(row));
    }
    if (coupled)
        rates_ = solve_exactly(std::move(rows), motion_.form(), place_of(motion_.mechanism().source));
    else
        for (const ExactRow& row : rows) rates_.push_back(row.back());
    for (std::size_t k = 0; k < constants.size(); ++k)
        constants_[constants[k].coordinate.velocity] = rates_[k];
    GiNaC::exmap second;
    for (std::size_t k = 0; k < constants.size(); ++k)
        second[constants[k].coordinate.acceleration] = put(motion_.derivative(rates_[k]), constants_);
    constants_.insert(second.begin(), second.end());
}

ex ChangeOfVariables::operator()(const ex& e) const { return put(put(e, all_), constants_); }

ex ChangeOfVariables::at_origin(const ex& e) const {
    GiNaC::exmap origin;
    for (const Coordinate& c : variables_) {
        const Variable* variable = motion_.system().variable(c.name);
        origin[c.velocity] = 0;
        if (variable != nullptr && variable->role == Role::fast && variable->weight > 0) origin[c.at] = 0;
    }
    const ex value = put(e, positions_);
    const auto there = where_regular([&] { return put(motion_.unperturbed(value), origin); });
    if (!there)
        bad_input({"nothing is divided by an expression that is zero at the origin",
                   excerpt(written(motion_.form(), value)),
                   "choose other coordinates, or another origin by [change]",
                   place_of(motion_.mechanism().source)});
    return *there;
}

} // namespace resonform
