// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/flow_program.hpp"

#include "algebra/number/error.hpp"
#include "emit/display/identifier.hpp"
#include "emit/display/quantity.hpp"
#include "emit/graph/conditioning.hpp"
#include "emit/program/corrections.hpp"
#include "emit/program/flow_moment.hpp"
#include "emit/program/flow_start.hpp"
#include "emit/program/flow_turning.hpp"
#include "emit/program/harmonics.hpp"
#include "emit/program/layers.hpp"
#include "emit/program/prune.hpp"
#include "emit/program/scene_program.hpp"
#include "model/text/eps_powers.hpp"
#include "solve/flow/flow_harmonics.hpp"
#include "solve/flow/slow_flow.hpp"
#include "solve/slow_law.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

namespace {

class FlowProgram : SceneProgram {
public:
    FlowProgram(const Solution& solution, const Scene& scene, const ProgramOptions& options)
        : SceneProgram(solution, scene, options), flow_(*solution.flow),
          field_(*solution.normalization->normal_form.field), real_(field_),
          fading_(fading_divisors(solution, scene.outputs)) {}

    Program build() {
        open(field_.ring->generator(field_.eps).name);
        start_ = flow_start(program_, solution_, scene_, real_, surroundings_, names_);
        define_flow();
        FlowMoment at_start(program_, real_, surroundings_, start_, false);
        const auto begin = [&](const Polynomial& p) { return at_start.lowering.polynomial(real_(p).re); };
        add_start_layers(program_, *solution_.normalization, surroundings_, begin);
        add_start_corrections(program_, solution_, surroundings_, start_.modes, begin);
        frame_.emplace(program_, real_, surroundings_, moving_, true);
        keep_signs();
        lower_rates();
        integrate_drifts();
        turned_ = FlowTurning(program_, *frame_, solution_, real_, surroundings_).turned(moving_, start_);
        turned_.moduli = constant_moduli();
        define_results();
        const auto lower = [&](const Polynomial& p) { return frame_->lowering.polynomial(real_(p).re); };
        add_layers(program_, *solution_.normalization, surroundings_, lower,
                   [&](const Polynomial& p) { return frame_->lowering.divisor(real_(p).re); });
        for (const FadingDivisor& fading : fading_)
            add_fading(program_, solution_, surroundings_, fading, begin, lower);
        add_corrections(program_, solution_, surroundings_, lasting_modes(), lower);
        close();
        return std::move(program_);
    }

private:
    void define_flow();
    void define_slow(std::size_t k);
    void keep_signs();
    FlowMoment::Unit moving_unit(const RealForm::Pair& pair, const FlowMoment::Unit& start, bool moves);
    void lower_rates();
    void integrate_drifts();
    std::vector<FlowUnit> lasting_modes();
    void define_results();
    Graph::Node result(const FlowOutput& output, bool oscillating);
    [[nodiscard]] std::string no_rows() const;
    void append_rows(const FlowOutput& output);
    const FlowOutput& output_of(const std::string& name) const;

    [[nodiscard]] static bool moves(const FlowMode& mode) {
        return !mode.rate.total(mode.rate.through()).empty();
    }
    [[nodiscard]] std::vector<Graph::Node> constant_moduli();
    // A rate per unit of slow time, times eps^-power of the ring besides.
    [[nodiscard]] Graph::Node lowered(const Polynomial& p, int power) {
        return per_slow_time(frame_->lowering, p, power);
    }
    // Rates have one power of the ring's eps at least; slow time has as many as weights are in one.
    [[nodiscard]] Graph::Node per_slow_time(Lowering& lowering, const Polynomial& p, int power) {
        Graph& graph = program_.graph;
        return graph.multiply({graph.power(program_.small, 1 - program_.eps_root),
                               lowering.polynomial(over_eps(real_, p, power + 1))});
    }
    [[nodiscard]] const std::string& name(std::size_t variable) const {
        return solution_.system().variables[variable].name;
    }

