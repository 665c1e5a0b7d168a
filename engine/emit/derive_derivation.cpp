// SPDX-License-Identifier: GPL-3.0-or-later
// (2), (7)-(10): the lines between a mechanism and its equations.
#include "emit/as_written.hpp"
#include "emit/derive.hpp"
#include "model/derivation.hpp"

#include <utility>

namespace resonform {

namespace {

const std::vector<DerivationSection>& sections_of(const System& system, bool constraints) {
    return constraints ? system.derivation->constraints : system.derivation->accelerations;
}

Formula formula_of(const std::string& text) {
    Equation equation;
    equation.text = text;
    WrittenEquation written = as_written(equation);
    return {side(std::move(written.left)), side(std::move(written.right))};
}

} // namespace

Page derivation_page(const System& system, bool constraints) {
    Page page;
    page.title = (constraints ? "constraints of " : "accelerations of ") + system.name_with_settings();
    for (const DerivationSection& lines : sections_of(system, constraints)) {
        Section section;
        section.heading = lines.heading;
        for (const std::string& text : lines.equations) section.formulas.push_back(formula_of(text));
        page.sections.push_back(std::move(section));
    }
    if (constraints) page.remarks = system.derivation->remarks;
    return page;
}

Json derivation_json(const System& system, bool constraints) {
    Json sections = Json::array();
    for (const DerivationSection& lines : sections_of(system, constraints))
        sections.push_back({{"heading", lines.heading}, {"equations", lines.equations}});
    Json document = json_head("resonform.derivation/1", system);
    document.update(Json{{"stage", constraints ? "constraints" : "accelerations"},
                         {"sections", std::move(sections)},
                         {"remarks", constraints ? Json(system.derivation->remarks) : Json::array()}});
    return document;
}

} // namespace resonform
