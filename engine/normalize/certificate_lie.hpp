// SPDX-License-Identifier: GPL-3.0-or-later
// The flow of a generator at one point: y(tau) with dy_a/dtau = {y_a, chi}(y), y(0) = w, as a power series
// in tau whose coefficients are truncated series of residues. exp(L_chi) w is y(1). No bracket of
// polynomials is formed, unlike in the Lie series that it is compared with.
#pragma once

#include "normalize/certificate_point.hpp"
#include "normalize/normal_form.hpp"

#include <map>
#include <vector>

namespace resonform {

class FlowAtPoint {
public:
    using Value = PointAlgebra::Value;

    // tau^k comes with weights above k: powers through `orders` are enough for weights through
    // orders + the weight of the modes.
    FlowAtPoint(const PointAlgebra& algebra, const Ring& ring, const HamiltonianForm& form, int orders);

    // y_a(1)
    [[nodiscard]] Value at_one(GeneratorId coordinate) const;

private:
    using TauSeries = std::vector<Value>; // by power of tau
    struct Term {                         // of chi: coefficient * product of coordinates
        Value coefficient;
        std::vector<std::pair<GeneratorId, int>> powers;
    };

    void read(const Ring& ring, const Series& generator);
    // y'_a through tau^k, from y through tau^k
    [[nodiscard]] std::map<GeneratorId, TauSeries> velocity(std::size_t k) const;
    [[nodiscard]] TauSeries multiply(const TauSeries& a, const TauSeries& b) const;
    void add(TauSeries& sum, const TauSeries& addend) const;
    [[nodiscard]] TauSeries scaled(const TauSeries& a, const Value& factor) const;

    const PointAlgebra& algebra_;
    const HamiltonianForm& form_;
    std::vector<Term> terms_;
    std::map<GeneratorId, TauSeries> y_;
};

} // namespace resonform
