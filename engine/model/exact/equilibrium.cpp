// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/exact/equilibrium.hpp"

#include "algebra/number/error.hpp"
#include "model/exact/equilibrium_roots.hpp"
#include "model/exact/first_order_system.hpp"
#include "model/exact/question.hpp"
#include "model/exact/substitution.hpp"
#include "model/signs/sign_prover.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/regular.hpp"

#include <algorithm>

namespace resonform {

namespace {

using GiNaC::ex;

// The rate of a fast variable at eps = 0, where it is to vanish.
struct RestingRate {
    std::size_t variable;
    ex value; // in the named variables that are to be solved for, slow variables, angles and parameters
};

class Settling {
public:
    explicit Settling(System& system)
        : system_(system), first_order_(solve_for_highest(std::make_shared<const System>(system))) {}

    void settle() {
        for (const Equilibrium& at : system_.equilibrium)
            if (!at.wanted) require_real(at, at.value);
        forces_ = forces();
        const bool wanted = std::any_of(system_.equilibrium.begin(), system_.equilibrium.end(),
                                        [](const Equilibrium& at) { return at.wanted; });
        if (wanted) solve();
        for (const RestingRate& force : forces_) require_zero(force, put(force.value, solution_));
    }

private:
    [[nodiscard]] const GiNaC::symbol& symbol(std::size_t variable) const {
        return system_.variables[variable].jet.front();
    }
    [[nodiscard]] std::string name_of_rate(const RestingRate& force) const {
        return system_.variables[force.variable].jet.back().get_name();
    }
    [[nodiscard]] std::vector<RestingRate> forces() const;
    [[nodiscard]] Place place_of_force(const RestingRate& force) const;
    void require_real(const Equilibrium& at, const ex& value) const;
    void require_zero(const RestingRate& force, const ex& rest) const;
    void solve();
    [[nodiscard]] std::vector<GiNaC::exmap> without_wrong(std::vector<GiNaC::exmap> candidates) const;
    [[nodiscard]] std::string spelled(const GiNaC::exmap& solution) const;

