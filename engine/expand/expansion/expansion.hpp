// SPDX-License-Identifier: GPL-3.0-or-later
// The steps by which expand() builds a GradedField: roles -> modes -> ring -> program.
#pragma once

#include "expand/expansion/graded_field.hpp"
#include "expand/expansion/translate.hpp"

namespace resonform {

class Expansion {
public:
    Expansion(std::shared_ptr<const FirstOrderSystem> first_order, const Divisors& divisors);
    GradedField build();

private:
    // roles (expansion_roles.cpp)
    void check_drifts() const;
    void find_driven();
    [[nodiscard]] bool occurs(Role role, const GiNaC::ex& e) const; // does a variable of that role, in e?
    void check_numbers() const;
    void check_slow_rate(const State& state) const;

    // weights (expansion_weights.cpp)
    void check_finite() const;
    void check_leading_terms() const;
    [[nodiscard]] bool holds_mode(const Polynomial& p, int weight) const; // one of that weight?
    [[noreturn]] void refuse_leading_term(const State& state, int weight) const;
    [[nodiscard]] const State& last_state(std::size_t variable) const; // its highest derivative
    [[nodiscard]] int lowest_weight(const GiNaC::ex& e) const;

    // ring
    void name_generators();
    void build_ring();
    void add_shifts();
    void add_slow();

    // program
    void add_inputs();
    void add_mode_input(std::size_t k);
    void bind_states();
    [[nodiscard]] SeriesProgram::Node numeric_state(std::size_t s);
    void add_rates();
    void add_energy();
    void add_angle_rate(AngleVariable& angle);
    [[nodiscard]] SeriesProgram::Node mode_rate(std::size_t k);
    [[nodiscard]] SeriesProgram::Node numeric_rate(std::size_t k);
    [[nodiscard]] SeriesProgram::Node moving(const Complex& c, const Place& place);
    using Addends = std::vector<std::pair<Rational, SeriesProgram::Node>>;
    void add_product(Addends& addends, const Complex& factor, SeriesProgram::Node node, const Place& place);
    void add_frame(Addends& addends, const Complex& row, const State& state, const Place& place);
    [[nodiscard]] SeriesProgram::Node slow_rate(const SlowVariable& slow);
    [[nodiscard]] Place place_of_equation(std::size_t variable) const {
        return place_of(system_.equations[variable].source);
    }
    [[nodiscard]] const Variable& variable_of(const State& state) const {
        return system_.variables[state.variable];
    }

    const Divisors& divisors_;
    std::shared_ptr<const FirstOrderSystem> first_order_;
    const System& system_;
    CoefficientRing coefficients_;
    std::vector<bool> driven_; // by variable
    std::shared_ptr<SeriesProgram> program_;
    std::unique_ptr<Translator> translate_;
    GradedField field_;
};

} // namespace resonform
