// SPDX-License-Identifier: GPL-3.0-or-later
// The values under [fix] of a scene, in numbers.
#pragma once

#include "model/system/scene_file.hpp"
#include "verify/integrate/tape.hpp"

#include <vector>

namespace resonform {

// The parameters of the system, in its order; 1 where the scene fixes none. Real: double, long double,
// Float128.
template <class Real> std::vector<Real> parameter_values(const Scene& scene) {
    std::vector<GiNaC::ex> values;
    for (const Parameter& p : scene.system->parameters) {
        const auto fixed = scene.fix.find(p.name);
        values.push_back(fixed == scene.fix.end() ? GiNaC::ex(1) : fixed->second);
    }
    return evaluate_constants<Real>(Tape::constants(*scene.system, values), std::vector<Real>(values.size()),
                                    Real(0));
}

} // namespace resonform
