// SPDX-License-Identifier: GPL-3.0-or-later
// Quadratures of a solution as tables over slow time. Where an output has several with constant
// coefficients, one table holds their sum:  eps^2 Q_1 + eps^3 c Q_2 -> int (eps^2 q_1 + eps^3 c q_2) dT.
#pragma once

#include "emit/program/moment.hpp"

#include <map>
#include <string>
#include <utility>

namespace resonform {

class Quadratures {
public:
    Quadratures(Program& program, const Solution& solution) : program_(program), solution_(solution) {}

    // d(slow variable)/dT, a constant: turns an integral over the slow variable into one over T. Where it is
    // none, all integrals are over T.
    void set_clock_rate(Graph::Node rate) { clock_rate_ = rate; }

    // A table of this quadrature alone; its value.
    Graph::Node value(const Primitive& primitive, Lowering& lowering);

    // p with T q(T) for each quadrature q from 0 to T: about as large, and no table is needed.
    Graph::Node without_tables(const Polynomial& p, const Lowering& lowering) const;

    // Takes the terms coefficient * quadrature with constant coefficients out of p (in the ring of the
    // solution, by powers of eps): returns the rest, and the value of one table for the sum of the terms.
    std::pair<Polynomial, Graph::Node> extract(const Polynomial& p, Moment& call, const std::string& name);

private:
    Graph::Node table(const std::string& name, Graph::Node integrand);
    [[nodiscard]] const Primitive* only_quadrature(const Monomial& m, const Moment& call) const;

    Program& program_;
    const Solution& solution_;
    Graph::Node clock_rate_ = -1;
    std::map<GeneratorId, Graph::Node> integrands_; // over T
};

} // namespace resonform
