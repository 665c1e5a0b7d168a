// SPDX-License-Identifier: GPL-3.0-or-later
// Variables constant at eps = 0, on the time 1/eps: x = C_X + r*log(...) + O(eps^2), or averaged rates.
#include "algebra/number/number.hpp"
#include "emit/derive/derive.hpp"
#include "emit/derive/flow.hpp"
#include "emit/display/display.hpp"
#include "emit/display/solution_display.hpp"
#include "model/text/eps_powers.hpp"

#include <fmt/format.h>

#include <utility>

namespace resonform {

namespace {

// The law of a drift x that oscillates less than it moves; for other drifts, of the mean z_x.
Formula drift_law(const Solution& law, const DriftSolution& drift, std::optional<int> oscillation) {
    const Substitutes substitutes = solution_substitutes(law);
    Side value;
    value.groups.push_back(symbol_sum(drift.constant_name));
    value.groups.push_back(
        display(*law.ring, drift.value.part(0) - law.ring->gen(drift.constant), substitutes));
    for (int n = 1; n <= drift.value.through(); ++n)
        value.groups.push_back(display(*law.ring, drift.value.part(n), substitutes));
    int moves = drift.value.through();
    while (moves > 0 && drift.value.part(moves).empty()) --moves;
    const bool itself = !oscillation || *oscillation > moves;
    value.remainder = drift.value.through() + 1;
    if (itself && oscillation && value.remainder > *oscillation) value.remainder = *oscillation;
    const std::string& name = law.system().variables[drift.variable].name;
    return {side(symbol_sum(itself ? name : "z_" + name)), std::move(value)};
}

// x - C_X, as a factor
DisplayFactor moved(const Solution& law, const DriftSolution& drift) {
    return sum_factor(symbol_sum(law.system().variables[drift.variable].name) +
                      -symbol_sum(drift.constant_name));
}

DisplaySum times(const Ring& ring, const Polynomial& coefficient, DisplayFactor factor) {
    if (coefficient.empty()) return {};
    DisplayTerm term = factored(display(ring, coefficient));
    term.tail.push_back(std::move(factor));
    return term_sum(std::move(term));
}

// y - C_Y = r*cosh((x - C_X)/r)
Formula path_formula(const Solution& law, const DriftPath& path) {
    const Ring& ring = *law.ring;
    const DriftSolution &over = law.drift[path.over], &of = law.drift[path.of];
    const auto exponent = [&](const Polynomial& inverse_scale) {
        DisplayTerm term = factored(display(ring, inverse_scale));
        term.factors.insert(term.factors.begin(), moved(law, over));
        return term_sum(std::move(term));
    };
    const Polynomial inverse = *ring.inverse(path.scale);
    const auto term = [&](const char* function, const Polynomial& coefficient, const Polynomial& of_inverse) {
        return times(ring, coefficient, function_factor(function, exponent(of_inverse)));
    };
    Side right;
    right.groups = {display(ring, path.offset), times(ring, path.slope, moved(law, over))};
    if (path.rising == path.falling)
        right.groups.push_back(term("cosh", Rational(2) * path.rising, inverse));
    else if (path.rising == -path.falling)
        right.groups.push_back(term("sinh", Rational(2) * path.rising, inverse));
    else
        right.groups.insert(right.groups.end(),
                            {term("exp", path.rising, inverse), term("exp", path.falling, -inverse)});
    return {side(moved(law, of).arguments.front()), std::move(right)};
}

std::vector<Section> closed_laws(const Transgression& transgression) {
    const Solution& law = transgression.law;
    Section section = slow_laws(law);
    for (const FormerConstant& constant : transgression.constants)
        for (const DriftSolution& drift : law.drift)
            if (drift.variable == constant.variable)
                section.formulas.push_back(drift_law(law, drift, constant.oscillation));
    if (!transgression.path) return {section};
    return {section, {"path, to leading order", {path_formula(law, *transgression.path)}}};
}

std::string oscillation_remark(const Solution& law, const FormerConstant& constant) {
    const std::string& name = law.system().variables[constant.variable].name;
    const Rational power = law.system().weight(constant.oscillation.value_or(0));
    return constant.oscillation ? fmt::format("{} oscillates about its law: O({})", name,
                                              power == 1 ? "eps" : spell_eps_power(power))
                                : fmt::format("{} does not oscillate through order {}", name,
                                              to_string(law.system().weight(law.order)));
}

} // namespace

Page transgression_page(const Transgression& transgression) {
    const Solution& law = transgression.law;
    Page page;
    page.title =
        fmt::format("transgression of {} on the time 1/eps (normal form and map through weight {})",
                    law.system().name_with_settings(), to_string(law.system().weight(law.truncation)));
    page.sections = law.flow ? leading_flow_sections(law) : closed_laws(transgression);
    for (const FormerConstant& constant : transgression.constants)
        page.remarks.push_back(oscillation_remark(law, constant));
    return page;
}

} // namespace resonform
