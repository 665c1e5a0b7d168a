// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/neglected.hpp"

#include "algebra/number/error.hpp"
#include "solve/flow/frame.hpp"
#include "solve/flow/slow_flow.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

namespace {

constexpr int nothing = 1 << 20; // the power of a zero error
constexpr int far = nothing / 2; // larger than any power of a nonzero error
constexpr ErrorPower none{nothing, true};

// Replaces `error` by `other` if its power is lower, or equal and sure. Returns whether it did.
bool lower(ErrorPower& error, const ErrorPower& other) {
    if (other.power > error.power) return false;
    const bool changes = other.power < error.power || (other.sure && !error.sure);
    if (changes) error = other;
    return changes;
}

ErrorPower operator+(const ErrorPower& a, const ErrorPower& b) {
    return {std::min(a.power + b.power, nothing), a.sure && b.sure};
}

Zero vanishing(const Ring& ring, const Polynomial& p) { return p.empty() ? Zero::yes : ring.is_zero(p); }

// The first part from weight `from` on that is not proved to vanish.
ErrorPower first(const Ring& ring, const Series& series, int from) {
    for (; from <= series.through(); ++from)
        if (const Zero zero = vanishing(ring, series.part(from)); zero != Zero::yes)
            return {from, zero == Zero::no};
    return none;
}

// The terms of p whose monomials satisfy `chosen`.
template <class Choice> Polynomial part_of(const Polynomial& p, const Choice& chosen) {
    std::vector<Term> terms;
    for (const Term& t : p.terms())
        if (chosen(t.monomial)) terms.push_back(t);
    return Polynomial::from_terms(std::move(terms));
}

// Of what several modes may have in common, a phase or an exponent.
struct Shared {
    int weight = nothing; // the least of these modes
    bool lasts = false;   // one of them does
    bool decays = false;  // one of them does for certain

    void join(const Shared& other) {
        weight = std::min(weight, other.weight);
        lasts = lasts || other.lasts;
        decays = decays || other.decays;
    }
};

} // namespace

Neglected::Neglected(const Solution& richer, const TruncatedFormula& formula)
    : richer_(richer), formula_(formula), field_(*richer.normalization->normal_form.field),
      ring_(*field_.ring),
      flow_(richer.flow ? *richer.flow : slow_flow(*richer.normalization, {richer.order, richer.truncation})),
      by_series_(!richer.flow && formula.time_power <= 1) {
    add_quantities();
    add_start_errors();
    spread();
    influences_.clear();
    if (by_series_)
        add_series_errors();
    else
        add_rates();
    spread();
}

void Neglected::add_quantities() {
    const auto add = [this](Kind kind, std::size_t index, const Shared& of) {
        quantities_.push_back({kind, index, of.weight, of.lasts ? formula_.time_power : 0,
                               of.decays && !of.lasts ? formula_.order : formula_.truncation, none});
    };
    std::vector<Shared> phases(flow_.phases.size()), decays(flow_.decays.size());
    for (std::size_t k = 0; k < field_.modes.size(); ++k) {
        const FlowMode& mode = flow_.modes[k];
        const Shared own{ring_.generator(field_.modes[k].z).weight, !mode.decay || mode.passes,
                         mode.decays(field_.modes[k])};
        for (const Kind kind : {Kind::modulus, Kind::argument}) add(kind, k, own);
        if (mode.decay) decays[*mode.decay].join(own);
        if (mode.phase) phases[*mode.phase].join(own);
    }
    const Shared whole{0, true, false};
    for (std::size_t k = 0; k < field_.angles.size(); ++k) {
        add(Kind::angle, k, whole);
        phases[*flow_.angles[k].phase].join(whole);
    }
    for (std::size_t k = 0; k < phases.size(); ++k) add(Kind::phase, k, phases[k]);
    for (std::size_t k = 0; k < decays.size(); ++k) add(Kind::decay, k, decays[k]);
    for (std::size_t k = 0; k < field_.slow.size(); ++k) add(Kind::slow, k, whole);
    for (std::size_t k = 0; k < field_.drift.size(); ++k) add(Kind::drift, k, whole);
}

