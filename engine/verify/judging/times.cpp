// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judging/times.hpp"

#include "model/text/regular.hpp"

#include <algorithm>
#include <cmath>

namespace resonform {

namespace {

constexpr double of_fastest_rate = 1e-3, of_interval = 1e-9;

} // namespace

std::vector<double> even_times(double interval, std::size_t points) {
    std::vector<double> times(points);
    for (std::size_t i = 0; i < points; ++i)
        times[i] = interval * (static_cast<double>(i) / static_cast<double>(points - 1));
    return times;
}

SampleTimes crowded_times(double interval, std::size_t points, double rate) {
    const std::vector<double> even = even_times(interval, points / 2);
    const std::size_t quarter = points / 4;
    SampleTimes times;
    times.first = std::min(of_fastest_rate / rate, of_interval * interval); // of rate 0: infinity
    times.all = even;
    for (std::size_t i = 0; i < quarter; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(quarter);
        const double distance = times.first * std::pow(interval / times.first, share);
        times.all.push_back(distance);
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
    GiNaC::exmap start;
    for (const SlowVariable& slow : field.slow)
        if (const StartValue* value = scene.start_of(slow.name))
            start[scene.system->variables[slow.variable].jet.front()] = value->value;
    const auto size = [&](const GiNaC::ex& value) {
        const auto found = where_regular([&] {
            const GiNaC::ex number = scene.fixed(value.subs(start))
                                         .subs(GiNaC::ex(scene.system->eps) == GiNaC::numeric(cln::cl_N(eps)))
                                         .evalf();
            return GiNaC::is_a<GiNaC::numeric>(number)
                       ? std::abs(GiNaC::ex_to<GiNaC::numeric>(number).to_double())
                       : 0.0;
        });
        return found.value_or(0.0); // it may start at a singularity of the frequency
    };
    double rate = 0;
    for (const ModeShape& mode : field.basis.modes)
        rate = std::max(rate, std::hypot(size(mode.eigenvalue.re), size(mode.eigenvalue.im)));
    for (const AngleVariable& angle : field.angles) rate = std::max(rate, size(angle.law));
    return rate;
}

} // namespace resonform
