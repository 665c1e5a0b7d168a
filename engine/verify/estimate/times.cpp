// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/estimate/times.hpp"

#include "algebra/number/number.hpp"
#include "model/files/interval_length.hpp"
#include "model/text/regular.hpp"
#include "solve/flow/passage.hpp"
#include "solve/flow/slow_flow.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace resonform {

namespace {

constexpr double of_fastest_rate = 1e-3, of_interval = 1e-9;
constexpr double of_allowed_error = 1e-3; // what may be left of a transient
constexpr double powers_of_layer = 20;    // of e
constexpr double powers_of_growth = 3;

// An expression where the motion starts; 0: it is no number there, such as at a singularity of the frequency.
class ValueAtStart {
public:
    ValueAtStart(const GradedField& field, const Scene& scene, const Rational& eps)
        : scene_(scene), eps_(GiNaC::ex(scene.system->eps) == scene.system->small_at(eps)) {
        for (const SlowVariable& slow : field.slow)
            if (const StartValue* value = scene.start_of(slow.name))
                start_[scene.system->variables[slow.variable].jet.front()] = value->value;
    }

    [[nodiscard]] double size(const GiNaC::ex& value) const { return std::abs((*this)(value)); }

    double operator()(const GiNaC::ex& value) const {
        const auto found = where_regular([&] {
            const GiNaC::ex number = scene_.fixed(value.subs(start_)).subs(eps_).evalf();
            return GiNaC::is_a<GiNaC::numeric>(number) ? GiNaC::ex_to<GiNaC::numeric>(number).to_double()
                                                       : 0.0;
        });
        return found.value_or(0.0);
    }

private:
    const Scene& scene_;
    GiNaC::ex eps_;
    GiNaC::exmap start_;
};

bool grows_there(const GradedField& field, std::size_t k, const ValueAtStart& value) {
    return grows(field, k) || (has_either_sign(field, k) && value(field.basis.modes[k].eigenvalue.re) > 0);
}

// max 1/|Re lambda| of the modes that are damped; 0: there are none.
double longest_decay(const GradedField& field, const Scene& scene, const Rational& eps) {
    const ValueAtStart value(field, scene, eps);
    double longest = 0;
    for (std::size_t k = 0; k < field.modes.size(); ++k)
        if (field.modes[k].is_damped() && !grows_there(field, k, value))
            longest = std::max(longest, 1 / value.size(field.basis.modes[k].eigenvalue.re));
    return longest;
}

} // namespace

std::vector<double> even_times(double interval, std::size_t points, double from) {
    std::vector<double> times(points);
    for (std::size_t i = 0; i < points; ++i)
        times[i] = from + (interval - from) * (static_cast<double>(i) / static_cast<double>(points - 1));
    return times;
}

SampleTimes crowded_times(double interval, std::size_t points, double rate, double from) {
    const std::vector<double> even = even_times(interval, points / 2, from);
    const std::size_t quarter = points / 4;
    const double length = interval - from,
                 nearest = std::min(of_fastest_rate / rate, of_interval * length); // of rate 0: infinity
    SampleTimes times;
    times.first = from + nearest;
    times.all = even;
    for (std::size_t i = 0; i < quarter; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(quarter);
        const double distance = nearest * std::pow(length / nearest, share);
        times.all.push_back(from + distance);
        times.all.push_back(interval - distance);
    }
    std::sort(times.all.begin(), times.all.end());
    times.all.erase(std::unique(times.all.begin(), times.all.end()), times.all.end());
    for (std::size_t i = 0, next = 0; i < times.all.size() && next < even.size(); ++i)
        if (times.all[i] == even[next]) {
            times.even.push_back(i);
            ++next;
        }
    return times;
}

double largest_rate(const GradedField& field, const Scene& scene, const Rational& eps) {
    const ValueAtStart value(field, scene, eps);
    double rate = 0;
    for (const ModeShape& mode : field.basis.modes)
        rate = std::max(rate, std::hypot(value(mode.eigenvalue.re), value(mode.eigenvalue.im)));
    for (const AngleVariable& angle : field.angles) rate = std::max(rate, value.size(angle.law));
    return rate;
}

bool grows_at_start(const GradedField& field, const Scene& scene, const Rational& eps) {
    const ValueAtStart value(field, scene, eps);
    for (std::size_t k = 0; k < field.modes.size(); ++k)
        if (grows_there(field, k, value)) return true;
    return false;
}

double digits_lost(const GradedField& field, const Scene& scene, const Rational& eps) {
    const ValueAtStart value(field, scene, eps);
    const double interval = interval_length(scene, eps);
    double most = 0;
    for (std::size_t k = 0; k < field.modes.size(); ++k) {
        if (!may_pass_zero(field, k)) continue;
        const GiNaC::ex& rate = field.basis.modes[k].eigenvalue.re;
        const double begin = value(rate);
        double slope = 0; // of a rate that is linear in them
        for (const SlowVariable& slow : field.slow) {
            const State& state = field.first_order->states[field.first_order->index(slow.variable, 0)];
            slope += value(rate.diff(state.symbol)) * value(state.rate);
        }
        const double end = begin + slope * interval;
        if (begin < 0 && end > 0)
            most = std::max(most, (begin * begin + end * end) / (2 * slope) / std::numbers::ln10);
    }
    return most;
}

double layer_length(const GradedField& field, const Scene& scene, const Rational& eps) {
    return scene.transients ? powers_of_layer * longest_decay(field, scene, eps) : 0;
}

double layer_end(const GradedField& field, const Scene& scene, const Rational& eps) {
    if (scene.transients || grows_at_start(field, scene, eps)) return 0;
    const double powers = -std::log(of_allowed_error) -
                          to_double(scene.system->weight(scene.order + 1)) * std::log(to_double(eps));
    return powers * longest_decay(field, scene, eps);
}

double judged_interval(const GradedField& field, const Scene& scene, const Rational& eps) {
    const ValueAtStart value(field, scene, eps);
    double interval = interval_length(scene, eps);
    for (std::size_t k = 0; k < field.modes.size(); ++k)
        if (grows_there(field, k, value))
            interval = std::min(interval, powers_of_growth / value.size(field.basis.modes[k].eigenvalue.re));
    return interval;
}

} // namespace resonform
