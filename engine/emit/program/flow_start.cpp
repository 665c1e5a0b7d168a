// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/flow_start.hpp"

#include "algebra/number/error.hpp"
#include "emit/display/identifier.hpp"
#include "emit/program/scene_program.hpp"
#include "emit/program/start_map.hpp"
#include "model/signs/sign_prover.hpp"
#include "normalize/recursion/inverse_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace resonform {

namespace {

// Refuses large angles: 1e30 as a double is off by many turns.
void require_moderate(const Scene& scene, const std::string& angle) {
    constexpr double most = 1e14;
    const StartValue* start = scene.start_of(angle);
    if (start == nullptr || !GiNaC::is_a<GiNaC::numeric>(start->value)) return;
    if (std::abs(GiNaC::ex_to<GiNaC::numeric>(start->value).to_double()) <= most) return;
    bad_input({"an angle starts between -1e14 and 1e14, or no digits of its place on the circle are known",
               angle, "give its remainder by 2*pi", place_of(start->source)});
}

class FlowStart {
public:
    FlowStart(Program& program, const Solution& solution, const Scene& scene, const RealForm& real,
              const Surroundings& surroundings, const std::map<std::string, Graph::Node>& names)
        : program_(program), solution_(solution), scene_(scene), real_(real), surroundings_(surroundings),
          names_(names), field_(*solution.normalization->normal_form.field),
          map_(solution.normalization->map) {}

    FlowValues find() {
        read_slow_and_angles();
        const bool physical = from_physical_values();
        if (physical)
            read_modes();
        else
            for (const Mode& mode : field_.modes) given_.modes.push_back(polar(mode));
        if (physical && !solved_ && starts_by_inverse_map(solution_)) {
            put_inverse_map();
        } else {
            new_ = given_;
            if (solved_) new_.modes[solved_->mode] = zero();
            for (const SubstitutionStep& step : start_substitutions(solution_, physical))
                substitute(physical, step);
        }
        require_near_identity(program_, solution_, real_, surroundings_,
                              {given_, new_, turns_, {}, !physical, &sums_});
        for (std::size_t k = 0; k < field_.drift.size(); ++k) new_.drift.push_back(drift(k));
        name_units();
        return std::move(new_);
    }

private:
    Graph::Node input(const std::string& name, const std::string& meaning, const std::string& canonical) {
        return add_start_input(program_, scene_, names_, name, meaning, canonical);
    }
    Graph::Node physical(const std::string& state) { return input(state + "_0", state + " at t = 0", state); }
    [[nodiscard]] const std::string& name(std::size_t variable) const {
        return solution_.system().variables[variable].name;
    }
    [[nodiscard]] int weight(std::size_t mode) const {
        return field_.ring->generator(field_.modes[mode].z).weight;
    }

    void read_slow_and_angles();
    [[nodiscard]] bool from_physical_values() const;
    void read_modes();
    void find_solved();
    void solve_for_state(Graph::Node shift);
    [[nodiscard]] FlowUnit zero() const { return {program_.graph.rational(0), program_.graph.rational(0)}; }
    void put_inverse_map();
    FlowUnit row_entry(std::size_t k, std::size_t s, Lowering& lowering);
    FlowUnit old_mode(std::size_t k, const std::vector<Graph::Node>& states, const Lowering& lowering);
    FlowUnit polar(const Mode& mode);
    void substitute(bool modes, const SubstitutionStep& step);
    void substitute(bool modes, const SubstitutionStep& step, int of_weight, bool others);
    FlowUnit unit(Graph::Node angle);
    FlowUnit turned(const FlowUnit& unit, Graph::Node by);
    Graph::Node drift(std::size_t k);
    void name_units();

