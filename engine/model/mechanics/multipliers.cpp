// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mechanics/multipliers.hpp"

#include "algebra/number/error.hpp"
#include "model/exact/substitution.hpp"
#include "model/text/canonical.hpp"

namespace resonform {

namespace {

using GiNaC::ex;

class SecondRoute {
public:
    SecondRoute(const Mechanism& mechanism, ExactForm& form, const SolvedConstraints& constraints,
                const AppellEquations& appell)
        : mechanism_(mechanism), form_(form), constraints_(constraints), appell_(appell) {}

    void check() {
        for (const Constraint& c : mechanism_.constraints) {
            require_zero(on_motion(c.condition.value), "a constraint", c.condition.source);
            require_zero(on_motion(rate(c.condition.value)), "a constraint, differentiated",
                         c.condition.source);
        }
        require_rank();
        const std::vector<ex> forces = unbalanced();
        for (std::size_t i = 0; i < constraints_.independent.size(); ++i) {
            require_zero(along(forces, i) - appell_.equations[i], "an equation with multipliers",
                         mechanism_.source);
            if (!appell_.accelerations.empty())
                require_zero(solved(appell_.equations[i]), "an equation, solved for the accelerations",
                             mechanism_.source);
        }
    }

private:
    // The velocity of a function of position.
    ex velocity(const ex& position) const {
        ex sum = 0;
        for (const Coordinate& c : mechanism_.coordinates) sum += position.diff(c.at) * c.velocity;
        for (const Prescribed& p : mechanism_.prescribed)
            sum += position.diff(p.coordinate.at) * p.coordinate.velocity;
        return sum;
    }
    // The rate of a function of positions and velocities.
    ex rate(const ex& e) const {
        ex sum = velocity(e);
        for (const Coordinate& c : mechanism_.coordinates) sum += e.diff(c.velocity) * c.acceleration;
        for (const Prescribed& p : mechanism_.prescribed)
            sum += e.diff(p.coordinate.velocity) * velocity(p.rate);
        return sum;
    }
    ex kinetic() const {
        ex energy = 0;
        const auto of_particle = [&](const Particle& particle) {
            for (const ex& x : particle.position) energy += particle.mass * GiNaC::pow(velocity(x), 2) / 2;
        };
        for (const Particle& particle : mechanism_.particles) of_particle(particle);
        for (const PlaneBody& body : mechanism_.plane_bodies) {
            of_particle(body.centre);
            energy += body.inertia * GiNaC::pow(velocity(body.angle), 2) / 2;
        }
        for (const SpatialBody& body : mechanism_.spatial_bodies) {
            of_particle(body.centre);
            for (std::size_t axis = 0; axis < 3; ++axis)
                energy += body.inertia[axis] * GiNaC::pow(body.spin[axis], 2) / 2;
        }
        return energy;
    }
    ex inertia(const ex& lagrangian, std::size_t k) const {
        const Coordinate& c = mechanism_.coordinates[k];
        return rate(lagrangian.diff(c.velocity)) - lagrangian.diff(c.at);
    }
    ex force(std::size_t k) const {
        ex sum = -mechanism_.dissipation.value.diff(mechanism_.coordinates[k].velocity);
        for (const Force& f : mechanism_.forces)
            if (f.coordinate == k) sum += f.value;
        return sum;
    }
    ex on_motion(const ex& e) const { return put(put(e, appell_.differentiated), constraints_.velocities); }
    ex solved(const ex& equation) const {
        GiNaC::exmap all;
        for (std::size_t i = 0; i < appell_.accelerations.size(); ++i)
            all[independent(i).acceleration] = appell_.accelerations[i];
        return put(equation, all);
    }
    const Coordinate& independent(std::size_t i) const {
        return mechanism_.coordinates[constraints_.independent[i]];
    }

    // The forces that the multipliers must balance, by coordinate.
    std::vector<ex> unbalanced() const {
        const ex lagrangian =
            mechanism_.lagrangian ? mechanism_.lagrangian->value : kinetic() - mechanism_.potential.value;
        std::vector<ex> forces;
        for (std::size_t k = 0; k < mechanism_.coordinates.size(); ++k)
            forces.push_back(on_motion(inertia(lagrangian, k) - force(k)));
        return forces;
    }

    // Their sum along the direction of x_i' that the constraints allow: there the multipliers do no work.
    // (They allow it, because they are checked to hold for all x_i'.)
    ex along(const std::vector<ex>& forces, std::size_t i) const {
        ex sum = forces[constraints_.independent[i]];
        for (const std::size_t d : constraints_.dependent)
            sum +=
                constraints_.velocities.at(mechanism_.coordinates[d].velocity).diff(independent(i).velocity) *
                forces[d];
        return sum;
    }

    // Requires that the constraints are independent: they allow no other directions then.
    void require_rank() const {
        const auto m = static_cast<unsigned>(mechanism_.constraints.size());
        if (m == 0) return;
        GiNaC::matrix square(m, m);
        for (unsigned s = 0; s < m; ++s)
            for (unsigned d = 0; d < m; ++d)
                square(s, d) = on_motion(mechanism_.constraints[s].condition.value.diff(
                    mechanism_.coordinates[constraints_.dependent[d]].velocity));
        if (form_.vanishes(square.determinant()) == Zero::no) return;
        refuse(Reason::undecided,
               {"the constraints are independent of each other",
                "no determinant of theirs is seen to differ from zero", "write them in a plainer form",
                place_of(mechanism_.constraints.front().condition.source)});
    }

    void require_zero(const ex& e, const std::string& what, const SourceText& source) const {
        const Zero zero = form_.vanishes(e);
        if (zero == Zero::yes) return;
        refuse(Reason::undecided,
               {"the equations by Gibbs and Appell and those with multipliers agree",
                what + (zero == Zero::no ? " is not satisfied" : " is not seen to be satisfied"),
                zero == Zero::no ? "report this: one of the two routes is wrong"
                                 : "write the mechanism in a plainer form",
                place_of(source)});
    }

    const Mechanism& mechanism_;
    ExactForm& form_;
    const SolvedConstraints& constraints_;
    const AppellEquations& appell_;
};

} // namespace

void check_by_multipliers(const Mechanism& mechanism, ExactForm& form, const SolvedConstraints& constraints,
                          const AppellEquations& appell) {
    SecondRoute(mechanism, form, constraints, appell).check();
}

} // namespace resonform
