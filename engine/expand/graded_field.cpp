// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/graded_field.hpp"

#include "expand/modes.hpp"
#include "expand/translate.hpp"
#include "model/canonical.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

namespace {

using GiNaC::ex;

Place place_of_equation(const System& system, std::size_t variable) {
    return place_of(system.equations[variable].source);
}

// Builds a GradedField in the order ring -> slow rates -> modes -> drift.
class Expansion {
public:
    Expansion(std::shared_ptr<const FirstOrderSystem> first_order, const Divisors& divisors)
        : divisors_(divisors), first_order_(std::move(first_order)), system_(*first_order_->system),
          coefficients_(first_order_->system, mode_names(), mode_conjugates()) {}

    GradedField build() {
        for (const State& state : first_order_->states)
            if (system_.variables[state.variable].role == Role::fast) coefficients_.vanish(state.symbol);
        check_drifts();
        for (std::size_t v = 0; v < system_.variables.size(); ++v)
            if (system_.variables[v].role == Role::fast)
                oscillators_.push_back(find_oscillator(*first_order_, v, coefficients_));
        build_ring();
        field_.first_order = first_order_;
        field_.ring = coefficients_.ring();
        field_.eps = coefficients_.eps();
        add_slow();
        auto program = std::make_shared<SeriesProgram>(field_.ring);
        add_rates(*program);
        field_.program = std::move(program);
        field_.coefficients = std::make_shared<const CoefficientRing>(std::move(coefficients_));
        return std::move(field_);
    }

private:
    std::vector<std::string> mode_names() const {
        std::vector<std::string> names;
        for (const auto& v : first_order_->system->variables)
            if (v.role == Role::fast)
                for (int half = 0; half < 2; ++half) names.push_back(fmt::format("z{}", names.size() + 1));
        return names;
    }

    std::vector<int> mode_conjugates() const {
        std::vector<int> partners(mode_names().size());
        for (std::size_t k = 0; k < partners.size(); ++k) partners[k] = static_cast<int>(k ^ 1U);
        return partners;
    }

    void check_drifts() const {
        for (const State& state : first_order_->states)
            for (const Variable& v : system_.variables)
                if (v.role == Role::drift && state.rate.has(v.jet.front()))
                    bad_input({"nothing depends on a drift variable",
                               fmt::format("the equation of {} contains {}",
                                           system_.variables[state.variable].name, v.name),
                               fmt::format("give {} the role slow", v.name),
                               place_of_equation(system_, state.variable)});
    }

    void build_ring() {
        for (const State& state : first_order_->states)
            coefficients_.collect(state.rate, place_of_equation(system_, state.variable));
        for (const Equation& equation : system_.equations)
            coefficients_.collect(equation.residual, place_of(equation.source));
        for (const Oscillator& o : oscillators_) {
            const Place place = place_of_equation(system_, o.variable);
            coefficients_.collect(GiNaC::pow(o.omega_squared, GiNaC::numeric(1, 2)), place);
            // 1/omega is needed as well: every base of omega^2 becomes invertible
            coefficients_.collect(GiNaC::pow(o.omega_squared, -GiNaC::numeric(1, 2)), place);
        }
        at_place(whole_file(system_.file), [&] { coefficients_.freeze(divisors_); });
    }

    void add_slow() {
        for (const State& state : first_order_->states) {
            const Variable& variable = system_.variables[state.variable];
            if (variable.role != Role::slow) continue;
            const Place place = place_of_equation(system_, state.variable);
            check_slow_rate(variable, state, place);
            field_.slow.push_back(
                {state.variable, variable.name, coefficients_.slow(state.variable),
                 at_place(place, [&] { return coefficients_.convert(state.rate, place); })});
        }
    }

    void check_slow_rate(const Variable& variable, const State& state, const Place& place) const {
        for (const State& other : first_order_->states)
            if (system_.variables[other.variable].role == Role::fast && state.rate.has(other.symbol))
                refuse({"the rate of a slow variable depends on slow variables and parameters only",
                        fmt::format("the rate of {} contains {}", variable.name, other.name),
                        "slow variables driven by fast ones are not supported yet", place});
        if (!coefficients_.at_origin(state.rate, place).is_zero())
            bad_input({"the rate of a slow variable vanishes with eps",
                       fmt::format("{}' = {}", variable.name, spell(state.rate)),
                       "write the rate with a factor eps", place});
        if (!state.rate.is_polynomial(system_.eps))
            refuse({"the rate of a slow variable is a polynomial in eps",
                    fmt::format("{}' = {}", variable.name, spell(state.rate)),
                    "expand the rate in powers of eps", place});
    }

