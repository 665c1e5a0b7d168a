// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a mechanism, as the user wrote them (docs/file_formats.md, "Mechanisms").
#pragma once

#include "model/system/system_file.hpp"

#include <string>
#include <vector>

namespace resonform {

// A text of the file with its value.
struct Written {
    GiNaC::ex value;
    std::string text;
    SourceText source;
};

struct Coordinate {
    std::string name, unit;
    GiNaC::symbol at, velocity, acceleration; // x, x', x''
    Place place;
};

// [prescribed] xi = "xi' = eps*v": imposed before anything else.
struct Prescribed {
    Coordinate coordinate;
    Written law; // lhs - rhs
    GiNaC::ex rate;
};

// [quasi_velocities] u = "x'*cos(phi) + y'*sin(phi)"
struct QuasiVelocity {
    std::string name, unit;
    GiNaC::symbol velocity, acceleration; // u, u'
    Written form;                         // in coordinates, prescribed ones and their velocities
    Place place;
};

struct Particle {
    std::string name;
    GiNaC::ex mass;
    std::vector<GiNaC::ex> position; // 2 or 3, in an inertial frame
    SourceText source;
};

// A rigid body that moves in a plane or parallel to one.
struct PlaneBody {
    Particle centre; // of mass
    GiNaC::ex inertia, angle;
};

// A rigid body in space, with the moments of inertia about its principal axes and the components of its
// angular velocity along these.
struct SpatialBody {
    Particle centre; // of mass
    std::vector<GiNaC::ex> inertia, spin;
};

struct Force { // generalised: its power is value * coordinate'
    std::size_t coordinate;
    GiNaC::ex value;
    SourceText source;
};

struct Constraint {
    std::string name;
    Written condition; // lhs - rhs, linear or affine in the velocities
};

// [change] phi = "psi + atan(xi/r)"
struct Change {
    std::size_t coordinate;
    Written value; // in coordinates that stay, new ones, integrals and prescribed ones
};

// [integrals] R = "x + y": constant at eps = 0, where prescribed coordinates rest or move.
struct Integral {
    Coordinate coordinate;
    Written value; // in coordinates and prescribed ones
};

// The name of an integral found by the engine that replaces this dependent coordinate: R_y.
std::string name_of_integral(const Coordinate& dependent);

struct Mechanism {
    std::vector<Coordinate> coordinates;
    std::vector<Prescribed> prescribed;
    std::vector<QuasiVelocity> quasi_velocities; // as many as degrees of freedom, or none
    std::vector<Coordinate> fresh;               // variables of the system that [change] brings in
    std::vector<Particle> particles;
    std::vector<PlaneBody> plane_bodies;
    std::vector<SpatialBody> spatial_bodies;
    Written potential, dissipation;
    std::optional<Written> lagrangian; // instead of particles, bodies and potential
    std::vector<Force> forces;
    std::vector<Constraint> constraints;
    std::vector<Integral> integrals;
    std::vector<Change> changes;
    SourceText source;          // of [coordinates]
    std::vector<Written> parts; // every expression of the file
};

} // namespace resonform
