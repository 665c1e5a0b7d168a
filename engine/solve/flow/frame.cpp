// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/flow/frame.hpp"

#include "algebra/number/error.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/nearest.hpp"
#include "normalize/recursion/inverse_map.hpp"
#include "solve/flow/passage.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

namespace {

void check_modes(const NormalForm& normal_form) {
    const GradedField& field = *normal_form.field;
    const System& system = field.system();
    for (std::size_t k = 0; k < field.modes.size(); ++k) {
        const Mode& mode = field.modes[k];
        if (!field.couplings(k).empty())
            refuse(Reason::not_semisimple,
                   {"a solution is for a linear part that is semisimple",
                    mode.name + " is driven by another mode", "derive and print the normal form",
                    system.place_of(mode.variable)});
    }
    if (field.basis.numeric)
        refuse(Reason::eigenvalues, {"a solution is for modes in closed form",
                                     "modes in numbers",
                                     "derive and print the normal form",
                                     {system.file.string(), 0, 0, "equations", ""}});
}

// The terms without modes that are left out.
Polynomial without_left_out(const GradedField& field, const std::vector<FlowMode>& modes,
                            const Polynomial& p) {
    std::vector<Term> terms;
    for (const Term& t : p.terms()) {
        bool lasts = true;
        for (std::size_t k = 0; k < modes.size(); ++k)
            lasts = lasts && !(modes[k].is_left_out && degree_in(field, t.monomial, k) > 0);
        if (lasts) terms.push_back(t);
    }
    return Polynomial::from_terms(std::move(terms));
}

// Which of the terms i z_j f(|z|^2) of a rate the phases take: the frequencies at eps = 0; also what turns
// faster than slow time, which weighs less than eps (of rational weights); or all.
enum class Turning { at_rest, fast, whole };

// The frame of the phases; chi_j' likewise.
class Framing {
public:
    Framing(const Normalization& normalization, const SolveOptions& options)
        : normal_form_(normalization.normal_form), field_(*normal_form_.field), ring_(*field_.ring),
          through_(options.truncation), order_(options.order) {
        for (std::size_t k = 0; k < field_.modes.size(); ++k) {
            FlowMode mode;
            mode.grows = resonform::grows(field_, k);
            mode.is_at_zero = options.at_zero && options.at_zero->mode == field_.modes[k].name;
            mode.is_left_out = is_damped(k) && (!options.transients || mode.is_at_zero ||
                                                (mode.grows && options.growing == Growing::project));
            mode.either = !mode.is_left_out && has_either_sign(field_, k);
            modes_.push_back(std::move(mode));
        }
        alone_ = damped_modes_decay_alone();
        for (std::size_t k = 0; k < modes_.size(); ++k)
            modes_[k].passes = modes_[k].either && alone_ && may_pass_zero(field_, k);
    }

    SlowFlow build() {
        if (field_.slow.empty() && field_.angles.empty() && keeps_moduli()) {
            SlowFlow flow = framed(Turning::whole);
            if (!complaint(flow)) return flow;
        }
        if (ring_.weights_in_one() > 1) {
            SlowFlow flow = framed(Turning::fast);
            if (!complaint(flow)) return flow;
        }
        SlowFlow flow = framed(Turning::at_rest);
        if (const auto term = complaint(flow))
            refuse(Reason::resonance,
                   {"the frame of a slow flow obeys the resonance relations exactly",
                    fmt::format("the rate of {} has a term whose divisor is only near zero", *term),
                    "declare the resonance by [relations], with its detuning, instead of [normal_form] near",
                    {field_.system().file.string(), 0, 0, "normal_form.near", ""}});
        return flow;
    }

private:
    [[nodiscard]] bool is_damped(std::size_t k) const { return field_.modes[k].is_damped(); }

