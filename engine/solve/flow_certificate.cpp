// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/flow_certificate.hpp"

#include "certify/restated.hpp"

#include <algorithm>

namespace resonform {

namespace {

class FlowCertificate {
public:
    explicit FlowCertificate(const Solution& solution)
        : solution_(solution), flow_(*solution.flow), normal_form_(solution.normalization->normal_form),
          field_(*normal_form_.field), ring_(*field_.ring) {}

    [[nodiscard]] std::string complaint() const {
        Restated on_manifold, whole; // without the modes that are left out, and with all
        for (std::size_t k = 0; k < flow_.modes.size(); ++k)
            if (flow_.modes[k].is_left_out) on_manifold.at_zero.push_back(k);
        add_rates(on_manifold.rates);
        add(flow_.outputs, on_manifold.states);
        const bool start_is_whole = !flow_.may_grow() && !on_manifold.at_zero.empty();
        add(flow_.state, start_is_whole ? whole.states : on_manifold.states);
        const std::string first = held(on_manifold);
        return first.empty() && start_is_whole ? held(whole) : first;
    }

private:
    [[nodiscard]] std::string held(const Restated& restated) const {
        return complaint_of(restated, normal_form_, solution_.normalization->map);
    }

    void add_rates(std::vector<Restated::Rate>& rates) const {
        const auto add = [&](SeriesName::Kind kind, std::size_t k, const Polynomial& rate, int through) {
            rates.push_back({{kind, k}, Series::split(ring_, rate, through)});
        };
        const int all = solution_.truncation;
        for (std::size_t k = 0; k < flow_.modes.size(); ++k) {
            if (flow_.modes[k].is_left_out) continue;
            const Mode& mode = field_.modes[k];
            const Polynomial rate =
                total(flow_.modes[k].rate) + ring_.multiply(frame_rate(flow_.modes[k]), ring_.gen(mode.z));
            add(SeriesName::mode_rate, k, rate, flow_.modes[k].decays(mode) ? solution_.order : all);
        }
        for (std::size_t k = 0; k < flow_.angles.size(); ++k)
            add(SeriesName::angle_rate, k, total(flow_.angles[k].rate) + flow_.phases[*flow_.angles[k].phase],
                all);
        for (std::size_t k = 0; k < flow_.slow.size(); ++k)
            add(SeriesName::slow_rate, k, total(flow_.slow[k]), all);
        for (std::size_t k = 0; k < flow_.drift.size(); ++k)
            add(SeriesName::drift_rate, k, total(flow_.drift[k]), all);
    }

    static void add(const std::vector<FlowOutput>& from, std::vector<Restated::OfState>& states) {
        for (const FlowOutput& output : from) states.push_back({output.name, output.value});
    }

    // i theta' + chi'
    [[nodiscard]] Polynomial frame_rate(const FlowMode& mode) const {
        Polynomial rate;
        if (mode.phase) rate = ring_.multiply(ring_.imaginary(), flow_.phases[*mode.phase]);
        return mode.decay ? rate + flow_.decays[*mode.decay] : rate;
    }

    [[nodiscard]] static Polynomial total(const Series& series) { return series.total(series.through()); }

    const Solution& solution_;
    const SlowFlow& flow_;
    const NormalForm& normal_form_;
    const GradedField& field_;
    const Ring& ring_;
};

} // namespace

std::string flow_complaint(const Solution& solution) {
    return solution.flow ? FlowCertificate(solution).complaint() : "";
}

} // namespace resonform
