// SPDX-License-Identifier: GPL-3.0-or-later
// (15): the equations as the file has them.
#include "emit/derive/derive.hpp"
#include "emit/display/as_written.hpp"
#include "emit/display/json.hpp"
#include "model/exact/equilibrium_shift.hpp"
#include "model/exact/first_order_system.hpp"
#include "model/exact/substitution.hpp"
#include "model/exact/written_form.hpp"
#include "model/mechanics/derivation.hpp"
#include "model/system/names.hpp"
#include "model/text/canonical.hpp"

#include <algorithm>
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

namespace {

// The equations about the equilibrium, as texts: "delta_c' = -(kappa + s)*delta_c - ...".
class DeviationTexts {
public:
    explicit DeviationTexts(const System& system)
        : field_(about_equilibrium(std::make_shared<const FirstOrderSystem>(
              solve_for_highest(std::make_shared<const System>(system))))),
          form_(system) {
        form_.add(system.eps, ExactForm::Kind::eps);
        for (const Parameter& p : system.parameters) form_.add(p.symbol, ExactForm::Kind::parameter);
        for (const State& state : field_->states) {
            const GiNaC::symbol shown(renamed(state.name, state.variable));
            shown_[state.symbol] = shown;
            form_.add(shown, kind_of(state));
        }
    }

    // Of the variables that are measured from the equilibrium, and of those whose rates hold one of these.
    [[nodiscard]] std::vector<Equation> all() {
        std::vector<Equation> equations;
        for (const State& state : field_->states) {
            const Variable& variable = field_->system->variables[state.variable];
            if (state.derivative + 1 != variable.order || !concerns(state)) continue;
            const std::string& rate = variable.jet.back().get_name();
            Equation equation = field_->system->equations[state.variable];
            equation.text = renamed(rate, state.variable) + " = " + text_of(put(state.rate, shown_));
            equation.source.verbatim = false; // the text stands in no file
            equations.push_back(std::move(equation));
        }
        return equations;
    }

private:
    [[nodiscard]] bool is_measured(std::size_t variable) const {
        return field_->system->equilibrium_of(variable) != nullptr;
    }
    [[nodiscard]] bool concerns(const State& state) const {
        return is_measured(state.variable) ||
               std::any_of(field_->states.begin(), field_->states.end(), [&](const State& other) {
                   return is_measured(other.variable) && state.rate.has(other.symbol);
               });
    }
    [[nodiscard]] std::string renamed(const std::string& jet, std::size_t variable) const {
        return is_measured(variable) ? deviation_name(jet) : jet;
    }
    [[nodiscard]] ExactForm::Kind kind_of(const State& state) const {
        if (field_->system->variables[state.variable].role == Role::slow) return ExactForm::Kind::slow;
        return state.derivative == 0 ? ExactForm::Kind::coordinate : ExactForm::Kind::velocity;
    }
    std::string text_of(const GiNaC::ex& rate) {
        try {
            return written(form_, rate);
        } catch (const Error&) { // exact form has no root of something that may be negative
            return spell(rate);
        }
    }

    std::shared_ptr<const FirstOrderSystem> field_;
    ExactForm form_;
    GiNaC::exmap shown_;
};

// c = s/(kappa + s) + delta_c, and the equations with this put in.
void append_equilibrium(Page& page, const System& system) {
    if (system.equilibrium.empty()) return;
    Section section{"about the equilibrium at eps = 0", {}};
    for (const Equilibrium& at : system.equilibrium) {
        const std::string& name = system.variables[at.variable].name;
        std::string text = name + " = ";
        if (!at.value.is_zero()) text.append(spell(at.value)).append(" + ");
        Equation shift{name, text.append(deviation_name(name)), 0, at.source};
        shift.source.verbatim = false;
        section.formulas.push_back(formula_of(shift, {}));
    }
    for (const Equation& equation : DeviationTexts(system).all())
        section.formulas.push_back(formula_of(equation, {}));
    page.sections.push_back(std::move(section));
}

// What the file has, in the variables that [change] replaces.
void append_change(Page& page, const System& system) {
    if (!system.derivation || system.derivation->change.empty()) return;
    Section before{"before the change of variables", {}}, change{"change of variables", {}};
    for (const EquationBefore& e : system.derivation->before)
        before.formulas.push_back(formula_of({{}, e.text, 0, {}}, system.settings));
    for (const EquationBefore& e : system.derivation->change)
        change.formulas.push_back(formula_of({{}, e.variable + " = " + e.text, 0, {}}, system.settings));
    page.sections.push_back(std::move(before));
    page.sections.push_back(std::move(change));
}

Json change_json(const Derivation& derivation) {
    Json equations = Json::array(), values = Json::object();
    for (const EquationBefore& e : derivation.before)
        equations.push_back({{"variable", e.variable}, {"equation", e.text}});
    for (const EquationBefore& e : derivation.change) values[e.variable] = e.text;
    return {{"equations", std::move(equations)}, {"values", std::move(values)}};
}

} // namespace

Page equations_page(const System& system) {
    Page page;
    page.title = "equations of " + system.name_with_settings();
    Section section;
    for (const Equation& equation : system.equations)
        section.formulas.push_back(formula_of(equation, system.settings));
    page.sections.push_back(std::move(section));
    append_change(page, system);
    append_relations(page, system);
    append_equilibrium(page, system);
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
    if (system.derivation && !system.derivation->change.empty())
        document["change"] = change_json(*system.derivation);
    if (!system.equilibrium.empty()) document["equilibrium"] = equilibrium_json(system);
    return document;
}

} // namespace resonform
