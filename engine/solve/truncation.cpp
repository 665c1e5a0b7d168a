// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/truncation.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/number.hpp"
#include "model/text/eps_powers.hpp"
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
    const char* formula; // "1" and "2" in it are weights in units of the least one
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

TruncationCount count_truncation(const GradedField& field, const Scene& scene) {
    const auto text = [&](int held) { return to_string(field.system().weight(held)); };
    const int order = scene.order, root = field.system().eps_root;
    if (scene.truncation)
        return {*scene.truncation, fmt::format("plain truncation: M = {}", text(*scene.truncation))};
    const int p = scene.time_scale.value_or(root);
    const std::string least = root == 1 ? "eps" : spell_eps_power(field.system().weight(1));
    for (const SlowVariable& slow : field.slow)
        if (const auto law = explicit_law(field, slow); p >= 2 && law && !law->relaxes())
            refuse(
                Reason::too_fast,
                {fmt::format("on a time scale beyond 1/{} the slow variables stay in a compact set", least),
                 fmt::format("time_scale = {}, {}' = O({}) of constant sign", text(p), slow.name, least),
                 fmt::format("use time_scale = {}, or give the truncation yourself",
                             quoted_weight(field.system().weight(1))),
                 scene.time_scale_place});
    const auto [truncation, formula] = counted(field, scene, p);
    if (truncation > largest_truncation * root)
        refuse(Reason::size,
               {fmt::format("normal forms are computed through weight {} at most", largest_truncation),
                fmt::format("order = {}, time_scale = {} ask for weight {}", text(order), text(p),
                            text(truncation)),
                "lower the order or the time scale", scene.order_place});
    if (p == 0)
        return {truncation, fmt::format("order {} on t = O(1): M = {}", text(order), text(truncation))};
    const std::string span = p == root ? "1/eps" : "1/" + spell_eps_power(field.system().weight(p));
    return {truncation,
            fmt::format("order {} on t = O({}): rates neglected at weight {} act over {}, so M = {} = {}{}",
                        text(order), span, text(truncation + 1), span, formula, text(truncation),
                        root == 1 ? "" : fmt::format(" (1 in it stands for the least weight, 1/{})", root))};
}

} // namespace resonform
