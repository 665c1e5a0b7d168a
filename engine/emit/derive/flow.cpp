// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/derive/flow.hpp"

#include "algebra/number/number.hpp"
#include "emit/display/display.hpp"
#include "emit/display/free_name.hpp"
#include "emit/display/json.hpp"
#include "emit/display/normal_form_parts.hpp"
#include "emit/display/solution_display.hpp"
#include "solve/flow/real_form.hpp"
#include "solve/slow_law.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

namespace {

class FlowPage {
public:
    // remainders: print the order of the terms left out of the rates.
    FlowPage(const Solution& solution, bool remainders)
        : solution_(solution), flow_(*solution.flow), normal_form_(solution.normalization->normal_form),
          field_(*normal_form_.field), ring_(*field_.ring), remainders_(remainders),
          write_(field_.ring, field_.eps, field_.outer(), std::nullopt, {}), real_(field_) {
        for (std::size_t k = 0; k < field_.modes.size(); ++k) {
            frame_.emplace(field_.modes[k].z, symbol_factor(amplitude(2 * k + 1)));
            if (!field_.modes[k].is_real())
                frame_.emplace(field_.modes[k].zbar, symbol_factor(amplitude(2 * k + 2)));
        }
        for (std::size_t k = 0; k < field_.angles.size(); ++k)
            frame_.emplace(field_.angles[k].phase, exponential(symbol_sum(offset(k))));
    }

    // z1 = a1*exp(chi1 + I*theta1), theta1' = ..., a1 = eps*(u_x + I*v_x)
    [[nodiscard]] Section frame() const {
        Section section{"frame", {}};
        for (std::size_t k = 0; k < field_.modes.size(); ++k) {
            const Mode& mode = field_.modes[k];
            if (flow_.modes[k].is_left_out) {
                define(section, mode.name, by_weight({}, frame_));
                continue;
            }
            DisplaySum value = symbol_sum(amplitude(2 * k + 1));
            if (DisplaySum exponent = exponent_of(flow_.modes[k]); !exponent.terms.empty())
                value.terms.front().tail.push_back(function_factor("exp", std::move(exponent)));
            define(section, mode.name, std::move(value));
            if (!mode.is_real()) define(section, mode.conjugate_name, function_of("conj", mode.name));
            define(section, amplitude(2 * k + 1), cartesian(k));
            if (!mode.is_real())
                define(section, amplitude(2 * k + 2), function_of("conj", amplitude(2 * k + 1)));
        }
        for (std::size_t k = 0; k < field_.angles.size(); ++k)
            define(section, field_.angles[k].name,
                   symbol_sum(phase(flow_.angles[k])) + symbol_sum(offset(k)));
        for (std::size_t p = 0; p < flow_.phases.size(); ++p)
            define(section, phase_names()[p] + "'", by_weight(flow_.phases[p], frame_));
        for (std::size_t p = 0; p < flow_.decays.size(); ++p)
            define(section, decay_names()[p] + "'", by_weight(flow_.decays[p], frame_));
        return section;
    }

    [[nodiscard]] Section motion() const {
        Section section{flow_.at_rest() ? "constants" : "slow flow", {}};
        const auto add = [&](const std::string& name, const Series& rate) {
            Side value = by_weight(rate.total(rate.through()), frame_);
            if (remainders_ && rate.through() >= 0) value.remainder = weight(rate.through() + 1);
            define(section, name + "'", std::move(value));
        };
        for (std::size_t k = 0; k < field_.modes.size(); ++k)
            if (!flow_.modes[k].is_left_out) add(amplitude(2 * k + 1), flow_.modes[k].rate);
        for (std::size_t k = 0; k < field_.angles.size(); ++k) add(offset(k), flow_.angles[k].rate);
        for (std::size_t k = 0; k < field_.slow.size(); ++k) {
            add(field_.slow[k].name, flow_.slow[k]);
            if (!remainders_) add_path(section, k);
        }
        for (std::size_t k = 0; k < field_.drift.size(); ++k) {
            add("z_" + field_.drift[k].name, flow_.drift[k]);
            if (flow_.at_rest()) section.formulas.push_back(uniform(k));
        }
        return section;
    }

