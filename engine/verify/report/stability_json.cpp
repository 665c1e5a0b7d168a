// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/display/json.hpp"
#include "verify/report/json.hpp"

namespace resonform {

namespace {

using Json = nlohmann::ordered_json;

Json lost_json(const LostDigits& lost) {
    Json operands = Json::array();
    for (const LostDigits::Operand& operand : lost.operands)
        operands.push_back({{"expression", operand.expression}, {"value", json_number(operand.value)}});
    return {{"expression", lost.expression},
            {"value", json_number(lost.value)},
            {"operands", operands},
            {"cancellation", json_number(lost.cancellation)},
            {"growth", json_number(lost.growth)},
            {"share", json_number(lost.share)}};
}

// By name.
template <class Numbers> Json numbers_json(const Numbers& numbers) {
    Json json = Json::object();
    for (const auto& [name, value] : numbers) json[name] = json_number(value);
    return json;
}

Json worst_json(const WorstPoint& w) {
    Json json{{"output", w.output},
              {"ulp", json_number(w.ulp)},
              {"unavoidable_ulp", json_number(w.unavoidable)},
              {"slow_time_ulp", json_number(w.by_slow_time)},
              {"at", numbers_json(w.at)}};
    if (!w.sensitive_to.empty()) json["sensitive_to"] = w.sensitive_to;
    if (w.lost) json["lost"] = lost_json(*w.lost);
    return json;
}

Json ranges_json(const std::vector<SweptInput>& inputs) {
    Json ranges = Json::object();
    for (const SweptInput& input : inputs)
        ranges[input.name] = input.high > 0 ? Json{json_number(input.low), json_number(input.high)} : Json();
    return ranges;
}

Json refusals_json(const std::vector<StabilityRefusals>& refusals) {
    Json all = Json::array();
    for (const StabilityRefusals& r : refusals) {
        all.push_back({{"status", r.status},
                       {"why", r.why},
                       {"count", r.count},
                       {"unexplained", r.unexplained},
                       {"where", ranges_json(r.where)},
                       {"t", {json_number(r.first_t), json_number(r.last_t)}}});
        if (!r.first.empty()) all.back()["first"] = numbers_json(r.first);
    }
    return all;
}

Json histogram_json(const std::vector<UlpBin>& bins) {
    Json all = Json::array();
    for (const UlpBin& bin : bins) all.push_back({json_number(bin.up_to), bin.count});
    return all;
}

// outputs: in the order of the errors.
Json decade_json(const Decade& decade,
                 const std::vector<std::pair<std::string, std::vector<UlpBin>>>& outputs) {
    Json ulp = Json::object();
    for (std::size_t k = 0; k < decade.ulp.size(); ++k) ulp[outputs[k].first] = json_number(decade.ulp[k]);
    return {{"from", decade.from()},
            {"compared", decade.compared},
            {"refused_by", Json(decade.refused_by)},
            {"ulp", ulp}};
}

Json by_decade_json(const Stability& s) {
    Json all = Json::object();
    for (const InputByDecade& own : s.by_decade) {
        Json& decades = all[own.input.name] = Json::array();
        for (const Decade& decade : own.decades) decades.push_back(decade_json(decade, s.histogram));
    }
    return all;
}

} // namespace

Json to_json(const Stability& s) {
    Json worst = Json::array(), histogram = Json::object();
    for (const WorstPoint& w : s.worst) worst.push_back(worst_json(w));
    for (const auto& [name, bins] : s.histogram) histogram[name] = histogram_json(bins);
    Json json{{"schema", "resonform.stability/1"},
              {"system", s.system},
              {"scene", s.scene},
              {"seed", s.seed},
              {"verdict", to_string(s.verdict)},
              {"rule", s.rule.empty() ? Json() : Json(s.rule)},
              {"threshold_ulp", s.threshold},
              {"ranges", ranges_json(s.inputs)},
              {"swept", ranges_json(s.swept)},
              {"cases", s.cases},
              {"compared", s.compared},
              {"refused", s.refused},
              {"unexplained", s.unexplained},
              {"worst", worst},
              {"refused_by", Json(s.refused_by)},
              {"refusals", refusals_json(s.refusals)},
              {"beyond_reference", s.beyond_reference},
              {"not_judged", s.not_judged},
              {"not_judged_ulp", numbers_json(s.not_judged_ulp)},
              {"not_judged_refused_by", Json(s.not_judged_refused_by)},
              {"ill_conditioned", s.ill_conditioned},
              {"moderately_ill_conditioned", s.moderately_ill_conditioned},
              {"median_ulp", numbers_json(s.median)},
              {"histogram_ulp", histogram},
              {"by_decade", by_decade_json(s)}};
    if (!s.reason.empty()) json["reason"] = s.reason;
    return json;
}

} // namespace resonform
