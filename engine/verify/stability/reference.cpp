// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/stability/reference.hpp"

#include "model/system/start_names.hpp"
#include "runtime/phase.hpp"
#include "verify/evaluate/scene_values.hpp"
#include "verify/integrate/tape.hpp"
#include "verify/symbolic/ulp.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace resonform {

namespace {

constexpr std::size_t most_panels = 16;
const Wide last_bit = 0x1p-52;

std::vector<GiNaC::ex> values_of_starts(const Scene& scene) {
    std::vector<GiNaC::ex> values;
    for (const StartValue& start : scene.start) values.push_back(start.value);
    return values;
}

} // namespace

StabilityReference::StabilityReference(const Program& program, const Solution& solution, const Scene& scene)
    : program_(program), scene_(scene), is_flow_(solution.flow != nullptr),
      start_(Tape::constants(*scene.system, values_of_starts(scene))),
      solution_(std::make_shared<const SymbolicSolution>(solution, scene, false)),
      parameters_(parameter_values<Float128>(scene)) {}

SymbolicInputs StabilityReference::inputs_at(const SweepPoint& at, double end) const {
    const System& system = *scene_.system;
    SymbolicInputs inputs{Wide(at.eps), {}, {}, Wide(end), {}};
    const std::vector<Float128> parameters = with_parameters_of(at, program_, system, parameters_);
    for (std::size_t k = 0; k < parameters.size(); ++k)
        inputs.parameters.emplace(system.parameters[k].name, widened(parameters[k]));
    const std::vector<Float128> of_scene = evaluate_constants(start_, parameters, Float128(at.eps));
    for (std::size_t k = 0; k < of_scene.size(); ++k) {
        const std::string name = canonical_start(scene_.start[k].name, system);
        inputs.start.emplace(name, widened(of_scene[k]));
        inputs.untaken.insert(name);
    }
    for (std::size_t i = 0; i < at.start.size(); ++i) {
        inputs.start[program_.start[i].canonical] = at.start[i];
        inputs.untaken.erase(program_.start[i].canonical);
    }
    return inputs;
}

bool StabilityReference::inside(const SweepPoint& at) const {
    const SymbolicInputs inputs = inputs_at(at, 1);
    const std::vector<Float128> declared = solution_->declared_at(solution_->start().at(inputs).slow, inputs);
    return std::all_of(declared.begin(), declared.end(), [](Float128 value) { return value > 0; });
}

StabilityReference::From::From(const StabilityReference& reference, const SweepPoint& at, double end)
    : reference_(reference), inputs_(reference.inputs_at(at, end)),
      exact_(reference.solution_, inputs_, Wide(end), most_panels),
      scales_(reference.program_.outputs.size(), Wide(0)) {}

const SymbolicPoint& StabilityReference::From::at(double t) {
    const auto known = known_.find(t);
    if (known != known_.end()) return known->second;
    SymbolicPoint point = exact_(Wide(t));
    if (!(inputs_.eps * t < exact_.tabulated())) point = {Status::outside_interval, {}, {}, {}};
    for (std::size_t k = 0; point.status == Status::ok && k < scales_.size(); ++k)
        scales_[k] = reference_.is_flow_ ? std::max(scales_[k], point.scales[k]) : point.scales[k];
    return known_.emplace(t, std::move(point)).first->second;
}

std::vector<double> StabilityReference::From::ulp(double t, const std::vector<double>& values) {
    const SymbolicPoint& exact = at(t);
    std::vector<double> ulp(values.size(), std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; exact.status == Status::ok && k < values.size(); ++k)
        ulp[k] = in_ulp<double>(values[k], exact.values[k], scales_[k]);
    return ulp;
}

std::vector<double> StabilityReference::From::units() const {
    std::vector<double> units;
    for (const Wide& scale : scales_) units.push_back(static_cast<double>(Wide(scale * last_bit)));
    return units;
}

bool StabilityReference::From::has_large_phase(double t) const {
    const Wide most = reference_.is_flow_ ? Wide(1e-9 / (16 * last_bit)) : Wide(1e13);
    const std::vector<Wide> theta = exact_.phases(Wide(t));
    return std::any_of(theta.begin(), theta.end(), [&](const Wide& phase) { return abs(phase) > most; }) ||
           exact_.loses_phase(Wide(t), known_end(), Wide(known_radians / (2 * most)));
}

bool StabilityReference::From::loses_phase(double t) const {
    return exact_.loses_phase(Wide(t), known_end(), phase_resolution<double>(reference_.is_flow_));
}

// Of t.
Wide StabilityReference::From::known_end() const {
    return std::min(inputs_.slow_time_end, exact_.tabulated()) / inputs_.eps;
}

const StabilityReference::From::Beside* StabilityReference::From::beside(std::size_t k) {
    if (k < beside_.size()) return &beside_[k];
    SymbolicInputs changed = inputs_;
    changed.slow_time_end *= 1 + 4 * last_bit;
    std::vector<std::pair<std::string, Wide*>> inputs{{"eps", &changed.eps}};
    for (auto* list : {&changed.parameters, &changed.start})
        for (auto& [name, input] : *list)
            if (input != 0 && changed.untaken.count(name) == 0) inputs.emplace_back(name, &input);
    if (k == inputs.size()) return nullptr;
    *inputs[k].second *= 1 + last_bit;
    beside_.push_back({inputs[k].first,
                       SymbolicEvaluator(reference_.solution_, changed, changed.slow_time_end, most_panels)});
    return &beside_.back();
}

Conditioning StabilityReference::From::conditioning(double t) {
    const SymbolicPoint& here = at(t);
    const std::size_t outputs = reference_.program_.outputs.size();
    Conditioning none(outputs, std::numeric_limits<double>::infinity());
    for (const Wide& later : times_at_edge<double>(t))
        if (exact_(later).status != here.status) return none;
    Conditioning all(outputs, 0);
    std::vector<double> most(outputs, 0.0);
    const bool numbers = here.status == Status::ok;
    const std::vector<Wide> theta = numbers ? exact_.phases(Wide(t)) : std::vector<Wide>{};
    if (numbers) {
        const SymbolicPoint later = exact_.with_phases(Wide(t * (1 + last_bit)), theta);
        if (later.status != here.status) return none;
        for (std::size_t k = 0; k < outputs; ++k)
            all.slow_time[k] = in_ulp<double>(later.values[k], here.values[k], scales_[k]);
    }
    std::size_t next = 0;
    while (const Beside* changed = beside(next++)) {
        const SymbolicPoint moved =
            numbers ? changed->exact.with_phases(Wide(t), theta) : changed->exact(Wide(t));
        if (moved.status != here.status) return none;
        for (std::size_t k = 0; numbers && k < outputs; ++k) {
            const double change = in_ulp<double>(moved.values[k], here.values[k], scales_[k]);
            all.sum[k] += change;
            if (change > most[k]) all.input[k] = changed->input;
            most[k] = std::max(most[k], change);
        }
    }
    return all;
}

} // namespace resonform