    [[nodiscard]] Section results(const std::vector<FlowOutput>& outputs) const {
        Section section{"outputs through order " + to_string(weight(solution_.order)), {}};
        for (const FlowOutput& output : outputs) {
            Side value = written(output.value, output.value.through(), write_, phases(ring_));
            if (output.drift) value.groups.insert(value.groups.begin(), symbol_sum("z_" + output.name));
            define(section, output.name, std::move(value));
        }
        return section;
    }

private:
    [[nodiscard]] Rational weight(int held) const { return solution_.system().weight(held); }
    [[nodiscard]] std::string amplitude(std::size_t number) const {
        return free_name(solution_.system(), fmt::format("a{}", number));
    }
    [[nodiscard]] std::string offset(std::size_t angle) const {
        return free_name(solution_.system(), "delta_" + field_.angles[angle].name);
    }
    [[nodiscard]] std::vector<std::string> numbered(const char* name, std::size_t count) const {
        std::vector<std::string> names;
        for (std::size_t p = 0; p < count; ++p)
            names.push_back(
                free_name(solution_.system(), count == 1 ? name : fmt::format("{}{}", name, p + 1)));
        return names;
    }
    [[nodiscard]] std::vector<std::string> phase_names() const {
        return numbered("theta", flow_.phases.size());
    }
    [[nodiscard]] std::vector<std::string> decay_names() const {
        return numbered("chi", flow_.decays.size());
    }
    [[nodiscard]] std::string phase(const FlowMode& mode) const { return phase_names()[*mode.phase]; }
    // chi + I*theta
    [[nodiscard]] DisplaySum exponent_of(const FlowMode& mode) const {
        DisplaySum sum;
        if (mode.decay) sum = symbol_sum(decay_names()[*mode.decay]);
        if (!mode.phase) return sum;
        DisplaySum turning = symbol_sum(phase(mode));
        turning.terms.front().imaginary = true;
        return mode.decay ? sum + turning : turning;
    }

    static DisplayFactor exponential(DisplaySum angle) {
        for (DisplayTerm& term : angle.terms) term.imaginary = true;
        return function_factor("exp", std::move(angle));
    }

    // eps^w*(u_x + I*v_x)
    [[nodiscard]] DisplaySum cartesian(std::size_t k) const {
        const auto symbol = [&](GeneratorId id) { return symbol_sum(real_.ring()->generator(id).name); };
        DisplaySum unit = symbol(real_.modes()[k].u);
        if (!real_.modes()[k].is_real()) {
            DisplaySum imaginary = symbol(real_.modes()[k].v);
            imaginary.terms.front().imaginary = true;
            unit = unit + imaginary;
        }
        const int held = ring_.generator(field_.modes[k].z).weight;
        if (held == 0) return unit;
        DisplaySum value = factor_sum(symbol_factor("eps", weight(held)));
        value.terms.front().tail.push_back(sum_factor(std::move(unit)));
        return value;
    }

    // tau = tau_0 + eps*t, where that is known
    void add_path(Section& section, std::size_t k) const {
        const Polynomial rate = flow_.slow[k].total(flow_.slow[k].through());
        const auto path = slow_path(ring_, field_.slow[k].generator, rate);
        if (rate.empty() || !path) return;
        DisplaySum moving = path_sum(ring_, field_.slow[k].name, *path);
        if (!moving.terms.empty()) define(section, field_.slow[k].name, std::move(moving));
    }

    // The first power of eps at which the neglected rates of constant amplitudes, and of the drift itself,
    // change the uniform motion of the drift within t <= 1/eps.
    [[nodiscard]] int remainder_of_uniform(std::size_t k) const {
        const Series& rate = flow_.drift[k];
        int leading = 0;
        while (leading < rate.through() && rate.part(leading).empty()) ++leading;
        const int one = solution_.system().eps_root;
        int least = rate.through() + 1 - one;
        const auto see = [&](const Series& other, int weight) {
            if (other.through() >= 0)
                least = std::min(least, leading + 1 + other.through() - weight - 2 * one);
        };
        for (std::size_t m = 0; m < flow_.modes.size(); ++m)
            see(flow_.modes[m].rate, ring_.generator(field_.modes[m].z).weight);
        for (const FlowMode& angle : flow_.angles) see(angle.rate, 0);
        for (const Series& slow : flow_.slow) see(slow, 0);
        return least;
    }

    // z_X = constant + rate t, in real constants
    [[nodiscard]] Formula uniform(std::size_t k) const {
        const std::string& name = field_.drift[k].name;
        DisplaySum value = symbol_sum(solution_.system().constant_name("constant", name));
        const Polynomial rate = real_(flow_.drift[k].total(flow_.drift[k].through())).re;
        if (!rate.empty()) {
            DisplayTerm motion = factored(display(*real_.ring(), rate));
            motion.tail.push_back(symbol_factor("t"));
            value.terms.push_back(std::move(motion));
        }
        return {side(symbol_sum("z_" + name)),
                side(std::move(value), remainders_ ? weight(remainder_of_uniform(k)) : 0)};
    }

    [[nodiscard]] Side by_weight(const Polynomial& p, const Substitutes& substitutes) const {
        int heaviest = 0;
        for (const Term& t : p.terms()) heaviest = std::max(heaviest, ring_.weight(t.monomial));
        return written(Series::split(ring_, p, heaviest), heaviest, write_, substitutes);
    }

