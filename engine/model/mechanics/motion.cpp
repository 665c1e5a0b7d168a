// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mechanics/motion.hpp"

#include "algebra/number/error.hpp"
#include "model/exact/substitution.hpp"
#include "model/signs/sign_prover.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/regular.hpp"

namespace resonform {

using GiNaC::ex;

Motion::Motion(const Mechanism& mechanism, const System& system, ExactForm& form)
    : mechanism_(&mechanism), system_(&system), form_(&form) {
    std::vector<const Coordinate*> all;
    for (const Variable& v : system.variables) { // the order of the system's variables comes first
        for (const auto* list : {&mechanism.coordinates, &mechanism.fresh})
            for (const Coordinate& c : *list)
                if (c.name == v.name) all.push_back(&c);
        for (const Integral& i : mechanism.integrals)
            if (i.coordinate.name == v.name) all.push_back(&i.coordinate);
    }
    for (const Coordinate& c : mechanism.coordinates)
        if (system.variable(c.name) == nullptr) all.push_back(&c);
    for (const Integral& i : mechanism.integrals)
        if (system.variable(i.coordinate.name) == nullptr) all.push_back(&i.coordinate);
    add_symbols(all);
    for (const QuasiVelocity& u : mechanism.quasi_velocities) {
        form.add(u.acceleration, ExactForm::Kind::acceleration);
        form.add(u.velocity, ExactForm::Kind::velocity);
        derivatives_.push_back({u.velocity, u.acceleration});
    }
    for (const Prescribed& p : mechanism.prescribed) {
        const Variable* variable = system.variable(p.coordinate.name);
        const bool turns = variable != nullptr && variable->role == Role::angle;
        form.add(p.coordinate.velocity, ExactForm::Kind::rate);
        form.add(p.coordinate.at, turns ? ExactForm::Kind::coordinate : ExactForm::Kind::slow);
        derivatives_.push_back({p.coordinate.at, p.coordinate.velocity});
        laws_[p.coordinate.velocity] = p.rate;
    }
    for (const Parameter& p : system.parameters) form.add(p.symbol, ExactForm::Kind::parameter);
    form.add(system.eps, ExactForm::Kind::eps);
    std::vector<TimeDerivative> second; // xi'' from the law of xi
    for (const Prescribed& p : mechanism.prescribed)
        second.push_back({p.coordinate.velocity, derivative(p.rate)});
    derivatives_.insert(derivatives_.end(), second.begin(), second.end());
}

void Motion::add_symbols(const std::vector<const Coordinate*>& all) {
    for (const Coordinate* c : all) {
        form_->add(c->acceleration, ExactForm::Kind::acceleration);
        form_->add(c->velocity, ExactForm::Kind::velocity);
        const Variable* variable = system_->variable(c->name);
        const bool slow = variable != nullptr && variable->role == Role::slow;
        form_->add(c->at, slow ? ExactForm::Kind::slow : ExactForm::Kind::coordinate);
        derivatives_.push_back({c->at, c->velocity});
        derivatives_.push_back({c->velocity, c->acceleration});
    }
}

void Motion::add(const Coordinate& constant) { add_symbols({&constant}); }

ex Motion::derivative(const ex& e) const { return along(e, derivatives_); }

ex Motion::with_laws(const ex& e) const { return e.subs(laws_, GiNaC::subs_options::no_pattern); }

ex Motion::unperturbed(const ex& e) const {
    const auto value = where_regular([&] { return with_laws(e).subs(system_->eps == 0); });
    if (!value)
        bad_input({"the mechanism is singular at eps = 0", excerpt(spell(e)), "scale it by a power of eps",
                   place_of(mechanism_->source)});
    return *value;
}

std::vector<const Prescribed*> Motion::moving() const {
    std::vector<const Prescribed*> result;
    for (const Prescribed& p : mechanism_->prescribed)
        if (form_->vanishes(unperturbed(p.rate)) != Zero::yes) result.push_back(&p);
    return result;
}

bool Motion::positive_where_expanded(const ex& e) const {
    GiNaC::exmap changes, origin;
    for (const Change& change : mechanism_->changes)
        changes[mechanism_->coordinates[change.coordinate].at] = change.value.value;
    for (const Variable& v : system_->variables)
        if (v.role == Role::fast && v.weight > 0) origin[v.jet.front()] = 0;
    const auto value = put_through(e, changes);
    if (!value) return false;
    const auto there = where_regular([&] { return put(with_laws(*value).subs(system_->eps == 0), origin); });
    return there && provably_positive(*there, *system_);
}

} // namespace resonform
