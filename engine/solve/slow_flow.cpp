// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/slow_flow.hpp"

#include "algebra/number/error.hpp"
#include "normalize/recursion/inverse_map.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

namespace {

void check_modes(const NormalForm& normal_form) {
    const GradedField& field = *normal_form.field;
    const System& system = field.system();
    for (std::size_t k = 0; k < field.modes.size(); ++k) {
        const Mode& mode = field.modes[k];
        const Place place = system.place_of(mode.variable);
        if (mode.is_real() || !mode.growth.empty())
            refuse({"a solution is for modes that oscillate without damping at eps = 0",
                    fmt::format("{}, a mode of {}, {}", mode.name, system.variables[mode.variable].name,
                                mode.is_real() ? "does not oscillate" : "is damped or grows"),
                    "multiply the damping by eps, or derive the normal form and its centre manifold", place});
        if (!field.couplings(k).empty())
            refuse({"a solution is for a linear part that is semisimple",
                    mode.name + " is driven by another mode", "derive and print the normal form", place});
    }
    if (field.basis.numeric)
        refuse({"a solution is for modes in closed form",
                "modes in numbers",
                "derive and print the normal form",
                {system.file.string(), 0, 0, "equations", ""}});
}

// Whether a monomial of a rate is z_k times powers of moduli; k = nullopt: powers of moduli only.
bool turns_as(const GradedField& field, const Monomial& monomial, std::optional<std::size_t> k) {
    const Ring& ring = *field.ring;
    for (std::size_t j = 0; j < field.modes.size(); ++j) {
        const Mode& mode = field.modes[j];
        if (ring.exponent(monomial, mode.z) - ring.exponent(monomial, mode.zbar) != (j == k ? 1 : 0))
            return false;
    }
    return std::all_of(field.angles.begin(), field.angles.end(),
                       [&](const AngleVariable& a) { return ring.exponent(monomial, a.phase) == 0; });
}

// The frame in which theta_j' are the frequencies at eps = 0, or those of all weights.
class Framing {
public:
    Framing(const Normalization& normalization, int through)
        : normal_form_(normalization.normal_form), field_(*normal_form_.field), ring_(*field_.ring),
          through_(through) {}

    SlowFlow build() {
        if (field_.slow.empty() && field_.angles.empty() && keeps_moduli()) {
            SlowFlow flow = framed(true);
            if (!complaint(flow)) return flow;
        }
        SlowFlow flow = framed(false);
        if (const auto term = complaint(flow))
            refuse({"the frame of a slow flow obeys the resonance relations exactly",
                    fmt::format("the rate of {} has a term whose divisor is only near zero", *term),
                    "declare the resonance by [relations], with its detuning, instead of [normal_form] near",
                    {field_.system().file.string(), 0, 0, "normal_form.near", ""}});
        return flow;
    }

private:
    // Is every term of every rate N_j of the form i z_j times a real coefficient and powers of moduli?
    [[nodiscard]] bool keeps_moduli() const {
        for (std::size_t k = 0; k < field_.modes.size(); ++k)
            for (const auto& [monomial, coefficient] :
                 ring_.collect(normal_form_.mode[k].total(through_), field_.outer())) {
                if (!turns_as(field_, monomial, k)) return false;
                if (!(coefficient + ring_.conjugate(coefficient)).empty()) return false;
            }
        return true;
    }

    [[nodiscard]] SlowFlow framed(bool whole) const {
        SlowFlow flow;
        for (std::size_t k = 0; k < field_.modes.size(); ++k) {
            const Mode& mode = field_.modes[k];
            const Polynomial rate = normal_form_.mode[k].total(through_);
            const Polynomial turning = whole ? without(rate, mode.z) : mode.omega;
            const Polynomial rest =
                rate - ring_.multiply(ring_.imaginary(), ring_.multiply(turning, ring_.gen(mode.z)));
            flow.modes.push_back({phase(flow, turning), Series::split(ring_, rest, through_)});
        }
        for (std::size_t k = 0; k < field_.angles.size(); ++k) {
            const Polynomial rate = normal_form_.angle[k].total(through_);
            const Polynomial& turning = field_.angles[k].frequency;
            flow.angles.push_back({phase(flow, turning), Series::split(ring_, rate - turning, through_)});
        }
        for (std::size_t k = 0; k < field_.slow.size(); ++k)
            flow.slow.push_back(
                field_.slow[k].driven
                    ? cut(normal_form_.slow[k])
                    : Series(ring_.by_weight(field_.slow[k].rate, heaviest(field_.slow[k].rate))));
        for (const Series& rate : normal_form_.drift) flow.drift.push_back(cut(rate));
        return flow;
    }

