// SPDX-License-Identifier: GPL-3.0-or-later
// The first-order system as graded series in modal coordinates, ready to be normalised.
//
//   oscillator psi'' + omega^2 psi = ...:  z = psi - i psi'/omega,  psi = (z + zbar)/2,
//   psi' = i omega (z - zbar)/2,  z' = i omega z + f(z, zbar, eps; xi)           (design 2.2)
#pragma once

#include "algebra/series_program.hpp"
#include "expand/coefficient_ring.hpp"
#include "model/first_order_system.hpp"

#include <memory>
#include <string>
#include <vector>

namespace resonform {

// One oscillator: its two states, its conjugate pair of modes, its frequency.
struct Mode {
    std::size_t variable;             // index into system.variables
    std::string name, conjugate_name; // "z1", "z2"
    GeneratorId z, zbar;
    Polynomial omega;          // a unit of the ring, positive
    SeriesProgram::Node input; // z as input of the program (zbar: input_conjugate)
    SeriesProgram::Node input_conjugate;
    SeriesProgram::Node rate; // z' - i omega z =: f, as a node
};

struct SlowVariable {
    std::size_t variable;
    std::string name;
    GeneratorId generator;
    Polynomial rate; // homogeneous parts of weight >= 1; no fast variable in it
};

struct DriftVariable {
    std::size_t variable;
    std::string name;
    SeriesProgram::Node rate;
};

struct GradedField {
    std::shared_ptr<const FirstOrderSystem> first_order;
    std::shared_ptr<const CoefficientRing> coefficients; // expressions -> ring
    RingPtr ring;
    GeneratorId eps;
    std::vector<Mode> modes;
    std::vector<SlowVariable> slow;
    std::vector<DriftVariable> drift;
    std::shared_ptr<const SeriesProgram> program;

    [[nodiscard]] const System& system() const { return *first_order->system; }
};

// Builds the ring (roots of weight-0 subexpressions), checks that every fast variable is an
// oscillator, and translates the rates into the program.
// Errors: bad_input: a fast variable of other order than 2, linear part absent, damping at weight 0,
// a force at the origin, division by an expression that is zero; refused: omega^2 not provably
// positive, a slow rate of weight 0 or depending on fast variables, a coefficient function that the
// ring cannot hold. The ring gets an inverse for each of the divisors.
GradedField expand(std::shared_ptr<const FirstOrderSystem> system, const Divisors& divisors = {});

// The small divisors that the ring has an inverse for, besides its units: polynomials of field.ring. None
// vanishes identically; on the surfaces where one does the normal form means nothing.
std::vector<Polynomial> small_divisors(const GradedField& field);

// The same field over a ring that divides by more; the divisors it has already are kept. New ones are
// polynomials of field.ring that are proved not to vanish identically; units are divided out of them.
// Errors (refused): more generators than a ring holds.
GradedField with_divisors(const GradedField& field, const std::vector<Polynomial>& divisors);

// The field in modal coordinates through a weight: f of each mode, each drift rate.
struct FieldSeries {
    std::vector<Series> mode; // z' - i omega z
    std::vector<Series> drift;
};
FieldSeries evaluate_field(const GradedField& field, int through);

// (16): the equations as written, expanded in the jets of the fast variables (all of weight 1, the
// highest derivative included) and eps; slow and drift variables as rates, solved for x'.
// With eps written explicitly (xi' already substituted); printers put xi' back (emit/).
struct EquationLine {
    std::size_t variable;
    bool implicit;   // fast: series = 0;  slow, drift: x' = series
    Series series;   // weights 0 ... through
    int next_weight; // the first weight > through with a term, 0 if none was seen
};
struct EquationSeries {
    std::shared_ptr<const CoefficientRing> coefficients;
    RingPtr ring; // parameters, slow variables, roots as in GradedField; fast generators are
                  // the jets, named "psi", "psi'", "psi''"
    GeneratorId eps;
    int through = 0;
    std::vector<EquationLine> lines; // one per variable, in file order
};
EquationSeries expand_equations(const GradedField& field, int through);

} // namespace resonform
