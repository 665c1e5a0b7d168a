// SPDX-License-Identifier: GPL-3.0-or-later
// The real form of a slow flow as nodes, at given values of its variables.
#pragma once

#include "emit/program/moment.hpp"
#include "solve/flow/real_form.hpp"

#include <map>
#include <utility>
#include <vector>

namespace resonform {

struct FlowUnit { // u + i v
    Graph::Node u = -1, v = -1;
};

// Modes (divided by eps^weight), angles, slow variables and drifts, in the order of the field.
struct FlowValues {
    std::vector<FlowUnit> modes, angles;
    std::vector<Graph::Node> slow, drift;
    std::vector<Graph::Node> moduli = {}; // u^2 + v^2 of modes where that is a constant, else -1; or empty
};

// p/eps^power before it is lowered to nodes: real and imaginary part multiplied out, or, where that is much
// longer, sums over what turns alike times products of the units.
struct FlowSum {
    struct Harmonic {
        std::vector<int> turns; // RealForm::Harmonic
        std::vector<Fraction> re, im;
    };
    bool real = false; // the imaginary part is not asked for
    std::vector<Fraction> re, im;
    std::vector<Harmonic> harmonics; // if it is not multiplied out
};
using FlowSums = std::map<std::pair<const Series*, int>, FlowSum>; // of a series through a weight
FlowSum flow_sum(const RealForm& real_form, const Polynomial& p, int power, bool real);

class FlowMoment {
public:
    using Unit = FlowUnit;
    // named: radicands get names for readers.
    FlowMoment(Program& program, const RealForm& real, const Surroundings& surroundings,
               const FlowValues& values, bool named);

    // u + i v; products of the units are formed once.
    Unit value(const FlowSum& sum);
    Unit value(const Polynomial& p, int power, bool real) { return value(flow_sum(real_, p, power, real)); }

    Lowering lowering;

private:
    void define_moduli();
    Unit sum_of_harmonics(const FlowSum& sum);
    Unit times(const Unit& a, const Unit& b);
    Unit power(std::size_t unit, int turns);
    Unit product(std::vector<int> turns);

    Graph& graph_;
    const RealForm& real_;
    std::vector<Unit> units_; // of modes, then of angles
    std::map<std::pair<std::size_t, int>, Unit> powers_;
    std::map<std::vector<int>, Unit> products_;
};

// A state of the user as the field has it: less its shift (GradedField::shift), which is often 0.
Graph::Node measured_from(Graph& graph, Graph::Node state, const Lowering& at, const RealForm& real,
                          const Polynomial& shift);

// p/eps^power. Precondition: every term of p has at least that power of eps.
Polynomial over_eps(const RealForm& real, const Polynomial& p, int power);

} // namespace resonform
