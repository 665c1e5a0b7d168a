// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/unit_check.hpp"

#include "algebra/number/error.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/named_function.hpp"

#include <algorithm>

namespace resonform {

namespace {

using GiNaC::ex;

const Dimension second = {{"s", 1}};

class UnitCheck {
public:
    explicit UnitCheck(const System& system) : missing_{"eps"} {
        of_[system.eps] = Dimensions::unknown("eps");
        for (const Parameter& p : system.parameters) declare(p.symbol, p.name, p.unit, {});
        for (const Variable& v : system.variables)
            for (std::size_t k = 0; k < v.jet.size(); ++k)
                declare(v.jet[k], v.name, v.unit, power(second, -static_cast<int>(k)), v.place);
    }
    void declare(const Coordinate& c) {
        declare(c.at, c.name, c.unit, {}, c.place);
        declare(c.velocity, c.name, c.unit, power(second, -1), c.place);
    }
    void declare(const QuasiVelocity& u) { declare(u.velocity, u.name, u.unit, {}, u.place); }
    [[nodiscard]] bool any() const { return any_; }
    // Units that the file does not give, but determines.
    [[nodiscard]] std::vector<std::pair<std::string, std::string>> found() const;

    // The unit of an expression at `source`, whose sums must fit together.
    Dimension unit(const ex& e, const SourceText& source);
    void require(const Dimension& found, const Dimension& wanted, const std::string& what,
                 const SourceText& source) {
        if (known_.equate(found, wanted)) return;
        bad_input({"units fit together",
                   what + " is in " + to_string(known_.resolved(found)) + ", not in " +
                       to_string(known_.resolved(wanted)),
                   "correct the expression or the units; a file without units is not checked",
                   place_of(source)});
    }

private:
    void declare(const GiNaC::symbol& symbol, const std::string& name, const std::string& unit,
                 const Dimension& factor, const Place& place = {}) {
        any_ = any_ || !unit.empty();
        if (unit.empty() && std::find(missing_.begin(), missing_.end(), name) == missing_.end())
            missing_.push_back(name);
        of_[symbol] =
            product(unit.empty() ? Dimensions::unknown(name) : read_unit(unit, {place, false}), factor);
    }
    Dimension of_sum(const ex& e, const SourceText& source);
    Dimension of_function(const ex& e, const SourceText& source);

