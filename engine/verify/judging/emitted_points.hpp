// SPDX-License-Identifier: GPL-3.0-or-later
// The points at which emitted code is held against the exact solution: seeded, and the same for whoever asks.
#pragma once

#include "model/system/scene_file.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

// One construction of an evaluator, and the times at which it is asked. Real: double, long double.
template <class Real> struct EmittedPoints {
    Real eps, end;                                   // of slow time
    std::vector<std::pair<std::string, Real>> start; // by canonical name
    std::vector<Real> times;

    [[nodiscard]] Real start_of(const std::string& canonical) const {
        for (const auto& [name, value] : start)
            if (name == canonical) return value;
        return Real(0);
    }
};

// eps is drawn from the ladder of the scene and three decades below it, log-uniform, start values within a
// factor of 10 of the scene's (the first has those), half of the times uniform in [0, interval] and half
// log-uniform from 1e-12 of it. Precondition: every parameter is fixed.
template <class Real>
std::vector<EmittedPoints<Real>> emitted_points(const Scene& scene, std::size_t starts, std::size_t times,
                                                std::uint64_t seed);

} // namespace resonform
