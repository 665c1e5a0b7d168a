// SPDX-License-Identifier: GPL-3.0-or-later
// Signs and relations of expressions of weight 0 in which symbols stand for functions: E for exp(tau/2),
// s and c for sin(tau) and cos(tau).
#pragma once

#include "model/exact/first_order_system.hpp"

#include <ginac/ginac.h>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace resonform {

// The inverse of a number made of roots in their own form; nullopt: the roots depend on one another.
using InverseOfNumber = std::function<std::optional<GiNaC::ex>(const GiNaC::ex& number, const Place& place)>;

class CoefficientDomain {
public:
    CoefficientDomain(const System& system, InverseOfNumber inverse)
        : inverse_of_number(std::move(inverse)), system_(&system) {}

    InverseOfNumber inverse_of_number; // uses a ring, which in turn uses this domain

    void add(const GiNaC::ex& symbol, const GiNaC::ex& meaning) {
        meanings_[symbol] = meaning;
        symbols_.push_back(symbol);
    }
    void add_circle(const GiNaC::ex& sine, const GiNaC::ex& cosine) { circles_.emplace_back(sine, cosine); }

    // Proved, with the functions themselves in the place of their symbols.
    [[nodiscard]] bool positive(const GiNaC::ex& e) const;
    [[nodiscard]] bool nonzero(const GiNaC::ex& e) const;
    [[nodiscard]] GiNaC::ex meaning(const GiNaC::ex& e) const;
    // e expanded, with s^2 = 1 - c^2.
    [[nodiscard]] GiNaC::ex expanded(const GiNaC::ex& e) const;
    // Is e a polynomial in parameters, slow variables and symbols of functions?
    [[nodiscard]] bool polynomial(const GiNaC::ex& e) const;

private:
    const System* system_;
    GiNaC::exmap meanings_;
    std::vector<GiNaC::ex> symbols_;
    std::vector<std::pair<GiNaC::ex, GiNaC::ex>> circles_;
};

} // namespace resonform
