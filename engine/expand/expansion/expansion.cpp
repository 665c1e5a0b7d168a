// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/expansion/expansion.hpp"

#include "algebra/number/error.hpp"
#include "expand/modes/find_modes.hpp"
#include "model/exact/equilibrium_shift.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"

#include <fmt/format.h>

namespace resonform {

using GiNaC::ex;
using Node = SeriesProgram::Node;

Expansion::Expansion(std::shared_ptr<const FirstOrderSystem> first_order, const Divisors& divisors)
    : divisors_(divisors), first_order_(std::move(first_order)), system_(*first_order_->system),
      coefficients_(first_order_->system) {}

GradedField Expansion::build() {
    find_driven();
    for (const State& state : first_order_->states) {
        if (variable_of(state).role == Role::fast) coefficients_.vanish(state.symbol);
        if (variable_of(state).role == Role::angle || driven_[state.variable])
            coefficients_.move(state.symbol);
    }
    check_drifts();
    check_numbers();
    field_.basis = find_modes(*first_order_, coefficients_);
    check_finite();
    name_generators();
    build_ring();
    field_.first_order = first_order_;
    field_.ring = coefficients_.ring();
    field_.eps = coefficients_.eps();
    program_ = std::make_shared<SeriesProgram>(field_.ring);
    translate_ = std::make_unique<Translator>(*program_, coefficients_);
    add_shifts();
    add_slow();
    add_inputs();
    bind_states();
    add_rates();
    check_leading_terms();
    add_energy();
    field_.program = program_;
    field_.coefficients = std::make_shared<const CoefficientRing>(std::move(coefficients_));
    return std::move(field_);
}

void Expansion::name_generators() {
    std::vector<FastGenerator> fast;
    for (const ModeShape& shape : field_.basis.modes) {
        const int weight = variable_of(first_order_->states[shape.pivot]).weight;
        const int next = static_cast<int>(fast.size()) + 1;
        fast.push_back({fmt::format("z{}", next), weight, shape.is_real() ? -1 : next});
        if (!shape.is_real()) fast.push_back({fmt::format("z{}", next + 1), weight, next - 1});
    }
    coefficients_.set_fast(std::move(fast));
    std::vector<std::string> angles;
    for (const Variable& v : system_.variables)
        if (v.role == Role::angle) angles.push_back(v.name);
    coefficients_.set_angles(std::move(angles));
    std::vector<CoefficientRing::Number> numbers;
    for (const NumberSymbol& n : field_.basis.numbers) numbers.push_back({n.symbol, n.name});
    coefficients_.set_numbers(std::move(numbers));
}

void Expansion::build_ring() {
    for (const State& state : first_order_->states) {
        coefficients_.collect(state.rate, place_of_equation(state.variable));
        coefficients_.collect(state.shift, place_of_equation(state.variable));
    }
    for (const Equation& equation : system_.equations)
        coefficients_.collect(equation.residual, place_of(equation.source));
    if (system_.hamiltonian)
        coefficients_.collect(system_.hamiltonian->energy, place_of(system_.hamiltonian->source));
    for (const ModeShape& shape : field_.basis.modes) {
        const Place place = place_of_equation(first_order_->states[shape.pivot].variable);
        const auto collect = [&](const Complex& c) {
            coefficients_.collect(c.re, place);
            coefficients_.collect(c.im, place);
        };
        collect(shape.eigenvalue);
        for (const Complex& c : shape.column) collect(c);
        for (const Complex& c : shape.row) collect(c);
    }
    at_place(whole_file(system_.file), [&] { coefficients_.freeze(divisors_); });
}

void Expansion::add_shifts() {
    for (const std::size_t s : field_.basis.states) {
        const State& state = first_order_->states[s];
        const Place place = place_of_equation(state.variable);
        field_.shifts.push_back(at_place(place, [&] { return coefficients_.convert(state.shift, place); }));
    }
}

void Expansion::add_slow() {
    for (const State& state : first_order_->states) {
        const Variable& variable = variable_of(state);
        if (variable.role != Role::slow) continue;
        check_slow_rate(state);
        SlowVariable slow{state.variable, variable.name, coefficients_.slow(state.variable), false, {}};
        slow.driven = driven_[state.variable];
        if (slow.driven) {
            slow.input = program_->input(variable.name);
            translate_->bind(state.symbol, slow.input);
        } else {
            const Place place = place_of_equation(state.variable);
            const Polynomial rate = at_place(place, [&] { return coefficients_.convert(state.rate, place); });
            slow.rate = RingDomain(field_.ring).without_vanishing(rate, {field_.eps});
        }
        field_.slow.push_back(std::move(slow));
    }
}

void Expansion::add_inputs() {
    for (std::size_t k = 0; k < field_.basis.modes.size(); ++k) add_mode_input(k);
    for (const State& state : first_order_->states) {
        const Variable& variable = variable_of(state);
        if (variable.role != Role::angle) continue;
        AngleVariable angle{
            state.variable, variable.name, coefficients_.angle(field_.angles.size()), {}, {}, 0, 0};
        angle.input = program_->input(variable.name);
        translate_->bind_angle(state.symbol, angle.phase, angle.input);
        field_.angles.push_back(std::move(angle));
    }
}

void Expansion::add_mode_input(std::size_t k) {
    const ModeShape& shape = field_.basis.modes[k];
    const State& pivot = first_order_->states[shape.pivot];
    const Place place = place_of_equation(pivot.variable);
    std::size_t generator = 0;
    for (std::size_t j = 0; j < k; ++j) generator += field_.basis.modes[j].is_real() ? 1 : 2;
    Mode mode;
    mode.variable = pivot.variable;
    mode.z = mode.zbar = coefficients_.fast(generator);
    mode.name = field_.ring->generator(mode.z).name;
    mode.input = mode.input_conjugate = program_->input(mode.name);
    mode.growth = at_place(place, [&] { return coefficients_.convert(shape.eigenvalue.re, place); });
    if (!shape.is_real()) {
        mode.zbar = coefficients_.fast(generator + 1);
        mode.conjugate_name = field_.ring->generator(mode.zbar).name;
        mode.input_conjugate = program_->input(mode.conjugate_name);
        mode.omega = at_place(place, [&] { return coefficients_.convert(shape.eigenvalue.im, place); });
    }
    mode.oscillator = field_.basis.is_oscillator(k, *first_order_);
    mode.rate = -1; // set in add_rates, when all states are bound
    field_.modes.push_back(std::move(mode));
}

// u_s = sum column z + conj
void Expansion::bind_states() {
    for (std::size_t s = 0; s < field_.basis.states.size(); ++s) {
        const State& state = first_order_->states[field_.basis.states[s]];
        const Place place = place_of_equation(state.variable);
        if (field_.basis.numeric) {
            translate_->bind(state.symbol, numeric_state(s));
            continue;
        }
        Addends addends;
        for (std::size_t k = 0; k < field_.modes.size(); ++k) {
            const Mode& mode = field_.modes[k];
            const Complex& c = field_.basis.modes[k].column[s];
            Addends real{{1, mode.input}}, imaginary{{1, mode.input}};
            if (!mode.is_real()) {
                real.emplace_back(1, mode.input_conjugate);
                imaginary.emplace_back(-1, mode.input_conjugate);
            }
            add_product(addends, {c.re, 0}, program_->sum(real), place);
            add_product(addends, {0, c.im}, program_->sum(imaginary), place);
        }
        translate_->bind(state.symbol, program_->sum(addends));
    }
}

void Expansion::add_product(Addends& addends, const Complex& factor, Node node, const Place& place) {
    if (factor.is_zero()) return;
    if (factor.im.is_zero() && factor.re.info(GiNaC::info_flags::rational)) {
        addends.emplace_back(to_rational(factor.re), node);
    } else {
        addends.emplace_back(1,
                             program_->product(at_place(place, [&] { return moving(factor, place); }), node));
    }
}

// The node of a coefficient at the old slow variables.
Node Expansion::moving(const Complex& c, const Place& place) {
    if (!coefficients_.has_weight(c.re) && !coefficients_.has_weight(c.im))
        return program_->constant(coefficients_.convert(c, place));
    const Node re = (*translate_)(c.re, place);
    if (c.im.is_zero()) return re;
    const Node i = program_->constant(field_.ring->imaginary());
    return program_->sum({{1, re}, {1, program_->product(i, (*translate_)(c.im, place))}});
}

void Expansion::add_rates() {
    for (SlowVariable& slow : field_.slow) {
        const State& state = first_order_->states[first_order_->index(slow.variable, 0)];
        const Place place = place_of_equation(slow.variable);
        if (slow.driven) slow.rate_node = at_place(place, [&] { return (*translate_)(state.rate, place); });
    }
    for (std::size_t k = 0; k < field_.modes.size(); ++k)
        field_.modes[k].rate =
            at_place(place_of_equation(field_.modes[k].variable), [&] { return mode_rate(k); });
    for (AngleVariable& angle : field_.angles)
        at_place(place_of_equation(angle.variable), [&] { add_angle_rate(angle); });
    for (const State& state : first_order_->states) {
        if (variable_of(state).role != Role::drift) continue;
        check_slow_rate(state);
        const Place place = place_of_equation(state.variable);
        field_.drift.push_back({state.variable, variable_of(state).name,
                                at_place(place, [&] { return (*translate_)(state.rate, place); })});
    }
}

void Expansion::add_energy() {
    if (!system_.hamiltonian) return;
    const Place place = place_of(system_.hamiltonian->source);
    field_.energy = at_place(place, [&] { return (*translate_)(system_.hamiltonian->energy, place); });
}

// z' - lambda z - sum n z_k with z' = sum_s (row_s u_s' + row_s' u_s); lambda at the new slow variables.
Node Expansion::mode_rate(std::size_t k) {
    if (field_.basis.numeric) return numeric_rate(k);
    const ModeShape& shape = field_.basis.modes[k];
    const Mode& mode = field_.modes[k];
    Addends addends;
    for (std::size_t s = 0; s < shape.row.size(); ++s) {
        const Complex& row = shape.row[s];
        if (row.is_zero()) continue;
        const State& state = first_order_->states[field_.basis.states[s]];
        const Place place = place_of_equation(state.variable);
        add_product(addends, row, (*translate_)(state.rate, place), place);
        add_frame(addends, row, state, place);
    }
    addends.emplace_back(-1, program_->product(program_->constant(field_.eigenvalue(mode)), mode.input));
    for (const ModeCoupling& coupling : shape.couplings)
        addends.emplace_back(-coupling.factor, field_.modes[coupling.mode].input);
    return program_->sum(addends);
}

// row' u with row' = sum over xi of (d row/d xi) xi'; folded into one coefficient where nothing is driven.
void Expansion::add_frame(Addends& addends, const Complex& row, const State& state, const Place& place) {
    std::vector<Polynomial> folded;
    const Node u = (*translate_)(state.symbol, place);
    const bool moves = coefficients_.has_weight(row.re) || coefficients_.has_weight(row.im);
    for (const SlowVariable& slow : field_.slow) {
        const GiNaC::symbol& xi = system_.variables[slow.variable].jet.front();
        if (moves || slow.driven) {
            const Complex slope{row.re.diff(xi), row.im.diff(xi)};
            if (slope.is_zero()) continue;
            const Node rate = program_->product(moving(slope, place), slow_rate(slow));
            addends.emplace_back(1, program_->product(rate, u));
        } else {
            folded.push_back(field_.ring->multiply(
                field_.ring->derivative(coefficients_.convert(row, place), slow.generator), slow.rate));
        }
    }
    const Polynomial frame = sum(folded);
    if (!frame.empty()) addends.emplace_back(1, program_->product(program_->constant(frame), u));
}

Node Expansion::slow_rate(const SlowVariable& slow) {
    return slow.driven ? slow.rate_node : program_->constant(slow.rate);
}

void Expansion::add_angle_rate(AngleVariable& angle) {
    const State& state = first_order_->states[first_order_->index(angle.variable, 0)];
    const Place place = place_of_equation(angle.variable);
    const ex frequency = coefficients_.at_origin(state.rate, place);
    if (occurs(Role::angle, frequency))
        refuse(Reason::nonlinear_layer,
               {"the rate of an angle at eps = 0 depends on slow variables and parameters only",
                fmt::format("{}' = {}", angle.name, spell(frequency)),
                "write the rest with a factor eps, or choose an angle that moves uniformly", place});
    angle.law = frequency;
    angle.frequency = coefficients_.convert(frequency, place);
    angle.rate =
        program_->sum({{1, (*translate_)(state.rate, place)}, {-1, program_->constant(angle.frequency)}});
}

GradedField expand(std::shared_ptr<const FirstOrderSystem> system, const Divisors& divisors) {
    return Expansion(about_equilibrium(std::move(system)), divisors).build();
}

} // namespace resonform
