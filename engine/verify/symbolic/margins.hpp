// SPDX-License-Identifier: GPL-3.0-or-later
// The margins of an exact solution, > 0 up to where its evaluator ends: of divisors that move
// (emit/program/layers.hpp), of the first corrections of the map (solve/first_correction.hpp), and of
// exponentials of slow time (solve/slow_law.hpp).
#pragma once

#include "verify/symbolic/integral.hpp"

#include <vector>

namespace resonform {

// Of a correction with its polynomials (solve/first_correction.hpp) at these values.
Wide margin_of(const FirstCorrection& correction, const std::vector<SymbolicSum>& polynomials,
               const SymbolicValues<Wide>& values, const Wide& eps, const std::vector<Wide>& moduli);

class SymbolicMargins {
public:
    explicit SymbolicMargins(const SymbolicFrame& frame); // must outlive it

    [[nodiscard]] bool empty() const;                                             // no margin moves
    [[nodiscard]] std::vector<Wide> at(const SymbolicValues<Wide>& values) const; // all but exponentials
    [[nodiscard]] Wide of(const SymbolicCorrection& added, const SymbolicValues<Wide>& values) const;
    // Draws `reach` back to before a margin fails; its status then.
    Status keep_clear(const SymbolicIntegral& integral, Wide& reach) const;

private:
    [[nodiscard]] const SymbolicSolution& solution() const { return *frame_.solution; }

    // The margins of exponentials at T. They are asked for before quadratures are tabulated, so a quadrature
    // in an exponent is taken to be T times its integrand at T.
    [[nodiscard]] std::vector<Wide> of_transients(SymbolicValues<Wide> values, const Wide& T) const;

    const SymbolicFrame& frame_;
    std::vector<const SymbolicCorrection*> corrections_; // that vary
    std::vector<const SymbolicPrimitive*> transients_;
};

} // namespace resonform