    const Solution& solution_;
    const SlowFlow& flow_;
    const NormalForm& normal_form_;
    const GradedField& field_;
    const Ring& ring_;
    bool remainders_;
    SeriesWriter write_;
    RealForm real_;
    Substitutes frame_;
};

} // namespace

std::vector<Section> flow_sections(const Solution& solution, const std::vector<FlowOutput>& outputs) {
    const FlowPage page(solution, false);
    return {page.frame(), page.motion(), page.results(outputs)};
}

std::vector<Section> leading_flow_sections(const Solution& solution) {
    const FlowPage page(solution, true);
    return {page.frame(), page.motion()};
}

namespace {

Json flow_terms(const GradedField& field, const std::string& name, const Series& series) {
    Json list = Json::array();
    append_json_terms(list, *field.ring, name, series.total(series.through()), field.outer());
    return list;
}

Json frame_json(const GradedField& field, const SlowFlow& flow) {
    Json frame = Json::array();
    for (std::size_t p = 0; p < flow.phases.size(); ++p) {
        Json turning = Json::array();
        for (std::size_t k = 0; k < field.modes.size(); ++k)
            if (flow.modes[k].phase == p) turning.push_back(field.modes[k].name);
        for (std::size_t k = 0; k < field.angles.size(); ++k)
            if (flow.angles[k].phase == p) turning.push_back(field.angles[k].name);
        frame.push_back({{"rate", json_expression(*field.ring, flow.phases[p])}, {"turning", turning}});
    }
    for (std::size_t p = 0; p < flow.decays.size(); ++p) {
        Json decaying = Json::array();
        for (std::size_t k = 0; k < field.modes.size(); ++k)
            if (flow.modes[k].decay == p) decaying.push_back(field.modes[k].name);
        frame.push_back({{"rate", json_expression(*field.ring, flow.decays[p])}, {"decaying", decaying}});
    }
    return frame;
}

// remainders: with the weight that is left out of each rate, null where it is exact.
Json rates_json(const GradedField& field, const SlowFlow& flow, bool remainders) {
    Json rates = Json::array();
    const auto add = [&](const std::string& name, const char* role, const Series& rate) {
        Json entry = {{"variable", name}, {"role", role}, {"terms", flow_terms(field, name, rate)}};
        if (remainders)
            entry["remainder"] =
                rate.through() < 0 ? Json(nullptr) : json_rational(field.system().weight(rate.through() + 1));
        rates.push_back(std::move(entry));
    };
    for (std::size_t k = 0; k < field.modes.size(); ++k) add(field.modes[k].name, "mode", flow.modes[k].rate);
    for (std::size_t k = 0; k < field.angles.size(); ++k)
        add(field.angles[k].name, "angle", flow.angles[k].rate);
    for (std::size_t k = 0; k < field.slow.size(); ++k) add(field.slow[k].name, "slow", flow.slow[k]);
    for (std::size_t k = 0; k < field.drift.size(); ++k) add(field.drift[k].name, "drift", flow.drift[k]);
    return rates;
}

} // namespace

Json flow_json(const Solution& solution) {
    const SlowFlow& flow = *solution.flow;
    const GradedField& field = *solution.normalization->normal_form.field;
    Json outputs = Json::array();
    for (const FlowOutput& output : flow.outputs)
        outputs.push_back({{"name", output.name}, {"terms", flow_terms(field, output.name, output.value)}});
    return {{"frame", frame_json(field, flow)},
            {"flow", rates_json(field, flow, false)},
            {"outputs", std::move(outputs)}};
}

Json leading_flow_json(const Solution& solution) {
    const SlowFlow& flow = *solution.flow;
    const GradedField& field = *solution.normalization->normal_form.field;
    Json json = {{"frame", frame_json(field, flow)}, {"flow", rates_json(field, flow, true)}};
    if (!flow.at_rest()) return json;
    const RealForm real(field);
    const auto name = [&](GeneratorId id) { return real.ring()->generator(id).name; };
    Json amplitudes = Json::array(), uniform = Json::array();
    for (std::size_t k = 0; k < field.modes.size(); ++k)
        amplitudes.push_back(
            {{"mode", field.modes[k].name},
             {"real", name(real.modes()[k].u)},
             {"imaginary", real.modes()[k].is_real() ? Json(nullptr) : Json(name(real.modes()[k].v))},
             {"eps", json_rational(field.system().weight(field.ring->generator(field.modes[k].z).weight))}});
    for (std::size_t k = 0; k < field.drift.size(); ++k) {
        const Polynomial rate = real(flow.drift[k].total(flow.drift[k].through())).re;
        uniform.push_back({{"variable", field.drift[k].name},
                           {"constant", field.system().constant_name("constant", field.drift[k].name)},
                           {"rate", json_expression(*real.ring(), rate)}});
    }
    json["amplitudes"] = std::move(amplitudes);
    json["uniform"] = std::move(uniform);
    return json;
}

} // namespace resonform