    // Is every rate of a damped mode this mode times something free of all damped ones?
    [[nodiscard]] bool damped_modes_decay_alone() const {
        const auto degrees = [&](const Monomial& monomial) {
            int all = 0;
            for (std::size_t j = 0; j < field_.modes.size(); ++j)
                if (is_damped(j)) all += degree_in(field_, monomial, j);
            return all;
        };
        for (std::size_t k = 0; k < field_.modes.size(); ++k) {
            if (!is_damped(k) || modes_[k].is_left_out) continue;
            const Polynomial rate = through(through_of(k), normal_form_.mode[k]);
            for (const Term& t : rate.terms())
                if (ring_.exponent(t.monomial, field_.modes[k].z) != 1 || degrees(t.monomial) != 1)
                    return false;
        }
        return true;
    }

    // Is every term of every rate N_j of an undamped mode i z_j times a real coefficient and powers of
    // moduli?
    [[nodiscard]] bool keeps_moduli() const {
        for (std::size_t k = 0; k < field_.modes.size(); ++k) {
            if (is_damped(k)) continue;
            const Polynomial rate = total(normal_form_.mode[k]);
            if (field_.modes[k].is_real() && !rate.empty()) return false;
            for (const auto& [monomial, coefficient] : ring_.collect(rate, field_.outer())) {
                if (!turns_as(field_, monomial, k)) return false;
                if (!(coefficient + ring_.conjugate(coefficient)).empty()) return false;
            }
        }
        return true;
    }

    // The terms below the weight of slow time that only turn what has this weight: times i f(|z|^2), f real.
    [[nodiscard]] Polynomial fast_turning(const Polynomial& rate, std::optional<std::size_t> k) const {
        const int weight = k ? ring_.generator(field_.modes[*k].z).weight : 0;
        std::vector<Polynomial> turning;
        for (const auto& [monomial, coefficient] : ring_.collect(rate, field_.outer())) {
            const Polynomial back = ring_.conjugate(coefficient);
            if (ring_.weight(monomial) >= weight + ring_.weights_in_one() || !turns_as(field_, monomial, k) ||
                has_real_mode(monomial) || !(k ? coefficient + back : coefficient - back).empty())
                continue;
            turning.push_back(ring_.multiply(Polynomial(monomial, 1), coefficient));
        }
        const Polynomial all = sum(turning);
        return k ? without(all, field_.modes[*k].z) : all;
    }

    // A real mode is no modulus, and one that decays is no part of a phase.
    [[nodiscard]] bool has_real_mode(const Monomial& monomial) const {
        for (std::size_t j = 0; j < field_.modes.size(); ++j)
            if ((field_.modes[j].is_real() || is_damped(j)) && degree_in(field_, monomial, j) > 0)
                return true;
        return false;
    }

    [[nodiscard]] SlowFlow framed(Turning taken) const {
        SlowFlow flow;
        for (std::size_t k = 0; k < field_.modes.size(); ++k) {
            const Mode& mode = field_.modes[k];
            FlowMode& framed = flow.modes.emplace_back(modes_[k]);
            if (framed.is_left_out) continue;
            const Polynomial rate = through(through_of(k), normal_form_.mode[k]);
            const bool all = is_damped(k) ? alone_ : taken == Turning::whole && !mode.is_real();
            Polynomial own = all ? without(rate, mode.z) : field_.eigenvalue(mode);
            if (taken == Turning::fast && !all && !is_damped(k) && !mode.is_real())
                own = own + fast_turning(rate - ring_.multiply(own, ring_.gen(mode.z)), k);
            framed.rate = cut(rate - ring_.multiply(own, ring_.gen(mode.z)));
            const Polynomial back = ring_.conjugate(own), half_i = Rational(-1) / 2 * ring_.imaginary();
            if (is_damped(k)) framed.decay = index(flow.decays, Rational(1) / 2 * (own + back));
            if (!mode.is_real()) framed.phase = index(flow.phases, ring_.multiply(half_i, own - back));
        }
        for (std::size_t k = 0; k < field_.angles.size(); ++k) {
            const Polynomial rate = total(normal_form_.angle[k]);
            Polynomial turning = field_.angles[k].frequency;
            if (taken == Turning::fast) turning = turning + fast_turning(rate - turning, std::nullopt);
            FlowMode& angle = flow.angles.emplace_back();
            angle.phase = index(flow.phases, turning);
            angle.rate = cut(rate - turning);
        }
        for (std::size_t k = 0; k < field_.slow.size(); ++k)
            flow.slow.push_back(
                field_.slow[k].driven
                    ? cut(total(normal_form_.slow[k]))
                    : Series(ring_.by_weight(field_.slow[k].rate, heaviest(field_.slow[k].rate))));
        for (const Series& rate : normal_form_.drift) flow.drift.push_back(cut(total(rate)));
        return flow;
    }