    System& system_;
    FirstOrderSystem first_order_;
    std::vector<RestingRate> forces_;
    GiNaC::exmap solution_; // of the variables that are solved for
};

// Of variables that are not named, and whose rates hold none that is, the expansion asks.
std::vector<RestingRate> Settling::forces() const {
    GiNaC::exmap rest{{system_.eps, 0}}, named;
    for (const Variable& v : system_.variables)
        if (v.role == Role::fast)
            for (const GiNaC::symbol& jet : v.jet) rest[jet] = 0;
    for (const Equilibrium& at : system_.equilibrium) {
        named[symbol(at.variable)] = 0;
        if (at.wanted)
            rest.erase(symbol(at.variable));
        else
            rest[symbol(at.variable)] = at.value;
    }
    std::vector<RestingRate> forces;
    for (const State& state : first_order_.states) {
        const Variable& v = system_.variables[state.variable];
        if (v.role != Role::fast || state.derivative + 1 != v.order) continue;
        const bool concerned = std::any_of(named.begin(), named.end(), [&](const auto& one) {
            return one.first.is_equal(v.jet.front()) || state.rate.has(one.first);
        });
        if (!concerned) continue;
        RestingRate force{state.variable, 0};
        const auto value = where_regular([&] { return put(state.rate, rest); });
        if (!value)
            bad_input({"the equations have values at eps = 0 where [equilibrium] says",
                       name_of_rate(force) + " is divided by zero there", "correct the equilibrium",
                       place_of_force(force)});
        force.value = *value;
        forces.push_back(std::move(force));
    }
    return forces;
}

// The entry of the variable, or the first one.
Place Settling::place_of_force(const RestingRate& force) const {
    const Equilibrium* own = system_.equilibrium_of(force.variable);
    return place_of((own == nullptr ? system_.equilibrium.front() : *own).source);
}

// The innermost part that is not proved real and finite.
ex unproved(const SignProver& prover, const ex& e) {
    for (const ex& part : operands(e))
        if (!prover.real(part)) return unproved(prover, part);
    return e;
}

void Settling::require_real(const Equilibrium& at, const ex& value) const {
    const SignProver prover(system_);
    if (prover.real(value)) return;
    refuse(Reason::undecided,
           {"an equilibrium is proved to be real and finite: what it divides by is not zero, and no root in "
            "it is of a negative number",
            excerpt(spell(unproved(prover, value))) + " in " + system_.variables[at.variable].name + " = " +
                excerpt(spell(value)),
            "declare positive or nonzero what is, in [parameters], [variables] or [domain]",
            place_of(at.source)});
}

void Settling::require_zero(const RestingRate& force, const ex& rest) const {
    const Zero zero = vanishes(rest, system_);
    if (zero == Zero::yes) return;
    const auto shorter = where_regular([&] { return rest.normal(); });
    const std::string found = name_of_rate(force) + " = " + excerpt(spell(shorter ? *shorter : rest));
    if (zero == Zero::no)
        bad_input({"what [equilibrium] gives is no equilibrium of the equations at eps = 0", found + " there",
                   "correct it, or write \"solve\"", place_of_force(force)});
    refuse(Reason::undecided,
           {"what [equilibrium] gives is proved to be an equilibrium at eps = 0",
            found + " there, which may be zero", "write it in a simpler form", place_of_force(force)});
}

void Settling::solve() {
    RootsOfForces roots{system_, {}, {}, {}};
    for (const Equilibrium& at : system_.equilibrium)
        if (at.wanted) {
            roots.unknowns.push_back(symbol(at.variable));
            roots.places.push_back(place_of(at.source));
        }
    for (const RestingRate& force : forces_) roots.forces.push_back(force.value);
    const std::vector<GiNaC::exmap> solutions = without_wrong(roots.find());
    const Place& place = roots.places.front();
    if (solutions.empty())
        bad_input({"the equations have an equilibrium at eps = 0", "none was found",
                   "correct the equations, or write it if there is one", place});
    if (solutions.size() > 1) {
        std::string list;
        for (const GiNaC::exmap& s : solutions) list.append(list.empty() ? "" : "; ").append(spelled(s));
        refuse({"\"solve\" finds one equilibrium at eps = 0",
                std::to_string(solutions.size()) + " of them: " + shown(list),
                "write the one that is meant in place of \"solve\"", place});
    }
    solution_ = solutions.front();
    for (Equilibrium& at : system_.equilibrium) {
        if (!at.wanted) continue;
        at.value = solution_.at(symbol(at.variable));
        at.wanted = false;
        require_real(at, at.value);
    }
}

// Solutions of some of the equations may be none of others.
std::vector<GiNaC::exmap> Settling::without_wrong(std::vector<GiNaC::exmap> candidates) const {
    std::erase_if(candidates, [&](const GiNaC::exmap& candidate) {
        return std::any_of(forces_.begin(), forces_.end(), [&](const RestingRate& force) {
            const auto rest = where_regular([&] { return put(force.value, candidate); });
            return !rest || vanishes(*rest, system_) == Zero::no;
        });
    });
    std::sort(candidates.begin(), candidates.end(),
              [&](const GiNaC::exmap& a, const GiNaC::exmap& b) { return spelled(a) < spelled(b); });
    return candidates;
}

std::string Settling::spelled(const GiNaC::exmap& solution) const {
    std::string text;
    for (const Equilibrium& at : system_.equilibrium)
        if (const auto found = solution.find(symbol(at.variable)); found != solution.end())
            text.append(text.empty() ? "" : ", ")
                .append(system_.variables[at.variable].name)
                .append(" = ")
                .append(spell(found->second));
    return text;
}

} // namespace

void settle_equilibrium(System& system) { Settling(system).settle(); }

} // namespace resonform
