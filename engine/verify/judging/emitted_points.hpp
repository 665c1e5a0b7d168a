// SPDX-License-Identifier: GPL-3.0-or-later
// The points at which emitted code is held against the exact solution: seeded, and the same for whoever asks.
#pragma once

#include "model/system/scene_file.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

// A grid t0 + i dt with all digits of dt: its times are no numbers of Real.
template <class Real> struct EmittedGrid {
    Real t0, dt;
    std::vector<std::pair<std::size_t, std::size_t>> places; // number of a point, after those of times; i
};
constexpr std::size_t grid_points = 1024;

// One construction of an evaluator, and the points at which it is asked: times, then those of the grid. Real:
// double, long double.
template <class Real> struct EmittedPoints {
    Real eps, end;                                   // of slow time
    std::vector<std::pair<std::string, Real>> start; // by canonical name
    std::vector<Real> times;
    EmittedGrid<Real> grid;

    [[nodiscard]] Real start_of(const std::string& canonical) const {
        for (const auto& [name, value] : start)
            if (name == canonical) return value;
        return Real(0);
    }
    // Asked at its first time alone. Precondition: it has one.
    [[nodiscard]] EmittedPoints at_first_time() const {
        EmittedPoints first = *this;
        first.times.resize(1);
        if (!first.grid.places.empty()) first.grid.places.resize(1);
        return first;
    }
};

// eps is drawn from the ladder of the scene and three decades below it, log-uniform; start values within a
// factor of 10 of the scene's, and of every second start those that are 0 within +-eps^weight (the first
// start is the scene's); half of the times, the first among them, uniform in [0, interval], and half
// log-uniform from 1e-12 of it; a quarter as many points of a grid in it. Precondition: every parameter is
// fixed.
template <class Real>
std::vector<EmittedPoints<Real>> emitted_points(const Scene& scene, std::size_t starts, std::size_t times,
                                                std::uint64_t seed);

// In double twice as many starts are taken, and five times as many times of each.
struct EmittedCheckOptions {
    std::filesystem::path cache;
    std::function<void(const std::string&)> progress;
    std::size_t starts = 50, times = 20; // of each start
    std::uint64_t seed = 1;
};

// The same options for double: 10^4 points in place of 10^3, for only there values come from tables, too.
EmittedCheckOptions in_double(EmittedCheckOptions options);

// What is found at them.
struct EmittedInType {
    std::string type;         // "double", "long double"
    std::size_t points = 0;   // all
    std::size_t compared = 0; // those that both answer with numbers
    double ulp = 0;           // the largest difference; infinite where statuses disagree, NaN: none is seen
    double phase_share = 0;   // there: what part of the scale is that of phases moved by a slow flow
    std::string output;       // there
    std::string form;         // there: "batch" (verify/judging/emitted_forms.hpp)
    std::string statuses;     // there, if they disagree: "emitted ok, symbolic outside_domain"
    std::vector<std::pair<std::string, double>> at; // there: eps, start values, t

    // Numbers were compared, or statuses that disagree.
    [[nodiscard]] bool has_seen() const { return !at.empty(); }
    // What was found at further points.
    void add(EmittedInType further);
};

} // namespace resonform
