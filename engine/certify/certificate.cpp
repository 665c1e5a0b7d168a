// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/certificate.hpp"

#include "algebra/number/elimination.hpp"
#include "algebra/number/error.hpp"
#include "certify/bound.hpp"
#include "certify/build_plan.hpp"
#include "certify/hamiltonian.hpp"
#include "certify/lie.hpp"
#include "certify/points/at_points.hpp"
#include "certify/points/point.hpp"
#include "certify/points/source.hpp"
#include "certify/resonance.hpp"
#include "certify/scan.hpp"
#include "model/text/diagnostic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace resonform {

namespace {

using Matrix = std::vector<std::vector<Residue>>;

// The functions below take n, the index of the point in the batch.
Matrix jacobian_of(const CertificatePlan& plan, const PointRun& run, std::size_t n) {
    Matrix values;
    values.reserve(plan.jacobian.size());
    for (const std::vector<Slot>& row : plan.jacobian) values.push_back(run.at_origin(row, n));
    return values;
}

void require_known_rates(const CertificatePlan& plan, const PointRun& run, std::size_t n, const Ring& ring,
                         int through) {
    for (const auto& [id, slope] : plan.unknown)
        for (int weight = 0; weight <= through; ++weight)
            if (run(slope, weight, n) != 0)
                refuse(Reason::size, {"a normal form holds no higher derivatives than its weights can bring",
                                      ring.generator(id).name,
                                      "ask for a lower order",
                                      {}});
}

// Part (a); the frequencies at the points are kept for part (b).
template <class Source>
std::string residual_complaint(const CertificatePlan& plan, Source& source, Surveyor& surveys,
                               std::uint64_t seed, Certificate& certificate,
                               std::vector<FrequencySample>& samples) {
    const NormalForm& shape = source.normal_form();
    const GradedField& field = *shape.field;
    const int through = shape.through + (shape.hamiltonian ? weight_of_modes(field) : 0);
    const double bound = point_error_bound(plan, shape, source.map(), surveys) + source.error();
    const int points = points_needed(bound, field.system());
    // The bound depends on the form in which GiNaC keeps an equation, which may differ from run to run.
    // Reported is the wanted probability, which the number of points guarantees.
    certificate.error_probability = wanted_error;
    PointSampler sampler(*field.ring, seed);
    std::string complaint;
    const auto draw = [&] { return sampler.next(); };
    at_random_points(
        plan, source, draw, points, through, [&](const PointRun& run, std::size_t n, const Point& point) {
            require_known_rates(plan, run, n, *field.ring, through);
            // A residual that vanishes through M says that the highest derivatives are right through M only
            // if they are determined at weight 0. A non-zero determinant at one point proves it.
            Matrix jacobian = jacobian_of(plan, run, n);
            if (reduce_rows(jacobian, jacobian.size(), Residues{point.field})->size() < jacobian.size())
                throw UnluckyPoint();
            std::string here = complaint_of(plan, run, n, field.system(), shape.through);
            if (here.empty() && shape.hamiltonian)
                here = generator_complaint(plan, source.normal_form(), run, n, point);
            if (complaint.empty()) complaint = here;
            samples.push_back(frequencies_of(plan, run, n, point));
            certificate.primes.push_back(point.field.prime());
            ++certificate.points;
        });
    if (const auto root = sampler.dependent_root())
        refuse(
            {"the roots of the ring are independent of each other", field.ring->generator(*root).name,
             "write the equations with one root instead of several that depend on each other; if they come "
             "from the modes, give these under [modes], or take numbers: --digits 30",
             field.coefficients->place_of(*root)});
    return complaint;
}

// plan() is called only if the shape is right.
template <class Source, class Plan> Certificate certified(Plan plan, Source& source, std::uint64_t seed) {
    const NormalForm& normal_form = source.normal_form();
    Certificate certificate;
    certificate.through_weight = normal_form.field->system().weight(normal_form.through);
    Surveyor surveys(*normal_form.field->ring);
    certificate.complaint = shape_complaint(normal_form, source.map(), surveys);
    if (!certificate.complaint.empty()) return certificate;

    std::vector<FrequencySample> samples;
    const std::string residual = residual_complaint(plan(), source, surveys, seed, certificate, samples);
    const std::string scan = scan_complaint(normal_form, source.map(), samples);
    conclude(certificate, residual, scan);
    return certificate;
}

} // namespace

Certifier::Certifier(std::shared_ptr<const GradedField> field)
    : field_(std::move(field)),
      plan_(std::make_shared<const CertificatePlan>(plan_certificate(*field_, nullptr))) {}

Certificate Certifier::operator()(const NormalForm& normal_form, const NearIdentityMap& map,
                                  std::uint64_t seed) const {
    // plan_ has no brackets: a Hamiltonian normal form needs a plan of its own.
    if (normal_form.field != field_ || normal_form.hamiltonian) return certify(normal_form, map, seed);
    RingSource source(normal_form, map);
    return certified([this]() -> const CertificatePlan& { return *plan_; }, source, seed);
}

Certificate certify(const NormalForm& normal_form, const NearIdentityMap& map, std::uint64_t seed) {
    RingSource source(normal_form, map);
    const HamiltonianForm* form = normal_form.hamiltonian ? &*normal_form.hamiltonian : nullptr;
    return certified([&] { return plan_certificate(*normal_form.field, form); }, source, seed);
}

Certificate certify(const GraphNormalization& normalization, std::uint64_t seed) {
    GraphSource source(normalization);
    const GradedField& field = *source.normal_form().field;
    PointSampler sampler(*field.ring, seed + 1); // for the shape; points of its own follow
    constexpr int tries = 8;
    for (int n = 0; n < tries; ++n) {
        try {
            source.go_to(sampler.next());
            return certified([&] { return plan_certificate(field, nullptr); }, source, seed);
        } catch (const UnluckyPoint&) {
            continue;
        }
    }
    throw std::logic_error("certify: no random point at which all divisors are non-zero");
}

} // namespace resonform
