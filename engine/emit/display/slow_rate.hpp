// SPDX-License-Identifier: GPL-3.0-or-later
// The rate of a slow variable as the paper writes it: where eps enters the equations through
// xi' = eps*v alone, every eps^n v^n of an expansion is xi'^n.
#pragma once

#include "emit/display/display.hpp"
#include "expand/expansion/graded_field.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

// xi' = coefficient * eps^eps_power * product of powers
struct SlowRate {
    std::string variable;
    int eps_power = 1;
    Rational coefficient = 1;
    std::vector<std::pair<std::string, int>> powers; // generator names: the same in every ring
};

// The slow variable through whose rate alone eps enters the equations of the file, its rate being one
// monomial; nullopt if there is none.
std::optional<SlowRate> only_rate_with_eps(const GradedField& field);

// Series written with eps, or with xi' if every given part allows it.
class SeriesWriter {
public:
    // `outer`: the generators to collect by, eps among them. `all`: everything that will be written.
    SeriesWriter(RingPtr ring, GeneratorId eps, std::vector<GeneratorId> outer, std::optional<SlowRate> rate,
                 const std::vector<Polynomial>& all);

    [[nodiscard]] DisplaySum operator()(const Polynomial& p) const;
    [[nodiscard]] DisplaySum operator()(const Polynomial& p, Substitutes substitutes) const;

private:
    // c eps^n -> c / (rate / eps^eps_power)^(n/eps_power): eps then stands for xi'^(1/eps_power).
    [[nodiscard]] Polynomial divided(const Polynomial& p) const;
    [[nodiscard]] std::optional<Monomial> divided(const Monomial& m) const; // without the coefficient
    [[nodiscard]] int times(const Monomial& m) const { return ring_->exponent(m, eps_) / rate_->eps_power; }

    RingPtr ring_;
    GeneratorId eps_;
    std::vector<GeneratorId> outer_;
    std::optional<SlowRate> rate_;
};

} // namespace resonform
