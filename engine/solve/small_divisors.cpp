// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/small_divisors.hpp"

#include "solve/flow/passage.hpp"
#include "solve/flow/slow_flow.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace resonform {

namespace {

// One divisor of each kind D = factor * primitive, the one with the smallest factor > 0.
enum class Of { all, lasting, transient };
std::vector<Polynomial> smallest_of_each(const Normalization& normalization, Of which) {
    std::vector<std::pair<Polynomial, Rational>> known; // primitive, factor
    for (const DivisorRecord& record : normalization.divisors) {
        if (record.verdict != DivisorVerdict::removed) continue;
        const bool transient = has_damped_mode(*normalization.normal_form.field, record.monomial);
        if (which != Of::all && transient != (which == Of::transient)) continue;
        const Rational lead = record.divisor.terms().front().coefficient, factor = cln::abs(lead);
        const Polynomial primitive = (1 / lead) * record.divisor;
        const auto same = std::find_if(known.begin(), known.end(),
                                       [&](const auto& entry) { return entry.first == primitive; });
        if (same == known.end())
            known.emplace_back(primitive, factor);
        else
            same->second = std::min(same->second, factor);
    }
    std::vector<Polynomial> divisors;
    for (const auto& [primitive, factor] : known) divisors.push_back(factor * primitive);
    return divisors;
}

// dD/dt by the leading part of each slow rate; nullopt: it is not known.
std::optional<Polynomial> rate_of(const Polynomial& divisor, const NormalForm& normal_form) {
    const GradedField& field = *normal_form.field;
    const Ring& ring = *field.ring;
    std::vector<Polynomial> addends;
    for (std::size_t k = 0; k < field.slow.size(); ++k) {
        if (!ring.derivative_known(divisor, field.slow[k].generator)) return std::nullopt;
        const Series& rate = normal_form.slow[k];
        int weight = 0;
        while (weight < rate.through() && rate.part(weight).empty()) ++weight;
        addends.push_back(
            ring.multiply(ring.derivative(divisor, field.slow[k].generator), rate.part(weight)));
    }
    return sum(addends);
}

std::vector<MovingDivisor> moving_of(const Normalization& normalization, Of which) {
    std::vector<MovingDivisor> moving;
    for (const Polynomial& divisor : smallest_of_each(normalization, which)) {
        const std::optional<Polynomial> rate = rate_of(divisor, normalization.normal_form);
        if (rate && !rate->empty()) moving.push_back({divisor, *rate});
    }
    return moving;
}

class Fading {
public:
    Fading(const Solution& solution, const std::vector<std::string>& outputs)
        : outputs_(outputs), flow_(*solution.flow), normalization_(*solution.normalization),
          field_(*normalization_.normal_form.field), ring_(*field_.ring) {}

    [[nodiscard]] std::vector<FadingDivisor> all() const {
        std::vector<FadingDivisor> result;
        for (const MovingDivisor& moving : moving_divisors_at_start(normalization_))
            for (const GeneratorId id : field_.coefficients->divisors())
                if (is(id, moving.divisor) && !passes_zero(flow_, field_, ring_.generator(id).radicand))
                    if (std::optional<FadingDivisor> found = divisor(id, moving))
                        result.push_back(std::move(*found));
        return result;
    }

private:
    // A radicand of one term is written by its generator.
    [[nodiscard]] bool is(GeneratorId id, const Polynomial& divisor) const {
        return are_proportional(ring_.generator(id).radicand, divisor) ||
               are_proportional(ring_.gen(id), divisor);
    }
    [[nodiscard]] std::optional<FadingDivisor> divisor(GeneratorId id, const MovingDivisor& moving) const {
        if (ring_.conjugate(moving.divisor) != moving.divisor || stands_in_a_rate(id) ||
            stands_under_a_root(id))
            return std::nullopt;
        FadingDivisor fading{id, moving, 0, {}};
        for (const FlowOutput& output : flow_.outputs) {
            if (std::find(outputs_.begin(), outputs_.end(), output.name) == outputs_.end()) continue;
            for (int n = 0; n <= output.value.through(); ++n)
                for (const Term& t : output.value.part(n).terms()) {
                    const int power = -ring_.exponent(t.monomial, id);
                    if (power <= 0) continue;
                    std::optional<std::vector<int>> product = decaying(t.monomial);
                    if (!product) return std::nullopt;
                    fading.power = std::max(fading.power, power);
                    if (std::find(fading.products.begin(), fading.products.end(), *product) ==
                        fading.products.end())
                        fading.products.push_back(std::move(*product));
                }
        }
        std::sort(fading.products.begin(), fading.products.end());
        return fading;
    }

