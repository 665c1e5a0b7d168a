// SPDX-License-Identifier: GPL-3.0-or-later
// The variables of a symbolic solution that have no law of their own, integrated in slow time: first the slow
// flow, whose variables are coupled, then the quadratures along it.
#pragma once

#include "runtime/interval.hpp"
#include "verify/symbolic/solution.hpp"

#include <functional>
#include <memory>
#include <vector>

namespace resonform {

enum class SymbolicMotion { rests, uniform, relaxes, computed };

// Numbers at one start, before anything is integrated.
struct SymbolicFrame {
    std::shared_ptr<const SymbolicSolution> solution;
    Wide small; // the ring's eps
    SymbolicStart start;
    SymbolicValues<Wide> constants; // generators at T = 0, phases left out of modes and angles
    std::vector<bool> moves;        // generators
    struct Variable {
        SymbolicMotion motion = SymbolicMotion::rests;
        WideComplex start, speed; // uniform: start + speed T
        Wide decline = 0;         // relaxes: d/dT = speed.re - decline times itself
    };
    std::vector<Variable> variables;      // one for each of the solution's
    std::vector<std::size_t> flow, along; // indices of those that are integrated

    SymbolicFrame(std::shared_ptr<const SymbolicSolution> s, const SymbolicInputs& inputs);
    [[nodiscard]] bool any_moves(const SymbolicSum& sum) const;
};

// The moving generators at one T.
template <class Number> struct SymbolicMoment {
    using Complex = ComplexNumber<Number>;
    SymbolicValues<Number> values;
    std::vector<Complex> now; // of each variable

    explicit SymbolicMoment(const SymbolicFrame& frame);
    // Sets the variables of known motion, then all generators. Precondition: `now` of the others is set.
    void move_to(const SymbolicFrame& frame, const Number& T);
    // Of the variable k, from its start; returns the size of what `now` is the sum of.
    Number move_along_path(const SymbolicFrame& frame, std::size_t k, const Number& T);
    // The generators of a mode that has the value a: eps^weight a.
    void put_mode(const SymbolicFrame& frame, const SymbolicVariable& variable, const Complex& a);
};

class SymbolicIntegral {
public:
    virtual ~SymbolicIntegral() = default;
    // Status and `reach` as FlowTable::build_while; without goes_on, as build.
    using GoesOn = std::function<bool(const SymbolicMoment<Wide>&)>;
    virtual Status build_flow(const GoesOn& goes_on, Wide& reach) = 0;
    virtual Status build_along(Wide& reach) = 0;
    // Sets the variables integrated so far, then everything else.
    virtual void move_to(const Wide& T, SymbolicMoment<Wide>& moment) const = 0;
    // After build_flow: computes how well the variables of the flow can be known up to `reach`. beyond(): the
    // excess of SymbolicPropagation over |value| at T, real and imaginary parts of modes apart.
    virtual void propagate(const Wide& reach) = 0;
    struct Beyond {
        std::size_t variable;
        bool imaginary;
        Wide size;
    };
    [[nodiscard]] virtual std::vector<Beyond> beyond(const SymbolicMoment<Wide>& moment,
                                                     const Wide& T) const = 0;
};

// In 50 digits; with a flow in 33, of which about 30 are right while neighbouring solutions do not part.
// most_panels: of a FlowTable.
std::unique_ptr<SymbolicIntegral> symbolic_integral(const SymbolicFrame& frame, std::size_t most_panels);

} // namespace resonform
