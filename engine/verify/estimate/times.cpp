// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/estimate/times.hpp"

#include "algebra/number/number.hpp"
#include "model/files/interval_length.hpp"
#include "model/text/regular.hpp"
#include "solve/flow/slow_flow.hpp"

#include <algorithm>
#include <cmath>

namespace resonform {

namespace {

constexpr double of_fastest_rate = 1e-3, of_interval = 1e-9;
constexpr double of_allowed_error = 1e-3; // what may be left of a transient
constexpr double powers_of_layer = 20;    // of e
constexpr double powers_of_growth = 3;

// The size of an expression where the motion starts; 0: it is no number there, such as at a singularity of
// the frequency.
class SizeAtStart {
public:
    SizeAtStart(const GradedField& field, const Scene& scene, const Rational& eps)
        : scene_(scene), eps_(GiNaC::ex(scene.system->eps) == GiNaC::numeric(cln::cl_N(eps))) {
        for (const SlowVariable& slow : field.slow)
            if (const StartValue* value = scene.start_of(slow.name))
                start_[scene.system->variables[slow.variable].jet.front()] = value->value;
    }

    double operator()(const GiNaC::ex& value) const {
        const auto found = where_regular([&] {
            const GiNaC::ex number = scene_.fixed(value.subs(start_)).subs(eps_).evalf();
            return GiNaC::is_a<GiNaC::numeric>(number)
                       ? std::abs(GiNaC::ex_to<GiNaC::numeric>(number).to_double())
                       : 0.0;
        });
        return found.value_or(0.0);
    }

private:
    const Scene& scene_;
    GiNaC::ex eps_;
    GiNaC::exmap start_;
};

// max 1/|Re lambda| of the modes that are damped; 0: there are none.
double longest_decay(const GradedField& field, const Scene& scene, const Rational& eps) {
    const SizeAtStart size(field, scene, eps);
    double longest = 0;
    for (std::size_t k = 0; k < field.modes.size(); ++k)
        if (field.modes[k].is_damped() && !grows(field, k))
            longest = std::max(longest, 1 / size(field.basis.modes[k].eigenvalue.re));
    return longest;
}

bool any_grows(const GradedField& field) {
    for (std::size_t k = 0; k < field.modes.size(); ++k)
        if (grows(field, k)) return true;
    return false;
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
    const SizeAtStart size(field, scene, eps);
    double rate = 0;
    for (const ModeShape& mode : field.basis.modes)
        rate = std::max(rate, std::hypot(size(mode.eigenvalue.re), size(mode.eigenvalue.im)));
    for (const AngleVariable& angle : field.angles) rate = std::max(rate, size(angle.law));
    return rate;
}

double layer_length(const GradedField& field, const Scene& scene, const Rational& eps) {
    return scene.transients ? powers_of_layer * longest_decay(field, scene, eps) : 0;
}

double layer_end(const GradedField& field, const Scene& scene, const Rational& eps) {
    if (scene.transients || any_grows(field)) return 0;
    const double powers = -std::log(of_allowed_error) - (scene.order + 1) * std::log(to_double(eps));
    return powers * longest_decay(field, scene, eps);
}

double judged_interval(const GradedField& field, const Scene& scene, const Rational& eps) {
    const SizeAtStart size(field, scene, eps);
    double interval = interval_length(scene, eps);
    for (std::size_t k = 0; k < field.modes.size(); ++k)
        if (grows(field, k))
            interval = std::min(interval, powers_of_growth / size(field.basis.modes[k].eigenvalue.re));
    return interval;
}

} // namespace resonform
