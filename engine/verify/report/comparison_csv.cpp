// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/number.hpp"
#include "verify/comparison/comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace resonform {

namespace {

// Empty where there is no number.
std::string field(double number) { return std::isfinite(number) ? fmt::format("{}", number) : ""; }

// Quoted where it has to be (RFC 4180).
std::string field(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

std::vector<std::string> fields(const ComparisonRow& r) {
    std::vector<std::string> all{field(to_double(r.eps)),
                                 field(r.method),
                                 field(r.setting),
                                 to_string(r.task),
                                 r.form ? to_string(*r.form) : "",
                                 r.is_emitted() ? to_string(r.order) : "",
                                 std::to_string(r.points),
                                 std::to_string(r.members),
                                 std::to_string(r.run_members),
                                 r.is_emitted() ? "" : "compiled",
                                 field(r.seconds.median),
                                 field(r.seconds.low),
                                 field(r.seconds.high),
                                 std::to_string(r.seconds.repetitions),
                                 field(r.construction_seconds)};
    for (const double e : r.max_error) all.push_back(field(e));
    all.push_back(field(r.failure));
    return all;
}

} // namespace

std::string to_csv(const Comparison& c) {
    std::string text =
        "eps,method,setting,task,form,order,points,members,run_members,rhs,seconds,seconds_low,"
        "seconds_high,repetitions,construction_seconds,";
    for (const std::string& name : c.outputs) text += field("max_error " + name) + ",";
    text += "failure\n";
    for (const ComparisonRow& r : c.rows) text += fmt::format("{}\n", fmt::join(fields(r), ","));
    return text;
}

} // namespace resonform
