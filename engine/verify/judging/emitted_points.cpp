// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judging/emitted_points.hpp"

#include "model/files/interval_length.hpp"
#include "model/system/start_names.hpp"
#include "verify/evaluate/scene_values.hpp"
#include "verify/judging/start_scaling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace resonform {

namespace {

constexpr double decades_below = 1e-3, earliest = 1e-12; // of the ladder; of the interval
constexpr double factor_of_starts = 10;

// Numbers with all digits of Real.
template <class Real> class Dice {
public:
    explicit Dice(std::uint64_t seed) : random_(seed) {}
    Real uniform() { // in [0, 1)
        const Real coarse = static_cast<Real>(random_() >> 11) * Real(0x1p-53);
        const Real fine = static_cast<Real>(random_() >> 11) * Real(0x1p-106);
        return std::numeric_limits<Real>::digits > 53 ? coarse + fine : coarse;
    }
    Real log_uniform(Real low, Real high) { return low * std::exp(uniform() * std::log(high / low)); }

private:
    std::mt19937_64 random_;
};

// The interval, then the start values.
Tape interval_and_starts(const Scene& scene) {
    std::vector<GiNaC::ex> expressions{scene.verify.interval};
    for (const StartValue& start : scene.start) expressions.push_back(start.value);
    return Tape::constants(*scene.system, expressions);
}

// The equilibrium at these start values of slow variables, to double precision; every parameter is fixed.
template <class Real>
Real rest_at(const Scene& scene, const StartValue& start, const std::vector<Real>& starts) {
    GiNaC::exmap slow;
    for (std::size_t k = 0; k < starts.size(); ++k)
        if (const Variable* v = scene.system->variable(scene.start[k].name);
            v != nullptr && v->role == Role::slow)
            slow[v->jet.front()] = GiNaC::numeric(static_cast<double>(starts[k]));
    const GiNaC::ex rest = scene.fixed(rest_of(*scene.system, start.name, slow)).evalf();
    return static_cast<Real>(GiNaC::ex_to<GiNaC::numeric>(rest).to_double());
}

// The start values of the scene times factors; of what rests elsewhere than at 0 the deviation from there.
template <class Real>
std::vector<Real> multiplied(const Scene& scene, const std::vector<Real>& starts,
                             const std::vector<Real>& factors) {
    std::vector<Real> result;
    for (std::size_t k = 0; k < starts.size(); ++k) result.push_back(starts[k] * factors[k]);
    const std::vector<Real> plain = result;
    for (std::size_t k = 0; k < starts.size(); ++k)
        if (rests_elsewhere(*scene.system, scene.start[k].name))
            result[k] = rest_at(scene, scene.start[k], plain) +
                        (starts[k] - rest_at(scene, scene.start[k], starts)) * factors[k];
    return result;
}

// What starts at 0 has no factor: else no coefficient of it would be seen.
template <class Real>
void move_from_zero(const Scene& scene, const Real& eps, Dice<Real>& dice, std::vector<Real>& start) {
    for (std::size_t k = 0; k < start.size(); ++k) {
        if (start[k] != Real(0)) continue;
        const int weight = start_weight(*scene.system, scene.start[k].name);
        const Real power = static_cast<Real>(from_rational<Float128>(scene.system->weight(weight)));
        start[k] = std::pow(eps, power) * (Real(2) * dice.uniform() - Real(1));
    }
}

// places: dice of their own, so that starts and times do not depend on the grid.
template <class Real>
void draw_points(const Real& interval, std::size_t times, Dice<Real>& dice, Dice<Real>& places,
                 EmittedPoints<Real>& d) {
    d.grid.dt = interval / Real(grid_points);
    d.grid.t0 = dice.uniform() * d.grid.dt;
    for (std::size_t i = 0; i < times; ++i)
        d.times.push_back(interval *
                          (i % 2 == 0 ? dice.uniform() : dice.log_uniform(Real(earliest), Real(1))));
    for (std::size_t k = 0; k < times / 4; ++k)
        d.grid.places.emplace_back(times + k, static_cast<std::size_t>(places.uniform() * Real(grid_points)));
}

} // namespace

void EmittedInType::add(EmittedInType further) {
    further.points += points;
    further.compared += compared;
    if (further.has_seen() && (!has_seen() || further.ulp > ulp)) {
        *this = std::move(further);
        return;
    }
    points = further.points;
    compared = further.compared;
}

EmittedCheckOptions in_double(EmittedCheckOptions options) {
    options.times *= 10; // a start costs more than its times
    return options;
}

template <class Real>
std::vector<EmittedPoints<Real>> emitted_points(const Scene& scene, std::size_t starts, std::size_t times,
                                                std::uint64_t seed) {
    const auto eps_of = [](const Rational& r) { return static_cast<Real>(from_rational<Float128>(r)); };
    const Real high = eps_of(scene.verify.eps.front());
    const Real low = std::max(eps_of(scene.verify.eps.back()) * Real(decades_below), Real(smallest_eps));
    const std::vector<Real> parameters = parameter_values<Real>(scene);
    const Tape expressions = interval_and_starts(scene);
    Dice<Real> dice(seed), places(~seed);
    std::vector<EmittedPoints<Real>> drawn;
    for (std::size_t j = 0; j < starts; ++j) {
        EmittedPoints<Real> d;
        d.eps = dice.log_uniform(low, high);
        const std::vector<Real> values = evaluate_constants<Real>(expressions, parameters, d.eps);
        // Below the ladder the interval may be beyond the range of an evaluator.
        const Real interval = std::clamp(values[0], Real(shortest_interval), Real(longest_interval));
        d.end = d.eps * interval * Real(1 + 0x1p-40); // t = end/eps is rounded
        std::vector<Real> start(values.begin() + 1, values.end());
        std::vector<Real> factors;
        for (std::size_t k = 0; j > 0 && k < start.size(); ++k)
            factors.push_back(dice.log_uniform(1 / Real(factor_of_starts), Real(factor_of_starts)));
        if (j > 0) start = multiplied(scene, start, factors);
        if (j % 2 == 1) move_from_zero(scene, d.eps, dice, start);
        for (std::size_t k = 0; k < scene.start.size(); ++k)
            d.start.emplace_back(canonical_start(scene.start[k].name, *scene.system), start[k]);
        draw_points(interval, times, dice, places, d);
        drawn.push_back(std::move(d));
    }
    return drawn;
}

template std::vector<EmittedPoints<double>> emitted_points(const Scene&, std::size_t, std::size_t,
                                                           std::uint64_t);
template std::vector<EmittedPoints<long double>> emitted_points(const Scene&, std::size_t, std::size_t,
                                                                std::uint64_t);

} // namespace resonform