    const SlowFlow& flow_;
    const GradedField& field_;
    RealForm real_;
    FlowValues start_, moving_, turned_; // at t = 0; within the frame; with their phases
    std::optional<FlowMoment> frame_;    // everything at moving_
    std::vector<Graph::Node> drift_;     // Z
    std::vector<FadingDivisor> fading_;
    std::map<Graph::Node, Graph::Node> inverses_; // 1/D of these D
};

// Symbols for variables that the flow changes; the others keep their start values. Names are those of the
// real form, because two modes may belong to one variable.
FlowMoment::Unit FlowProgram::moving_unit(const RealForm::Pair& pair, const FlowMoment::Unit& start,
                                          bool moves) {
    if (!moves) return start;
    const auto part = [&](GeneratorId id, Graph::Node begin) {
        const std::string called = identifier(real_.ring()->generator(id).name);
        const Graph::Node value = program_.graph.symbol("flow " + called); // a space: no parameter's name
        program_.flow.push_back({called, begin, -1, value});
        return value;
    };
    const Graph::Node u = part(pair.u, start.u);
    return {u, pair.is_real() ? start.v : part(pair.v, start.v)};
}

void FlowProgram::define_flow() {
    for (std::size_t k = 0; k < field_.modes.size(); ++k)
        moving_.modes.push_back(moving_unit(real_.modes()[k], start_.modes[k], moves(flow_.modes[k])));
    for (std::size_t k = 0; k < field_.angles.size(); ++k)
        moving_.angles.push_back(moving_unit(real_.angles()[k], start_.angles[k], moves(flow_.angles[k])));
    for (std::size_t k = 0; k < field_.slow.size(); ++k) define_slow(k);
}

// By its path where that is known, else a variable of the flow.
void FlowProgram::define_slow(std::size_t k) {
    const SlowVariable& slow = field_.slow[k];
    const Variable& variable = solution_.system().variables[slow.variable];
    const Polynomial rate = flow_.slow[k].total(flow_.slow[k].through());
    Graph::Node value = -1;
    if (const auto path = slow_path(*field_.ring, slow.generator, rate)) {
        FlowMoment at_start(program_, real_, surroundings_, start_, false);
        const auto constant = [&](const Polynomial& p) {
            return per_slow_time(at_start.lowering, real_(p).re, 0);
        };
        value = value_on_path(variable.name, start_.slow[k], constant(path->drive),
                              path->relaxes() ? constant(path->decline) : -1);
    } else {
        value = program_.graph.symbol("flow " + slow.name);
        program_.flow.push_back({identifier(slow.name), start_.slow[k], -1, value});
    }
    moving_.slow.push_back(value);
    move_slow(variable, slow.driven ? variable.name + "_mean" : variable.name, start_.slow[k], value);
}

// Moving small divisors must keep the sign that they start with: a change crosses a resonance surface. Two
// kinds may change it, because the terms that they divide have decayed by then: multiples of Re lambda of a
// mode that passes (emit/program/passage.hpp), and divisors of decaying products only
// (solve/small_divisors.hpp).
void FlowProgram::keep_signs() {
    const FlowMoment at_start(program_, real_, surroundings_, start_, false);
    for (GeneratorId id = 0; id < real_.ring()->size(); ++id) {
        const Generator& g = real_.ring()->generator(id);
        if (g.kind != GeneratorKind::root || g.index != 1 || g.positive || !frame_->lowering.varying(id))
            continue;
        const Graph::Node begin = at_start.lowering.node(id);
        const std::string name = quantity(*real_.ring(), g.radicand);
        // It must not be zero at the start: this is checked before the start is put into the map.
        if (!signs_of(program_.graph, begin, surroundings_.positive).is_positive())
            program_.positive.push_back({program_.graph.power(begin, 2), name});
        const GeneratorId own = *field_.ring->find(g.name);
        const Graph::Node now = frame_->lowering.node(id);
        const Graph::Node sign = program_.graph.multiply({begin, now});
        if (signs_of(program_.graph, sign, surroundings_.positive).is_positive())
            std::erase_if(fading_, [&](const FadingDivisor& d) { return d.generator == own; });
        if (fades(fading_, own))
            inverses_.emplace(now, inverse_of(program_.graph, now, begin));
        else if (!passes_zero(flow_, field_, field_.ring->generator(own).radicand))
            program_.positive.push_back({sign, name});
    }
}

// d(u + i v)/dT = rate/eps^(w + 1); of an angle i (u + i v) rate/eps.
void FlowProgram::lower_rates() {
    Graph& graph = program_.graph;
    std::size_t next = 0;
    for (std::size_t k = 0; k < field_.modes.size(); ++k) {
        if (!moves(flow_.modes[k])) continue;
        const RealForm::Value rate = real_(flow_.modes[k].rate.total(flow_.modes[k].rate.through()));
        const int weight = field_.ring->generator(field_.modes[k].z).weight;
        program_.flow[next++].rate = lowered(rate.re, weight);
        if (!real_.modes()[k].is_real()) program_.flow[next++].rate = lowered(rate.im, weight);
    }
    for (std::size_t k = 0; k < field_.angles.size(); ++k) {
        if (!moves(flow_.angles[k])) continue;
        const Graph::Node speed =
            lowered(real_(flow_.angles[k].rate.total(flow_.angles[k].rate.through())).re, 0);
        const FlowMoment::Unit& unit = moving_.angles[k];
        program_.flow[next++].rate = graph.negate(graph.multiply({unit.v, speed}));
        program_.flow[next++].rate = graph.multiply({unit.u, speed});
    }
    for (std::size_t k = 0; k < field_.slow.size(); ++k)
        if (next < program_.flow.size() && program_.flow[next].value == moving_.slow[k])
            program_.flow[next++].rate = lowered(real_(flow_.slow[k].total(flow_.slow[k].through())).re, 0);
}

void FlowProgram::integrate_drifts() {
    Graph& graph = program_.graph;
    for (std::size_t k = 0; k < field_.drift.size(); ++k) {
        const Graph::Node rate = lowered(real_(flow_.drift[k].total(flow_.drift[k].through())).re, 0);
        Graph::Node integral = graph.multiply({rate, program_.slow_time});
        if (varies(program_, rate)) {
            const std::string called = "Q_" + identifier(field_.drift[k].name);
            integral = graph.symbol("table " + called); // a space: no parameter has this name
            program_.tables.push_back({called, rate, integral});
        }
        drift_.push_back(graph.add({start_.drift[k], integral}));
    }
}

// Of amplitudes that stay as they are at the start; of others -1.
std::vector<Graph::Node> FlowProgram::constant_moduli() {
    Graph& graph = program_.graph;
    std::vector<Graph::Node> moduli;
    for (std::size_t k = 0; k < field_.modes.size(); ++k) {
        const bool stays = !field_.modes[k].is_real() && !moves(flow_.modes[k]) && !flow_.modes[k].decay;
        const FlowUnit& unit = start_.modes[k];
        moduli.push_back(stays ? graph.add({graph.power(unit.u, 2), graph.power(unit.v, 2)}) : -1);
    }
    return moduli;
}

// Modes as they matter after the first moments: of those that decay nothing is left.
std::vector<FlowUnit> FlowProgram::lasting_modes() {
    std::vector<FlowUnit> modes = moving_.modes;
    for (std::size_t k = 0; k < modes.size(); ++k)
        if (field_.modes[k].is_damped()) modes[k].u = modes[k].v = program_.graph.rational(0);
    return modes;
}

Graph::Node FlowProgram::result(const FlowOutput& output, bool oscillating) {
    FlowMoment call(program_, real_, surroundings_, oscillating ? turned_ : moving_, false);
    for (const auto& [divisor, inverse] : inverses_) call.lowering.set_inverse(divisor, inverse);
    Polynomial all = output.value.total(output.value.through());
    if (!oscillating) all = mean_part(field_, flow_, all);
    // A sum of squares that stays is a constant, and squares have twice their factors' rounding errors.
    std::vector<bool> stays;
    if (oscillating)
        for (const Graph::Node modulus : turned_.moduli) stays.push_back(modulus >= 0);
    Graph::Node value =
        by_powers_of_eps(*real_.ring(), real_.eps(), real_(all, stays).re, output.name,
                         [&](const Polynomial& part, int) { return call.lowering.polynomial(part); });
    if (output.drift) value = program_.graph.add({drift_[*output.drift], value});
    return value;
}

// Why there are no rows, "" if there are: where a mode may grow, or a divisor may change its sign, more is
// asked of a point than that tables reach it.
std::string FlowProgram::no_rows() const {
    if (flow_.decays.empty()) return "";
    if (flow_.may_grow()) return "no tables of modes that may grow";
    return fading_.empty() ? "" : "no tables where a divisor may pass zero";
}

// Of a harmonic A e^{i k.theta} + conjugate: 2 Re A cos k.theta - 2 Im A sin k.theta, times e^{d.chi}.
void FlowProgram::append_rows(const FlowOutput& output) {
    Graph& graph = program_.graph;
    FlowMoment call(program_, real_, surroundings_, moving_, false);
    Amplitudes rows;
    if (output.drift)
        rows.add(std::vector<int>(flow_.phases.size() + flow_.decays.size(), 0), 0, drift_[*output.drift]);
    for (const FlowHarmonic& harmonic :
         flow_harmonics(field_, flow_, output.value.total(output.value.through()))) {
        const bool mean = harmonic.turns_not();
        if (!(mean && harmonic.lasts()) && !scene_.oscillating) break;
        const FlowMoment::Unit amplitude = call.value(harmonic.part, 0, mean);
        std::vector<int> powers = harmonic.turns;
        powers.insert(powers.end(), harmonic.decays.begin(), harmonic.decays.end());
        if (mean)
            rows.add(powers, 0, amplitude.u);
        else
            rows.add(powers, 0, graph.multiply({graph.rational(2), amplitude.u}),
                     graph.multiply({graph.rational(-2), amplitude.v}));
    }
    rows.append_to(program_, program_.outputs.size());
}

const FlowOutput& FlowProgram::output_of(const std::string& name) const {
    const auto found = std::find_if(flow_.outputs.begin(), flow_.outputs.end(),
                                    [&](const FlowOutput& output) { return output.name == name; });
    if (found == flow_.outputs.end())
        bad_input({"the output is not a fast, slow or drift variable of the system",
                   name,
                   "remove it from outputs",
                   {}});
    return *found;
}

void FlowProgram::define_results() {
    for (std::size_t k = 0; k < field_.slow.size(); ++k)
        if (!field_.slow[k].driven) program_.slow.push_back({field_.slow[k].name, moving_.slow[k]});
    if (options_.rows) program_.form_reason = no_rows();
    for (const std::string& wanted : scene_.outputs) {
        const FlowOutput& output = output_of(wanted);
        const bool its_own = solution_.order == scene_.order; // lower orders may be 0
        if (!scene_.transients && scene_.oscillating && its_own && !output.drift &&
            !lowest_weight(output.value))
            bad_input({"without transients an output has something that lasts",
                       fmt::format("{} = O({}) on the slow manifold", wanted,
                                   spell_eps_power(program_.weight(solution_.order + 1))),
                       "remove it from outputs, or write transients = true", scene_.transients_place});
        if (options_.rows && no_rows().empty()) append_rows(output);
        program_.outputs.push_back({wanted, result(output, scene_.oscillating)});
    }
    if (options_.keep_state)
        for (const FlowOutput& state : flow_.state)
            program_.state.push_back({state.name, result(state, true)});
}

} // namespace

Program build_flow_program(const Solution& solution, const Scene& scene, const ProgramOptions& options) {
    return FlowProgram(solution, scene, options).build();
}

} // namespace resonform
