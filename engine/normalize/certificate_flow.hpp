// SPDX-License-Identifier: GPL-3.0-or-later
// The jets of the old variables along the normal form: z = w + h, X = Z + l, and time derivatives by
// the chain rule  s' = sum over generators g of (ds/dg) g',  with
//   w' = N,  wbar' = conj N,  xi' = slow rate,  eps' = 0,  sigma' = P'/(k sigma^(k-1)).
// Independent of Ring's products, derivatives and conjugation: only exponents and coefficients are read.
#pragma once

#include "normalize/certificate_equation.hpp"
#include "normalize/normal_form.hpp"

#include <optional>

namespace resonform {

// The conjugate side reads i as -i and swaps the modes of a pair.
enum class Side { itself, conjugate };

// A value and its partial derivatives by the generators that occur in it.
template <class Value> struct Gradient {
    Value value;
    std::vector<std::pair<GeneratorId, Value>> slopes;
};

template <class Value> struct Moving { Value value, rate; };

// What is substituted into the equations, and what must vanish besides them: psi' - d/dt psi.
template <class Value> struct Jets {
    SymbolValues<Value> symbols;
    std::vector<std::pair<std::size_t, Value>> velocity_defects; // by variable
};

// The Algebra of EquationEvaluator with gradient(Series, Side) besides.
template <class Algebra> class Flow {
public:
    using Value = typename Algebra::Value;

    Flow(Algebra& algebra, const NormalForm& normal_form, const NearIdentityMap& map)
        : algebra_(algebra), normal_form_(normal_form), map_(map), field_(*normal_form.field),
          rates_(static_cast<std::size_t>(field_.ring->size())) {
        for (std::size_t k = 0; k < field_.modes.size(); ++k) {
            rate(field_.modes[k].z) = value(normal_form.mode[k], Side::itself);
            rate(field_.modes[k].zbar) = value(normal_form.mode[k], Side::conjugate);
        }
        for (std::size_t k = 0; k < field_.slow.size(); ++k)
            rate(field_.slow[k].generator) = value(normal_form.slow[k], Side::itself);
        for (GeneratorId id = 0; id < field_.ring->size(); ++id)
            if (field_.ring->generator(id).kind == GeneratorKind::root) rate(id) = root_rate(id);
    }

    Jets<Value> jets() const {
        Jets<Value> result;
        const System& system = field_.system();
        result.symbols[system.eps] = algebra_.generator(field_.eps, 1);
        for (GeneratorId id = 0; id < field_.ring->size(); ++id)
            if (const Parameter* p = parameter(id)) result.symbols[p->symbol] = algebra_.generator(id, 1);
        for (std::size_t k = 0; k < field_.slow.size(); ++k) {
            const auto& jet = system.variables[field_.slow[k].variable].jet;
            result.symbols[jet[0]] = algebra_.generator(field_.slow[k].generator, 1);
            result.symbols[jet[1]] = value(normal_form_.slow[k], Side::itself);
        }
        for (std::size_t k = 0; k < field_.drift.size(); ++k)
            result.symbols[system.variables[field_.drift[k].variable].jet[1]] = algebra_.add(
                value(normal_form_.drift[k], Side::itself), follow(map_.drift[k], Side::itself).rate);
        for (std::size_t k = 0; k < field_.modes.size(); ++k) add_oscillator(k, result);
        return result;
    }

private:
    std::optional<Value>& rate(GeneratorId id) { return rates_[static_cast<std::size_t>(id)]; }

    const Parameter* parameter(GeneratorId id) const {
        const Generator& g = field_.ring->generator(id);
        return g.kind == GeneratorKind::parameter ? field_.system().parameter(g.name) : nullptr;
    }

    Value value(const Series& s, Side side) const { return algebra_.gradient(s, side).value; }

    Moving<Value> follow(const Series& s, Side side) const {
        Gradient<Value> gradient = algebra_.gradient(s, side);
        Value total = algebra_.number(0);
        for (const auto& [id, slope] : gradient.slopes) {
            const GeneratorId partner = field_.ring->generator(id).conjugate;
            const GeneratorId moved = side == Side::conjugate && partner >= 0 ? partner : id;
            if (const auto& r = rates_[static_cast<std::size_t>(moved)])
                total = algebra_.add(total, algebra_.multiply(slope, *r));
        }
        return {std::move(gradient.value), std::move(total)};
    }

    Value root_rate(GeneratorId id) const {
        const Generator& root = field_.ring->generator(id);
        const Value slope = algebra_.multiply(algebra_.number(Rational(1) / root.index),
                                              algebra_.generator(id, 1 - root.index));
        return algebra_.multiply(slope, follow(Series({root.radicand}), Side::itself).rate);
    }

    // z = w + h with its rate.
    Moving<Value> mode(std::size_t k, Side side) const {
        const Mode& m = field_.modes[k];
        const GeneratorId w = side == Side::itself ? m.z : m.zbar;
        Moving<Value> shift = follow(map_.mode[k], side);
        return {algebra_.add(algebra_.generator(w, 1), shift.value),
                algebra_.add(*rates_[static_cast<std::size_t>(w)], shift.rate)};
    }

    // psi = (z + zbar)/2,  psi' = i omega (z - zbar)/2,  psi'' = i (omega' (z - zbar) + omega (z' - zbar'))/2
    void add_oscillator(std::size_t k, Jets<Value>& result) const {
        const Moving<Value> z = mode(k, Side::itself), zbar = mode(k, Side::conjugate);
        const Moving<Value> omega = follow(Series({field_.modes[k].omega}), Side::itself);
        const Value half = algebra_.number(Rational(1) / 2), minus = algebra_.number(-1);
        const Value half_i = algebra_.multiply(half, algebra_.generator(Ring::imaginary_unit, 1));
        const Value difference = algebra_.add(z.value, algebra_.multiply(minus, zbar.value));
        const Value difference_rate = algebra_.add(z.rate, algebra_.multiply(minus, zbar.rate));
        const Value velocity = algebra_.multiply(half_i, algebra_.multiply(omega.value, difference));
        const Value position_rate = algebra_.multiply(half, algebra_.add(z.rate, zbar.rate));

        const auto& jet = field_.system().variables[field_.modes[k].variable].jet;
        result.symbols[jet[0]] = algebra_.multiply(half, algebra_.add(z.value, zbar.value));
        result.symbols[jet[1]] = velocity;
        result.symbols[jet[2]] =
            algebra_.multiply(half_i, algebra_.add(algebra_.multiply(omega.rate, difference),
                                                   algebra_.multiply(omega.value, difference_rate)));
        result.velocity_defects.emplace_back(field_.modes[k].variable,
                                             algebra_.add(velocity, algebra_.multiply(minus, position_rate)));
    }

    Algebra& algebra_;
    const NormalForm& normal_form_;
    const NearIdentityMap& map_;
    const GradedField& field_;
    std::vector<std::optional<Value>> rates_; // absent: constant
};

} // namespace resonform
