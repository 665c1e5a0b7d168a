// SPDX-License-Identifier: GPL-3.0-or-later
// (2), (7)-(10): the lines between a mechanism and its equations.
#include "model/mechanics/derivation.hpp"
#include "emit/derive/derive.hpp"
#include "emit/display/as_written.hpp"
#include "emit/display/json.hpp"

#include <utility>

namespace resonform {

namespace {

const std::vector<DerivationSection>& sections_of(const System& system, bool constraints) {
    return constraints ? system.derivation->constraints : system.derivation->accelerations;
}

const std::vector<std::string>& remarks_of(const System& system, bool constraints) {
    return constraints ? system.derivation->remarks : system.derivation->agreement;
}

} // namespace

Page derivation_page(const System& system, bool constraints) {
    Page page;
    page.title = (constraints ? "constraints of " : "accelerations of ") + system.name_with_settings();
    for (const DerivationSection& lines : sections_of(system, constraints)) {
        Section section;
        section.heading = lines.heading;
        for (const std::string& text : lines.equations)
            section.formulas.push_back(formula_of({{}, text, 0, {}}, system.settings));
        page.sections.push_back(std::move(section));
    }
    if (!constraints) append_relations(page, system);
    page.remarks = remarks_of(system, constraints);
    return page;
}

Json derivation_json(const System& system, bool constraints) {
    Json sections = Json::array();
    for (const DerivationSection& lines : sections_of(system, constraints)) {
        Json equations = Json::array();
        for (const std::string& text : lines.equations)
            equations.push_back(with_values(text, {}, system.settings));
        sections.push_back({{"heading", lines.heading}, {"equations", std::move(equations)}});
    }
    Json document = json_head("resonform.derivation/1", system);
    document.update(Json{{"stage", constraints ? "constraints" : "accelerations"},
                         {"sections", std::move(sections)},
                         {"relations", relations_json(system)},
                         {"remarks", remarks_of(system, constraints)}});
    return document;
}

} // namespace resonform
