// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/flow.hpp"

#include "certify/as_written.hpp"

#include <utility>

namespace resonform {

namespace {

// A series along the normal form, with its time derivative.
struct Moving {
    Slot value, rate;
};

// The generator of f'(u) for a sine or a function that is known by its name.
std::optional<GeneratorId> slope_generator(const Ring& ring, GeneratorId function) {
    const FunctionOf& of = ring.generator(function).of;
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const Generator& g = ring.generator(id);
        if (g.kind != GeneratorKind::function) continue;
        const bool cosine = of.function == Function::sine && g.of.sine == function;
        const bool next = of.function == Function::named && g.of.symbol == of.symbol &&
                          g.of.derivative == of.derivative + 1 && g.of.argument == of.argument;
        if (cosine || next) return id;
    }
    return std::nullopt;
}

class Flow {
public:
    Flow(CertificateProgram& program, CertificateRoots& roots, const GradedField& field)
        : program_(program), roots_(roots), field_(field),
          rates_(static_cast<std::size_t>(field_.ring->size())) {
        for (std::size_t k = 0; k < field_.modes.size(); ++k) {
            rate(field_.modes[k].z) = program_.value({SeriesName::mode_rate, k}, Side::itself);
            if (!field_.modes[k].is_real())
                rate(field_.modes[k].zbar) = program_.value({SeriesName::mode_rate, k}, Side::conjugate);
        }
        for (std::size_t k = 0; k < field_.slow.size(); ++k)
            rate(field_.slow[k].generator) = value({SeriesName::slow_rate, k});
        for (std::size_t k = 0; k < field_.angles.size(); ++k)
            rate(field_.angles[k].phase) = times_i(program_.multiply(
                program_.generator(field_.angles[k].phase, 1), value({SeriesName::angle_rate, k})));
        for (GeneratorId id = 0; id < field_.ring->size(); ++id)
            if (field_.ring->generator(id).kind == GeneratorKind::root)
                rate(id) = root_rate(id);
            else if (field_.ring->generator(id).kind == GeneratorKind::function)
                rate(id) = function_rate(id, follow_argument(id));
    }

    Jets jets() {
        Jets result;
        add_constants(result.values);
        add_slow(result.values);
        add_angles(result.values);
        for (std::size_t k = 0; k < field_.drift.size(); ++k)
            result.values.symbols[jet(field_.drift[k].variable, 1)] = program_.add(
                value({SeriesName::drift_rate, k}), follow({SeriesName::drift_shift, k}, Side::itself).rate);
        add_fast(result);
        result.unknown = std::move(unknown_);
        return result;
    }

private:
    std::optional<Slot>& rate(GeneratorId id) { return rates_[static_cast<std::size_t>(id)]; }

    const Parameter* parameter(GeneratorId id) const {
        const Generator& g = field_.ring->generator(id);
        return g.kind == GeneratorKind::parameter ? field_.system().parameter(g.name) : nullptr;
    }

    bool is_last_derivative(GeneratorId id) const {
        const Generator& g = field_.ring->generator(id);
        return g.kind == GeneratorKind::function && g.of.function == Function::named &&
               !slope_generator(*field_.ring, id);
    }

    Slot value(SeriesName series) const { return program_.value(series, Side::itself); }

    Moving follow(SeriesName series, Side side) {
        Slot total = program_.number(0);
        for (GeneratorId id = 0; id < field_.ring->size(); ++id) {
            const GeneratorId partner = field_.ring->generator(id).conjugate;
            const GeneratorId moved = side == Side::conjugate && partner >= 0 ? partner : id;
            const auto& r = rates_[static_cast<std::size_t>(moved)];
            if (!r && is_last_derivative(id)) unknown_.emplace_back(id, program_.slope(series, side, id));
            if (!r) continue;
            // (1/E)' = -E'/E^2
            const bool inverse =
                side == Side::conjugate && field_.ring->generator(id).kind == GeneratorKind::phase;
            const Slot moved_rate =
                inverse ? program_.minus(program_.multiply(program_.generator(id, -2), *r)) : *r;
            total = program_.add(total, program_.multiply(program_.slope(series, side, id), moved_rate));
        }
        return {program_.value(series, side), total};
    }

