// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mechanics/changed_equations.hpp"

#include "algebra/number/error.hpp"
#include "model/exact/first_order_system.hpp"
#include "model/exact/invertible.hpp"
#include "model/exact/substitution.hpp"
#include "model/mechanics/equation_texts.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/regular.hpp"

#include <algorithm>
#include <map>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::symbol;

class ChangedEquations {
public:
    explicit ChangedEquations(const ChangeOfEquations& change)
        : change_(change), before_(change.before), after_(change.after), form_(after_),
          texts_(after_, form_, place_of(change.replacements.front().value.source)) {
        form_.set_place(place_of(change.replacements.front().value.source));
        for (std::size_t v = 0; v < after_.variables.size(); ++v)
            if (before_.variable(after_.variables[v].name) == nullptr) fresh_.push_back(v);
        find_orders();
        add_symbols();
        require_invertible();
        solved_ = solve_for_highest(std::make_shared<const System>(before_));
        differentiate();
    }

    std::vector<Equation> run() {
        std::map<std::string, Equation> found;
        const std::vector<std::string> replaced = texts_of_replaced();
        for (std::size_t k = 0; k < fresh_.size(); ++k) {
            Equation equation = derived(replaced[k], old(k));
            equation.variable = after_.variables[fresh_[k]].name;
            found[equation.variable] = equation;
        }
        for (std::size_t v = 0; v < before_.variables.size(); ++v)
            if (!is_replaced(v)) found[before_.variables[v].name] = of_one_that_stays(v);
        std::vector<Equation> equations;
        for (const Variable& v : after_.variables) equations.push_back(found.at(v.name));
        return equations;
    }

private:
    // The k-th replaced variable, and the new one in its place.
    [[nodiscard]] const Equation& old(std::size_t k) const {
        return before_.equations[change_.replacements[k].variable];
    }
    [[nodiscard]] const Variable& replaced(std::size_t k) const {
        return before_.variables[change_.replacements[k].variable];
    }
    [[nodiscard]] const symbol& highest(std::size_t k) const {
        return after_.variables[fresh_[k]].jet[static_cast<std::size_t>(orders_.at(fresh_[k]))];
    }
    [[nodiscard]] bool is_replaced(std::size_t variable) const {
        return std::any_of(change_.replacements.begin(), change_.replacements.end(),
                           [&](const Replacement& r) { return r.variable == variable; });
    }
    [[nodiscard]] bool holds_old(const ex& e) const {
        for (const Replacement& r : change_.replacements)
            for (const symbol& jet : before_.variables[r.variable].jet)
                if (e.has(jet)) return true;
        return false;
    }
    void find_orders();
    void add_symbols();
    void require_invertible();
    void differentiate();
    [[nodiscard]] ex derivative(const ex& e) const;
    [[nodiscard]] ex beyond_equation(std::size_t variable) const;
    [[nodiscard]] ex in_new(const ex& e, const Equation& of) const;
    [[nodiscard]] ex residual_of_replaced(std::size_t k, bool linear) const;
    std::vector<std::string> texts_of_replaced();
    std::vector<std::string> texts_of(const std::vector<ex>& residuals, const std::vector<symbol>& unknowns);
    [[nodiscard]] Equation of_one_that_stays(std::size_t variable);
    static Equation derived(const std::string& text, const Equation& from) {
        Equation equation{from.variable, text, 0, from.source};
        equation.source.verbatim = false; // the text stands in no file
        return equation;
    }

    const ChangeOfEquations& change_;
    const System &before_, &after_;
    ExactForm form_;
    EquationTexts texts_;
    std::vector<std::size_t> fresh_;    // new variables, indices into those of after_
    std::map<std::size_t, int> orders_; // of all variables of after_
    FirstOrderSystem solved_;           // before_
    GiNaC::exmap jets_;                 // phi, phi', ... in the new variables
};

