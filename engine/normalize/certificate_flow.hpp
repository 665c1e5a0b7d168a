// SPDX-License-Identifier: GPL-3.0-or-later
// The jets of the old variables along the normal form: z = w + h, phi = theta + m, xi = zeta + k, X = Z + l,
// u = T(xi) z, and time derivatives by the chain rule  s' = sum over generators g of (ds/dg) g',  with
//   w' = N,  wbar' = conj N,  zeta' = N,  (e^{i theta})' = i e^{i theta} N,  eps' = 0,
//   sigma' = P'/(k sigma^(k-1)).
// Independent of Ring's products, derivatives and conjugation: only exponents and coefficients are read.
#pragma once

#include "normalize/certificate_equation.hpp"
#include "normalize/certificate_functions.hpp"
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

// What is substituted into the equations, and what must vanish besides them: psi' - d/dt psi.
template <class Value> struct Jets {
    Substituted<Value> values;
    std::vector<std::pair<std::size_t, Value>> velocity_defects; // by variable
};

// The Algebra of EquationEvaluator with gradient(Series, Side) besides.
template <class Algebra> class Flow {
public:
    using Value = typename Algebra::Value;

    Flow(Algebra& algebra, CertificateRoots& roots, const NormalForm& normal_form, const NearIdentityMap& map)
        : algebra_(algebra), roots_(roots), normal_form_(normal_form), map_(map), field_(*normal_form.field),
          rates_(static_cast<std::size_t>(field_.ring->size())) {
        for (std::size_t k = 0; k < field_.modes.size(); ++k) {
            rate(field_.modes[k].z) = value(normal_form.mode[k], Side::itself);
            if (!field_.modes[k].is_real())
                rate(field_.modes[k].zbar) = value(normal_form.mode[k], Side::conjugate);
        }
        for (std::size_t k = 0; k < field_.slow.size(); ++k)
            rate(field_.slow[k].generator) = value(normal_form.slow[k], Side::itself);
        for (std::size_t k = 0; k < field_.angles.size(); ++k)
            rate(field_.angles[k].phase) = times_i(algebra_.multiply(
                algebra_.generator(field_.angles[k].phase, 1), value(normal_form.angle[k], Side::itself)));
        for (GeneratorId id = 0; id < field_.ring->size(); ++id)
            if (field_.ring->generator(id).kind == GeneratorKind::root)
                rate(id) = root_rate(id);
            else if (field_.ring->generator(id).kind == GeneratorKind::function)
                rate(id) = function_rate(algebra_, *field_.ring, id, follow_argument(id));
    }

    Jets<Value> jets() const {
        Jets<Value> result;
        add_constants(result.values);
        add_slow(result.values);
        add_angles(result.values);
        for (std::size_t k = 0; k < field_.drift.size(); ++k)
            result.values.symbols[jet(field_.drift[k].variable, 1)] = algebra_.add(
                value(normal_form_.drift[k], Side::itself), follow(map_.drift[k], Side::itself).rate);
        add_fast(result);
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
            require_known_rate(*field_.ring, id);
            const GeneratorId partner = field_.ring->generator(id).conjugate;
            const GeneratorId moved = side == Side::conjugate && partner >= 0 ? partner : id;
            const auto& r = rates_[static_cast<std::size_t>(moved)];
            if (!r) continue;
            // (1/E)' = -E'/E^2
            const bool inverse =
                side == Side::conjugate && field_.ring->generator(id).kind == GeneratorKind::phase;
            const Value moved_rate = inverse ? minus(algebra_.multiply(algebra_.generator(id, -2), *r)) : *r;
            total = algebra_.add(total, algebra_.multiply(slope, moved_rate));
        }
        return {std::move(gradient.value), std::move(total)};
    }

    Moving<Value> follow_argument(GeneratorId id) const {
        return follow(Series({field_.ring->generator(id).of.argument}), Side::itself);
    }

    Value root_rate(GeneratorId id) const {
        const Generator& root = field_.ring->generator(id);
        const Value slope = algebra_.multiply(algebra_.number(Rational(1) / root.index),
                                              algebra_.generator(id, 1 - root.index));
        return algebra_.multiply(slope, follow(Series({root.radicand}), Side::itself).rate);
    }

    Value times_i(const Value& v) const {
        return algebra_.multiply(algebra_.generator(Ring::imaginary_unit, 1), v);
    }
    Value minus(const Value& v) const { return algebra_.multiply(algebra_.number(-1), v); }

    const GiNaC::symbol& jet(std::size_t variable, std::size_t derivative) const {
        return field_.system().variables[variable].jet[derivative];
    }

    void add_constants(Substituted<Value>& values) const {
        values.symbols[field_.system().eps] = algebra_.generator(field_.eps, 1);
        for (GeneratorId id = 0; id < field_.ring->size(); ++id)
            if (const Parameter* p = parameter(id)) values.symbols[p->symbol] = algebra_.generator(id, 1);
    }

    void add_slow(Substituted<Value>& values) const {
        for (std::size_t k = 0; k < field_.slow.size(); ++k) {
            const SlowVariable& slow = field_.slow[k];
            const Moving<Value> shift = follow(map_.slow[k], Side::itself);
            values.symbols[jet(slow.variable, 0)] =
                algebra_.add(algebra_.generator(slow.generator, 1), shift.value);
            values.symbols[jet(slow.variable, 1)] =
                algebra_.add(value(normal_form_.slow[k], Side::itself), shift.rate);
        }
    }

    // e^{i phi} = e^{i theta} e^{i m},  phi' = theta' + m'
    void add_angles(Substituted<Value>& values) const {
        for (std::size_t k = 0; k < field_.angles.size(); ++k) {
            const AngleVariable& angle = field_.angles[k];
            const Moving<Value> shift = follow(map_.angle[k], Side::itself);
            const Value turn = times_i(shift.value);
            values.angles.push_back(
                {jet(angle.variable, 0),
                 algebra_.multiply(algebra_.generator(angle.phase, 1),
                                   algebra_.function(Elementary::exponential, turn)),
                 algebra_.multiply(algebra_.generator(angle.phase, -1),
                                   algebra_.function(Elementary::exponential, minus(turn)))});
            values.symbols[jet(angle.variable, 1)] =
                algebra_.add(value(normal_form_.angle[k], Side::itself), shift.rate);
        }
    }

    // z = w + h with its rate.
    Moving<Value> mode(std::size_t k, Side side) const {
        const Mode& m = field_.modes[k];
        const GeneratorId w = side == Side::itself ? m.z : m.zbar;
        Moving<Value> shift = follow(map_.mode[k], side);
        return {algebra_.add(algebra_.generator(w, 1), shift.value),
                algebra_.add(*rates_[static_cast<std::size_t>(w)], shift.rate)};
    }

    // An entry of T at the old slow variables, with its rate.
    Moving<Value> entry(const GiNaC::ex& e, const Substituted<Value>& values,
                        const Equation& equation) const {
        EquationEvaluator<Algebra> evaluate(algebra_, roots_, values, equation);
        Moving<Value> result{evaluate(e), algebra_.number(0)};
        for (const SlowVariable& slow : field_.slow) {
            const GiNaC::ex slope = e.diff(jet(slow.variable, 0));
            if (slope.is_zero()) continue;
            result.rate = algebra_.add(result.rate,
                                       algebra_.multiply(evaluate(slope), evaluate(jet(slow.variable, 1))));
        }
        return result;
    }

    void add_product(Moving<Value>& sum, const Moving<Value>& a, const Moving<Value>& b) const {
        sum.value = algebra_.add(sum.value, algebra_.multiply(a.value, b.value));
        sum.rate = algebra_.add(
            sum.rate, algebra_.add(algebra_.multiply(a.rate, b.value), algebra_.multiply(a.value, b.rate)));
    }

    // u_s = sum over modes of re (z + zbar) + i im (z - zbar)
    Moving<Value> state(std::size_t s, const std::vector<Moving<Value>>& modes,
                        const std::vector<Moving<Value>>& conjugates, const Substituted<Value>& values,
                        const Equation& equation) const {
        Moving<Value> u{algebra_.number(0), algebra_.number(0)};
        for (std::size_t k = 0; k < modes.size(); ++k) {
            const Complex& column = field_.basis.modes[k].column[s];
            const bool real = field_.modes[k].is_real();
            const auto combined = [&](const auto& change) {
                Moving<Value> sum = modes[k];
                if (real) return sum;
                sum.value = algebra_.add(sum.value, change(conjugates[k].value));
                sum.rate = algebra_.add(sum.rate, change(conjugates[k].rate));
                return sum;
            };
            if (!column.re.is_zero())
                add_product(u, entry(column.re, values, equation),
                            combined([](const Value& v) { return v; }));
            if (column.im.is_zero()) continue;
            const Moving<Value> im = entry(column.im, values, equation);
            add_product(u, {times_i(im.value), times_i(im.rate)},
                        combined([&](const Value& v) { return minus(v); }));
        }
        return u;
    }

    void add_fast(Jets<Value>& result) const {
        std::vector<Moving<Value>> modes, conjugates;
        for (std::size_t k = 0; k < field_.modes.size(); ++k) {
            modes.push_back(mode(k, Side::itself));
            conjugates.push_back(field_.modes[k].is_real() ? modes.back() : mode(k, Side::conjugate));
        }
        for (std::size_t s = 0; s < field_.basis.states.size(); ++s) {
            const State& old = field_.first_order->states[field_.basis.states[s]];
            const auto derivative = static_cast<std::size_t>(old.derivative);
            Moving<Value> u =
                state(s, modes, conjugates, result.values, field_.system().equations[old.variable]);
            if (derivative > 0)
                result.velocity_defects.emplace_back(
                    old.variable,
                    algebra_.add(u.value, minus(result.values.symbols.at(jet(old.variable, derivative)))));
            result.values.symbols[jet(old.variable, derivative)] = u.value;
            result.values.symbols[jet(old.variable, derivative + 1)] = std::move(u.rate);
        }
    }

    Algebra& algebra_;
    CertificateRoots& roots_;
    const NormalForm& normal_form_;
    const NearIdentityMap& map_;
    const GradedField& field_;
    std::vector<std::optional<Value>> rates_; // absent: constant
};

} // namespace resonform