    Moving follow_argument(GeneratorId id) {
        return follow(program_.series(field_.ring->generator(id).of.argument), Side::itself);
    }

    Slot root_rate(GeneratorId id) {
        const Generator& root = field_.ring->generator(id);
        const Slot slope = program_.multiply(program_.number(Rational(1) / root.index),
                                             program_.generator(id, 1 - root.index));
        return program_.multiply(slope, follow(program_.series(root.radicand), Side::itself).rate);
    }

    // f(u)' = f'(u) u'. The ring tells which function a generator is; its derivatives are not used. nullopt:
    // the last derivative that the ring has of a function known by its name.
    std::optional<Slot> function_rate(GeneratorId id, const Moving& argument) {
        const FunctionOf& of = field_.ring->generator(id).of;
        const auto times = [&](Slot slope) { return program_.multiply(slope, argument.rate); };
        const Slot u = argument.value;
        switch (of.function) {
        case Function::exponential: return times(program_.generator(id, 1));
        case Function::cosine: return times(program_.minus(program_.generator(of.sine, 1)));
        case Function::logarithm: return times(program_.inverse_power(u, 1));
        case Function::arc_tangent:
            return times(
                program_.inverse_power(program_.add(program_.number(1), program_.multiply(u, u)), 1));
        case Function::sine:
        case Function::named: break;
        default: return times(slope_as_written(of.function, id));
        }
        const std::optional<GeneratorId> slope = slope_generator(*field_.ring, id);
        return slope ? std::optional(times(program_.generator(*slope, 1))) : std::nullopt;
    }

    // f'(u) at weight 0, substituted like an expression of an equation.
    Slot slope_as_written(Function f, GeneratorId id) {
        const Equation& equation = field_.system().equations.front();
        Substituted values;
        add_constants(values);
        for (const SlowVariable& slow : field_.slow)
            values.symbols[jet(slow.variable, 0)] = program_.generator(slow.generator, 1);
        const GiNaC::ex slope = roots_.at_origin(known_slope(f, roots_.argument_of(id)), equation);
        return substitute(program_, roots_, values, equation, slope);
    }

    Slot times_i(Slot v) const { return program_.multiply(program_.generator(Ring::imaginary_unit, 1), v); }

    const GiNaC::symbol& jet(std::size_t variable, std::size_t derivative) const {
        return field_.system().variables[variable].jet[derivative];
    }

    void add_constants(Substituted& values) const {
        values.symbols[field_.system().eps] = program_.generator(field_.eps, 1);
        for (GeneratorId id = 0; id < field_.ring->size(); ++id)
            if (const Parameter* p = parameter(id)) values.symbols[p->symbol] = program_.generator(id, 1);
    }

    void add_slow(Substituted& values) {
        for (std::size_t k = 0; k < field_.slow.size(); ++k) {
            const SlowVariable& slow = field_.slow[k];
            const Moving shift = follow({SeriesName::slow_shift, k}, Side::itself);
            values.symbols[jet(slow.variable, 0)] =
                program_.add(program_.generator(slow.generator, 1), shift.value);
            values.symbols[jet(slow.variable, 1)] =
                program_.add(value({SeriesName::slow_rate, k}), shift.rate);
        }
    }

    // e^{i phi} = e^{i theta} e^{i m},  phi' = theta' + m'
    void add_angles(Substituted& values) {
        for (std::size_t k = 0; k < field_.angles.size(); ++k) {
            const AngleVariable& angle = field_.angles[k];
            const Moving shift = follow({SeriesName::angle_shift, k}, Side::itself);
            const Slot turn = times_i(shift.value);
            values.angles.push_back(
                {jet(angle.variable, 0),
                 program_.multiply(program_.generator(angle.phase, 1),
                                   program_.function(Function::exponential, turn)),
                 program_.multiply(program_.generator(angle.phase, -1),
                                   program_.function(Function::exponential, program_.minus(turn)))});
            values.symbols[jet(angle.variable, 1)] =
                program_.add(value({SeriesName::angle_rate, k}), shift.rate);
        }
    }

