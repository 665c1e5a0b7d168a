// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/points/readings.hpp"

#include <algorithm>
#include <future>
#include <stdexcept>
#include <thread>

namespace resonform {

PointReadings::PointReadings(const CertificatePlan& plan, const NormalForm& normal_form,
                             const NearIdentityMap& map, const std::vector<Point>& points, int through) {
    const Ring& ring = *normal_form.field->ring;
    std::size_t terms = 0, slots = 0;
    for (const CertificatePlan::Reading& reading : plan.readings)
        for (const auto& of : reading.sides) slots += 1 + of.slopes.size();
    const std::size_t weights = static_cast<std::size_t>(through) + 1;
    parts_.reserve(plan.readings.size() * weights);
    coefficients_.reserve(slots * weights);
    for (const CertificatePlan::Reading& reading : plan.readings) {
        const Series& from = series_of(reading.series, plan.program, normal_form, map);
        for (int weight = 0; weight <= std::min(through, from.through()); ++weight) {
            if (from.part(weight).empty()) continue;
            parts_.push_back({&reading, &from.part(weight).fractions()});
            terms += parts_.back().numbers->size();
            for (const auto& of : reading.sides) {
                if (of.value >= 0) coefficients_.push_back({of.value, weight, {}});
                for (const auto& [by, slot] : of.slopes)
                    coefficients_.push_back({slot, weight - ring.generator(by).weight, {}});
            }
        }
    }
    // Two threads take a share of the points each. They use no number of CLN, which is not thread-safe.
    constexpr std::size_t enough = std::size_t{1} << 15; // half a millisecond
    if (points.size() < 2 || terms * points.size() < enough || std::thread::hardware_concurrency() < 2) {
        read(ring, points, 0);
        return;
    }
    const std::span<const Point> all(points);
    const std::size_t half = points.size() / 2;
    std::future<void> other = std::async(std::launch::async, [&] { read(ring, all.subspan(half), half); });
    read(ring, all.first(half), 0);
    other.get();
}

// `first` is the index of the first of these points among all.
void PointReadings::read(const Ring& ring, std::span<const Point> points, std::size_t first) {
    PointReader reader(ring, points);
    std::vector<PointReader::Wanted> wanted;
    const CertificatePlan::Reading* reading = nullptr;
    auto to = coefficients_.begin();
    const auto keep = [&](const auto& value) {
        for (std::size_t n = 0; n < points.size(); ++n) to->value[first + n] = value(n);
        ++to;
    };
    for (const Part& part : parts_) {
        if (part.reading != reading) {
            reading = part.reading;
            wanted.clear();
            for (const auto& of : reading->sides) {
                std::vector<GeneratorId> slopes;
                for (const auto& slope : of.slopes) slopes.push_back(slope.first);
                wanted.emplace_back(of.side, slopes);
            }
        }
        reader.read(*part.numbers, wanted);
        for (std::size_t side = 0; side < wanted.size(); ++side) {
            const PointReader::Wanted& w = wanted[side];
            if (reading->sides[side].value >= 0) keep([&](std::size_t n) { return w.value(n); });
            for (std::size_t k = 0; k < reading->sides[side].slopes.size(); ++k)
                keep([&](std::size_t n) { return w.slope(k, n); });
        }
    }
}

const Series& series_of(SeriesName name, const CertificateProgram& program, const NormalForm& normal_form,
                        const NearIdentityMap& map) {
    switch (name.kind) {
    case SeriesName::mode_rate: return normal_form.mode[name.index];
    case SeriesName::angle_rate: return normal_form.angle[name.index];
    case SeriesName::slow_rate: return normal_form.slow[name.index];
    case SeriesName::drift_rate: return normal_form.drift[name.index];
    case SeriesName::mode_shift: return map.mode[name.index];
    case SeriesName::angle_shift: return map.angle[name.index];
    case SeriesName::slow_shift: return map.slow[name.index];
    case SeriesName::drift_shift: return map.drift[name.index];
    case SeriesName::energy: return normal_form.hamiltonian->energy;
    case SeriesName::own: return program.own(name.index);
    }
    throw std::logic_error("series_of: unknown kind");
}

} // namespace resonform