    std::map<ex, Dimension, GiNaC::ex_is_less> of_;
    Dimensions known_;
    std::vector<std::string> missing_;
    bool any_ = false;
};

std::vector<std::pair<std::string, std::string>> UnitCheck::found() const {
    std::vector<std::pair<std::string, std::string>> list;
    for (const std::string& name : missing_) {
        const Dimension unit = known_.resolved(Dimensions::unknown(name));
        const bool determined = std::none_of(unit.begin(), unit.end(),
                                             [](const auto& factor) { return factor.first.front() == '?'; });
        if (determined) list.emplace_back(name, to_string(unit));
    }
    return list;
}

Dimension UnitCheck::unit(const ex& e, const SourceText& source) {
    if (GiNaC::is_a<GiNaC::symbol>(e)) return of_.at(e);
    if (GiNaC::is_a<GiNaC::add>(e)) return of_sum(e, source);
    if (GiNaC::is_a<GiNaC::mul>(e)) {
        Dimension result;
        for (const ex& factor : operands(e)) result = product(result, unit(factor, source));
        return result;
    }
    if (GiNaC::is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::rational))
        return power(unit(e.op(0), source), to_rational(e.op(1)));
    if (GiNaC::is_a<GiNaC::function>(e)) return of_function(e, source);
    return {};
}

// All terms must have the unit of the first.
Dimension UnitCheck::of_sum(const ex& e, const SourceText& source) {
    const std::vector<ex> terms = operands(e);
    Dimension first = unit(terms.front(), source);
    for (std::size_t k = 1; k < terms.size(); ++k)
        require(unit(terms[k], source), first,
                "beside the term " + excerpt(spell(terms.front())) + ", the term " + excerpt(spell(terms[k])),
                source);
    return first;
}

Dimension UnitCheck::of_function(const ex& e, const SourceText& source) {
    const Dimension argument = unit(e.op(0), source);
    if (is_named(e)) {
        const NamedCall call = named_call(e);
        return quotient(Dimensions::unknown(call.name), power(argument, call.derivative));
    }
    require(argument, {}, "the argument " + excerpt(spell(e.op(0))) + " of a function", source);
    return {};
}

// Checks all energies: kinetic ones m*x^2/s^2, and those given by [energy] and [forces].
void check_energies(const Mechanism& mechanism, UnitCheck& check) {
    const Dimension energy = Dimensions::unknown(" energy");
    const auto require = [&](const ex& value, const Dimension& factor, const std::string& what,
                             const SourceText& source) {
        if (!value.is_zero()) check.require(product(check.unit(value, source), factor), energy, what, source);
    };
    const auto kinetic = [&](const ex& mass, const ex& position, const SourceText& source) {
        require(mass * position * position, power(second, -2), "mass*position^2/s^2", source);
    };
    const auto of_particle = [&](const Particle& particle) {
        for (const ex& x : particle.position) kinetic(particle.mass, x, particle.source);
    };
    for (const Particle& particle : mechanism.particles) of_particle(particle);
    for (const PlaneBody& body : mechanism.plane_bodies) {
        of_particle(body.centre);
        check.require(check.unit(body.angle, body.centre.source), {}, "the angle", body.centre.source);
        require(body.inertia, power(second, -2), "inertia/s^2", body.centre.source);
    }
    for (const SpatialBody& body : mechanism.spatial_bodies) {
        of_particle(body.centre);
        for (const ex& inertia : body.inertia)
            require(inertia, power(second, -2), "inertia/s^2", body.centre.source);
    }
    require(mechanism.potential.value, {}, "the potential", mechanism.potential.source);
    require(mechanism.dissipation.value, second, "the dissipation times a second",
            mechanism.dissipation.source);
    if (mechanism.lagrangian)
        require(mechanism.lagrangian->value, {}, "the Lagrangian", mechanism.lagrangian->source);
    for (const Force& force : mechanism.forces)
        require(force.value * mechanism.coordinates[force.coordinate].at, {}, "force times coordinate",
                force.source);
}

} // namespace

std::vector<std::pair<std::string, std::string>> check_units(const Mechanism& mechanism, const System& system,
                                                             const std::vector<GivenRelation>& relations) {
    UnitCheck check(system);
    for (const Coordinate& c : mechanism.coordinates) check.declare(c);
    for (const Integral& i : mechanism.integrals) check.declare(i.coordinate);
    for (const QuasiVelocity& u : mechanism.quasi_velocities) check.declare(u);
    if (!check.any()) return {};
    for (const Prescribed& p : mechanism.prescribed) check.unit(p.law.value, p.law.source);
    check_energies(mechanism, check);
    for (const QuasiVelocity& u : mechanism.quasi_velocities)
        check.require(check.unit(u.form.value, u.form.source), check.unit(u.velocity, u.form.source),
                      "the quasi-velocity", u.form.source);
    for (const Constraint& c : mechanism.constraints) check.unit(c.condition.value, c.condition.source);
    const auto equal = [&](const Written& value, const Coordinate& coordinate, const std::string& what) {
        check.require(check.unit(value.value, value.source), check.unit(coordinate.at, value.source), what,
                      value.source);
    };
    for (const Integral& i : mechanism.integrals) equal(i.value, i.coordinate, "the integral");
    for (const Change& c : mechanism.changes)
        equal(c.value, mechanism.coordinates[c.coordinate], "the change of variables");
    for (const GivenRelation& r : relations)
        check.require(check.unit(r.value.value, r.value.source),
                      check.unit(r.parameter->symbol, r.value.source), "the relation", r.value.source);
    for (const Declaration& d : system.positive) check.unit(d.value, d.source);
    return check.found();
}

} // namespace resonform