    // z = w + h with its rate.
    Moving mode(std::size_t k, Side side) {
        const Mode& m = field_.modes[k];
        const GeneratorId w = side == Side::itself ? m.z : m.zbar;
        Moving shift = follow({SeriesName::mode_shift, k}, side);
        return {program_.add(program_.generator(w, 1), shift.value),
                program_.add(*rates_[static_cast<std::size_t>(w)], shift.rate)};
    }

    // An entry of T at the old slow variables, with its rate.
    Moving entry(const GiNaC::ex& e, const Substituted& values, const Equation& equation) const {
        const auto evaluate = [&](const GiNaC::ex& f) {
            return substitute(program_, roots_, values, equation, f);
        };
        Moving result{evaluate(e), program_.number(0)};
        for (const SlowVariable& slow : field_.slow) {
            const GiNaC::ex slope = e.diff(jet(slow.variable, 0));
            if (slope.is_zero()) continue;
            result.rate = program_.add(result.rate,
                                       program_.multiply(evaluate(slope), evaluate(jet(slow.variable, 1))));
        }
        return result;
    }

    void add_product(Moving& sum, const Moving& a, const Moving& b) const {
        sum.value = program_.add(sum.value, program_.multiply(a.value, b.value));
        sum.rate = program_.add(
            sum.rate, program_.add(program_.multiply(a.rate, b.value), program_.multiply(a.value, b.rate)));
    }

    // u_s = sum over modes of re (z + zbar) + i im (z - zbar)
    Moving state(std::size_t s, const std::vector<Moving>& modes, const std::vector<Moving>& conjugates,
                 const Substituted& values, const Equation& equation) const {
        Moving u{program_.number(0), program_.number(0)};
        for (std::size_t k = 0; k < modes.size(); ++k) {
            const Complex& column = field_.basis.modes[k].column[s];
            const bool real = field_.modes[k].is_real();
            const auto combined = [&](const auto& change) {
                Moving sum = modes[k];
                if (real) return sum;
                sum.value = program_.add(sum.value, change(conjugates[k].value));
                sum.rate = program_.add(sum.rate, change(conjugates[k].rate));
                return sum;
            };
            if (!column.re.is_zero())
                add_product(u, entry(column.re, values, equation), combined([](Slot v) { return v; }));
            if (column.im.is_zero()) continue;
            const Moving im = entry(column.im, values, equation);
            add_product(u, {times_i(im.value), times_i(im.rate)},
                        combined([&](Slot v) { return program_.minus(v); }));
        }
        return u;
    }

    void add_fast(Jets& result) {
        std::vector<Moving> modes, conjugates;
        for (std::size_t k = 0; k < field_.modes.size(); ++k) {
            modes.push_back(mode(k, Side::itself));
            conjugates.push_back(field_.modes[k].is_real() ? modes.back() : mode(k, Side::conjugate));
        }
        for (std::size_t s = 0; s < field_.basis.states.size(); ++s) {
            const State& old = field_.first_order->states[field_.basis.states[s]];
            const auto derivative = static_cast<std::size_t>(old.derivative);
            Moving u = state(s, modes, conjugates, result.values, field_.system().equations[old.variable]);
            if (derivative > 0)
                result.velocity_defects.emplace_back(
                    old.variable,
                    program_.add(u.value,
                                 program_.minus(result.values.symbols.at(jet(old.variable, derivative)))));
            result.values.symbols[jet(old.variable, derivative)] = u.value;
            result.values.symbols[jet(old.variable, derivative + 1)] = u.rate;
        }
    }

    CertificateProgram& program_;
    CertificateRoots& roots_;
    const GradedField& field_;
    std::vector<std::optional<Slot>> rates_; // absent: constant
    std::vector<std::pair<GeneratorId, Slot>> unknown_;
};

} // namespace

Jets jets_along(CertificateProgram& program, CertificateRoots& roots, const GradedField& field) {
    return Flow(program, roots, field).jets();
}

} // namespace resonform
