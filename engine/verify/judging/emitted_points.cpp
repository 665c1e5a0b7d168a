// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judging/emitted_points.hpp"

#include "model/files/interval_length.hpp"
#include "model/system/start_names.hpp"
#include "verify/evaluate/scene_values.hpp"

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

} // namespace

template <class Real>
std::vector<EmittedPoints<Real>> emitted_points(const Scene& scene, std::size_t starts, std::size_t times,
                                                std::uint64_t seed) {
    const auto eps_of = [](const Rational& r) { return static_cast<Real>(from_rational<Float128>(r)); };
    const Real high = eps_of(scene.verify.eps.front());
    const Real low = std::max(eps_of(scene.verify.eps.back()) * Real(decades_below), Real(smallest_eps));
    const std::vector<Real> parameters = parameter_values<Real>(scene);
    const Tape expressions = interval_and_starts(scene);
    Dice<Real> dice(seed);
    std::vector<EmittedPoints<Real>> drawn;
    for (std::size_t j = 0; j < starts; ++j) {
        EmittedPoints<Real> d;
        d.eps = dice.log_uniform(low, high);
        const std::vector<Real> values = evaluate_constants<Real>(expressions, parameters, d.eps);
        // Below the ladder the interval may be beyond the range of an evaluator.
        const Real interval = std::clamp(values[0], Real(shortest_interval), Real(longest_interval));
        d.end = d.eps * interval * Real(1 + 0x1p-40); // t = end/eps is rounded
        for (std::size_t k = 0; k < scene.start.size(); ++k) {
            const Real factor =
                j == 0 ? Real(1) : dice.log_uniform(1 / Real(factor_of_starts), Real(factor_of_starts));
            d.start.emplace_back(canonical_start(scene.start[k].name, *scene.system), values[k + 1] * factor);
        }
        for (std::size_t i = 0; i < times; ++i)
            d.times.push_back(interval *
                              (i % 2 == 0 ? dice.uniform() : dice.log_uniform(Real(earliest), Real(1))));
        drawn.push_back(std::move(d));
    }
    return drawn;
}

template std::vector<EmittedPoints<double>> emitted_points(const Scene&, std::size_t, std::size_t,
                                                           std::uint64_t);
template std::vector<EmittedPoints<long double>> emitted_points(const Scene&, std::size_t, std::size_t,
                                                                std::uint64_t);

} // namespace resonform
