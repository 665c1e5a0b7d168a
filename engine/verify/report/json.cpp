// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/report/json.hpp"

#include "algebra/number/number.hpp"
#include "emit/display/json.hpp"
#include "verify/judging/judge.hpp"

#include <cmath>

namespace resonform {

namespace {

using Json = nlohmann::ordered_json;

Json of(const LadderRung& r) {
    return {{"eps", to_double(r.eps)},
            {"max_error", json_number(r.max_error)},
            {"rms_error", json_number(r.rms_error)},
            {"digits", r.digits},
            {"reference_error", json_number(r.reference_error)}};
}

// The conditions of all verdicts, between the names and the outputs.
void add(Json& json, const Conditions& c) {
    json["times"] = {{"count", c.count},
                     {"first", json_number(c.first)},
                     {"per_fast_period", json_number(c.per_fast_period)},
                     {"from", c.layer_end}};
    json["interval"] = c.interval;
    json["promised"] = c.promised;
    json["shorter_than_promised"] = c.shorter_than_promised;
    for (const auto& [call, value] : c.functions) json["functions"][call] = value;
    json["start"] = Json::object();
    for (const auto& [name, text] : c.start) json["start"][name] = text;
    json["within_layer"] = Json::array();
    for (const Rational& eps : c.within_layer) json["within_layer"].push_back(to_double(eps));
    if (c.growth_end) json["times"]["growth_end"] = *c.growth_end;
    for (const Conditions::Moved& moved : c.moved)
        json["projected"][moved.state] = {{"given", moved.given ? Json(*moved.given) : Json()},
                                          {"start", moved.start}};
    json["ladder_end"] =
        c.ladder_end ? Json{{"eps", to_double(c.ladder_end->eps)}, {"reason", c.ladder_end->reason}} : Json();
}

// Of the estimated error, beside the true one.
Json estimate_of(const OutputVerdict& o) {
    const ErrorEstimate& e = *o.estimate;
    Json ladder = Json::array();
    for (std::size_t i = 0; i < e.ladder.size() && e.next_order > 0; ++i)
        ladder.push_back({{"eps", to_double(e.ladder[i].eps)},
                          {"estimated", json_number(e.ladder[i].error)},
                          {"true", json_number(o.ladder[i].max_error)}});
    const EstimatedRung* told = told_estimate(o);
    Json out{{"map", told ? json_number(told->map) : Json()},
             {"flow", told ? json_number(told->flow) : Json()},
             {"ratio", o.estimate_ratio ? json_number(*o.estimate_ratio) : Json()},
             {"next_order", e.next_order > 0 ? json_rational(o.order(e.next_order)) : Json()}};
    if (!e.reason.empty()) out["reason"] = e.reason;
    out["ladder"] = std::move(ladder);
    return out;
}

Json of(const OutputVerdict& o) {
    const auto order = [&](int held) { return json_rational(o.order(held)); };
    Json ladder = Json::array();
    for (const LadderRung& r : o.ladder) ladder.push_back(of(r));
    Json out{{"name", o.name},
             {"claimed_order", order(o.claimed_order)},
             {"guaranteed_order", o.guaranteed_order ? order(*o.guaranteed_order) : Json(nullptr)},
             {"found_order", o.found_order ? order(*o.found_order) : Json(nullptr)},
             {"verdict", to_string(o.verdict)},
             {"expected", to_string(o.expected)},
             {"slope", json_number(o.slope)},
             {"slope_window", {json_number(o.slope_low_eps), json_number(o.slope_high_eps)}},
             {"constant", json_number(o.constant)}};
    if (!o.reason.empty()) out["reason"] = o.reason;
    out["ladder"] = std::move(ladder);
    for (const LadderRung& r : o.layer) out["layer"].push_back(of(r));
    if (o.estimate) {
        out["error_estimate"] = estimate_of(o);
        out["best_order"] = Json::array();
        for (const BestOrder& b : o.estimate->best)
            out["best_order"].push_back(
                {{"eps", to_double(b.eps)}, {"order", order(b.order)}, {"accuracy", b.accuracy}});
    }
    if (o.data_error)
        out["data_error"] = {{"eps", o.data_error->eps}, {"error", json_number(o.data_error->error)}};
    return out;
}

// Beside the ladder of the output whose equation it is.
void add_defects(Json& outputs, const std::vector<OutputVerdict>& defects) {
    for (Json& output : outputs)
        for (const OutputVerdict& defect : defects) {
            if (output["name"] != defect.name) continue;
            for (const LadderRung& r : defect.ladder) output["defect"].push_back(of(r));
            output["defect_slope"] = json_number(defect.slope);
        }
}

Json of(const EmittedCheck& check) {
    Json types = Json::array();
    for (const EmittedInType& type : check.types) {
        Json at = Json::object();
        for (const auto& [name, value] : type.at) at[name] = json_number(value);
        Json row{{"type", type.type},         {"points", type.points},
                 {"compared", type.compared}, {"ulp", json_number(type.ulp)},
                 {"output", type.output},     {"phase_share", json_number(type.phase_share)},
                 {"form", type.form},         {"at", std::move(at)}};
        if (type.output.empty()) row["output"] = row["phase_share"] = Json();
        if (!type.has_seen()) row["form"] = row["at"] = Json();
        if (!type.statuses.empty()) row["statuses"] = type.statuses;
        types.push_back(std::move(row));
    }
    Json out{{"threshold_ulp", json_number(check.threshold)}, {"verdict", to_string(check.verdict)}};
    if (!check.reason.empty()) out["reason"] = check.reason;
    out["real_types"] = std::move(types);
    return out;
}

Json of(const Lies& lies) {
    const auto or_null = [](const std::string& text) { return text.empty() ? Json() : Json(text); };
    Json out = Json::array();
    for (const Lie& lie : lies.all)
        out.push_back({{"output", or_null(lie.output)},
                       {"where", lie.where},
                       {"planted", lie.planted},
                       {"effect_ulp", json_number(lie.effect_ulp)},
                       {"caught_by", or_null(lie.caught_by)}});
    return out;
}

} // namespace

Json to_json(const Verification& v) {
    Json outputs = Json::array();
    for (const OutputVerdict& o : v.outputs) outputs.push_back(of(o));
    Json json{{"schema", "resonform.verification/1"}, {"system", v.system}, {"scene", v.scene}};
    add(json, v.conditions);
    add_defects(outputs, v.defects);
    json["outputs"] = std::move(outputs);
    json["emitted_against_symbolic_ulp"] = json_number(v.emitted.worst());
    json["emitted_equals_symbolic"] = of(v.emitted);
    if (v.lies) json["liars"] = of(*v.lies);
    return json;
}

} // namespace resonform
