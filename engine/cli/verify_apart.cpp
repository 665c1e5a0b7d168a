// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/verify_apart.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/number.hpp"
#include "cli/apart.hpp"
#include "cli/pipeline.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace resonform {

namespace {

const char* const within_limits = "it is derived within --time-limit, --memory-limit and --term-limit";

// Derives under the limits; a certificate that does not hold is a refusal.
Derive derive_under(DerivationLimits limits) {
    limits.json = false; // the document is that of the verdicts
    return [limits](const std::shared_ptr<const System>& system, int order, int truncation) {
        try {
            return watched(limits,
                           [&](Watch& watch) { return solve_system(system, order, truncation, watch); });
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::check_failed) throw;
            refuse({error.diagnostic().rule, error.diagnostic().value, "", {}});
        }
    };
}

std::string packed(const Guarantees& guarantees) {
    nlohmann::json all;
    for (const auto& [name, g] : guarantees) all[name] = {g.order.value_or(-1), g.refuted, g.reason};
    return all.dump();
}

Guarantees unpacked_guarantees(const std::string& text) {
    Guarantees guarantees;
    const nlohmann::json all = nlohmann::json::parse(text);
    for (const auto& [name, g] : all.items())
        guarantees[name] = {g[0] < 0 ? std::nullopt : std::optional<int>(g[0]), g[1], g[2]};
    return guarantees;
}

// Infinity, which JSON has no number for, is null.
std::string packed(const ErrorEstimates& estimates) {
    nlohmann::json all;
    for (const auto& [name, e] : estimates) {
        nlohmann::json ladder = nlohmann::json::array();
        for (const EstimatedRung& r : e.ladder) ladder.push_back({r.map, r.flow, r.error, r.rounding});
        nlohmann::json best = nlohmann::json::array();
        for (const BestOrder& b : e.best)
            best.push_back({to_string(b.eps), b.order, b.accuracy, b.looked_at});
        all[name] = {e.next_order, e.reason, ladder, best};
    }
    return all.dump();
}

ErrorEstimates unpacked_estimates(const std::string& text, const std::vector<Rational>& eps) {
    const auto number = [](const nlohmann::json& x) {
        return x.is_null() ? std::numeric_limits<double>::infinity() : x.get<double>();
    };
    ErrorEstimates estimates;
    const nlohmann::json all = nlohmann::json::parse(text);
    for (const auto& [name, e] : all.items()) {
        ErrorEstimate& estimate = estimates[name];
        estimate.next_order = e[0];
        estimate.reason = e[1];
        for (std::size_t i = 0; i < e[2].size(); ++i) {
            const nlohmann::json& r = e[2][i];
            estimate.ladder.push_back({eps[i], number(r[0]), number(r[1]), number(r[2]), number(r[3])});
        }
        for (const nlohmann::json& b : e[3])
            estimate.best.push_back({parse_rational(b[0].get<std::string>()), b[1], b[2], b[3]});
    }
    return estimates;
}

} // namespace

Guarantees guarantees_apart(const Scene& scene, const Solution& solution, const Claims& claims,
                            DerivationLimits limits) {
    const auto nothing = [](const auto&, int, int) -> Solution { refuse({within_limits, "", "", {}}); };
    const Apart done =
        done_apart([&] { return packed(guarantees(scene, solution, claims, derive_under(limits))); });
    return done.ended ? unpacked_guarantees(done.text) : guarantees(scene, solution, claims, nothing);
}

ErrorEstimates error_estimates_apart(const Scene& scene, const Solution& solution,
                                     const std::vector<Rational>& eps, DerivationLimits limits) {
    const auto unknown = [&](const std::string& why) {
        ErrorEstimates estimates;
        for (const std::string& name : scene.outputs)
            estimates[name].reason = "the next weight cannot be derived: " + why;
        return estimates;
    };
    const Apart done = done_apart([&] {
        try {
            return packed(error_estimates(scene, solution, eps, derive_under(limits)));
        } catch (const Error& error) {
            return packed(unknown(told(error)));
        }
    });
    return done.ended ? unpacked_estimates(done.text, eps) : unknown(within_limits);
}

} // namespace resonform
