// SPDX-License-Identifier: GPL-3.0-or-later
// The error of a formula of order N with normal form and map through weight M, read from a solution of higher
// order: the first power of eps at which an output differs on t <= T/eps^p.
//
//   psi of the pendulum, M = N = 3: the phase rate has a part of weight 3, which is eps^2 over 1/eps, and psi
//   oscillates at eps  ->  3
//
// An error is followed from where it arises to the output, at each step with the lowest power that is not
// zero:
//   rates above weight M       act over eps^-p on the modulus or the argument of a mode, a phase, an angle, a
//                              slow variable, a drift; above N (M, where it may grow), over times of order 1,
//                              on a mode that decays;
//   the start above weight M   acts as it is;
//   each of these              acts through the rates of others, over eps^-p once more, and through the map;
//   the output above eps^N     is missing; a mean motion also lacks all oscillating terms.
// A coefficient that vanishes identically carries nothing, so all this holds for every start.
#pragma once

#include "normalize/recursion/inverse_map.hpp"
#include "solve/solution.hpp"

#include <optional>
#include <string>
#include <vector>

namespace resonform {

// eps^power; sure: its coefficient was proved not to vanish. Else it may be smaller.
struct ErrorPower {
    int power;
    bool sure;
};

struct TruncatedFormula {
    int order = 0, truncation = 0; // N, M
    int time_power = 1;            // p
    bool oscillating = true;       // false: outputs are mean motions
    bool from_constants = false;   // of the solution; false: from physical values, by the inverse map
};

class Neglected {
public:
    // richer: of the same system, its order >= N and its truncation > M. Errors (refused): those of
    // slow_flow; errors that feed on each other faster than eps^p, so that no power bounds them.
    Neglected(const Solution& richer, const TruncatedFormula& formula);

    // nullopt: the formula leaves out nothing that `richer` contains.
    [[nodiscard]] std::optional<ErrorPower> power(const std::string& output) const;

private:
    enum class Kind { modulus, argument, phase, decay, angle, slow, drift };
    struct Quantity { // a quantity and its error
        Kind kind;
        std::size_t index;
        int scale;      // a rate of weight n moves it at eps^(n - scale)
        int time_power; // p; 0: it matters on times of order 1 only
        int through;    // the largest weight of its rate that the formula has
        ErrorPower error;
    };
    struct Influence {
        std::size_t from, on;
        ErrorPower times;
    };

    void add_quantities();
    void add_rates();
    void add_rate(std::size_t on, int weight, const Polynomial& rate, bool exact = false);
    void add_series_errors(); // closed solutions: truncated power series
    void add_start_errors();
    void spread();
    void lower_of(Kind kind, std::size_t index, const ErrorPower& error);
    [[nodiscard]] Zero insensitive(const Polynomial& p, const Quantity& what, const Quantity* rate_of) const;
    [[nodiscard]] Zero missing(const FlowOutput& output, int weight) const;

    const Solution& richer_;
    TruncatedFormula formula_;
    const GradedField& field_;
    const Ring& ring_;
    SlowFlow flow_;
    bool by_series_; // in closed form, on times on which T = eps t is not large
    std::vector<Quantity> quantities_;
    std::vector<Influence> influences_;
};

} // namespace resonform
