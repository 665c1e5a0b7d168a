// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/derive_flow.hpp"

#include "emit/drift_frame.hpp"
#include "emit/normal_form_parts.hpp"
#include "solve/real_form.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

namespace {

class FlowPage {
public:
    FlowPage(const Solution& solution, const std::vector<FlowOutput>& outputs)
        : solution_(solution), flow_(*solution.flow), normal_form_(solution.normalization->normal_form),
          field_(*normal_form_.field), ring_(*field_.ring), outputs_(outputs),
          write_(field_.ring, field_.eps, field_.outer(), std::nullopt, {}), real_(field_) {
        for (std::size_t k = 0; k < field_.modes.size(); ++k) {
            frame_.emplace(field_.modes[k].z, symbol_factor(amplitude(2 * k + 1)));
            frame_.emplace(field_.modes[k].zbar, symbol_factor(amplitude(2 * k + 2)));
        }
        for (std::size_t k = 0; k < field_.angles.size(); ++k)
            frame_.emplace(field_.angles[k].phase, exponential(symbol_sum(offset(k))));
    }

    // z1 = a1*exp(I*theta1), theta1' = ..., a1 = eps*(u_x + I*v_x)
    [[nodiscard]] Section frame() const {
        Section section{"frame", {}};
        for (std::size_t k = 0; k < field_.modes.size(); ++k) {
            const Mode& mode = field_.modes[k];
            DisplaySum value = symbol_sum(amplitude(2 * k + 1));
            value.terms.front().tail.push_back(exponential(symbol_sum(phase(flow_.modes[k]))));
            section.formulas.push_back({side(symbol_sum(mode.name)), side(std::move(value))});
            section.formulas.push_back({side(symbol_sum(mode.conjugate_name)),
                                        side(factor_sum(function_factor("conj", symbol_sum(mode.name))))});
            section.formulas.push_back({side(symbol_sum(amplitude(2 * k + 1))), side(cartesian(k))});
            section.formulas.push_back(
                {side(symbol_sum(amplitude(2 * k + 2))),
                 side(factor_sum(function_factor("conj", symbol_sum(amplitude(2 * k + 1)))))});
        }
        for (std::size_t k = 0; k < field_.angles.size(); ++k)
            section.formulas.push_back({side(symbol_sum(field_.angles[k].name)),
                                        side(symbol_sum(phase(flow_.angles[k])) + symbol_sum(offset(k)))});
        for (std::size_t p = 0; p < flow_.phases.size(); ++p)
            section.formulas.push_back(
                {side(symbol_sum(phase_names()[p] + "'")), by_weight(flow_.phases[p], frame_)});
        return section;
    }

    [[nodiscard]] Section motion() const {
        Section section{flow_.at_rest() ? "constants" : "slow flow", {}};
        const auto add = [&](const std::string& name, const Series& rate) {
            const Polynomial all = rate.total(rate.through());
            section.formulas.push_back({side(symbol_sum(name + "'")), by_weight(all, frame_)});
        };
        for (std::size_t k = 0; k < field_.modes.size(); ++k) add(amplitude(2 * k + 1), flow_.modes[k].rate);
        for (std::size_t k = 0; k < field_.angles.size(); ++k) add(offset(k), flow_.angles[k].rate);
        for (std::size_t k = 0; k < field_.slow.size(); ++k) add(field_.slow[k].name, flow_.slow[k]);
        for (std::size_t k = 0; k < field_.drift.size(); ++k) {
            add("z_" + field_.drift[k].name, flow_.drift[k]);
            if (flow_.at_rest()) section.formulas.push_back(uniform(k));
        }
        return section;
    }

    [[nodiscard]] Section results() const {
        Section section{"outputs through order " + std::to_string(solution_.order), {}};
        for (const FlowOutput& output : outputs_) {
            Side value = written(output.value, output.value.through(), write_, phases(ring_));
            if (output.drift) value.groups.insert(value.groups.begin(), symbol_sum("z_" + output.name));
            section.formulas.push_back({side(symbol_sum(output.name)), std::move(value)});
        }
        return section;
    }

private:
    [[nodiscard]] std::string amplitude(std::size_t number) const {
        return free_name(solution_.system(), fmt::format("a{}", number));
    }
    [[nodiscard]] std::string offset(std::size_t angle) const {
        return free_name(solution_.system(), "delta_" + field_.angles[angle].name);
    }
    [[nodiscard]] std::vector<std::string> phase_names() const {
        std::vector<std::string> names;
        for (std::size_t p = 0; p < flow_.phases.size(); ++p)
            names.push_back(free_name(solution_.system(),
                                      flow_.phases.size() == 1 ? "theta" : fmt::format("theta{}", p + 1)));
        return names;
    }
    [[nodiscard]] std::string phase(const FlowMode& mode) const { return phase_names()[mode.phase]; }