    // How often the decays of the flow multiply it; nullopt: something in it does not decay.
    [[nodiscard]] std::optional<std::vector<int>> decaying(const Monomial& monomial) const {
        std::vector<int> product(flow_.decays.size(), 0);
        bool decays = false;
        for (std::size_t k = 0; k < field_.modes.size(); ++k) {
            const int times = degree_in(field_, monomial, k);
            const FlowMode& mode = flow_.modes[k];
            if (times == 0 || !field_.modes[k].is_damped()) continue;
            if (mode.grows || !mode.decay) return std::nullopt;
            product[*mode.decay] += times;
            decays = true;
        }
        return decays ? std::optional(product) : std::nullopt;
    }

    [[nodiscard]] bool is_divided(const Polynomial& p, GeneratorId id) const {
        return std::any_of(p.terms().begin(), p.terms().end(),
                           [&](const Term& t) { return ring_.exponent(t.monomial, id) < 0; });
    }
    [[nodiscard]] bool is_divided(const Series& series, GeneratorId id) const {
        return is_divided(series.total(series.through()), id);
    }
    [[nodiscard]] bool stands_in_a_rate(GeneratorId id) const {
        const auto one = [&](const Polynomial& p) { return is_divided(p, id); };
        const auto series = [&](const Series& s) { return is_divided(s, id); };
        const auto mode = [&](const FlowMode& m) { return is_divided(m.rate, id); };
        return std::any_of(flow_.phases.begin(), flow_.phases.end(), one) ||
               std::any_of(flow_.decays.begin(), flow_.decays.end(), one) ||
               std::any_of(flow_.modes.begin(), flow_.modes.end(), mode) ||
               std::any_of(flow_.angles.begin(), flow_.angles.end(), mode) ||
               std::any_of(flow_.slow.begin(), flow_.slow.end(), series) ||
               std::any_of(flow_.drift.begin(), flow_.drift.end(), series);
    }
    [[nodiscard]] bool stands_under_a_root(GeneratorId id) const {
        for (GeneratorId other = 0; other < ring_.size(); ++other)
            if (ring_.generator(other).kind == GeneratorKind::root &&
                is_divided(ring_.generator(other).radicand, id))
                return true;
        return false;
    }

    const std::vector<std::string>& outputs_;
    const SlowFlow& flow_;
    const Normalization& normalization_;
    const GradedField& field_;
    const Ring& ring_;
};

} // namespace

std::vector<MovingDivisor> moving_divisors(const Normalization& normalization) {
    return moving_of(normalization, Of::lasting);
}

std::vector<MovingDivisor> moving_divisors_at_start(const Normalization& normalization) {
    return moving_of(normalization, Of::transient);
}

std::vector<StandingDivisor> standing_divisors(const Normalization& normalization) {
    const GradedField& field = *normalization.normal_form.field;
    const Ring& ring = *field.ring;
    const Polynomial eps = ring.gen(field.eps, ring.weights_in_one());
    const Polynomial least = (least_divisor() * least_divisor()) * ring.multiply(eps, eps);
    std::vector<StandingDivisor> standing;
    for (const Polynomial& divisor : smallest_of_each(normalization, Of::all)) {
        const std::optional<Polynomial> rate = rate_of(divisor, normalization.normal_form);
        if (rate && rate->empty())
            standing.push_back({divisor, ring.multiply(divisor, ring.conjugate(divisor)), least});
    }
    return standing;
}

Rational least_divisor() { return Rational(1) / 10'000; }

std::vector<FadingDivisor> fading_divisors(const Solution& solution,
                                           const std::vector<std::string>& outputs) {
    return solution.flow ? Fading(solution, outputs).all() : std::vector<FadingDivisor>();
}

bool fades(const std::vector<FadingDivisor>& fading, GeneratorId generator) {
    return std::any_of(fading.begin(), fading.end(),
                       [&](const FadingDivisor& divisor) { return divisor.generator == generator; });
}

} // namespace resonform
