// SPDX-License-Identifier: GPL-3.0-or-later
// (15): the equations as the file has them.
#include "emit/as_written.hpp"
#include "emit/derive.hpp"

#include <utility>

namespace resonform {

Page equations_page(const System& system) {
    Page page;
    page.title = "equations of " + system.name_with_settings();
    Section section;
    for (const Equation& equation : system.equations) {
        WrittenEquation written = as_written(equation, system.settings);
        section.formulas.push_back({side(std::move(written.left)), side(std::move(written.right))});
    }
    page.sections.push_back(std::move(section));
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
    document.update(Json{{"parameters", std::move(parameters)}, {"variables", std::move(variables)}});
    return document;
}

} // namespace resonform
