// SPDX-License-Identifier: GPL-3.0-or-later
// The near-identity map of a solution at t = 0, in 50 digits.
#pragma once

#include "normalize/recursion/substitutions.hpp"
#include "solve/near_identity.hpp"
#include "verify/symbolic/ring.hpp"

#include <vector>

namespace resonform {

// Old variables or new ones; modes divided by eps^weight.
struct SymbolicStartValues {
    std::vector<WideComplex> modes;
    std::vector<Wide> angles, slow;
};

class SymbolicMap {
public:
    // ring: of the normal form
    SymbolicMap(const Solution& solution, const SymbolicRing& ring);

    struct Shifts {
        std::vector<SymbolicSum> mode, angle, slow, drift;
    };
    [[nodiscard]] Shifts shifts(const NearIdentityMap& map) const;
    // Without drifts, as far as a substitution takes them.
    [[nodiscard]] Shifts shifts(const NearIdentityMap& map, const SubstitutionStep& step) const;
    [[nodiscard]] const Shifts& map() const { return map_; }
    [[nodiscard]] Wide scale_of_mode(std::size_t k, const Wide& eps) const;

    // False: a radicand is not positive.
    bool set(SymbolicValues<Wide>& values, const Wide& eps, const SymbolicStartValues& at) const;
    // `from` plus or minus the shifts `by`, evaluated at `values`.
    [[nodiscard]] SymbolicStartValues moved(const SymbolicStartValues& from, const Shifts& by,
                                            const SymbolicValues<Wide>& values, const Wide& eps,
                                            int sign) const;

    // Old and new variables. `old.modes` of modes that start from constants is not looked at.
    struct Pair {
        SymbolicStartValues old, now;
        struct Drift {
            bool checked = false;
            Wide old = 0, now = 0;
            std::vector<Wide> terms = {}; // of `now`, where it is a sum
        };
        std::vector<Drift> drift; // or empty
        bool from_constants = false;
    };
    // The conditions of solve/near_identity.hpp. Variables that depend on start values not taken by
    // the evaluator, which are NaN in `pair`, are not checked.
    [[nodiscard]] bool leads_back(const Pair& pair, const SymbolicInputs& inputs) const;
    // The same condition for a factor of an amplitude.
    [[nodiscard]] static bool is_close_to_one(const Wide& factor, const SymbolicInputs& inputs);

private:
    [[nodiscard]] const SymbolicSum& sum_of(const MovedVariable& v) const;
    [[nodiscard]] StartShifts<WideComplex> shifts_at(const Pair& pair, const SymbolicInputs& inputs) const;

    const GradedField& field_;
    int truncation_;
    const SymbolicRing& ring_;
    std::vector<MovedVariable> moved_;
    std::vector<std::vector<SymbolicSum>> forced_; // of each
    Shifts map_;
};

} // namespace resonform
