// SPDX-License-Identifier: GPL-3.0-or-later
// Rational weights and powers of eps as multiples of one unit 1/q: sqrt(eps)*x + eps*x^3, q = 2, is held as
// e*x + e^2*x^3 over a symbol e that stands for eps^(1/q).
#pragma once

#include "algebra/number/number.hpp"
#include "model/text/toml_tree.hpp"

#include <ginac/ginac.h>

#include <optional>
#include <string>

namespace resonform {

// A weight in a file: 2, 0.5, "1/3". Errors (bad_input): negative, too large, a large denominator.
Rational weight_of(const TomlNode& node);

// An order, a claim or a time scale, 2 or "5/2", in units of 1/root as weights are held; lowest: in these
// units. Errors (bad_input): out of lowest ... highest, no multiple of 1/root.
int held_weight_of(const TomlNode& node, int root, int lowest, int highest);

class EpsPowers {
public:
    explicit EpsPowers(GiNaC::symbol eps) : eps_(std::move(eps)) {}

    // Errors (refused): the common denominator becomes too large.
    void note(const Rational& weight, const Place& place);
    // e with eps taken out of the roots of products, sqrt(a*eps) = sqrt(a)*sqrt(eps); its powers are noted.
    GiNaC::ex taken_out(const GiNaC::ex& e, const Place& place);
    // q
    [[nodiscard]] int root() const { return root_; }
    // e over the q-th root.
    [[nodiscard]] GiNaC::ex held(const GiNaC::ex& e, const GiNaC::symbol& root) const;

private:
    GiNaC::symbol eps_;
    int root_ = 1;
};

// Its name is that of the root, eps^(1/2).
GiNaC::symbol symbol_of_eps_root(int root);
// A weight as files have it: 2, "7/2".
std::string quoted_weight(const Rational& weight);
// eps^2, eps^(7/2)
std::string spell_eps_power(const Rational& power);
// The power of such a symbol as the user writes it, eps^(3/2); nullopt: the symbol is another one.
std::optional<std::string> spell_eps_power(const GiNaC::symbol& symbol, const GiNaC::numeric& exponent);

} // namespace resonform
