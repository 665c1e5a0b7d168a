// SPDX-License-Identifier: GPL-3.0-or-later
// An exact expression -> nodes of a SeriesProgram over a CoefficientRing:
//
//   g*sin(psi)/sqrt(xi^2 + r^2)  ->  product(constant(G^2/sigma^2), sine(input psi))
#pragma once

#include "algebra/series/series_program.hpp"
#include "expand/ring/coefficient_ring.hpp"
#include "model/text/named_function.hpp"

#include <map>

namespace resonform {

class Translator {
public:
    // coefficients must be frozen and outlive the translator, as must the program.
    Translator(SeriesProgram& program, const CoefficientRing& coefficients)
        : program_(program), coefficients_(coefficients) {}

    // The node that stands for a symbol of positive weight.
    void bind(const GiNaC::ex& symbol, SeriesProgram::Node node);
    // An angle phi = theta + m: `phase` is e^{i theta}, `shift` is m, of positive weight.
    void bind_angle(const GiNaC::ex& symbol, GeneratorId phase, SeriesProgram::Node shift);

    // A function of mixed weight, sin(tau + psi), is split by addition theorems.
    // Errors (refused): functions that have no expansion here; (bad_input): division by an expression that
    // vanishes at the origin.
    SeriesProgram::Node operator()(const GiNaC::ex& e, const Place& place);

private:
    struct Angle {
        GiNaC::ex symbol;
        SeriesProgram::Node forward, backward; // e^{i phi}, e^{-i phi}
    };

    SeriesProgram::Node translate(const GiNaC::ex& e, const Place& place);
    SeriesProgram::Node product(const GiNaC::ex& e, const Place& place);
    SeriesProgram::Node power(const GiNaC::ex& e, const Place& place);
    void require_small(const GiNaC::ex& function, const Place& place) const;
    SeriesProgram::Node function(const GiNaC::ex& e, const Place& place);
    [[nodiscard]] bool holds_angle(const GiNaC::ex& e) const;
    SeriesProgram::Node of_angles(const GiNaC::ex& e, const Place& place);
    SeriesProgram::Node named(const NamedCall& call, const GiNaC::ex& u0, SeriesProgram::Node rest,
                              const Place& place);
    SeriesProgram::Node sum(SeriesProgram::Node a, SeriesProgram::Node b);
    SeriesProgram::Node quotient(SeriesProgram::Node a, SeriesProgram::Node b);

    SeriesProgram& program_;
    const CoefficientRing& coefficients_;
    std::map<GiNaC::ex, SeriesProgram::Node, GiNaC::ex_is_less> nodes_; // look-up only, never iterated
    std::vector<Angle> angles_;
};

} // namespace resonform
