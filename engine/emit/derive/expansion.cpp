// SPDX-License-Identifier: GPL-3.0-or-later
// (16) and (19): the equations expanded, with their remainders.
#include "emit/derive/derive.hpp"
#include "emit/display/display.hpp"
#include "emit/display/drift_frame.hpp"
#include "emit/display/json.hpp"
#include "emit/display/normal_form_parts.hpp"
#include "emit/display/page.hpp"
#include "emit/display/slow_rate.hpp"
#include "expand/expansion/graded_field.hpp"
#include "model/system/names.hpp"

#include <algorithm>
#include <utility>

namespace resonform {

namespace {

// Is it the rate of a slow variable that is not driven? Such a rate is shown unchanged.
bool is_free(const GradedField& field, const EquationLine& line) {
    return std::any_of(field.slow.begin(), field.slow.end(), [&](const SlowVariable& slow) {
        return slow.variable == line.variable && !slow.driven;
    });
}

SeriesWriter writer_of(const GradedField& field, const EquationSeries& equations) {
    std::vector<Polynomial> all;
    for (const EquationLine& line : equations.lines)
        if (!is_free(field, line)) all.push_back(line.series.total(equations.through));
    return {equations.ring, equations.eps, equations.outer(), only_rate_with_eps(field), all};
}

const DriftFrame* frame_of(const std::vector<DriftFrame>& frames, const std::string& variable) {
    for (const DriftFrame& frame : frames)
        if (frame.variable == variable) return &frame;
    return nullptr;
}

class ExpansionPage {
public:
    ExpansionPage(const GradedField& field, int order)
        : field_(field), equations_(expand_equations(field, order)), write_(writer_of(field, equations_)) {}

    [[nodiscard]] Section section(std::string heading, const std::vector<DriftFrame>& frames) const {
        Section result{std::move(heading), {}};
        for (const EquationLine& line : equations_.lines) result.formulas.push_back(formula(line, frames));
        for (const DriftFrame& frame : frames) define_frame(result, frame);
        return result;
    }

private:
    [[nodiscard]] Formula formula(const EquationLine& line, const std::vector<DriftFrame>& frames) const {
        const std::string& variable = field_.system().variables[line.variable].name;
        const DriftFrame* frame = frame_of(frames, variable);
        const bool removed = frame != nullptr && frame->removed;
        Side series;
        for (int n = 0; n <= equations_.through; ++n) {
            const Polynomial& part = line.series.part(n);
            if (is_free(field_, line))
                series.groups.push_back(display(*equations_.ring, part));
            else
                series.groups.push_back(
                    write_(removed ? without_known_drift(*equations_.ring, equations_.eps, part) : part,
                           phases(*equations_.ring)));
        }
        series.remainder = field_.system().weight(line.next_weight);
        if (line.implicit) return {std::move(series), zero_side()};
        return {side(symbol_sum((removed ? frame->name : variable) + "'")), std::move(series)};
    }

    const GradedField& field_;
    EquationSeries equations_;
    SeriesWriter write_;
};

} // namespace

Page expansion_page(const GradedField& field, int order, const Solution* solution) {
    const ExpansionPage expansion(field, order);
    Page page;
    page.title = "equations of " + field.system().name_with_settings() + ", expanded through weight " +
                 to_string(field.system().weight(order));
    page.sections.push_back(expansion.section("", {}));
    const std::vector<DriftFrame> frames = drift_frames(field, solution);
    for (const Equilibrium& at : field.system().equilibrium) {
        const std::string& name = field.system().variables[at.variable].name;
        define(page.sections.front(), name,
               display(*field.ring, field.shift(at.variable, 0)) + symbol_sum(deviation_name(name)));
    }
    bool removed = false;
    for (const DriftFrame& frame : frames) removed = removed || frame.removed;
    if (removed) page.sections.push_back(expansion.section("without the known drift", frames));
    return page;
}

Json expansion_json(const GradedField& field, int order) {
    const EquationSeries equations = expand_equations(field, order);
    const std::vector<GeneratorId> outer = equations.outer();
    Json lines = Json::array();
    for (const EquationLine& line : equations.lines) {
        const std::string& variable = field.system().variables[line.variable].name;
        Json terms = Json::array();
        append_json_terms(terms, *equations.ring, variable, line.series.total(order), outer);
        lines.push_back({{"variable", variable},
                         {"form", line.implicit ? "series = 0" : "rate = series"},
                         {"terms", std::move(terms)},
                         {"next_weight", line.next_weight == 0
                                             ? Json(nullptr)
                                             : json_rational(field.system().weight(line.next_weight))}});
    }
    Json document = json_head("resonform.expansion/1", field.system());
    if (!field.system().equilibrium.empty()) document["equilibrium"] = equilibrium_json(field.system());
    document.update(
        Json{{"order", json_rational(field.system().weight(order))}, {"equations", std::move(lines)}});
    return document;
}

} // namespace resonform
