// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/multipliers.hpp"

#include "model/canonical.hpp"

#include <algorithm>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::matrix;

class SecondRoute {
public:
    SecondRoute(const Mechanism& mechanism, ExactForm& form, const GiNaC::exmap& velocities,
                const GiNaC::exmap& accelerations)
        : mechanism_(mechanism), form_(form), velocities_(velocities), accelerations_(accelerations) {}

    void check() {
        for (const Constraint& c : mechanism_.constraints) {
            require_zero(on_motion(c.condition.value), "a constraint", c.condition.source);
            require_zero(on_motion(rate(c.condition.value)), "a constraint, differentiated",
                         c.condition.source);
        }
        const ex lagrangian =
            mechanism_.lagrangian ? mechanism_.lagrangian->value : kinetic() - mechanism_.potential.value;
        std::vector<ex> forces;
        for (std::size_t k = 0; k < mechanism_.coordinates.size(); ++k)
            forces.push_back(on_motion(inertia(lagrangian, k) - force(k)));
        for (const ex& unbalanced : without_reactions(forces))
            require_zero(unbalanced, "an equation with multipliers", mechanism_.source);
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
    ex on_motion(const ex& e) const {
        return e.subs(accelerations_, GiNaC::subs_options::no_pattern)
            .subs(velocities_, GiNaC::subs_options::no_pattern);
    }

    // What multipliers, found from as many rows as there are constraints, leave of the others.
    std::vector<ex> without_reactions(const std::vector<ex>& forces) const {
        const std::size_t m = mechanism_.constraints.size(), n = forces.size();
        if (m == 0) return forces;
        std::vector<std::vector<ex>> directions(n, std::vector<ex>(m));
        for (std::size_t k = 0; k < n; ++k)
            for (std::size_t s = 0; s < m; ++s)
                directions[k][s] = on_motion(
                    mechanism_.constraints[s].condition.value.diff(mechanism_.coordinates[k].velocity));
        std::vector<bool> chosen(n, false); // the last ones that give a determinant that is not zero
        std::fill(chosen.end() - static_cast<std::ptrdiff_t>(m), chosen.end(), true);
        do {
            matrix square(static_cast<unsigned>(m), static_cast<unsigned>(m));
            std::vector<ex> right;
            for (std::size_t k = 0; k < n; ++k) {
                if (!chosen[k]) continue;
                for (unsigned s = 0; s < m; ++s)
                    square(static_cast<unsigned>(right.size()), s) = directions[k][s];
                right.push_back(forces[k]);
            }
            const ex determinant = square.determinant();
            if (form_.vanishes(determinant) != Zero::no) continue;
            return remainders(forces, directions, multipliers(square, right, determinant));
        } while (std::next_permutation(chosen.begin(), chosen.end()));
        refuse({"the constraints are independent of each other",
                "no determinant of theirs is seen to differ from zero", "write them in a plainer form",
                place_of(mechanism_.constraints.front().condition.source)});
    }

    // Cramer's rule.
    static std::vector<ex> multipliers(const matrix& square, const std::vector<ex>& right,
                                       const ex& determinant) {
        std::vector<ex> result;
        for (unsigned s = 0; s < square.cols(); ++s) {
            matrix replaced = square;
            for (unsigned row = 0; row < square.rows(); ++row) replaced(row, s) = right[row];
            result.push_back(replaced.determinant() / determinant);
        }
        return result;
    }

    static std::vector<ex> remainders(const std::vector<ex>& forces,
                                      const std::vector<std::vector<ex>>& directions,
                                      const std::vector<ex>& multipliers) {
        std::vector<ex> result = forces;
        for (std::size_t k = 0; k < forces.size(); ++k)
            for (std::size_t s = 0; s < multipliers.size(); ++s)
                result[k] -= multipliers[s] * directions[k][s];
        return result;
    }

    void require_zero(const ex& e, const std::string& what, const SourceText& source) const {
        const Zero zero = form_.vanishes(e);
        if (zero == Zero::yes) return;
        refuse({"the equations by Gibbs and Appell and those with multipliers agree",
                what + (zero == Zero::no ? " is not satisfied" : " is not seen to be satisfied"),
                zero == Zero::no ? "report this: one of the two routes is wrong"
                                 : "write the mechanism in a plainer form",
                place_of(source)});
    }

    const Mechanism& mechanism_;
    ExactForm& form_;
    const GiNaC::exmap& velocities_;
    const GiNaC::exmap& accelerations_;
};

} // namespace

void check_by_multipliers(const Mechanism& mechanism, ExactForm& form, const GiNaC::exmap& velocities,
                          const GiNaC::exmap& accelerations) {
    SecondRoute(mechanism, form, velocities, accelerations).check();
}

} // namespace resonform
