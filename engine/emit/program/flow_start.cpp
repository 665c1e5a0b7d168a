// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/flow_start.hpp"

#include "algebra/number/error.hpp"
#include "emit/display/identifier.hpp"
#include "emit/program/scene_program.hpp"
#include "emit/program/start_map.hpp"
#include "normalize/recursion/inverse_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
        if (physical && starts_by_inverse_map(solution_)) {
            put_inverse_map();
        } else {
            new_ = given_;
            if (physical || moves_slow_or_angles())
                for (int step = 0; step <= solution_.truncation; ++step) substitute(physical);
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
    void put_inverse_map();
    FlowUnit old_mode(std::size_t k, const std::vector<Graph::Node>& states, const Lowering& lowering);
    FlowUnit polar(const Mode& mode);
    [[nodiscard]] bool moves_slow_or_angles() const;
    void substitute(bool modes);
    void substitute(bool modes, int of_weight, bool others);
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

// sum of row * state, over eps^weight
FlowUnit FlowStart::old_mode(std::size_t k, const std::vector<Graph::Node>& states, const Lowering& start) {
    Graph& graph = program_.graph;
    Lowering lowering = start;
    const ModeShape& shape = field_.basis.modes[k];
    const Place place = place_of(solution_.system().equations[field_.modes[k].variable].source);
    std::vector<Graph::Node> re, im;
    for (std::size_t s = 0; s < shape.row.size(); ++s) {
        if (shape.row[s].is_zero()) continue;
        const RealForm::Value entry = real_(field_.coefficients->convert(shape.row[s], place));
        re.push_back(graph.multiply({lowering.polynomial(entry.re), states[s]}));
        im.push_back(graph.multiply({lowering.polynomial(entry.im), states[s]}));
    }
    const Graph::Node scale = graph.power(program_.small, -weight(k));
    return {graph.multiply({scale, graph.add(std::move(re))}),
            graph.multiply({scale, graph.add(std::move(im))})};
}

void FlowStart::read_modes() {
    std::vector<Graph::Node> states;
    for (const std::size_t s : field_.basis.states)
        states.push_back(physical(field_.first_order->states[s].name));
    given_.modes.assign(field_.modes.size(), {program_.graph.rational(0), program_.graph.rational(0)});
    const FlowMoment before(program_, real_, surroundings_, given_, false);
    for (std::size_t s = 0; s < states.size(); ++s)
        states[s] = measured_from(program_.graph, states[s], before.lowering, real_, field_.shifts[s]);
    for (std::size_t k = 0; k < field_.modes.size(); ++k)
        given_.modes[k] = old_mode(k, states, before.lowering);
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

bool FlowStart::moves_slow_or_angles() const {
    const auto moves = [&](const Series& series) { return !series.total(solution_.truncation).empty(); };
    return std::any_of(map_.slow.begin(), map_.slow.end(), moves) ||
           std::any_of(map_.angle.begin(), map_.angle.end(), moves);
}

// zeta <- xi_0 - k(w, theta, zeta), theta <- phi_0 - m(w, theta, zeta); with `modes` w <- z_0 - h(w, theta,
// zeta), those of lower weight first: products of them may be as heavy as a mode in whose map they stand.
void FlowStart::substitute(bool modes) {
    std::vector<int> weights = modes ? field_.mode_weights() : std::vector<int>();
    if (weights.empty()) weights.push_back(0);
    std::reverse(weights.begin(), weights.end());
    for (const int now : weights) substitute(modes, now, now == weights.front());
}

// The modes of one weight; `others`: slow variables and angles, too.
void FlowStart::substitute(bool modes, int of_weight, bool others) {
    Graph& graph = program_.graph;
    FlowMoment now(program_, real_, surroundings_, new_, false);
    const auto shift = [&](const Series& series, int weight, bool real) {
        const auto known = sums_.find(&series);
        if (known != sums_.end()) return now.value(known->second);
        const FlowSum sum = flow_sum(real_, series.total(solution_.truncation), weight, real);
        return now.value(sums_.emplace(&series, sum).first->second);
    };
    const auto less = [&](Graph::Node from, Graph::Node by) { return graph.add({from, graph.negate(by)}); };
    FlowValues next = new_;
    for (std::size_t k = 0; modes && k < field_.modes.size(); ++k) {
        if (weight(k) != of_weight) continue;
        const FlowUnit by = shift(map_.mode[k], weight(k), false);
        next.modes[k] = {less(given_.modes[k].u, by.u), less(given_.modes[k].v, by.v)};
    }
    if (others) turns_.clear();
    for (std::size_t k = 0; others && k < field_.angles.size(); ++k) {
        turns_.push_back(graph.negate(shift(map_.angle[k], 0, true).u));
        next.angles[k] = turned(given_.angles[k], turns_[k]);
    }
    for (std::size_t k = 0; others && k < field_.slow.size(); ++k)
        next.slow[k] = less(given_.slow[k], shift(map_.slow[k], 0, true).u);
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

// The inverse of a map has many times its terms; M + 1 substitutions have M + 1 times as many.
bool starts_by_inverse_map(const Solution& solution) {
    constexpr std::size_t most_inverted = 2000;
    const NearIdentityMap& map = solution.normalization->map;
    std::size_t terms = 0;
    for (const auto* list : {&map.mode, &map.angle, &map.slow})
        for (const Series& series : *list) terms += series.total(solution.truncation).size();
    return terms <= most_inverted;
}

FlowValues flow_start(Program& program, const Solution& solution, const Scene& scene, const RealForm& real,
                      const Surroundings& surroundings, const std::map<std::string, Graph::Node>& names) {
    return FlowStart(program, solution, scene, real, surroundings, names).find();
}

} // namespace resonform