    void add_rates(SeriesProgram& program) {
        Translator translate(program, coefficients_);
        for (const auto add : {&Expansion::add_mode_inputs, &Expansion::add_mode_rate})
            for (std::size_t k = 0; k < oscillators_.size(); ++k)
                at_place(place_of_equation(system_, oscillators_[k].variable),
                         [&] { (this->*add)(program, translate, k); });
        for (const State& state : first_order_->states) {
            const Variable& variable = system_.variables[state.variable];
            if (variable.role != Role::drift) continue;
            const Place place = place_of_equation(system_, state.variable);
            if (!coefficients_.at_origin(state.rate, place).is_zero())
                bad_input({"the rate of a drift variable vanishes with eps and the fast variables",
                           fmt::format("{}' = {}", variable.name, spell(state.rate)),
                           "write the rate with a factor eps", place});
            field_.drift.push_back({state.variable, variable.name,
                                    at_place(place, [&] { return translate(state.rate, place); })});
        }
    }

    // psi = (z + zbar)/2, psi' = i omega (z - zbar)/2
    void add_mode_inputs(SeriesProgram& program, Translator& translate, std::size_t k) {
        const Ring& ring = *field_.ring;
        const Oscillator& o = oscillators_[k];
        const Place place = place_of_equation(system_, o.variable);
        Mode mode;
        mode.variable = o.variable;
        mode.z = coefficients_.fast(2 * k);
        mode.zbar = coefficients_.fast(2 * k + 1);
        mode.name = ring.generator(mode.z).name;
        mode.conjugate_name = ring.generator(mode.zbar).name;
        mode.omega = coefficients_.convert(GiNaC::pow(o.omega_squared, GiNaC::numeric(1, 2)), place);
        mode.input = program.input(mode.name);
        mode.input_conjugate = program.input(mode.conjugate_name);
        const Rational half = Rational(1) / 2;
        const auto psi = program.sum({{half, mode.input}, {half, mode.input_conjugate}});
        const auto difference = program.sum({{half, mode.input}, {-half, mode.input_conjugate}});
        const auto i_omega = program.constant(ring.multiply(ring.imaginary(), mode.omega));
        translate.bind(first_order_->states[first_order_->index(o.variable, 0)].symbol, psi);
        translate.bind(first_order_->states[first_order_->index(o.variable, 1)].symbol,
                       program.product(i_omega, difference));
        mode.rate = -1; // set in add_mode_rate, when the inputs of all modes are bound
        field_.modes.push_back(std::move(mode));
    }

    // z' - i omega z with z' = psi' - (i/omega) psi'' + (i/omega^2) omega' psi', omega' = sum omega_xi xi'
    void add_mode_rate(SeriesProgram& program, Translator& translate, std::size_t k) {
        const Ring& ring = *field_.ring;
        Mode& mode = field_.modes[k];
        const State& velocity = first_order_->states[first_order_->index(mode.variable, 1)];
        const Place place = place_of_equation(system_, mode.variable);
        const Polynomial inverse = *ring.inverse(mode.omega); // a unit: its bases were made invertible
        const Polynomial i_over_omega = ring.multiply(ring.imaginary(), inverse);
        std::vector<Polynomial> omega_rate;
        for (const SlowVariable& s : field_.slow)
            omega_rate.push_back(ring.multiply(ring.derivative(mode.omega, s.generator), s.rate));
        const Polynomial frame = ring.multiply(ring.multiply(i_over_omega, inverse), sum(omega_rate));
        const auto psi_dot = translate(velocity.symbol, place);
        const auto acceleration = translate(velocity.rate, place);
        mode.rate =
            program.sum({{1, psi_dot},
                         {-1, program.product(program.constant(i_over_omega), acceleration)},
                         {1, program.product(program.constant(frame), psi_dot)},
                         {-1, program.product(program.constant(ring.multiply(ring.imaginary(), mode.omega)),
                                              mode.input)}});
    }

    const Divisors& divisors_;
    std::shared_ptr<const FirstOrderSystem> first_order_;
    const System& system_;
    CoefficientRing coefficients_;
    std::vector<Oscillator> oscillators_;
    GradedField field_;
};

} // namespace

GradedField expand(std::shared_ptr<const FirstOrderSystem> system, const Divisors& divisors) {
    return Expansion(std::move(system), divisors).build();
}

FieldSeries evaluate_field(const GradedField& field, int through) {
    SeriesRun run(*field.program);
    FieldSeries result;
    for (int n = 0; n <= through; ++n) {
        for (const Mode& mode : field.modes) {
            run.set_input(mode.input, n, n == 1 ? field.ring->gen(mode.z) : Polynomial());
            run.set_input(mode.input_conjugate, n, n == 1 ? field.ring->gen(mode.zbar) : Polynomial());
        }
        run.advance(n);
    }
    for (const Mode& mode : field.modes) result.mode.push_back(run.series(mode.rate));
    for (const DriftVariable& drift : field.drift) result.drift.push_back(run.series(drift.rate));
    return result;
}

} // namespace resonform
