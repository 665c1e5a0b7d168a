// SPDX-License-Identifier: GPL-3.0-or-later
// The solution as JSON: schema resonform.solution/1. Primitives are named, and listed before use.
#include "emit/derive/derive.hpp"
#include "emit/derive/flow.hpp"
#include "emit/display/json.hpp"
#include "emit/display/solution_display.hpp"

#include <utility>

namespace resonform {

namespace {

const char* name_of(PrimitiveKind kind) {
    switch (kind) {
    case PrimitiveKind::logarithm: return "logarithm";
    case PrimitiveKind::quadrature: return "quadrature";
    case PrimitiveKind::exponential: return "exponential";
    }
    return "";
}

class SolutionJson {
public:
    explicit SolutionJson(const Solution& solution) : solution_(solution), ring_(*solution.ring) {}

    // xi' = eps*(rate - decline*xi) from start
    [[nodiscard]] Json slow() const {
        Json list = Json::array();
        for (const SlowLaw& law : solution_.slow) {
            list.push_back({{"variable", name(law.variable)},
                            {"start", name(law.variable) + "_0"},
                            {"rate", json_expression(ring_, law.path.drive)}});
            if (law.path.relaxes()) list.back()["decline"] = json_expression(ring_, law.path.decline);
        }
        return list;
    }

    // Delta = eps*amplitude*envelope*sum factor,  theta = phase + int_0^t sum phase_rate dt
    [[nodiscard]] Json modes() const {
        Json list = Json::array();
        for (const ModeSolution& mode : solution_.modes)
            list.push_back({{"variable", name(mode.variable)},
                            {"amplitude", mode.amplitude_name},
                            {"phase", mode.phase_name},
                            {"envelope", json_expression(ring_, mode.envelope)},
                            {"factor", powers(mode.factor)},
                            {"phase_rate", powers(mode.phase_rate)}});
        return list;
    }

    [[nodiscard]] Json drift() const {
        Json list = Json::array();
        for (const DriftSolution& drift : solution_.drift)
            list.push_back({{"variable", name(drift.variable)},
                            {"constant", drift.constant_name},
                            {"value", powers(drift.value)}});
        return list;
    }

    // A quadrature runs from xi_0 to xi, or over slow time from 0 to eps*t.
    [[nodiscard]] Json primitives() const {
        Json list = Json::array();
        for (const Primitive& primitive : solution_.primitives) {
            Json json = {{"name", primitive.name},
                         {"kind", name_of(primitive.kind)},
                         {"argument", json_expression(ring_, primitive.argument)}};
            if (primitive.kind == PrimitiveKind::quadrature)
                json["over"] = primitive.over_slow_time || solution_.slow.empty()
                                   ? slow_time_name(solution_)
                                   : name(solution_.slow.front().variable);
            list.push_back(std::move(json));
        }
        return list;
    }

    [[nodiscard]] Json outputs() const {
        Json list = Json::array();
        for (const SolutionOutput& output : solution_.outputs) {
            Json terms = Json::array();
            for (int n = 0; n <= output.value.through(); ++n)
                for (const Harmonic& harmonic : harmonics(solution_, output.value.part(n)))
                    terms.push_back({{"eps", n},
                                     {"harmonic", harmonic.multiple},
                                     {"function", harmonic.multiple == 0 ? "1"
                                                  : harmonic.sine        ? "sin"
                                                                         : "cos"},
                                     {"coefficient", expression(harmonic.coefficient)}});
            list.push_back({{"name", output.name}, {"terms", std::move(terms)}});
        }
        return list;
    }

private:
    [[nodiscard]] const std::string& name(std::size_t variable) const {
        return solution_.system().variables[variable].name;
    }

    // Without its power of eps.
    [[nodiscard]] std::string expression(const Polynomial& p) const {
        std::vector<Term> terms;
        for (const Term& term : p.terms()) {
            const int power = ring_.exponent(term.monomial, solution_.eps);
            terms.push_back({term.monomial - ring_.monomial(solution_.eps, power), term.coefficient});
        }
        return json_expression(ring_, Polynomial::from_terms(std::move(terms)));
    }

    [[nodiscard]] Json powers(const Series& series) const {
        Json list = Json::array();
        for (int n = 0; n <= series.through(); ++n)
            if (!series.part(n).empty())
                list.push_back({{"eps", n}, {"coefficient", expression(series.part(n))}});
        return list;
    }

    const Solution& solution_;
    const Ring& ring_;
};

Json former_constants(const Transgression& transgression) {
    Json list = Json::array();
    for (const FormerConstant& constant : transgression.constants) {
        const Variable& variable = transgression.law.system().variables[constant.variable];
        list.push_back(
            {{"variable", variable.name},
             {"role", to_string(variable.role)},
             {"oscillation", constant.oscillation
                                 ? json_rational(transgression.law.system().weight(*constant.oscillation))
                                 : Json(nullptr)}});
    }
    return list;
}

Json path_json(const Solution& law, const DriftPath& path) {
    const auto name = [&](std::size_t drift) {
        return law.system().variables[law.drift[drift].variable].name;
    };
    const auto text = [&](const Polynomial& p) { return json_expression(*law.ring, p); };
    return {{"variable", name(path.of)},    {"over", name(path.over)},   {"offset", text(path.offset)},
            {"slope", text(path.slope)},    {"scale", text(path.scale)}, {"rising", text(path.rising)},
            {"falling", text(path.falling)}};
}

} // namespace

Json transgression_json(const Transgression& transgression) {
    const Solution& law = transgression.law;
    Json document = json_head("resonform.transgression/1", law.system());
    document.update(Json{{"order", json_rational(law.system().weight(law.order))},
                         {"truncation", json_rational(law.system().weight(law.truncation))},
                         {"former_constants", former_constants(transgression)}});
    if (law.flow) {
        document.update(leading_flow_json(law));
        return document;
    }
    const SolutionJson parts(law);
    Json drift = parts.drift();
    for (std::size_t d = 0; d < law.drift.size(); ++d)
        drift[d]["remainder"] = law.drift[d].value.through() + 1;
    document.update(
        Json{{"slow", parts.slow()}, {"drift", std::move(drift)}, {"primitives", parts.primitives()}});
    if (transgression.path) document["path"] = path_json(law, *transgression.path);
    return document;
}

Json solution_json(const Solution& solution) {
    Json document = json_head("resonform.solution/1", solution.system());
    document.update(Json{{"order", json_rational(solution.system().weight(solution.order))},
                         {"truncation", json_rational(solution.system().weight(solution.truncation))}});
    if (solution.flow) {
        document.update(flow_json(solution));
        return document;
    }
    const SolutionJson parts(solution);
    document.update(Json{{"slow", parts.slow()},
                         {"modes", parts.modes()},
                         {"drift", parts.drift()},
                         {"primitives", parts.primitives()},
                         {"outputs", parts.outputs()}});
    return document;
}

} // namespace resonform