void Neglected::add_rates() {
    for (std::size_t on = 0; on < quantities_.size(); ++on) {
        const Quantity& quantity = quantities_[on];
        const Kind kind = quantity.kind;
        const std::size_t k = quantity.index;
        const auto add = [&](const Series& rate, bool exact = false) {
            for (int n = 0; n <= rate.through(); ++n) add_rate(on, n, rate.part(n), exact);
        };
        switch (kind) {
        case Kind::modulus:
        case Kind::argument: { // |z|^2 (log |z|)' = Re z' zbar, |z|^2 (arg z)' = Im z' zbar
            const Series& rate = flow_.modes[k].rate;
            for (int n = 0; n <= rate.through(); ++n) {
                const Polynomial p = ring_.multiply(rate.part(n), ring_.gen(field_.modes[k].zbar));
                const Polynomial conjugate = ring_.conjugate(p);
                add_rate(on, n, kind == Kind::modulus ? p + conjugate : p - conjugate);
            }
            break;
        }
        case Kind::phase:
        case Kind::decay:
            for (const Term& t : (kind == Kind::phase ? flow_.phases : flow_.decays)[k].terms())
                add_rate(on, ring_.weight(t.monomial) + quantity.scale,
                         Polynomial(t.monomial, t.coefficient));
            break;
        case Kind::angle: add(flow_.angles[k].rate); break;
        case Kind::slow: add(flow_.slow[k], !field_.slow[k].driven); break;
        case Kind::drift: add(flow_.drift[k]); break;
        }
    }
}

// Adds one part of a rate: its error, if it was neglected, and the quantities whose errors it passes on.
void Neglected::add_rate(std::size_t on, int weight, const Polynomial& rate, bool exact) {
    const Zero zero = vanishing(ring_, rate);
    if (zero == Zero::yes) return;
    const int power = weight - quantities_[on].scale - quantities_[on].time_power;
    if (weight > quantities_[on].through && !exact) lower(quantities_[on].error, {power, zero == Zero::no});
    for (std::size_t from = 0; from < quantities_.size(); ++from)
        if (const Zero rests = insensitive(rate, quantities_[from], &quantities_[on]); rests != Zero::yes)
            influences_.push_back({from, on, {power, rests == Zero::no}});
}

// In closed form amplitude, phase and drifts are power series in eps with coefficients in T = eps t that
// vanish at T = 0: the error is the first part that is cut off.
void Neglected::add_series_errors() {
    const int last = formula_.truncation, p = formula_.time_power;
    const Ring& ring = *richer_.ring;
    for (std::size_t k = 0; k < richer_.modes.size(); ++k) {
        const ModeSolution& mode = richer_.modes[k];
        lower_of(Kind::modulus, k, first(ring, mode.factor, std::max(last - 1, 1)) + ErrorPower{1 - p, true});
        if (last < 2) // neglects rates of weight 2, which make the envelope
            if (const Zero one = vanishing(ring, mode.envelope - ring.one()); one != Zero::yes)
                lower_of(Kind::modulus, k, {1 - p, one == Zero::no});
        lower_of(Kind::argument, k, first(ring, mode.phase_rate, last) + ErrorPower{-p, true});
    }
    for (std::size_t k = 0; k < richer_.drift.size(); ++k)
        lower_of(Kind::drift, k, first(ring, richer_.drift[k].value, last) + ErrorPower{1 - p, true});
}

// Direct integration starts from the same values as the formula. From physical values the inverse map is cut
// at M. From constants the map itself is, and an error in one variable reaches those whose maps contain it.
void Neglected::add_start_errors() {
    const Normalization& n = *richer_.normalization;
    const NearIdentityMap map = formula_.from_constants ? n.map : invert(n.normal_form, n.map);
    for (std::size_t on = 0; on < quantities_.size(); ++on) {
        const Kind kind = quantities_[on].kind;
        const std::size_t k = quantities_[on].index;
        if (kind == Kind::phase || kind == Kind::decay) continue;
        const Series& series = kind == Kind::angle   ? map.angle[k]
                               : kind == Kind::slow  ? map.slow[k]
                               : kind == Kind::drift ? map.drift[k]
                                                     : map.mode[k];
        const int scale = quantities_[on].scale;
        lower(quantities_[on].error,
              first(ring_, series, formula_.truncation + 1) + ErrorPower{-scale, true});
        for (int weight = 0; formula_.from_constants && weight <= series.through(); ++weight)
            for (std::size_t from = 0; from < quantities_.size(); ++from)
                if (const Zero rests = insensitive(series.part(weight), quantities_[from], nullptr);
                    rests != Zero::yes)
                    influences_.push_back({from, on, {weight - scale, rests == Zero::no}});
    }
}

