// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/truncation.hpp"

#include "algebra/number/error.hpp"
#include "solve/flow/passage.hpp"
#include "solve/route.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace resonform {

namespace {

constexpr int largest_truncation = 99;

struct Count {
    int truncation;
    const char* formula;
};

// The lowest weight of an output that shows a lasting phase: 0 with angles, else the lowest weight of an
// undamped oscillation, or of one whose damping may vanish; nullopt: there is none.
std::optional<int> lightest(const GradedField& field) {
    if (!field.angles.empty()) return 0;
    std::optional<int> least;
    for (std::size_t k = 0; k < field.modes.size(); ++k) {
        const Mode& mode = field.modes[k];
        if (mode.is_real() || (mode.is_damped() && !may_pass_zero(field, k))) continue;
        const int weight = field.ring->generator(mode.z).weight;
        least = std::min(least.value_or(weight), weight);
    }
    return least;
}

Count counted(const GradedField& field, const Scene& scene, int p) {
    const int order = scene.order;
    const bool drifts = std::any_of(field.drift.begin(), field.drift.end(),
                                    [&](const DriftVariable& d) { return scene.wants(d.name); });
    if (solves_by_quadratures(field) && (p < 2 || !drifts)) {
        if (field.modes.empty()) return {order + p, "N + p"};
        return {std::max(order + p, order + 2 * p - 2), "max(N + p, N + 2p - 2)"};
    }
    const bool driven =
        std::any_of(field.slow.begin(), field.slow.end(), [](const SlowVariable& s) { return s.driven; });
    const std::optional<int> weight = lightest(field);
    if (!weight) return {order + p, "N + p"};
    const Count flow{std::max(order + p, order + 2 * p - 1), "max(N + p, N + 2p - 1)"};
    const int through_slow = order + 2 * p - *weight;
    if (!driven || through_slow <= flow.truncation) return flow;
    return {through_slow, *weight == 0 ? "N + 2p" : "N + 2p - w"};
}

} // namespace

void require_whole_weights(const System& system) {
    if (system.eps_root == 1) return;
    refuse({"a solution is for integer weights and powers of eps",
            fmt::format("multiples of 1/{}", system.eps_root),
            "take eps^(1/q) as the small parameter, or print the normal form",
            {system.file.string(), 0, 0, "equations", ""}});
}

TruncationCount count_truncation(const GradedField& field, const Scene& scene) {
    require_whole_weights(field.system());
    const int order = scene.order;
    if (scene.truncation)
        return {*scene.truncation, fmt::format("plain truncation: M = {}", *scene.truncation)};
    const int p = scene.time_scale.value_or(1);
    for (const SlowVariable& slow : field.slow)
        if (p >= 2 && has_explicit_law(field, slow))
            refuse(Reason::too_fast,
                   {"on a time scale beyond 1/eps the slow variables stay in a compact set",
                    fmt::format("time_scale = {}, {}' = O(eps) of constant sign", p, slow.name),
                    "use time_scale = 1, or give the truncation yourself", scene.time_scale_place});
    const auto [truncation, formula] = counted(field, scene, p);
    if (truncation > largest_truncation)
        refuse(Reason::size,
               {fmt::format("normal forms are computed through weight {} at most", largest_truncation),
                fmt::format("order = {}, time_scale = {} ask for weight {}", order, p, truncation),
                "lower the order or the time scale", scene.order_place});
    const std::string span = p == 1 ? "1/eps" : fmt::format("1/eps^{}", p);
    if (p == 0) return {truncation, fmt::format("order {} on t = O(1): M = {}", order, truncation)};
    return {truncation,
            fmt::format("order {} on t = O({}): rates neglected at weight {} act over {}, so M = {} = {}",
                        order, span, truncation + 1, span, formula, truncation)};
}

} // namespace resonform