    static DisplayFactor exponential(DisplaySum angle) {
        for (DisplayTerm& term : angle.terms) term.imaginary = true;
        return function_factor("exp", std::move(angle));
    }

    // eps^w*(u_x + I*v_x)
    [[nodiscard]] DisplaySum cartesian(std::size_t k) const {
        const auto symbol = [&](GeneratorId id) { return symbol_sum(real_.ring()->generator(id).name); };
        DisplaySum imaginary = symbol(real_.modes()[k].v);
        imaginary.terms.front().imaginary = true;
        DisplaySum unit = symbol(real_.modes()[k].u) + imaginary;
        const int weight = ring_.generator(field_.modes[k].z).weight;
        if (weight == 0) return unit;
        DisplaySum value = factor_sum(symbol_factor("eps", weight));
        DisplayFactor factor;
        factor.kind = DisplayFactor::Kind::sum;
        factor.arguments = {unit};
        value.terms.front().tail.push_back(std::move(factor));
        return value;
    }

    // z_X = constant + rate t, in real constants
    [[nodiscard]] Formula uniform(std::size_t k) const {
        const FlowOutput& output = *std::find_if(flow_.outputs.begin(), flow_.outputs.end(),
                                                 [&](const FlowOutput& o) { return o.drift == k; });
        DisplaySum value = symbol_sum(solution_.system().constant_name("constant", field_.drift[k].name));
        const Polynomial rate = real_(flow_.drift[k].total(flow_.drift[k].through())).re;
        if (!rate.empty()) {
            DisplayTerm motion = factored(display(*real_.ring(), rate));
            motion.tail.push_back(symbol_factor("t"));
            value.terms.push_back(std::move(motion));
        }
        return {side(symbol_sum("z_" + output.name)), side(std::move(value))};
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
    const std::vector<FlowOutput>& outputs_;
    SeriesWriter write_;
    RealForm real_;
    Substitutes frame_;
};

} // namespace

std::vector<Section> flow_sections(const Solution& solution, const std::vector<FlowOutput>& outputs) {
    const FlowPage page(solution, outputs);
    return {page.frame(), page.motion(), page.results()};
}

Json flow_json(const Solution& solution) {
    const SlowFlow& flow = *solution.flow;
    const GradedField& field = *solution.normalization->normal_form.field;
    const auto terms = [&](const std::string& name, const Series& series) {
        Json list = Json::array();
        append_json_terms(list, *field.ring, name, series.total(series.through()), field.outer());
        return list;
    };
    Json frame = Json::array(), rates = Json::array(), outputs = Json::array();
    const auto add = [&](const std::string& name, const char* role, const Series& rate) {
        rates.push_back({{"variable", name}, {"role", role}, {"terms", terms(name, rate)}});
    };
    for (std::size_t p = 0; p < flow.phases.size(); ++p) {
        Json turning = Json::array();
        for (std::size_t k = 0; k < field.modes.size(); ++k)
            if (flow.modes[k].phase == p) turning.push_back(field.modes[k].name);
        for (std::size_t k = 0; k < field.angles.size(); ++k)
            if (flow.angles[k].phase == p) turning.push_back(field.angles[k].name);
        frame.push_back({{"rate", json_expression(*field.ring, flow.phases[p])}, {"turning", turning}});
    }
    for (std::size_t k = 0; k < field.modes.size(); ++k) add(field.modes[k].name, "mode", flow.modes[k].rate);
    for (std::size_t k = 0; k < field.angles.size(); ++k)
        add(field.angles[k].name, "angle", flow.angles[k].rate);
    for (std::size_t k = 0; k < field.slow.size(); ++k) add(field.slow[k].name, "slow", flow.slow[k]);
    for (std::size_t k = 0; k < field.drift.size(); ++k) add(field.drift[k].name, "drift", flow.drift[k]);
    for (const FlowOutput& output : flow.outputs)
        outputs.push_back({{"name", output.name}, {"terms", terms(output.name, output.value)}});
    return {{"frame", std::move(frame)}, {"flow", std::move(rates)}, {"outputs", std::move(outputs)}};
}

} // namespace resonform
