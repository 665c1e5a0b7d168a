// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mechanics/gibbs_appell.hpp"

#include "algebra/number/error.hpp"
#include "model/exact/solution.hpp"
#include "model/exact/substitution.hpp"
#include "model/text/canonical.hpp"

namespace resonform {

namespace {

using GiNaC::ex;

// sum over the axes of I_1 w_1'^2/2 + (I_3 - I_2) w_2 w_3 w_1', up to terms free of accelerations
ex of_rotation(const Motion& motion, const SpatialBody& body) {
    ex energy = 0;
    for (std::size_t a = 0; a < 3; ++a) {
        const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
        const ex rate = motion.derivative(body.spin[a]);
        energy += body.inertia[a] * rate * rate / 2 +
                  (body.inertia[c] - body.inertia[b]) * body.spin[b] * body.spin[c] * rate;
    }
    return energy;
}

ex of_masses(const Motion& motion) {
    const auto of_particle = [&](const Particle& particle) {
        ex square = 0;
        for (const ex& x : particle.position)
            square += GiNaC::pow(motion.derivative(motion.derivative(x)), 2);
        return particle.mass * square / 2;
    };
    ex energy = 0;
    for (const Particle& particle : motion.mechanism().particles) energy += of_particle(particle);
    for (const PlaneBody& body : motion.mechanism().plane_bodies)
        energy += of_particle(body.centre) +
                  body.inertia * GiNaC::pow(motion.derivative(motion.derivative(body.angle)), 2) / 2;
    for (const SpatialBody& body : motion.mechanism().spatial_bodies)
        energy += of_particle(body.centre) + of_rotation(motion, body);
    return energy;
}

// sum over x'' of (N(x'') + N(0))/2 x'', N linear in the accelerations
ex of_lagrangian(const Motion& motion) {
    const ex lagrangian = motion.mechanism().lagrangian->value;
    const ex rate = motion.derivative(lagrangian);
    GiNaC::exmap none;
    for (const Coordinate& c : motion.mechanism().coordinates) none[c.acceleration] = 0;
    ex energy = 0;
    for (const Coordinate& c : motion.mechanism().coordinates) {
        const ex nielsen = rate.diff(c.velocity) - 2 * lagrangian.diff(c.at);
        energy += (nielsen + put(nielsen, none)) / 2 * c.acceleration;
    }
    return energy;
}

ex force_on(const Motion& motion, std::size_t coordinate) {
    const Mechanism& mechanism = motion.mechanism();
    const Coordinate& c = mechanism.coordinates[coordinate];
    ex force = -mechanism.potential.value.diff(c.at) - mechanism.dissipation.value.diff(c.velocity);
    for (const Force& f : mechanism.forces)
        if (f.coordinate == coordinate) force += f.value;
    return force;
}

// dS/dx'' - Q, where a displacement of an independent coordinate takes the dependent ones along.
ex equation_of(const Motion& motion, const SolvedConstraints& constraints, const ex& energy, std::size_t i) {
    const std::size_t coordinate = constraints.independent[i];
    ex force = force_on(motion, coordinate);
    for (std::size_t d = 0; d < constraints.dependent.size(); ++d)
        force += constraints.slope[d][i] * force_on(motion, constraints.dependent[d]);
    const ex slope = energy.diff(motion.mechanism().coordinates[coordinate].acceleration);
    return motion.form().simplified(put(slope - force, constraints.velocities));
}

std::vector<ex> solved(const Motion& motion, const SolvedConstraints& constraints,
                       const std::vector<ex>& equations) {
    const auto& coordinates = motion.mechanism().coordinates;
    GiNaC::exmap none;
    for (const std::size_t i : constraints.independent) none[coordinates[i].acceleration] = 0;
    std::vector<ExactRow> rows;
    for (const ex& equation : equations) {
        ExactRow row;
        for (const std::size_t i : constraints.independent)
            row.push_back(motion.form().simplified(equation.diff(coordinates[i].acceleration)));
        row.push_back(-put(equation, none));
        rows.push_back(std::move(row));
    }
    GiNaC::matrix masses(static_cast<unsigned>(rows.size()), static_cast<unsigned>(rows.size()));
    for (unsigned r = 0; r < masses.rows(); ++r)
        for (unsigned c = 0; c < masses.cols(); ++c) masses(r, c) = rows[r][c];
    if (motion.form().vanishes(masses.determinant()) == Zero::yes)
        bad_input({"the matrix of the accelerations is singular", "its determinant is zero",
                   "give every coordinate a mass, or leave it out", place_of(motion.mechanism().source)});
    return solve_if_short(std::move(rows), motion.form(), place_of(motion.mechanism().source));
}

} // namespace

AppellEquations appell_equations(const Motion& motion, const SolvedConstraints& constraints) {
    ExactForm& form = motion.form();
    AppellEquations result;
    result.energy =
        form.simplified(motion.mechanism().lagrangian ? of_lagrangian(motion) : of_masses(motion));
    for (const auto& [velocity, value] : constraints.velocities)
        for (const std::size_t d : constraints.dependent)
            if (const Coordinate& c = motion.mechanism().coordinates[d]; velocity.is_equal(c.velocity))
                result.differentiated[c.acceleration] =
                    form.simplified(put(motion.derivative(value), constraints.velocities));
    const ex with_accelerations = put(result.energy, result.differentiated);
    result.constrained = form.simplified(put(with_accelerations, constraints.velocities));
    for (std::size_t i = 0; i < constraints.independent.size(); ++i)
        result.equations.push_back(equation_of(motion, constraints, result.constrained, i));
    result.accelerations = solved(motion, constraints, result.equations);
    return result;
}

} // namespace resonform