// Propagates errors along the influences until no error grows.
void Neglected::spread() {
    bool moved = true;
    for (std::size_t round = 0; moved; ++round) {
        moved = false;
        for (const Influence& i : influences_) {
            const ErrorPower& error = quantities_[i.from].error;
            if (error.power < far && lower(quantities_[i.on].error, error + i.times)) moved = true;
        }
        if (moved && round > quantities_.size())
            refuse(Reason::too_fast,
                   {"neighbouring solutions of the slow flow part by a bounded power of 1/eps",
                    fmt::format("errors feed on each other within t = O(1/eps^{})",
                                to_string(field_.system().weight(formula_.time_power))),
                    "shorten verify.interval",
                    {}});
    }
}

void Neglected::lower_of(Kind kind, std::size_t index, const ErrorPower& error) {
    for (Quantity& q : quantities_)
        if (q.kind == kind && q.index == index) lower(q.error, error);
}

// Whether p is independent of a quantity. Rates of a mode carry a factor |z|^2, which does not count as
// dependence on its own modulus.
Zero Neglected::insensitive(const Polynomial& p, const Quantity& what, const Quantity* rate_of) const {
    const auto turns = [&](const Monomial& m, std::size_t k) {
        return ring_.exponent(m, field_.modes[k].z) - ring_.exponent(m, field_.modes[k].zbar);
    };
    const auto chosen = [&](const Monomial& m) {
        switch (what.kind) {
        case Kind::modulus: {
            const bool own = rate_of != nullptr && rate_of->index == what.index &&
                             (rate_of->kind == Kind::modulus || rate_of->kind == Kind::argument);
            return degree_in(field_, m, what.index) != (own ? 2 : 0);
        }
        case Kind::argument: return turns(m, what.index) != 0;
        case Kind::angle: return ring_.exponent(m, field_.angles[what.index].phase) != 0;
        case Kind::phase: {
            int all = 0;
            for (std::size_t k = 0; k < field_.modes.size(); ++k)
                if (flow_.modes[k].phase == what.index) all += turns(m, k);
            for (std::size_t k = 0; k < field_.angles.size(); ++k)
                if (flow_.angles[k].phase == what.index) all += ring_.exponent(m, field_.angles[k].phase);
            return all != 0;
        }
        case Kind::decay: {
            int all = 0;
            for (std::size_t k = 0; k < field_.modes.size(); ++k)
                if (flow_.modes[k].decay == what.index) all += degree_in(field_, m, k);
            return all != 0;
        }
        case Kind::slow:
        case Kind::drift: return false;
        }
        return false;
    };
    if (what.kind == Kind::slow)
        return vanishing(ring_, ring_.derivative(p, field_.slow[what.index].generator));
    return vanishing(ring_, part_of(p, chosen));
}

// yes: the formula has the whole part eps^weight of an output; no: a part of it is missing.
Zero Neglected::missing(const FlowOutput& output, int weight) const {
    const Polynomial& part = output.value.part(weight);
    if (weight <= formula_.order)
        return formula_.oscillating ? Zero::yes : vanishing(ring_, part - mean_part(field_, flow_, part));
    for (const SolutionOutput& closed : richer_.outputs)
        if (by_series_ && closed.name == output.name)
            return vanishing(*richer_.ring, closed.value.part(weight));
    return vanishing(ring_, part);
}

std::optional<ErrorPower> Neglected::power(const std::string& output) const {
    ErrorPower least = none;
    for (const FlowOutput& o : flow_.outputs) {
        if (o.name != output) continue;
        for (int n = 0; n <= richer_.order; ++n) {
            if (const Zero zero = missing(o, n); zero != Zero::yes) lower(least, {n, zero == Zero::no});
            if (n > formula_.order) continue;
            const Polynomial& part = o.value.part(n);
            const Polynomial kept = formula_.oscillating ? part : mean_part(field_, flow_, part);
            for (const Quantity& q : quantities_)
                if (n + q.error.power <= least.power)
                    if (const Zero rests = insensitive(kept, q, nullptr); rests != Zero::yes)
                        lower(least, q.error + ErrorPower{n, rests == Zero::no});
        }
        for (const Quantity& q : quantities_)
            if (q.kind == Kind::drift && o.drift == q.index) lower(least, q.error);
    }
    if (least.power >= far) return std::nullopt;
    return least;
}

} // namespace resonform
