// SPDX-License-Identifier: GPL-3.0-or-later
// The symbols of a mechanism in motion, their time derivatives, and their values at eps = 0.
#pragma once

#include "model/exact/form.hpp"
#include "model/exact/substitution.hpp"
#include "model/system/mechanism.hpp"

namespace resonform {

class Motion {
public:
    // Adds all symbols to `form`. The referents outlive the motion.
    Motion(const Mechanism& mechanism, const System& system, ExactForm& form);
    // The symbols of an integral that the engine found.
    void add(const Coordinate& constant);

    // d/dt of an expression in coordinates, velocities and prescribed ones; x'' has none.
    [[nodiscard]] GiNaC::ex derivative(const GiNaC::ex& e) const;
    // At eps = 0, where prescribed velocities have their values there.
    // Errors (bad_input): a pole.
    [[nodiscard]] GiNaC::ex unperturbed(const GiNaC::ex& e) const;
    // The prescribed coordinates that do not rest at eps = 0.
    [[nodiscard]] std::vector<const Prescribed*> moving() const;
    // e > 0 is proved at eps = 0 and the origin of small variables, hence nearby.
    [[nodiscard]] bool positive_where_expanded(const GiNaC::ex& e) const;
    // With the laws of prescribed coordinates put in.
    [[nodiscard]] GiNaC::ex with_laws(const GiNaC::ex& e) const;
    [[nodiscard]] const Mechanism& mechanism() const { return *mechanism_; }
    [[nodiscard]] const System& system() const { return *system_; }
    [[nodiscard]] ExactForm& form() const { return *form_; }

private:
    void add_symbols(const std::vector<const Coordinate*>& all);
    const Mechanism* mechanism_;
    const System* system_;
    ExactForm* form_;
    std::vector<TimeDerivative> derivatives_;
    GiNaC::exmap laws_; // xi' -> eps*v
};

} // namespace resonform
