// SPDX-License-Identifier: GPL-3.0-or-later
// The inputs of a stability sweep: how far each is driven, and the starts that are drawn.
#pragma once

#include "emit/program/program.hpp"
#include "model/system/scene_file.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace resonform {

// |value| = eps^weight * (low ... high), or |value - rest|
struct SweptInput {
    std::string name; // as the evaluator's constructor calls it
    double low, high;
    bool negative = false; // of both signs
    bool zero = false;     // and 0
    Rational weight = 0;   // of a start value
    bool rests = false;    // by [equilibrium]
    double extreme = 0;    // a corner far beyond that is asked and not judged; 0: none
    double judged = 0;     // corners drawn between `high` and this are judged, those up to extreme are not
    double subnormal = 0;  // the same far below
};

struct SweepPoint {
    double eps = 0;
    std::vector<double> parameters, start; // in the order of the program
    std::vector<double> distance = {};     // of start values from where they rest, as they are drawn

    friend bool operator==(const SweepPoint&, const SweepPoint&) = default;
};

constexpr double extreme_phase = 1e14, extreme_slow = 1e150, subnormal_slow = 1e-310;
constexpr double judged_slow = 1e15; // its square beside 1 leaves 20 of 50 digits

// log10(high/low), 0 where nothing but 0 was tried.
double decades(const SweptInput& input);

// In the order eps, parameters, start: eps 1e-12 ... 0.5, parameters 1e-12 ... 1e12 (of both signs unless
// they are declared positive), start values eps^weight * (1e-12 ... 1e3), measured from [equilibrium] where
// there is one; phases to 1e12. Phases and slow variables have a corner far beyond, slow variables one on the
// way there and one among the subnormal numbers.
std::vector<SweptInput> swept_inputs(const Program& program, const System& system);

// The same, each no farther than it may go alone, the other inputs as in the scene, in steps of half a
// decade.
std::vector<SweptInput> reachable_inputs(const Program& program, const Scene& scene,
                                         const std::function<bool(const SweepPoint&)>& inside);

// The times that are looked at from each start.
inline constexpr std::array<double, 6> shares_of_interval{0, 1e-9, 0.1, 1.0 / 3, 0.7, 1};

// The parameters of a system, in its order: those of a point, and of the scene where the program has none.
template <class Real>
std::vector<Real> with_parameters_of(const SweepPoint& at, const Program& program, const System& system,
                                     std::vector<Real> of_scene) {
    for (std::size_t k = 0; k < of_scene.size(); ++k)
        for (std::size_t i = 0; i < at.parameters.size(); ++i)
            if (program.parameters[i].meaning == "parameter " + system.parameters[k].name)
                of_scene[k] = at.parameters[i];
    return of_scene;
}

// The values of all inputs at a point as their ranges are given: signed, of start values the distance over
// eps^weight.
std::vector<double> as_swept(const SweepPoint& point, const std::vector<SweptInput>& inputs);

// An input is at a corner far beyond its range, or far below.
bool is_far_beyond(const SweepPoint& point, const std::vector<SweptInput>& inputs);

// nothing_swept: the inputs with empty ranges; add() then widens `swept` by the values of a point.
std::vector<SweptInput> nothing_swept(std::vector<SweptInput> inputs);
void add(const SweepPoint& point, std::vector<SweptInput>& swept);

// The scene's own, then points of which every other one has one input at a corner, with the rest as in the
// scene: all inputs in turn, at the high and the low one first, then in the middle, at zero, far beyond and,
// drawn, on the way there. In the others all inputs are drawn: log-uniform, each at a corner that is not
// drawn with probability 0.4; in every other of these one input is then moved towards the end of the domain,
// over all but 1 ... 1e-6 of the way. A point not `inside`, or drawn before, is drawn again, 60 times at
// most. Same seed, same points.
std::vector<SweepPoint> sweep_points(const Program& program, const Scene& scene, std::size_t count,
                                     std::uint64_t seed,
                                     const std::function<bool(const SweepPoint&)>& inside);

} // namespace resonform