// A new variable has the order of those that depend on it.
void ChangedEquations::find_orders() {
    for (std::size_t v = 0; v < after_.variables.size(); ++v) {
        if (const Variable* stays = before_.variable(after_.variables[v].name)) {
            orders_[v] = stays->order;
            continue;
        }
        const Variable* first = nullptr;
        for (std::size_t k = 0; k < change_.replacements.size(); ++k) {
            const Written& value = change_.replacements[k].value;
            if (!value.value.has(after_.variables[v].jet.front())) continue;
            if (first == nullptr) first = &replaced(k);
            if (first->order == replaced(k).order) continue;
            const auto with_order = [](const Variable& x) {
                return x.name + " (order " + std::to_string(x.order) + ")";
            };
            refuse({"variables that a change replaces by the same new ones have equations of one order",
                    with_order(*first) + " and " + with_order(replaced(k)) + " hold " +
                        in_quotes(after_.variables[v].name),
                    "write the equations in first order, with velocities as variables",
                    place_of(value.source)});
        }
        if (first == nullptr)
            bad_input({"every new variable stands in [change]",
                       in_quotes(after_.variables[v].name) + " does not",
                       "write a replaced variable in it, as x = \"" + after_.variables[v].name +
                           " + ...\", or give its equation",
                       after_.variables[v].place});
        orders_[v] = first->order;
    }
}

void ChangedEquations::add_symbols() {
    using Kind = ExactForm::Kind;
    for (std::size_t v = 0; v < after_.variables.size(); ++v) {
        const Variable& variable = after_.variables[v];
        const bool slow = variable.role == Role::slow;
        for (int k = orders_.at(v); k > 0; --k) {
            const Kind kind = slow ? Kind::rate : k > 1 ? Kind::acceleration : Kind::velocity;
            form_.add(variable.jet[static_cast<std::size_t>(k)], kind);
        }
        form_.add(variable.jet.front(), slow ? Kind::slow : Kind::coordinate);
    }
    for (const Parameter& p : after_.parameters) form_.add(p.symbol, Kind::parameter);
    form_.add(after_.eps, Kind::eps);
}

void ChangedEquations::require_invertible() {
    std::vector<ex> values;
    std::vector<symbol> variables;
    for (const Replacement& r : change_.replacements) values.push_back(r.value.value);
    GiNaC::exmap origin = change_.small;
    for (const Variable& v : after_.variables)
        if (v.role == Role::fast && v.weight > 0) origin[v.jet.front()] = 0;
    for (const std::size_t v : fresh_) variables.push_back(after_.variables[v].jet.front());
    const ex determinant = determinant_of_slopes(values, variables);
    const Place place = place_of(change_.replacements.front().value.source);
    const auto there = where_regular([&] { return put(determinant, origin); });
    if (!there)
        bad_input({"a change of variables has derivatives where the equations are expanded",
                   "the determinant of its derivatives, " + excerpt(spell(determinant)) +
                       ", has no value at the origin of the new variables",
                   "correct it, or choose another origin", place});
    resonform::require_invertible(*there, form_, after_, place);
}

// phi^(k) for one k after the other: what a variable that stays contributes may hold earlier ones.
void ChangedEquations::differentiate() {
    int most = 0;
    for (std::size_t k = 0; k < change_.replacements.size(); ++k) {
        jets_[replaced(k).jet.front()] = change_.replacements[k].value.value;
        most = std::max(most, replaced(k).order);
    }
    for (int n = 1; n <= most; ++n) {
        GiNaC::exmap next;
        for (std::size_t k = 0; k < change_.replacements.size(); ++k) {
            if (n > replaced(k).order) continue;
            const std::vector<symbol>& jet = replaced(k).jet;
            next[jet[static_cast<std::size_t>(n)]] =
                derivative(jets_.at(jet[static_cast<std::size_t>(n - 1)]));
        }
        jets_.insert(next.begin(), next.end());
    }
}

