// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/json.hpp"

#include <cmath>

namespace resonform {

namespace {

using Json = nlohmann::ordered_json;

Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

Json numbers(const std::vector<double>& values) {
    Json list = Json::array();
    for (const double x : values) list.push_back(number(x));
    return list;
}

Json of(const LadderRung& r) {
    return {{"eps", to_double(r.eps)},
            {"max_error", number(r.max_error)},
            {"rms_error", number(r.rms_error)},
            {"digits", r.digits},
            {"reference_error", number(r.reference_error)}};
}

Json of(const OutputVerdict& o) {
    Json ladder = Json::array();
    for (const LadderRung& r : o.ladder) ladder.push_back(of(r));
    Json out{{"name", o.name},
             {"claimed_order", o.claimed_order},
             {"found_order", o.found_order ? Json(*o.found_order) : Json(nullptr)},
             {"verdict", to_string(o.verdict)},
             {"expected", to_string(o.expected)},
             {"slope", number(o.slope)},
             {"slope_window", {number(o.slope_low_eps), number(o.slope_high_eps)}},
             {"constant", number(o.constant)}};
    if (!o.reason.empty()) out["reason"] = o.reason;
    out["ladder"] = std::move(ladder);
    return out;
}

Json of(const ComparisonRow& r) {
    // One number for tools that want one; each output's own beside it.
    double worst = 0;
    for (const double e : r.max_error) worst = e <= worst ? worst : e;
    Json out{{"method", r.method},
             {"setting", r.setting},
             {"task", to_string(r.task)},
             {"points", r.points},
             {"max_error", r.failure.empty() ? number(worst) : Json(nullptr)},
             {"seconds", number(r.seconds)},
             {"construction_seconds", number(r.construction_seconds)},
             {"max_error_by_output", numbers(r.max_error)}};
    if (!r.failure.empty()) out["failure"] = r.failure;
    return out;
}

Json of(const BreakEven& b) {
    Json rivals = Json::array();
    for (const RivalAtEqualAccuracy& r : b.rivals)
        rivals.push_back({{"method", r.method},
                          {"seconds", r.seconds ? number(*r.seconds) : Json(nullptr)},
                          {"ratio", r.ratio ? number(*r.ratio) : Json(nullptr)}});
    return {{"emitted_seconds", number(b.emitted_seconds)}, {"rivals", rivals}, {"winner", b.winner}};
}

Json of(const WorstPoint& w) {
    Json at = Json::object();
    for (const auto& [name, value] : w.at) at[name] = number(value);
    return {{"output", w.output}, {"ulp", number(w.ulp)}, {"at", at}};
}

} // namespace

Json to_json(const Verification& v) {
    Json outputs = Json::array();
    for (const OutputVerdict& o : v.outputs) outputs.push_back(of(o));
    return {{"schema", "resonform.verification/1"},
            {"system", v.system},
            {"scene", v.scene},
            {"outputs", outputs},
            {"emitted_against_symbolic_ulp", number(v.emitted_against_symbolic)}};
}

Json to_json(const Comparison& c) {
    Json rows = Json::array(), even = Json::object();
    for (const ComparisonRow& r : c.rows) rows.push_back(of(r));
    for (const BreakEven& b : c.break_even) even[to_string(b.task)] = of(b);
    return {{"schema", "resonform.comparison/1"},
            {"system", c.system},
            {"scene", c.scene},
            {"eps", to_double(c.eps)},
            {"rows", rows},
            {"break_even", even}};
}

Json to_json(const Stability& s) {
    Json worst = Json::array(), median = Json::object(), refused = Json::object();
    for (const WorstPoint& w : s.worst) worst.push_back(of(w));
    for (const auto& [name, ulp] : s.median) median[name] = number(ulp);
    for (const auto& [status, count] : s.refused_by) refused[status] = count;
    return {{"schema", "resonform.stability/1"},
            {"system", s.system},
            {"scene", s.scene},
            {"cases", s.cases},
            {"refused", s.refused},
            {"worst", worst},
            {"refused_by", refused},
            {"beyond_reference", s.beyond_reference},
            {"median_ulp", median}};
}

} // namespace resonform