    Program& program_;
    const Solution& solution_;
    const Scene& scene_;
    const RealForm& real_;
    const Surroundings& surroundings_;
    const std::map<std::string, Graph::Node>& names_;
    const GradedField& field_;
    const NearIdentityMap& map_;
    // The mode that is 0 and the state that is solved for: index into the basis' states. Old modes without
    // it, and what one unit of z_j, moved by it, adds to each.
    struct Solved {
        std::size_t mode, state;
        std::vector<FlowUnit> without, per_unit;
    };
    std::optional<Solved> solved_;
    FlowValues given_, new_; // old and new variables at t = 0 (of modes given by constants, the new ones)
    std::vector<Graph::Node> turns_; // of the angles from the old to the new
    FlowSums sums_;                  // of the map; lowered anew at each substitution
};

void FlowStart::read_slow_and_angles() {
    for (const SlowVariable& slow : field_.slow) given_.slow.push_back(physical(slow.name));
    for (const AngleVariable& angle : field_.angles) {
        require_moderate(scene_, angle.name);
        given_.angles.push_back(unit(physical(angle.name)));
    }
}

FlowUnit FlowStart::unit(Graph::Node angle) {
    return {program_.graph.function(Graph::Op::cos, {angle}),
            program_.graph.function(Graph::Op::sin, {angle})};
}

// Turns u + i v by a small angle. Adding the small angle to a large one would lose its digits.
FlowUnit FlowStart::turned(const FlowUnit& at, Graph::Node by) {
    Graph& graph = program_.graph;
    const FlowUnit turn = unit(by);
    return {graph.add({graph.multiply({at.u, turn.u}), graph.negate(graph.multiply({at.v, turn.v}))}),
            graph.add({graph.multiply({at.u, turn.v}), graph.multiply({at.v, turn.u})})};
}

// Either all fast variables start from physical values, or none does.
bool FlowStart::from_physical_values() const {
    if (scene_.at_zero) return true;
    std::string physical, constant;
    for (const std::size_t s : field_.basis.states) {
        const std::string& variable = name(field_.first_order->states[s].variable);
        (scene_.start_of(variable) != nullptr ? physical : constant) = variable;
    }
    const Place place{scene_.file.string(), 0, 0, "start", ""};
    if (!physical.empty() && !constant.empty())
        refuse({"the fast variables of coupled oscillators all start from physical values, or all from "
                "constants",
                physical + " from its value, " + constant + " from its amplitude and phase",
                "give " + constant + " and its derivatives under [start]", place});
    if (!physical.empty() || field_.basis.states.empty()) return true;
    for (const std::size_t s : field_.basis.states) {
        const std::size_t variable = field_.first_order->states[s].variable;
        if (std::none_of(field_.modes.begin(), field_.modes.end(),
                         [&](const Mode& mode) { return mode.variable == variable; }))
            refuse({"a fast variable that starts from its amplitude and phase has a mode of its own",
                    name(variable), "give physical values of all fast variables", place});
    }
    return false;
}

FlowUnit FlowStart::polar(const Mode& mode) {
    Graph& graph = program_.graph;
    const std::string& variable = name(mode.variable);
    if (mode.is_real())
        refuse({"a variable starts from amplitude and phase if its mode oscillates",
                fmt::format("{}, a mode of {}, has no phase", mode.name, variable),
                "give physical values of all fast variables under [start]",
                {scene_.file.string(), 0, 0, "start", ""}});
    const System& system = solution_.system();
    const Graph::Node amplitude = input(system.constant_name("amplitude", variable),
                                        "amplitude of the oscillation", "amplitude." + variable);
    const Graph::Node phase =
        input(system.constant_name("phase", variable), "its phase at t = 0", "phase." + variable);
    const FlowUnit direction = unit(phase);
    return {graph.multiply({amplitude, direction.u}), graph.multiply({amplitude, direction.v})};
}

FlowUnit FlowStart::row_entry(std::size_t k, std::size_t s, Lowering& lowering) {
    const Complex& entry = field_.basis.modes[k].row[s];
    if (entry.is_zero()) return zero();
    const Place place = place_of(solution_.system().equations[field_.modes[k].variable].source);
    const RealForm::Value value = real_(field_.coefficients->convert(entry, place));
    return {lowering.polynomial(value.re), lowering.polynomial(value.im)};
}

// sum of row * state, over eps^weight
FlowUnit FlowStart::old_mode(std::size_t k, const std::vector<Graph::Node>& states, const Lowering& start) {
    Graph& graph = program_.graph;
    Lowering lowering = start;
    std::vector<Graph::Node> re, im;
    for (std::size_t s = 0; s < states.size(); ++s) {
        const FlowUnit entry = row_entry(k, s, lowering);
        re.push_back(graph.multiply({entry.u, states[s]}));
        im.push_back(graph.multiply({entry.v, states[s]}));
    }
    const Graph::Node scale = graph.power(program_.small, -weight(k));
    return {graph.multiply({scale, graph.add(std::move(re))}),
            graph.multiply({scale, graph.add(std::move(im))})};
}

void FlowStart::read_modes() {
    if (scene_.at_zero) find_solved();
    const std::size_t count = field_.basis.states.size();
    std::vector<Graph::Node> states(count, zero().u);
    given_.modes.assign(field_.modes.size(), zero());
    for (std::size_t s = 0; s < count; ++s)
        if (!solved_ || s != solved_->state)
            states[s] = physical(field_.first_order->states[field_.basis.states[s]].name);
    const FlowMoment before(program_, real_, surroundings_, given_, false);
    for (std::size_t s = 0; s < count; ++s)
        if (!solved_ || s != solved_->state)
            states[s] = measured_from(program_.graph, states[s], before.lowering, real_, field_.shifts[s]);
    for (std::size_t k = 0; k < field_.modes.size(); ++k)
        given_.modes[k] = old_mode(k, states, before.lowering);
    if (!solved_) return;
    Graph& graph = program_.graph;
    Lowering lowering = before.lowering;
    const Graph::Node unit = graph.power(row_entry(solved_->mode, solved_->state, lowering).u, -1);
    for (std::size_t k = 0; k < field_.modes.size(); ++k) {
        const FlowUnit entry = row_entry(k, solved_->state, lowering);
        solved_->per_unit.push_back({graph.multiply({entry.u, unit}), graph.multiply({entry.v, unit})});
    }
    solved_->without = given_.modes;
    solve_for_state(zero().u);
}

void FlowStart::find_solved() {
    const auto mode = std::find_if(solution_.flow->modes.begin(), solution_.flow->modes.end(),
                                   [](const FlowMode& m) { return m.is_at_zero; });
    const auto state =
        std::find_if(field_.basis.states.begin(), field_.basis.states.end(), [&](std::size_t s) {
            return field_.first_order->states[s].name == scene_.at_zero->state;
        });
    solved_ = {static_cast<std::size_t>(mode - solution_.flow->modes.begin()),
               static_cast<std::size_t>(state - field_.basis.states.begin()),
               {},
               {}};
    const Complex& entry = field_.basis.modes[solved_->mode].row[solved_->state];
    const std::string& name = field_.modes[solved_->mode].name;
    if (entry.is_zero())
        bad_input({"the value that is left out follows from the mode that is 0",
                   fmt::format("{} does not depend on {}", name, scene_.at_zero->state),
                   "give it, and leave out another one", scene_.at_zero->place});
    if (!provably_nonzero(entry.re, solution_.system()))
        refuse(Reason::undecided,
               {"the value that is left out follows from the mode that is 0, if its part in that is not 0",
                fmt::format("the part of {} in {} is not proved to be", scene_.at_zero->state, name),
                "declare under [domain] what it needs, or leave out another value", scene_.at_zero->place});
}

// So that the old mode is `shift` where the new one is 0.
void FlowStart::solve_for_state(Graph::Node shift) {
    Graph& graph = program_.graph;
    const Graph::Node by = graph.add({shift, graph.negate(solved_->without[solved_->mode].u)});
    for (std::size_t k = 0; k < given_.modes.size(); ++k) {
        const FlowUnit &from = solved_->without[k], &per = solved_->per_unit[k];
        given_.modes[k] = {graph.add({from.u, graph.multiply({per.u, by})}),
                           graph.add({from.v, graph.multiply({per.v, by})})};
    }
    given_.modes[solved_->mode] = {shift, zero().v};
}

void FlowStart::put_inverse_map() {
    Graph& graph = program_.graph;
    FlowMoment old(program_, real_, surroundings_, given_, false);
    const NearIdentityMap inverse = invert(solution_.normalization->normal_form, map_);
    const auto shift = [&](const Series& series, int weight) {
        return old.value(series.total(solution_.truncation), weight, false);
    };
    for (std::size_t k = 0; k < field_.modes.size(); ++k) {
        const FlowUnit by = shift(inverse.mode[k], weight(k));
        new_.modes.push_back({graph.add({given_.modes[k].u, by.u}), graph.add({given_.modes[k].v, by.v})});
    }
    for (std::size_t k = 0; k < field_.angles.size(); ++k) turns_.push_back(shift(inverse.angle[k], 0).u);
    for (std::size_t k = 0; k < field_.angles.size(); ++k)
        new_.angles.push_back(turned(given_.angles[k], turns_[k]));
    for (std::size_t k = 0; k < field_.slow.size(); ++k)
        new_.slow.push_back(graph.add({given_.slow[k], shift(inverse.slow[k], 0).u}));
}

// zeta <- xi_0 - k(w, theta, zeta), theta <- phi_0 - m(w, theta, zeta); with `modes` w <- z_0 - h(w, theta,
// zeta), those of lower weight first: products of them may be as heavy as a mode in whose map they stand.
void FlowStart::substitute(bool modes, const SubstitutionStep& step) {
    std::vector<int> weights = modes ? field_.mode_weights() : std::vector<int>();
    if (weights.empty()) weights.push_back(0);
    std::reverse(weights.begin(), weights.end());
    for (const int now : weights) substitute(modes, step, now, now == weights.front());
}

// The modes of one weight; `others`: slow variables and angles, too.
void FlowStart::substitute(bool modes, const SubstitutionStep& step, int of_weight, bool others) {
    Graph& graph = program_.graph;
    FlowMoment now(program_, real_, surroundings_, new_, false);
    const auto shift = [&](const Series& series, int through, int weight, bool real) {
        const auto known = sums_.find({&series, through});
        if (known != sums_.end()) return now.value(known->second);
        const FlowSum sum = flow_sum(real_, series.total(through), weight, real);
        return now.value(sums_.emplace(std::pair{&series, through}, sum).first->second);
    };
    const auto less = [&](Graph::Node from, Graph::Node by) { return graph.add({from, graph.negate(by)}); };
    FlowValues next = new_;
    const bool solves = solved_ && weight(solved_->mode) == of_weight;
    if (solves)
        solve_for_state(shift(map_.mode[solved_->mode], step.mode[solved_->mode], of_weight, false).u);
    for (std::size_t k = 0; modes && k < field_.modes.size(); ++k) {
        if (weight(k) != of_weight) continue;
        const FlowUnit by = shift(map_.mode[k], step.mode[k], weight(k), false);
        next.modes[k] = {less(given_.modes[k].u, by.u), less(given_.modes[k].v, by.v)};
    }
    if (solves) next.modes[solved_->mode] = zero();
    if (others) turns_.clear();
    for (std::size_t k = 0; others && k < field_.angles.size(); ++k) {
        turns_.push_back(graph.negate(shift(map_.angle[k], step.angle[k], 0, true).u));
        next.angles[k] = turned(given_.angles[k], turns_[k]);
    }
    for (std::size_t k = 0; others && k < field_.slow.size(); ++k)
        next.slow[k] = less(given_.slow[k], shift(map_.slow[k], step.slow[k], 0, true).u);
    new_ = std::move(next);
}

// Z_0 = X_0 - l(w_0, zeta_0), or the constant.
Graph::Node FlowStart::drift(std::size_t k) {
    const std::string& variable = field_.drift[k].name;
    const std::string constant = solution_.system().constant_name("constant", variable);
    if (scene_.start_of(variable) == nullptr)
        return input(constant, "constant of " + variable, "constant." + variable);
    const Graph::Node begin = physical(variable);
    FlowMoment at(program_, real_, surroundings_, new_, false);
    const Graph::Node shift = at.lowering.polynomial(real_(map_.drift[k].total(solution_.truncation)).re);
    const Graph::Node value = program_.graph.add({begin, program_.graph.negate(shift)});
    program_.names.push_back({identifier(constant), value});
    return value;
}

void FlowStart::name_units() {
    const auto name_unit = [&](const RealForm::Pair& pair, const FlowUnit& unit) {
        program_.names.push_back({identifier(real_.ring()->generator(pair.u).name), unit.u});
        if (!pair.is_real())
            program_.names.push_back({identifier(real_.ring()->generator(pair.v).name), unit.v});
    };
    for (std::size_t k = 0; k < field_.modes.size(); ++k) name_unit(real_.modes()[k], new_.modes[k]);
    for (std::size_t k = 0; k < field_.angles.size(); ++k) name_unit(real_.angles()[k], new_.angles[k]);
}

} // namespace

// The inverse of a map has many times its terms.
bool starts_by_inverse_map(const Solution& solution) {
    constexpr std::size_t most_inverted = 2000;
    const NearIdentityMap& map = solution.normalization->map;
    std::size_t terms = 0;
    for (const auto* list : {&map.mode, &map.angle, &map.slow})
        for (const Series& series : *list) terms += series.total(solution.truncation).size();
    return terms <= most_inverted;
}

std::vector<SubstitutionStep> start_substitutions(const Solution& solution, bool modes) {
    SubstitutionFor wanted{modes};
    for (std::size_t k = 0; k < solution.flow->modes.size(); ++k)
        if (solution.flow->modes[k].is_at_zero) wanted.mode_at_zero = k;
    return substitutions(*solution.normalization->normal_form.field, solution.normalization->map,
                         solution.truncation, wanted);
}

FlowValues flow_start(Program& program, const Solution& solution, const Scene& scene, const RealForm& real,
                      const Surroundings& surroundings, const std::map<std::string, Graph::Node>& names) {
    return FlowStart(program, solution, scene, real, surroundings, names).find();
}

} // namespace resonform