ex ChangedEquations::derivative(const ex& e) const {
    std::vector<TimeDerivative> motion;
    for (std::size_t v = 0; v < after_.variables.size(); ++v) {
        const std::vector<symbol>& jet = after_.variables[v].jet;
        const auto order = static_cast<std::size_t>(orders_.at(v));
        for (std::size_t k = 0; k < order; ++k) motion.push_back({jet[k], jet[k + 1]});
        if (e.has(jet[order])) motion.push_back({jet[order], beyond_equation(v)});
    }
    return along(e, motion);
}

// xi'' of a variable that stays and whose equation gives xi', in the new variables.
ex ChangedEquations::beyond_equation(std::size_t variable) const {
    const Variable* stays = before_.variable(after_.variables[variable].name);
    const auto v = static_cast<std::size_t>(stays - before_.variables.data());
    const ex rate = solved_.states[solved_.index(v, stays->order - 1)].rate;
    ex value = in_new(along(rate, motion_of(solved_)), before_.equations[v]);
    if (holds_old(value))
        refuse({"what a change of variables puts in does not depend on derivatives that it is to give",
                "the derivative of " + stays->jet.back().get_name() + " does",
                "write the equations in first order, with velocities as variables",
                place_of(change_.replacements.front().value.source)});
    return value;
}

ex ChangedEquations::in_new(const ex& e, const Equation& of) const {
    const auto value = where_regular([&] { return put(e, jets_); });
    if (!value)
        bad_input({"the equations have values in the new variables",
                   "the equation of " + of.variable + " is divided by zero", "correct it, or the change",
                   place_of(of.source)});
    return *value;
}

// As written; or phi^(n) - rate, where an equation holds other highest derivatives in a power.
ex ChangedEquations::residual_of_replaced(std::size_t k, bool linear) const {
    if (linear) return in_new(old(k).residual, old(k));
    const std::size_t v = change_.replacements[k].variable;
    const ex& rate = solved_.states[solved_.index(v, replaced(k).order - 1)].rate;
    return in_new(replaced(k).jet.back() - rate, old(k));
}

std::vector<std::string> ChangedEquations::texts_of_replaced() {
    bool linear = true;
    for (std::size_t k = 0; k < fresh_.size(); ++k)
        for (std::size_t i = 0; i < fresh_.size(); ++i) {
            const ex slope = old(k).residual.diff(replaced(i).jet.back());
            for (std::size_t j = 0; j < fresh_.size(); ++j)
                linear = linear && !slope.has(replaced(j).jet.back());
        }
    std::vector<ex> residuals;
    std::vector<symbol> unknowns;
    for (std::size_t k = 0; k < fresh_.size(); ++k) {
        residuals.push_back(residual_of_replaced(k, linear));
        unknowns.push_back(highest(k));
    }
    return texts_of(residuals, unknowns);
}

std::vector<std::string> ChangedEquations::texts_of(const std::vector<ex>& residuals,
                                                    const std::vector<symbol>& unknowns) {
    try {
        const std::vector<std::string> rates = texts_.rates_of(residuals, unknowns);
        return rates.empty() ? texts_.of(residuals, unknowns) : rates;
    } catch (const Error& error) { // exact form has no root of something that may be negative
        if (error.kind() != ErrorKind::refused) throw;
    }
    std::vector<std::string> texts;
    for (const ex& residual : residuals) texts.push_back(spell(residual) + " = 0");
    return texts;
}

Equation ChangedEquations::of_one_that_stays(std::size_t variable) {
    const Equation& equation = before_.equations[variable];
    if (!holds_old(equation.residual)) return {equation.variable, equation.text, 0, equation.source};
    const ex residual = in_new(equation.residual, equation);
    const symbol& unknown = before_.variables[variable].jet.back();
    form_.set_place(place_of(equation.source));
    return derived(texts_of({residual}, {unknown}).front(), equation);
}

} // namespace

std::vector<Equation> changed_equations(const ChangeOfEquations& change) {
    return ChangedEquations(change).run();
}

} // namespace resonform