    [[nodiscard]] Series cut(const Series& rate) const {
        return Series::split(ring_, rate.total(through_), through_);
    }

    [[nodiscard]] int heaviest(const Polynomial& p) const {
        int most = 0;
        for (const Term& t : p.terms()) most = std::max(most, ring_.weight(t.monomial));
        return most;
    }

    // -i rate/z
    [[nodiscard]] Polynomial without(const Polynomial& rate, GeneratorId z) const {
        std::vector<Term> terms;
        for (const Term& t : rate.terms()) terms.push_back({t.monomial - ring_.monomial(z), t.coefficient});
        return -ring_.multiply(ring_.imaginary(), Polynomial::from_terms(std::move(terms)));
    }

    static std::size_t phase(SlowFlow& flow, const Polynomial& rate) {
        const auto known = std::find(flow.phases.begin(), flow.phases.end(), rate);
        const auto index = static_cast<std::size_t>(known - flow.phases.begin());
        if (known == flow.phases.end()) flow.phases.push_back(rate);
        return index;
    }

    // The first variable whose rate has a term that does not turn with the phase of the variable.
    [[nodiscard]] std::optional<std::string> complaint(const SlowFlow& flow) const {
        const auto turns = [&](const Series& series, const Polynomial& with) {
            const Polynomial rate = series.total(series.through());
            return std::all_of(rate.terms().begin(), rate.terms().end(), [&](const Term& t) {
                return ring_.vanishes(net_rate(field_, flow, t.monomial) - with);
            });
        };
        for (std::size_t k = 0; k < flow.modes.size(); ++k)
            if (!turns(flow.modes[k].rate, flow.phases[flow.modes[k].phase])) return field_.modes[k].name;
        for (std::size_t k = 0; k < flow.angles.size(); ++k)
            if (!turns(flow.angles[k].rate, {})) return field_.angles[k].name;
        for (std::size_t k = 0; k < flow.slow.size(); ++k)
            if (!turns(flow.slow[k], {})) return field_.slow[k].name;
        for (std::size_t k = 0; k < flow.drift.size(); ++k)
            if (!turns(flow.drift[k], {})) return field_.drift[k].name;
        return std::nullopt;
    }

    const NormalForm& normal_form_;
    const GradedField& field_;
    const Ring& ring_;
    int through_;
};

// Writes every state in the old modes z and slow variables, then substitutes the map.
class Outputs {
public:
    explicit Outputs(const Normalization& normalization)
        : map_(normalization.map), field_(*normalization.normal_form.field), ring_(*field_.ring) {}

    [[nodiscard]] FlowOutput of(const State& state, int through) const {
        FlowOutput output{state.name, state.variable, {}, std::nullopt};
        switch (field_.system().variables[state.variable].role) {
        case Role::drift:
            output.drift = index(field_.drift, state.variable);
            output.value = Series::split(ring_, map_.drift[*output.drift].total(through), through);
            break;
        case Role::slow: {
            const SlowVariable& slow = field_.slow[index(field_.slow, state.variable)];
            output.value = compose(field_, ring_.gen(slow.generator), through);
            break;
        }
        case Role::fast: output.value = compose(field_, in_modes(state), through); break;
        case Role::angle: break;
        }
        return output;
    }

private:
    template <class List> static std::size_t index(const List& list, std::size_t variable) {
        std::size_t k = 0;
        while (list[k].variable != variable) ++k;
        return k;
    }

    [[nodiscard]] Series compose(const GradedField& field, const Polynomial& p, int through) const {
        return resonform::compose(field, Series::split(ring_, p, through), map_, through);
    }

    [[nodiscard]] Polynomial in_modes(const State& state) const {
        const std::vector<std::size_t>& states = field_.basis.states;
        const auto place = place_of(field_.system().equations[state.variable].source);
        const auto row = static_cast<std::size_t>(
            std::find(states.begin(), states.end(),
                      static_cast<std::size_t>(&state - field_.first_order->states.data())) -
            states.begin());
        std::vector<Polynomial> parts;
        for (std::size_t k = 0; k < field_.modes.size(); ++k) {
            const Complex& entry = field_.basis.modes[k].column[row];
            if (entry.is_zero()) continue;
            const Polynomial part =
                ring_.multiply(field_.coefficients->convert(entry, place), ring_.gen(field_.modes[k].z));
            parts.push_back(part + ring_.conjugate(part));
        }
        parts.push_back(field_.shifts[row]);
        return sum(parts);
    }

