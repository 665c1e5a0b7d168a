// SPDX-License-Identifier: GPL-3.0-or-later
// The generators of a ring that do not depend on the solution at hand, as numbers: eps, parameters, pi, the
// roots, whose radicands must be positive, and functions, whose arguments must be in their domain.
#pragma once

#include "model/system/system_file.hpp"
#include "verify/run/spline.hpp"
#include "verify/symbolic/functions.hpp"
#include "verify/symbolic/terms.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace resonform {

// The inputs of an evaluator. Start values by canonical name ("xi", "psi'", "amplitude.psi", "constant.x");
// parameters only where the scene does not fix them.
struct SymbolicInputs {
    Wide eps;
    std::map<std::string, Wide> parameters, start;
    Wide slow_time_end;                 // times with eps t beyond it have a status
    std::set<std::string> untaken = {}; // start values that the evaluator does not take: no output needs them

    // 0 where it is not given, as in emitted code.
    [[nodiscard]] Wide start_of(const std::string& canonical) const;
    // The same with NaN for start values that are not taken.
    [[nodiscard]] SymbolicInputs blind() const;
};

class SymbolicRing {
public:
    using Fix = std::map<std::string, GiNaC::ex>; // of Scene::fix
    SymbolicRing(RingPtr ring, const Fix& fix, const System& system);

    [[nodiscard]] const Fix& fix() const { return fix_; }

    [[nodiscard]] const FixedRing& fixed() const { return fixed_; }
    [[nodiscard]] const Ring& ring() const { return fixed_.ring(); }
    // The ring's eps, by whose powers weights count.
    [[nodiscard]] Wide small(const SymbolicInputs& inputs) const;
    // i, eps, parameters and pi are set.
    [[nodiscard]] SymbolicValues<Wide> constants(const SymbolicInputs& inputs) const;

    struct Root { // or a function of its radicand
        GeneratorId id;
        int index;
        bool divisor; // of any sign
        SymbolicSum radicand;
        SymbolicSum positive; // must be > 0; empty: nothing must
        std::optional<Function> function = {};
        DataPointer data = nullptr; // of a named function
        int derivative = 0;
    };
    [[nodiscard]] const std::vector<Root>& roots() const { return roots_; } // those without a fixed value
    // Precondition: the generators in radicands are set. False: a radicand that has to be positive is not.
    bool set_roots(SymbolicValues<Wide>& values) const;

    template <class Number>
    static void set_root(const Root& root, Number radicand, SymbolicValues<Number>& values) {
        if (root.data != nullptr || root.function) {
            values.set(root.id, value_of_call(root, radicand));
            return;
        }
        int index = root.index;
        for (; index % 2 == 0; index /= 2) radicand = square_root(radicand);
        values.set(root.id, index == 1 ? radicand : math::root(radicand, index));
    }
    // The same for one that moves, with its scale. Where a function f(x) passes through zero that is not |f|,
    // but what last places of x are worth, |f'(x)| (scale of x), by a difference quotient: a digit or two
    // will do. Where a divisor comes near zero, or a radicand does, what cancels there is in the scale.
    template <class Number> static void set_moving_root(const Root& root, SymbolicValues<Number>& values) {
        const Number x = value_of(root.radicand, values).re;
        set_root(root, x, values);
        if (!root.function && root.data == nullptr) {
            if (x == 0) return;
            const Number terms =
                root.divisor ? scale_of(root.radicand, values) : sizes_of_terms(root.radicand, values);
            values.set_condition(root.id, Number(1 + (terms / math::magnitude(x) - 1) / root.index));
        } else if (root.function && *root.function != Function::exponential) {
            const Number step(1e-8), value = values[root.id].re;
            const Number change =
                value_of_call(root, Number(x + step * scale_of(root.radicand, values))) - value;
            const Number worth = math::magnitude(change) / step;
            if (math::finite(worth) && worth > math::magnitude(value))
                values.set(root.id, {value, Number(0)}, worth);
        }
    }

private:
    template <class Number> static Number value_of_call(const Root& root, const Number& x) {
        if (root.data != nullptr) return Number(spline(spline_of(*root.data), root.derivative, x));
        return value_of_function(*root.function, x);
    }

    Fix fix_;
    std::map<std::string, Wide> irrational_; // of fix
    FixedRing fixed_;
    std::vector<Root> roots_;
};

} // namespace resonform
