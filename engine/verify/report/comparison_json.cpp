// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/number.hpp"
#include "emit/display/json.hpp"
#include "verify/report/json.hpp"

#include <cstdint>

namespace resonform {

namespace {

using Json = nlohmann::ordered_json;

template <class Value> Json or_null(const std::optional<Value>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json count_of(const std::optional<double>& count) {
    return count ? Json(static_cast<std::uint64_t>(*count)) : Json(nullptr);
}

Json name_of(const std::optional<Form>& form) { return form ? Json(to_string(*form)) : Json(nullptr); }

Json of(const ComparisonRow& r) {
    // One number for tools that want one; each output's own beside it.
    double worst = 0;
    for (const double e : r.max_error) worst = e <= worst ? worst : e;
    Json out{{"eps", to_double(r.eps)},
             {"method", r.method},
             {"setting", r.setting},
             {"task", to_string(r.task)},
             {"form", name_of(r.form)},
             {"order", r.is_emitted() ? json_rational(r.order) : Json(nullptr)},
             {"points", r.points},
             {"members", r.members},
             {"run_members", r.run_members},
             {"rhs", r.is_emitted() ? Json(nullptr) : Json("compiled")},
             {"max_error", r.failure.empty() ? json_number(worst) : Json(nullptr)},
             {"seconds", json_number(r.seconds.median)},
             {"seconds_low", json_number(r.seconds.low)},
             {"seconds_high", json_number(r.seconds.high)},
             {"repetitions", r.seconds.repetitions},
             {"construction_seconds", json_number(r.construction_seconds)},
             {"max_error_by_output", json_numbers(r.max_error)}};
    if (!r.failure.empty()) out["failure"] = r.failure;
    return out;
}

Json of(const RivalAtEqualAccuracy& r) {
    Json out{{"method", r.method}, {"seconds", or_null(r.seconds)}, {"ratio", or_null(r.ratio)}};
    for (const char* key : {"tolerance", "error_ratio", "seconds_low", "seconds_high", "repetitions"})
        out[key] = nullptr;
    if (!r.seconds) return out;
    out["tolerance"] = json_number(r.tolerance);
    out["error_ratio"] = json_number(r.error_ratio);
    out["seconds_low"] = json_number(r.spread.low);
    out["seconds_high"] = json_number(r.spread.high);
    out["repetitions"] = r.spread.repetitions;
    return out;
}

Json of(const BreakEven& b) {
    Json rivals = Json::array();
    for (const RivalAtEqualAccuracy& r : b.rivals) rivals.push_back(of(r));
    const bool compared = b.failure.empty();
    return {{"emitted_seconds", compared ? json_number(b.emitted_seconds) : Json(nullptr)},
            {"form", name_of(b.form)},
            {"order", json_rational(b.order)},
            {"measured_points", b.measured_points},
            {"members", b.members},
            {"rivals", rivals},
            {"winner", compared ? Json(b.winner) : Json(nullptr)},
            {"points", count_of(b.points)},
            {"eps", b.eps ? Json(to_double(*b.eps)) : Json(nullptr)},
            {"runs", count_of(b.runs)}};
}

// At one eps: of each task that of the highest order and the most points, and all of them.
Json of(const BreakEvenAtEps& at) {
    Json tasks = Json::object(), all = Json::array();
    for (const BreakEven& b : at.tasks) {
        tasks[to_string(b.task)] = of(b); // the last stays
        Json one{{"task", to_string(b.task)}};
        one.update(of(b));
        all.push_back(std::move(one));
    }
    return {{"eps", to_double(at.eps)}, {"break_even", tasks}, {"all", all}};
}

Json of(const Machine& m, bool pinned) {
    return {{"processor", m.processor}, {"processors", m.processors},
            {"load", or_null(m.load)},  {"instructions", m.instructions},
            {"loops", m.loops},         {"compiler", m.compiler},
            {"pinned", pinned}};
}

} // namespace

Json to_json(const Comparison& c) {
    Json rows = Json::array(), by_eps = Json::array(), prepared = Json::array();
    for (const ComparisonRow& r : c.rows) rows.push_back(of(r));
    for (const BreakEvenAtEps& at : c.by_eps) by_eps.push_back(of(at));
    for (const Preparation& p : c.prepared)
        prepared.push_back({{"order", json_rational(p.order)},
                            {"derivation_seconds", json_number(p.derivation_seconds)},
                            {"compilation_seconds", json_number(p.compilation_seconds)}});
    return {{"schema", "resonform.comparison/1"},
            {"system", c.system},
            {"scene", c.scene},
            {"eps", by_eps.front()["eps"]},
            {"machine", of(c.machine, c.pinned)},
            {"prepared", prepared},
            {"rows", rows},
            {"break_even", by_eps.front()["break_even"]},
            {"by_eps", by_eps}};
}

} // namespace resonform