    const NearIdentityMap& map_;
    const GradedField& field_;
    const Ring& ring_;
};

bool depends_on_phases(const GradedField& field, const SlowFlow& flow) {
    const auto turns = [&](const Series& rate, std::optional<std::size_t> as) {
        const Polynomial all = rate.total(rate.through());
        return std::any_of(all.terms().begin(), all.terms().end(),
                           [&](const Term& t) { return !turns_as(field, t.monomial, as); });
    };
    for (std::size_t k = 0; k < flow.modes.size(); ++k)
        if (turns(flow.modes[k].rate, k)) return true;
    return std::any_of(flow.angles.begin(), flow.angles.end(),
                       [&](const FlowMode& angle) { return turns(angle.rate, std::nullopt); }) ||
           std::any_of(flow.slow.begin(), flow.slow.end(),
                       [&](const Series& rate) { return turns(rate, std::nullopt); });
}

// The rate of |z|^2, zbar a' + z abar'; empty if the rate only turns the phase.
Series of_modulus(const GradedField& field, const Mode& mode, const Series& rate) {
    Series result;
    for (int n = 0; n <= rate.through(); ++n) {
        const Polynomial half = field.ring->multiply(field.ring->gen(mode.zbar), rate.part(n));
        result.set(n, half + field.ring->conjugate(half));
    }
    return result;
}

} // namespace

bool SlowFlow::at_rest() const {
    const auto is_empty = [](const Series& rate) { return !lowest_weight(rate); };
    const auto rests = [&](const FlowMode& mode) { return is_empty(mode.rate); };
    return std::all_of(modes.begin(), modes.end(), rests) &&
           std::all_of(angles.begin(), angles.end(), rests) &&
           std::all_of(slow.begin(), slow.end(), is_empty);
}

Polynomial net_rate(const GradedField& field, const SlowFlow& flow, const Monomial& monomial) {
    const Ring& ring = *field.ring;
    Polynomial rate;
    const auto add = [&](int turns, const FlowMode& mode) {
        if (turns != 0) rate = rate + Rational(turns) * flow.phases[mode.phase];
    };
    for (std::size_t k = 0; k < field.modes.size(); ++k)
        add(ring.exponent(monomial, field.modes[k].z) - ring.exponent(monomial, field.modes[k].zbar),
            flow.modes[k]);
    for (std::size_t k = 0; k < field.angles.size(); ++k)
        add(ring.exponent(monomial, field.angles[k].phase), flow.angles[k]);
    return rate;
}

Polynomial mean_part(const GradedField& field, const SlowFlow& flow, const Polynomial& p) {
    std::vector<Term> terms;
    for (const Term& t : p.terms())
        if (field.ring->vanishes(net_rate(field, flow, t.monomial))) terms.push_back(t);
    return Polynomial::from_terms(std::move(terms));
}

std::optional<int> first_oscillation(const GradedField& field, const SlowFlow& flow,
                                     const std::string& output) {
    for (const FlowOutput& o : flow.outputs)
        for (int n = 0; o.name == output && n <= o.value.through(); ++n)
            if (!(o.value.part(n) - mean_part(field, flow, o.value.part(n))).empty()) return n;
    return std::nullopt;
}

std::optional<int> lowest_weight(const Series& series) {
    for (int n = 0; n <= series.through(); ++n)
        if (!series.part(n).empty()) return n;
    return std::nullopt;
}

std::optional<int> flow_power(const GradedField& field, const SlowFlow& flow) {
    std::optional<int> power;
    const auto lower = [&](const Series& rate, int base) {
        if (const auto weight = lowest_weight(rate))
            power = std::min(power.value_or(*weight - base), *weight - base);
    };
    const bool phases_act = depends_on_phases(field, flow);
    for (std::size_t k = 0; k < flow.modes.size(); ++k) {
        const Series& rate = flow.modes[k].rate;
        lower(phases_act ? rate : of_modulus(field, field.modes[k], rate),
              field.ring->generator(field.modes[k].z).weight);
    }
    for (const FlowMode& angle : flow.angles)
        if (phases_act) lower(angle.rate, 0);
    for (const Series& slow : flow.slow) lower(slow, 0);
    return power;
}

SlowFlow slow_flow(const Normalization& normalization, int order, int truncation) {
    check_modes(normalization.normal_form);
    const GradedField& field = *normalization.normal_form.field;
    SlowFlow flow = Framing(normalization, truncation).build();
    const Outputs outputs(normalization);
    for (const State& state : field.first_order->states) {
        const Role role = field.system().variables[state.variable].role;
        if (role == Role::angle) continue;
        if (state.derivative == 0) flow.outputs.push_back(outputs.of(state, order));
        if (role != Role::slow) flow.state.push_back(outputs.of(state, truncation));
    }
    return flow;
}

} // namespace resonform
