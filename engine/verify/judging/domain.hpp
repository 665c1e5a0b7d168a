// SPDX-License-Identifier: GPL-3.0-or-later
// Does the motion to be verified stay in the declared domain of the system?
#pragma once

#include "model/exact/first_order_system.hpp"
#include "model/system/scene_file.hpp"

#include <string>
#include <vector>

namespace resonform {

class DeclaredDomain {
public:
    // The scene must outlive it. Precondition: every parameter is fixed. Only slow variables of constant rate
    // are followed: conditions on others are left to the integration and to the evaluator, which answer
    // beyond with a status.
    DeclaredDomain(const FirstOrderSystem& system, const Scene& scene);

    // Errors (bad_input): the slow variables leave the domain within the interval of the scene. The place is
    // the interval; the condition, its place, the values, and how long the motion may last are told.
    void require(const Rational& eps) const;

private:
    struct Condition {
        GiNaC::ex value;               // in eps and `time_`: positive within the domain
        std::string text;              // "2 - tau > 0"
        std::string where;             // file:line of the declaration
        std::vector<std::size_t> slow; // which variables it is about
    };
    struct SlowMotion {
        std::string name;
        GiNaC::ex value;
    };
    [[nodiscard]] double number(const GiNaC::ex& value, const Rational& eps, double t) const;
    [[noreturn]] void complain(const Condition& condition, const Rational& eps, double t) const;

    const System& system_;
    const Scene& scene_;
    GiNaC::symbol time_{"t"};
    std::string interval_text_;
    Place place_; // of the interval
    std::vector<SlowMotion> motions_;
    std::vector<Condition> conditions_;
};

} // namespace resonform
