// SPDX-License-Identifier: GPL-3.0-or-later
// A solution under construction: its ring grows by one generator with every primitive that is found,
// and everything in the solution is rewritten for the new ring.
//
//   ring of the normal form            i z1 z2 eps g r v xi G sigma
//   first ring, sigma = rho^2          i eps g r v xi G rho C_delta C_X C_Y phase
//   after the drift of x               ... L1 Q_x2
#pragma once

#include "solve/solution.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

// The root `base` of the normal form's ring, or the positive slow variable itself, is to have its
// factor-th root in the ring of the solution.
struct Refinement {
    GeneratorId base;
    int factor;
};

class Draft {
public:
    // Fills everything of the solution but envelope, factor, phase rate, drift values and outputs.
    Draft(std::shared_ptr<const Normalization> normalization, const SolveOptions& options,
          const std::vector<Refinement>& refinements);

    Solution solution;

    [[nodiscard]] const Ring& ring() const { return *solution.ring; }
    [[nodiscard]] const NormalForm& normal_form() const { return solution.normalization->normal_form; }

    // A polynomial of the normal form's ring without modes -> the present ring.
    [[nodiscard]] Polynomial lift(const Polynomial& p) const { return (*solution.from_normal_form)(p); }

    // The integral over slow time of a rate dF/dT, T = eps t: in closed form over the clock (the slow
    // variable, or T itself) if the ansatz finds it, of a constant beside a slow variable that relaxes as a
    // multiple of T, else a new quadrature `name`. Without additive
    // constant. The result lies in the new ring; polynomials of the ring before are stale.
    Polynomial integrate(const Polynomial& rate, const std::string& name);
    // exp(argument) as a generator.
    Polynomial exponential(const Polynomial& argument, const std::string& name);
    // base^exponent for a refined base of the normal form's ring; exponent*factor is an integer.
    [[nodiscard]] Polynomial power_of(GeneratorId base, const Rational& exponent) const;

private:
    void copy_generators(RingBuilder& builder, const std::vector<Refinement>& refinements);
    void add_constants(RingBuilder& builder);
    void set_clock();
    Polynomial quadrature(const Polynomial& integrand, const std::string& name, bool over_slow_time);
    GeneratorId logarithm(const Polynomial& argument, const Polynomial& derivative);
    // Appends a generator to the ring; its name is made unique. exponential: the derivatives given are
    // those of its logarithm.
    GeneratorId extend(Generator g, bool exponential = false);
    void rewrite(const RingMap& map);
    void rebuild_lift();
    // Beside a slow variable: p has no derivative by it in the ring.
    [[nodiscard]] bool uses_slow_time(const Polynomial& p) const;

    struct RefinedRoot { // base (in the normal form's ring) = generator^factor
        GeneratorId base;
        std::string name;
        int factor;
    };
    std::vector<RefinedRoot> refined_;
    GeneratorId clock_ = -1;
    Polynomial clock_rate_; // d clock/dT; not constant where the slow variable relaxes
};

} // namespace resonform
