// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/points/at_points.hpp"

#include "model/text/diagnostic.hpp"

#include <fmt/format.h>

#include <cmath>

namespace resonform {

namespace {

constexpr int fewest_points = 2;
constexpr int unlucky_points_allowed = 64;

} // namespace

int points_needed(double bound, const System& system) {
    if (!(bound < 0.1))
        refuse(
            Reason::size,
            {"one random point of the certificate leaves an error probability below 0.1",
             fmt::format("{:.2g}", bound),
             "ask for a lower order, or write fewer functions, powers and quotients inside of one another: "
             "each multiplies the degree that the bound follows from",
             whole_file(system.file)});
    return std::max(fewest_points, static_cast<int>(std::ceil(std::log(wanted_error) / std::log(bound))));
}

std::string complaint_of(const CertificatePlan& plan, const System& system, int order,
                         const std::function<bool(Slot slot, int weight)>& vanishes) {
    const VanishingCheck* worst = nullptr;
    int lowest = 0;
    for (const VanishingCheck& check : plan.checks) {
        if (worst != nullptr && worst->stage < check.stage) continue;
        const int last = check.weight + (check.above_order ? order : 0);
        int weight = 0;
        while (weight <= last && vanishes(check.slot, weight)) ++weight;
        if (weight > last || (worst != nullptr && worst->stage == check.stage && weight >= lowest)) continue;
        worst = &check;
        lowest = weight;
    }
    return worst == nullptr ? ""
                            : fmt::format("weight {}: {}", to_string(system.weight(lowest)), worst->sentence);
}

std::string complaint_of(const CertificatePlan& plan, const PointRun& run, std::size_t n,
                         const System& system, int order) {
    return complaint_of(plan, system, order,
                        [&](Slot slot, int weight) { return run(slot, weight, n) == 0; });
}

void refuse_undetermined(const System& system) {
    refuse({"at the origin no denominator of the equations vanishes and their highest derivatives are "
            "determined",
            system.name,
            "divide the equations by what vanishes at the origin",
            {}});
}

void UnluckyPoints::count(const System& system) {
    if (++so_far_ > unlucky_points_allowed) refuse_undetermined(system);
}

} // namespace resonform
