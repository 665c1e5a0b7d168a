// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/restated.hpp"

#include "certify/bound.hpp"
#include "certify/build_plan.hpp"
#include "certify/flow.hpp"
#include "certify/points/at_points.hpp"
#include "certify/points/source.hpp"
#include "certify/points/survey.hpp"

#include <fmt/format.h>

#include <utility>

namespace resonform {

namespace {

class RestatedPlan {
public:
    explicit RestatedPlan(const GradedField& field)
        : field_(field), roots_(field), jets_(jets_along(plan_.program, roots_, field)) {}

    CertificatePlan of(const Restated& restated) {
        for (const Restated::Rate& rate : restated.rates)
            check(plan_.program.value(rate.of, Side::itself), rate.series, name_of(rate.of));
        for (const Restated::OfState& state : restated.states)
            check(slot_of(field_.first_order->state(state.name)), state.series, state.name);
        settle_readings(plan_);
        return std::move(plan_);
    }

private:
    void check(Slot truth, const Series& said, const std::string& what) {
        CertificateProgram& p = plan_.program;
        const Slot slot = p.difference(truth, p.value(p.series(said), Side::itself));
        plan_.checks.push_back({slot, said.through(), false, 0,
                                fmt::format("{} in the solution is not that of normal form and map", what)});
    }

    [[nodiscard]] std::string name_of(SeriesName rate) const {
        const std::size_t k = rate.index;
        switch (rate.kind) {
        case SeriesName::angle_rate: return "the rate of " + field_.angles[k].name;
        case SeriesName::slow_rate: return "the rate of " + field_.slow[k].name;
        case SeriesName::drift_rate: return "the rate of " + field_.drift[k].name;
        default: return "the rate of " + field_.modes[k].name;
        }
    }

    // As the user measures it.
    Slot slot_of(const State& state) {
        CertificateProgram& p = plan_.program;
        for (std::size_t k = 0; k < field_.drift.size(); ++k)
            if (field_.drift[k].variable == state.variable)
                return p.value({SeriesName::drift_shift, k}, Side::itself);
        const System& system = field_.system();
        const auto& jet = system.variables[state.variable].jet;
        const Slot own = jets_.values.symbols.at(jet[static_cast<std::size_t>(state.derivative)]);
        return p.add(own, substitute(p, roots_, jets_.values, system.equations[state.variable], state.shift));
    }

    const GradedField& field_;
    CertificatePlan plan_;
    CertificateRoots roots_;
    Jets jets_;
};

} // namespace

std::string complaint_of(const Restated& restated, const NormalForm& normal_form, const NearIdentityMap& map,
                         std::uint64_t seed) {
    const GradedField& field = *normal_form.field;
    const CertificatePlan plan = RestatedPlan(field).of(restated);
    RingSource source(normal_form, map);
    Surveyor surveys(*field.ring);
    const int points = points_needed(point_error_bound(plan, normal_form, map, surveys), field.system());
    PointSampler sampler(*field.ring, seed);
    const auto draw = [&] {
        Point point = sampler.next();
        for (const std::size_t k : restated.at_zero)
            for (const GeneratorId id : {field.modes[k].z, field.modes[k].zbar})
                point.values[static_cast<std::size_t>(id)] = 0;
        return point;
    };
    std::string complaint;
    at_random_points(plan, source, draw, points, normal_form.through,
                     [&](const PointRun& run, std::size_t n, const Point&) {
                         if (complaint.empty())
                             complaint = complaint_of(plan, run, n, field.system(), normal_form.through);
                     });
    return complaint;
}

} // namespace resonform
