// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/display/drift_frame.hpp"

#include "emit/display/display.hpp"
#include "emit/display/free_name.hpp"
#include "emit/display/solution_display.hpp"

#include <algorithm>
#include <cctype>

namespace resonform {

namespace {

std::string capitalised(std::string name) {
    name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
    return name;
}

// X for x, or x_new where X is taken: a system with q and Q has q_new and Q_new.
std::string name_without_drift(const System& system, const std::string& variable,
                               const std::vector<DriftFrame>& others) {
    const auto is_free = [&](const std::string& name) {
        return !is_taken(system, name) && !is_taken(system, "z_" + name) &&
               std::none_of(others.begin(), others.end(),
                            [&](const DriftFrame& other) { return other.name == name; });
    };
    std::string name = capitalised(variable);
    if (!is_free(name)) name = variable;
    while (!is_free(name)) name += "_new";
    return name;
}

// The primitive of x = constant + primitive + O(eps), for a solution in closed form.
Polynomial known_primitive(const Solution& solution, std::size_t variable) {
    for (const DriftSolution& drift : solution.drift) {
        if (drift.variable != variable) continue;
        std::vector<Term> terms;
        for (const Term& term : drift.value.part(0).terms())
            if (solution.ring->exponent(term.monomial, drift.constant) == 0) terms.push_back(term);
        return Polynomial::from_terms(std::move(terms));
    }
    return {};
}

} // namespace

std::vector<DriftFrame> drift_frames(const GradedField& field, const Solution* solution) {
    std::vector<DriftFrame> frames;
    for (const DriftVariable& drift : field.drift) {
        DriftFrame frame{drift.name, drift.name, {}, false, {}};
        const Polynomial primitive =
            solution == nullptr ? Polynomial() : known_primitive(*solution, drift.variable);
        if (!primitive.empty()) {
            frame.removed = true;
            frame.name = name_without_drift(field.system(), drift.name, frames);
            frame.primitive = display(*solution->ring, primitive, solution_substitutes(*solution));
        }
        frame.normal = "z_" + frame.name;
        frames.push_back(std::move(frame));
    }
    return frames;
}

void define_frame(Section& section, const DriftFrame& frame) {
    if (frame.removed) define(section, frame.name, symbol_sum(frame.variable) + -frame.primitive);
}

Polynomial without_known_drift(const Ring& ring, GeneratorId eps, const Polynomial& rate) {
    std::vector<Term> terms;
    for (const Term& term : rate.terms())
        if (ring.weight(term.monomial) != 1 || ring.exponent(term.monomial, eps) != 1) terms.push_back(term);
    return Polynomial::from_terms(std::move(terms));
}

} // namespace resonform
