// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/comparison/break_even.hpp"

#include <algorithm>
#include <cmath>

namespace resonform {

namespace {

constexpr const char* own_name = "emitted";

// The least n >= 1 with construction + n a <= b + (n - 1) c, where the rival takes b to the end of its run
// and c for every further point. Precondition: it holds at the measured n.
double points_against(const BreakEven& own, const RivalAtEqualAccuracy& rival) {
    const auto measured = static_cast<double>(own.measured_points);
    const double each = (own.emitted_seconds - own.construction_seconds) / measured;
    const double to_end = rival.to_end.value_or(*rival.seconds);
    if (own.construction_seconds + each <= to_end || measured <= 1) return 1;
    const double further = (*rival.seconds - to_end) / (measured - 1);
    return std::ceil((own.construction_seconds - to_end + further) / (further - each));
}

bool is_same_task(const BreakEven& a, const BreakEven& b) {
    return a.task == b.task && a.order == b.order && a.measured_points == b.measured_points &&
           a.members == b.members;
}

} // namespace

BreakEven break_even(const std::vector<ComparisonRow>& own, std::vector<RivalAtEqualAccuracy> rivals,
                     const Preparation& prepared, const std::string& failure) {
    BreakEven result;
    const auto slower = [](const ComparisonRow& a, const ComparisonRow& b) {
        if (a.failure.empty() != b.failure.empty()) return a.failure.empty();
        return a.total_seconds() < b.total_seconds();
    };
    const ComparisonRow& fastest = *std::min_element(own.begin(), own.end(), slower);
    result.task = fastest.task;
    result.order = fastest.order;
    result.measured_points = fastest.points;
    result.members = fastest.members;
    result.failure = failure.empty() ? fastest.failure : failure;
    if (!result.failure.empty()) return result;
    result.form = fastest.form;
    result.emitted_seconds = fastest.total_seconds();
    result.construction_seconds = fastest.construction_seconds;
    result.winner = own_name;
    result.rivals = std::move(rivals);
    for (RivalAtEqualAccuracy& rival : result.rivals)
        if (rival.seconds) rival.ratio = *rival.seconds / result.emitted_seconds;
    const RivalAtEqualAccuracy* best = best_rival(result);
    if (best == nullptr) return result;
    if (*best->ratio < 1) {
        result.winner = best->method;
        return result;
    }
    result.points = 1;
    for (const RivalAtEqualAccuracy& rival : result.rivals)
        if (rival.seconds) result.points = std::max(*result.points, points_against(result, rival));
    const double saved = *best->seconds - result.emitted_seconds;
    if (saved > 0)
        result.runs = std::ceil((prepared.derivation_seconds + prepared.compilation_seconds) / saved);
    return result;
}

const RivalAtEqualAccuracy* best_rival(const BreakEven& even) {
    const RivalAtEqualAccuracy* best = nullptr;
    for (const RivalAtEqualAccuracy& rival : even.rivals)
        if (rival.seconds && (best == nullptr || *rival.seconds < *best->seconds)) best = &rival;
    return best;
}

void find_break_even_eps(std::vector<BreakEvenAtEps>& by_eps) {
    for (BreakEvenAtEps& at : by_eps)
        for (BreakEven& task : at.tasks) {
            std::vector<std::pair<Rational, bool>> wins;
            for (const BreakEvenAtEps& other : by_eps)
                for (const BreakEven& same : other.tasks)
                    if (is_same_task(task, same)) wins.emplace_back(other.eps, same.winner == own_name);
            std::sort(wins.begin(), wins.end(),
                      [](const auto& a, const auto& b) { return a.first < b.first; });
            task.eps.reset();
            for (const auto& [eps, won] : wins) {
                if (!won) break;
                task.eps = eps;
            }
        }
}

} // namespace resonform
