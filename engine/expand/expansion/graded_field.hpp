// SPDX-License-Identifier: GPL-3.0-or-later
// The first-order system as graded series in modal coordinates, ready to be normalised.
//
//   z' = lambda z + f(z, zbar, e^{i phi}, eps; xi)     modes of the linear part (expand/modes/modes.hpp);
//                                                      with couplings: z' = lambda z + sum n z_k + f
//   phi' = omega(xi) + f,   xi' = f,   X' = f           angles, slow variables, drift variables
//
//   oscillator psi'' + omega^2 psi = ...:  z = psi - i psi'/omega,  psi = (z + zbar)/2        (design 2.2)
#pragma once

#include "algebra/series/number_domain.hpp"
#include "algebra/series/series_program.hpp"
#include "expand/modes/modes.hpp"
#include "expand/ring/coefficient_ring.hpp"
#include "model/exact/first_order_system.hpp"

#include <memory>
#include <string>
#include <vector>

namespace resonform {

// A mode with its complex conjugate, or a real one.
struct Mode {
    std::size_t variable;             // index into system.variables: of the pivot
    std::string name, conjugate_name; // "z1", "z2"; a real mode has no conjugate_name
    GeneratorId z, zbar;              // equal for a real mode
    Polynomial growth, omega;         // lambda = growth + i omega; a pair has omega > 0, a unit
    bool oscillator;                  // psi'' + omega^2 psi by itself: z = psi - i psi'/omega
    SeriesProgram::Node input;        // z as input of the program
    SeriesProgram::Node input_conjugate;
    SeriesProgram::Node rate; // z' - lambda z - sum n z_k =: f, as a node

    [[nodiscard]] bool is_real() const { return z == zbar; }
    // It decays (or grows) at eps = 0.
    [[nodiscard]] bool is_damped() const { return !growth.empty(); }
};

// phi' = frequency(xi) + f; harmonics e^{i k phi} are powers of the generator `phase`.
struct AngleVariable {
    std::size_t variable;
    std::string name;
    GeneratorId phase;
    GiNaC::ex law;             // omega(xi)
    Polynomial frequency;      // the same in the ring
    SeriesProgram::Node input; // the old angle minus the new one
    SeriesProgram::Node rate;  // phi' - frequency (at the new xi)
};

// Driven: fast variables, angles or driven variables occur in its rate. Then it is an input of the program,
// and functions of it are expanded about the new variable.
struct SlowVariable {
    std::size_t variable;
    std::string name;
    GeneratorId generator;
    bool driven = false;
    Polynomial rate;                                // not driven: homogeneous parts of weight >= 1
    SeriesProgram::Node input = -1, rate_node = -1; // driven
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
    ModalBasis basis;               // basis.modes[k] belongs to modes[k]
    std::vector<Polynomial> shifts; // State::shift of basis.states: the user's variable is that much more
    std::vector<Mode> modes;
    std::vector<AngleVariable> angles;
    std::vector<SlowVariable> slow;
    std::vector<DriftVariable> drift;
    std::shared_ptr<const SeriesProgram> program;
    SeriesProgram::Node energy = -1; // of a Hamiltonian system, in modal coordinates

    [[nodiscard]] const System& system() const { return *first_order->system; }
    // The generators that make up monomials: modes with their conjugates, phases, eps.
    [[nodiscard]] std::vector<GeneratorId> outer() const;
    [[nodiscard]] Polynomial eigenvalue(const Mode& mode) const;
    [[nodiscard]] const std::vector<ModeCoupling>& couplings(std::size_t mode) const {
        return basis.modes[mode].couplings;
    }
    [[nodiscard]] bool is_semisimple() const;
    // What a derivative of the user's variable is more than the state of the field: 0 but for [equilibrium].
    [[nodiscard]] Polynomial shift(std::size_t variable, int derivative) const;
    // The different weights of the modes, the largest first.
    [[nodiscard]] std::vector<int> mode_weights() const;
    // lambda z + sum n z_k
    [[nodiscard]] Polynomial linear_part(std::size_t mode) const;
};

// Builds the ring (roots of weight-0 subexpressions), finds the modes, and translates the rates into the
// program. The ring gets an inverse for each of the divisors.
// Errors: bad_input: a force at the origin, a rate of a slow or drift variable that does not vanish with
// eps (and the fast variables), division by an expression that is zero; refused: what find_modes refuses,
// fast variables of weight 0 that are not linear at eps = 0, a term of lower weight than the fast variable
// in whose rate it stands, an angle that occurs outside of sin and cos, a
// coefficient function that the ring cannot hold.
GradedField expand(std::shared_ptr<const FirstOrderSystem> system, const Divisors& divisors = {});

// The numbers without exact value of a field over numbers (System::digits), to this precision; nullopt: more
// bits are needed.
std::optional<GivenNumbers> given_numbers(const GradedField& field, std::int64_t bits);

// The small divisors that the ring has an inverse for, besides its units: polynomials of field.ring. None
// vanishes identically; where one of them vanishes the normal form is not defined.
std::vector<Polynomial> small_divisors(const GradedField& field);

// p without its common factors: numbers, the sign of the first term, and the units that every term can be
// divided by; exponents >= 0 are left.
Polynomial primitive_part(const Ring& ring, const Polynomial& p);

// The same field over a ring with inverses of more divisors; those it has already are kept. New ones are
// polynomials of field.ring that are proved not to vanish identically; units are divided out of them.
// Errors (refused): more generators than a ring holds.
GradedField with_divisors(const GradedField& field, const std::vector<Polynomial>& divisors);

// The same field over a ring that differentiates functions known by their names only so many times at
// least: each weight needs one more.
std::shared_ptr<const GradedField> with_derivatives(std::shared_ptr<const GradedField> field, int count);

// The field in modal coordinates through a weight: f of each mode, each drift rate.
struct FieldSeries {
    std::vector<Series> mode; // z' without its linear part
    std::vector<Series> drift;
};
FieldSeries evaluate_field(const GradedField& field, int through);

// (16): the equations as written, expanded in the jets of the fast variables (all of the weight of the
// variable, the highest derivative included), harmonics of angles, and eps; slow and drift variables as
// rates, solved for x'. With eps written explicitly (xi' already substituted); printers put xi' back (emit/).
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
    // The generators that make up monomials: jets of the fast variables, phases, eps.
    [[nodiscard]] std::vector<GeneratorId> outer() const;
};
EquationSeries expand_equations(const GradedField& field, int through);

} // namespace resonform
