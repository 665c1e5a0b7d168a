// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/time_scale.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/number.hpp"
#include "model/text/eps_powers.hpp"
#include "solve/flow/slow_flow.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>

namespace resonform {

void check_time_scale(const Solution& solution, const Scene& scene) {
    const System& system = solution.system();
    const int p = scene.slow_power();
    if (scene.truncation || p < 2) return;
    const NormalForm& normal_form = solution.normalization->normal_form;
    const auto require = [&](std::optional<int> power, const std::string& what) {
        if (power && *power < p)
            refuse(Reason::too_fast,
                   {system.eps_root == 1 ? "on a time scale beyond 1/eps slow flow and drifts go a finite way"
                                         : "on its time scale a scene's slow flow and drifts go a finite way",
                    fmt::format("time_scale = {}, {} of order {}", to_string(system.weight(p)), what,
                                spell_eps_power(system.weight(*power))),
                    fmt::format("use time_scale = {}, or give the truncation yourself",
                                quoted_weight(system.weight(*power))),
                    scene.time_scale_place});
    };
    if (solution.flow) require(flow_power(*normal_form.field, *solution.flow), "the flow has rates");
    for (std::size_t d = 0; d < normal_form.drift.size(); ++d)
        if (const DriftVariable& drift = normal_form.field->drift[d]; scene.wants(drift.name))
            require(lowest_weight(normal_form.drift[d]), drift.name + " has a rate");
}

} // namespace resonform
