// SPDX-License-Identifier: GPL-3.0-or-later
// (15): the equations as the file has them.
#include "emit/derive/derive.hpp"
#include "emit/display/as_written.hpp"
#include "emit/display/json.hpp"

#include <utility>

namespace resonform {

Formula formula_of(const Equation& equation, const std::vector<Setting>& settings) {
    WrittenEquation written = as_written(equation, settings);
    return {side(std::move(written.left)), side(std::move(written.right))};
}

void append_relations(Page& page, const System& system) {
    if (system.relations.empty()) return;
    Section section;
    section.heading = "relations";
    for (const ParameterRelation& r : system.relations)
        section.formulas.push_back(
            formula_of({r.parameter, r.parameter + " = " + r.text, 0, r.source}, system.settings));
    page.sections.push_back(std::move(section));
}

Json relations_json(const System& system) {
    Json relations = Json::array();
    for (const ParameterRelation& r : system.relations)
        relations.push_back({{"parameter", r.parameter}, {"value", r.text}});
    return relations;
}

Page equations_page(const System& system) {
    Page page;
    page.title = "equations of " + system.name_with_settings();
    Section section;
    for (const Equation& equation : system.equations)
        section.formulas.push_back(formula_of(equation, system.settings));
    page.sections.push_back(std::move(section));
    append_relations(page, system);
    return page;
}

Json equations_json(const System& system) {
    Json parameters = Json::array(), variables = Json::array();
    for (const Parameter& p : system.parameters)
        parameters.push_back(
            {{"name", p.name}, {"positive", p.positive}, {"nonzero", p.nonzero || p.positive}});
    for (std::size_t i = 0; i < system.variables.size(); ++i)
        variables.push_back({{"name", system.variables[i].name},
                             {"role", to_string(system.variables[i].role)},
                             {"equation", system.equations[i].text}});
    Json document = json_head("resonform.equations/1", system);
    document.update(Json{{"parameters", std::move(parameters)},
                         {"relations", relations_json(system)},
                         {"variables", std::move(variables)}});
    return document;
}

} // namespace resonform
