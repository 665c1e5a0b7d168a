// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/recursion/numbers.hpp"
#include "algebra/number/ball_matrix.hpp"
#include "certify/balls.hpp"
#include "certify/build_plan.hpp"
#include "certify/points/at_points.hpp"
#include "certify/points/point.hpp"
#include "certify/resonance.hpp"
#include "certify/scan.hpp"

#include <limits>

namespace resonform {

namespace {

constexpr int points = 4, samples = 2;

// Whether it is smaller than 10^-(digits + spare_digits/2) times the sum of the magnitudes of its terms;
// false if that sum is not finite.
bool is_small(const BallRun::Coefficient& c, int digits, std::int64_t bits) {
    RealBall magnitude, bound = RealBall(power_of_ten(-(digits + spare_digits / 2)), bits);
    acb_abs(magnitude.get(), c.value.get(), bits);
    arb_mul(bound.get(), bound.get(), c.size.number().get(), bits);
    return c.size.is_finite() && arb_le(magnitude.get(), bound.get()) != 0;
}

// Whether the equations determine their highest derivatives: if not, a residual proves less than its weight.
bool is_regular(const CertificatePlan& plan, const BallRun& run, std::int64_t bits) {
    BallMatrix jacobian;
    for (const std::vector<Slot>& row : plan.jacobian) {
        jacobian.emplace_back();
        for (const Slot slot : row) jacobian.back().push_back(run(slot)[0].value);
    }
    return solution(jacobian, std::vector<ComplexBall>(jacobian.size()), bits).has_value();
}

std::string residual_complaint(const Normalization& n, const CertificatePlan& plan, std::uint64_t seed,
                               Certificate& certificate) {
    const GradedField& field = *n.normal_form.field;
    const System& system = field.system();
    const auto bits = static_cast<std::int64_t>(2 * bits_of_digit * (system.digits + spare_digits)) + 64;
    std::mt19937_64 random(seed);
    std::string complaint;
    for (; certificate.points < points; ++certificate.points) {
        const BallPoint point = random_ball_point(field.ring, random, bits);
        const BallRun run(plan, n.normal_form, n.map, point);
        if (!is_regular(plan, run, bits)) refuse_undetermined(system);
        const auto vanishes = [&](Slot slot, int weight) {
            return is_small(run(slot)[static_cast<std::size_t>(weight)], system.digits, bits);
        };
        const std::string here = complaint_of(plan, system, n.normal_form.through, vanishes);
        if (complaint.empty()) complaint = here;
    }
    return complaint;
}

// The frequencies of the field as they are known exactly, at random points modulo primes.
std::vector<FrequencySample> sampled(const std::shared_ptr<const GradedField>& field, std::uint64_t seed,
                                     Certificate& certificate) {
    const CertificatePlan plan = plan_frequencies(*field);
    NormalForm none;
    none.field = field;
    std::vector<FrequencySample> result;
    PointSampler sampler(*field->ring, seed);
    for (int n = 0; n < samples; ++n) {
        const std::vector<Point> drawn{sampler.next()};
        const Point& point = drawn.front();
        const PointReadings readings(plan, none, {}, drawn, 0);
        const PointRun run(plan, *field->ring, readings, drawn, 0);
        certificate.primes.push_back(point.field.prime());
        result.push_back(frequencies_of(plan, run, 0, point));
    }
    return result;
}

} // namespace

Certificate certify_numbers(const Normalization& n, const std::shared_ptr<const GradedField>& field,
                            std::uint64_t seed) {
    Certificate certificate;
    certificate.route = "substitution, balls";
    certificate.through_weight = field->system().weight(n.normal_form.through);
    certificate.error_probability = std::numeric_limits<double>::quiet_NaN();
    Surveyor surveys(*n.normal_form.field->ring);
    certificate.complaint = shape_complaint(n.normal_form, n.map, surveys);
    if (!certificate.complaint.empty()) return certificate;

    const CertificatePlan plan = plan_certificate(*n.normal_form.field, nullptr);
    const std::string residual = residual_complaint(n, plan, seed, certificate);
    const std::string scan = scan_complaint(n.normal_form, n.map, sampled(field, seed, certificate));
    conclude(certificate, residual, scan);
    return certificate;
}

} // namespace resonform