    // The weight through which the rate of a mode is needed: of one that decays N, for its rate acts over
    // times of order 1 only. (What grows, or may, is followed further than that.)
    [[nodiscard]] int through_of(std::size_t k) const {
        return modes_[k].decays(field_.modes[k]) ? order_ : through_;
    }

    // On the manifold: without the modes that are left out.
    [[nodiscard]] Polynomial through(int weight, const Series& series) const {
        return without_left_out(field_, modes_, series.total(weight));
    }
    [[nodiscard]] Polynomial total(const Series& series) const { return through(through_, series); }

    [[nodiscard]] Series cut(const Polynomial& rate) const { return Series::split(ring_, rate, through_); }

    [[nodiscard]] int heaviest(const Polynomial& p) const {
        int most = 0;
        for (const Term& t : p.terms()) most = std::max(most, ring_.weight(t.monomial));
        return most;
    }

    // rate/z
    [[nodiscard]] Polynomial without(const Polynomial& rate, GeneratorId z) const {
        std::vector<Term> terms;
        for (const Term& t : rate.terms()) terms.push_back({t.monomial - ring_.monomial(z), t.coefficient});
        return Polynomial::from_terms(std::move(terms));
    }

    static std::size_t index(std::vector<Polynomial>& rates, const Polynomial& rate) {
        const auto known = std::find(rates.begin(), rates.end(), rate);
        const auto index = static_cast<std::size_t>(known - rates.begin());
        if (known == rates.end()) rates.push_back(rate);
        return index;
    }

    // The first variable whose rate has a term that does not turn and decay with the frame of the variable.
    [[nodiscard]] std::optional<std::string> complaint(const SlowFlow& flow) const {
        const auto follows = [&](const Series& series, const FlowMode& frame) {
            const Polynomial rate = series.total(series.through());
            const Polynomial turning = frame.phase ? flow.phases[*frame.phase] : Polynomial(),
                             decay = frame.decay ? flow.decays[*frame.decay] : Polynomial();
            return std::all_of(rate.terms().begin(), rate.terms().end(), [&](const Term& t) {
                return ring_.vanishes(net_rate(field_, flow, t.monomial) - turning) &&
                       ring_.vanishes(net_decay(field_, flow, t.monomial) - decay);
            });
        };
        for (std::size_t k = 0; k < flow.modes.size(); ++k)
            if (!follows(flow.modes[k].rate, flow.modes[k])) return field_.modes[k].name;
        for (std::size_t k = 0; k < flow.angles.size(); ++k)
            if (!follows(flow.angles[k].rate, {})) return field_.angles[k].name;
        for (std::size_t k = 0; k < flow.slow.size(); ++k)
            if (!follows(flow.slow[k], {})) return field_.slow[k].name;
        for (std::size_t k = 0; k < flow.drift.size(); ++k)
            if (!follows(flow.drift[k], {})) return field_.drift[k].name;
        return std::nullopt;
    }

    const NormalForm& normal_form_;
    const GradedField& field_;
    const Ring& ring_;
    int through_, order_;
    std::vector<FlowMode> modes_; // without phase, decay and rate
    bool alone_ = true;
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
            parts.push_back(field_.modes[k].is_real() ? part : part + ring_.conjugate(part));
        }
        parts.push_back(field_.shifts[row]);
        return sum(parts);
    }

    const NearIdentityMap& map_;
    const GradedField& field_;
    const Ring& ring_;
};

