// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/flow_start.hpp"

#include "algebra/error.hpp"
#include "emit/identifier.hpp"
#include "emit/scene_program.hpp"
#include "normalize/inverse_map.hpp"

#include <algorithm>
#include <cmath>

namespace resonform {

namespace {

// 1e30 as a double is off by many turns.
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
        if (from_physical_values()) {
            put_inverse_map();
        } else {
            for (const Mode& mode : field_.modes) given_.modes.push_back(polar(mode));
            new_ = given_;
            if (moves_slow_or_angles())
                for (int step = 0; step <= solution_.truncation; ++step) substitute();
        }
        require_reproduced();
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

    void read_slow_and_angles();
    [[nodiscard]] bool from_physical_values() const;
    void put_inverse_map();
    FlowUnit old_mode(std::size_t k, const std::vector<Graph::Node>& states, const Lowering& lowering);
    FlowUnit polar(const Mode& mode);
    [[nodiscard]] bool moves_slow_or_angles() const;
    void substitute();
    FlowUnit unit(Graph::Node angle);
    FlowUnit turned(const FlowUnit& unit, Graph::Node by);
    void require_reproduced();
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

// An angle is turned by small ones: of a large one no digits would be left, had they to be added.
FlowUnit FlowStart::turned(const FlowUnit& at, Graph::Node by) {
    Graph& graph = program_.graph;
    const FlowUnit turn = unit(by);
    return {graph.add({graph.multiply({at.u, turn.u}), graph.negate(graph.multiply({at.v, turn.v}))}),
            graph.add({graph.multiply({at.u, turn.v}), graph.multiply({at.v, turn.u})})};
}

// Of all fast variables, or of none.
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
    const Graph::Node scale = graph.power(program_.eps, -field_.ring->generator(field_.modes[k].z).weight);
    return {graph.multiply({scale, graph.add(std::move(re))}),
            graph.multiply({scale, graph.add(std::move(im))})};
}

void FlowStart::put_inverse_map() {
    Graph& graph = program_.graph;
    std::vector<Graph::Node> states;
    for (const std::size_t s : field_.basis.states)
        states.push_back(physical(field_.first_order->states[s].name));
    given_.modes.assign(field_.modes.size(), {graph.rational(0), graph.rational(0)});
    const FlowMoment before(program_, real_, surroundings_, given_, false);
    for (std::size_t k = 0; k < field_.modes.size(); ++k)
        given_.modes[k] = old_mode(k, states, before.lowering);

    FlowMoment old(program_, real_, surroundings_, given_, false);
    const NearIdentityMap inverse = invert(solution_.normalization->normal_form, map_);
    const auto shift = [&](const Series& series, int weight) {
        const RealForm::Value value = real_(series.total(solution_.truncation));
        return FlowUnit{old.lowering.polynomial(over_eps(real_, value.re, weight)),
                        old.lowering.polynomial(over_eps(real_, value.im, weight))};
    };
    for (std::size_t k = 0; k < field_.modes.size(); ++k) {
        const FlowUnit by = shift(inverse.mode[k], field_.ring->generator(field_.modes[k].z).weight);
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

// zeta <- xi_0 - k(w_0, theta, zeta), theta <- phi_0 - m(w_0, theta, zeta)
void FlowStart::substitute() {
    Graph& graph = program_.graph;
    FlowMoment now(program_, real_, surroundings_, new_, false);
    const auto shift = [&](const Series& series) {
        return graph.negate(now.lowering.polynomial(real_(series.total(solution_.truncation)).re));
    };
    FlowValues next = new_;
    turns_.clear();
    for (std::size_t k = 0; k < field_.angles.size(); ++k) {
        turns_.push_back(shift(map_.angle[k]));
        next.angles[k] = turned(given_.angles[k], turns_[k]);
    }
    for (std::size_t k = 0; k < field_.slow.size(); ++k)
        next.slow[k] = graph.add({given_.slow[k], shift(map_.slow[k])});
    new_ = std::move(next);
}

// The map takes the new start back to the old one, up to eps^(M + 1): where it misses by more than a half of
// what it starts from and of what it adds, a divisor is too small for the series, and the answer is a status.
void FlowStart::require_reproduced() {
    Graph& graph = program_.graph;
    FlowMoment now(program_, real_, surroundings_, new_, false);
    const auto shift = [&](const Series& series, int weight) {
        const RealForm::Value value = real_(series.total(solution_.truncation));
        return FlowUnit{now.lowering.polynomial(over_eps(real_, value.re, weight)),
                        now.lowering.polynomial(over_eps(real_, value.im, weight))};
    };
    const Graph::Node little = graph.power(program_.eps, 2 * solution_.truncation);
    const auto square = [&](const FlowUnit& x) {
        return graph.add({graph.power(x.u, 2), graph.power(x.v, 2)});
    };
    const auto require = [&](const FlowUnit& old, const FlowUnit& found, const FlowUnit& added) {
        const auto missed = [&](Graph::Node a, Graph::Node b, Graph::Node c) {
            return graph.add({a, b, graph.negate(c)});
        };
        const FlowUnit miss{missed(found.u, added.u, old.u), missed(found.v, added.v, old.v)};
        program_.positive.push_back(graph.add(
            {little, square(old), square(added), graph.multiply({graph.rational(-4), square(miss)})}));
    };
    const Graph::Node zero = graph.rational(0);
    if (from_physical_values())
        for (std::size_t k = 0; k < field_.modes.size(); ++k)
            if (!map_.mode[k].total(solution_.truncation).empty())
                require(given_.modes[k], new_.modes[k],
                        shift(map_.mode[k], field_.ring->generator(field_.modes[k].z).weight));
    for (std::size_t k = 0; k < field_.slow.size(); ++k)
        if (!map_.slow[k].total(solution_.truncation).empty())
            require({given_.slow[k], zero}, {new_.slow[k], zero}, {shift(map_.slow[k], 0).u, zero});
    for (std::size_t k = 0; k < field_.angles.size(); ++k)
        if (!map_.angle[k].total(solution_.truncation).empty()) // within half a radian
            program_.positive.push_back(graph.add(
                {graph.rational(1),
                 graph.multiply({graph.rational(-4),
                                 graph.power(graph.add({turns_[k], shift(map_.angle[k], 0).u}), 2)})}));
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
        program_.names.push_back({identifier(real_.ring()->generator(pair.v).name), unit.v});
    };
    for (std::size_t k = 0; k < field_.modes.size(); ++k) name_unit(real_.modes()[k], new_.modes[k]);
    for (std::size_t k = 0; k < field_.angles.size(); ++k) name_unit(real_.angles()[k], new_.angles[k]);
}

} // namespace

FlowValues flow_start(Program& program, const Solution& solution, const Scene& scene, const RealForm& real,
                      const Surroundings& surroundings, const std::map<std::string, Graph::Node>& names) {
    return FlowStart(program, solution, scene, real, surroundings, names).find();
}

} // namespace resonform
