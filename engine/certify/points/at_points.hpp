// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a plan at as many random points as bring the probability of an error to wanted_error.
#pragma once

#include "algebra/number/error.hpp"
#include "certify/points/plan.hpp"
#include "certify/points/point.hpp"
#include "certify/points/readings.hpp"
#include "certify/points/sampler.hpp"
#include "expand/expansion/graded_field.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace resonform {

constexpr double wanted_error = 1e-30;

// bound: of the probability of an error at one point (bound.hpp). Error (refused): it is too large.
int points_needed(double bound, const System& system);

// The first check that fails, by stage and then by weight; "" if all hold.
std::string complaint_of(const CertificatePlan& plan, const System& system, int order,
                         const std::function<bool(Slot slot, int weight)>& vanishes);
// At the n-th point of a run.
std::string complaint_of(const CertificatePlan& plan, const PointRun& run, std::size_t n,
                         const System& system, int order);

// Error (refused): the equations do not determine their highest derivatives at the origin.
[[noreturn]] void refuse_undetermined(const System& system);

// Counts the batches of points that were in vain. Error (refused): there are too many.
class UnluckyPoints {
public:
    void count(const System& system);

private:
    int so_far_ = 0;
};

// visit(run, n, point) for `points` points that draw() makes, in batches that `source` can read together.
// The run is known through weight `through`. A visit that throws UnluckyPoint ends its batch.
template <class Source, class Draw, class Visit>
void at_random_points(const CertificatePlan& plan, Source& source, const Draw& draw, int points, int through,
                      const Visit& visit) {
    const GradedField& field = *source.normal_form().field;
    UnluckyPoints unlucky;
    for (int left = points; left > 0;) {
        try {
            std::vector<Point> batch;
            while (batch.size() < std::min(static_cast<std::size_t>(left), Source::together))
                batch.push_back(draw());
            source.go_to(batch.front());
            const PointReadings readings(plan, source.normal_form(), source.map(), batch, through);
            const PointRun run(plan, *field.ring, readings, batch, through);
            for (std::size_t n = 0; n < batch.size(); ++n, --left) visit(run, n, batch[n]);
        } catch (const UnluckyPoint&) {
            unlucky.count(field.system());
        }
    }
}

} // namespace resonform