// The name is one of derive's, of a real mode that decays or grows.
void check_mode_at_zero(const GradedField& field, const ModeAtZero& at_zero) {
    std::vector<std::string> names;
    for (const Mode& mode : field.modes) {
        const bool is_it = mode.name == at_zero.mode;
        names.push_back(mode.name);
        if (!mode.is_real()) names.push_back(mode.conjugate_name);
        if (!is_it && names.back() != at_zero.mode) continue;
        if (!mode.is_damped())
            bad_input({"a mode that is 0 at the start decays or grows at eps = 0",
                       at_zero.mode + (mode.is_real() ? " has the eigenvalue 0" : " oscillates"),
                       fmt::format("give physical values, or amplitude and phase of {}",
                                   field.system().variables[mode.variable].name),
                       at_zero.place});
        if (!mode.is_real())
            refuse({"a mode that is 0 at the start is real, for it takes the place of one value",
                    at_zero.mode + " is a spiral", "write transients = false or growing = \"project\"",
                    at_zero.place});
        return;
    }
    bad_input(Reason::name, {"a mode that is 0 at the start is one of those that derive prints",
                             in_quotes(at_zero.mode), suggest(at_zero.mode, names), at_zero.place});
}

// What is left of its rate would drive it away from 0.
void check_stays_at_zero(const Normalization& normalization, const SlowFlow& flow,
                         const SolveOptions& options) {
    const GradedField& field = *normalization.normal_form.field;
    for (std::size_t k = 0; k < flow.modes.size(); ++k)
        if (flow.modes[k].is_at_zero &&
            !without_left_out(field, flow.modes, normalization.normal_form.mode[k].total(options.truncation))
                 .empty())
            refuse(Reason::resonance, {"a mode that is 0 at the start stays 0",
                                       field.modes[k].name + " is driven by a resonance of other modes",
                                       "give physical values of all fast variables", options.at_zero->place});
}

// An angle has no place in the state that a projected start is read from.
void check_projection(const Normalization& normalization, const SlowFlow& flow) {
    const GradedField& field = *normalization.normal_form.field;
    for (std::size_t k = 0; flow.is_projected() && k < field.angles.size(); ++k) {
        const Polynomial shift = normalization.map.angle[k].total(normalization.map.through);
        if (!(shift - without_left_out(field, flow.modes, shift)).empty())
            refuse({"a start is projected where no angle moves with the mode that grows",
                    field.angles[k].name, "write growing = \"status\" and transients = true",
                    field.system().place_of(field.angles[k].variable)});
    }
}

} // namespace

SlowFlow slow_flow(const Normalization& normalization, const SolveOptions& options) {
    check_modes(normalization.normal_form);
    const GradedField& field = *normalization.normal_form.field;
    if (options.at_zero) check_mode_at_zero(field, *options.at_zero);
    SlowFlow flow = Framing(normalization, options).build();
    check_projection(normalization, flow);
    check_stays_at_zero(normalization, flow, options);
    const Outputs outputs(normalization);
    const auto lasting = [&](FlowOutput output) {
        for (int n = 0; n <= output.value.through(); ++n)
            output.value.set(n, without_left_out(field, flow.modes, output.value.part(n)));
        return output;
    };
    for (const State& state : field.first_order->states) {
        const Role role = field.system().variables[state.variable].role;
        if (role == Role::angle) continue;
        if (state.derivative == 0) flow.outputs.push_back(lasting(outputs.of(state, options.order)));
        if (role == Role::slow && !flow.may_grow()) continue;
        const FlowOutput whole = outputs.of(state, options.truncation);
        flow.state.push_back(flow.may_grow() ? lasting(whole) : whole);
    }
    return flow;
}

} // namespace resonform
