// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/series/ring_domain.hpp"
#include "expand/expansion/graded_field.hpp"
#include "expand/expansion/translate.hpp"
#include "model/system/names.hpp"
#include "model/text/diagnostic.hpp"

#include <utility>

namespace resonform {

namespace {

using GiNaC::ex;

// How many weights, of the user, past the last printed one are searched for the first neglected term.
constexpr int searched_ahead = 4;

// The residual of a fast equation with the rates of slow variables put in; the rate of the others.
ex line_expression(const FirstOrderSystem& first_order, std::size_t variable) {
    const System& system = *first_order.system;
    if (system.variables[variable].role != Role::fast)
        return first_order.states[first_order.index(variable, 0)].rate;
    GiNaC::exmap rates;
    for (std::size_t v = 0; v < system.variables.size(); ++v)
        if (system.variables[v].role != Role::fast)
            rates[system.variables[v].jet.back()] = first_order.states[first_order.index(v, 0)].rate;
    return system.equations[variable].residual.subs(rates, GiNaC::subs_options::no_pattern);
}

struct Jet {
    GiNaC::symbol symbol;
    int weight;
    std::string name; // of a variable that is measured from its equilibrium: delta_x, delta_x'
};

std::vector<Jet> fast_jets(const System& system) {
    std::vector<Jet> jets;
    for (std::size_t v = 0; v < system.variables.size(); ++v) {
        if (system.variables[v].role != Role::fast) continue;
        const bool measured = system.equilibrium_of(v) != nullptr;
        for (const GiNaC::symbol& symbol : system.variables[v].jet) {
            const std::string name = symbol.get_name();
            jets.push_back({symbol, system.variables[v].weight, measured ? deviation_name(name) : name});
        }
    }
    return jets;
}

std::vector<GiNaC::symbol> angles_of(const System& system) {
    std::vector<GiNaC::symbol> angles;
    for (const Variable& v : system.variables)
        if (v.role == Role::angle) angles.push_back(v.jet.front());
    return angles;
}

std::shared_ptr<const CoefficientRing> jet_ring(const FirstOrderSystem& first_order,
                                                const std::vector<Jet>& jets, int through) {
    CoefficientRing coefficients(first_order.system);
    std::vector<FastGenerator> generators;
    for (const Jet& jet : jets) generators.push_back({jet.name, jet.weight, -1});
    coefficients.set_fast(std::move(generators));
    std::vector<std::string> angles;
    for (const auto& angle : angles_of(*first_order.system)) {
        angles.push_back(angle.get_name());
        coefficients.move(angle);
    }
    coefficients.set_angles(std::move(angles));
    for (const Jet& jet : jets) coefficients.vanish(jet.symbol);
    for (std::size_t v = 0; v < first_order.system->variables.size(); ++v)
        coefficients.collect(line_expression(first_order, v),
                             place_of(first_order.system->equations[v].source));
    const int derivatives = coefficients.expands_named() ? through : 0;
    at_place(whole_file(first_order.system->file), [&] { coefficients.freeze({nullptr, {}, derivatives}); });
    return std::make_shared<const CoefficientRing>(std::move(coefficients));
}

// Without what vanishes and does not look like it: an equilibrium solves its equation only by a relation that
// the ring does not apply.
EquationLine make_line(std::size_t variable, bool implicit, const Series& series,
                       const EquationSeries& equations) {
    const RingDomain domain(equations.ring);
    EquationLine line{variable, implicit, {}, 0};
    for (int n = 0; n <= series.through() && line.next_weight == 0; ++n) {
        Polynomial part = domain.without_vanishing(series.part(n), equations.outer());
        if (n <= equations.through)
            line.series.set(n, std::move(part));
        else if (!part.empty())
            line.next_weight = n;
    }
    return line;
}

} // namespace

EquationSeries expand_equations(const GradedField& field, int through) {
    const FirstOrderSystem& first_order = *field.first_order;
    const System& system = *first_order.system;
    const auto jets = fast_jets(system);
    const int last = through + searched_ahead * system.eps_root;
    const auto shared = jet_ring(first_order, jets, last);
    const CoefficientRing& coefficients = *shared;

    SeriesProgram program(coefficients.ring());
    Translator translate(program, coefficients);
    std::vector<SeriesProgram::Node> inputs;
    for (const Jet& jet : jets) {
        inputs.push_back(program.input(jet.symbol.get_name()));
        translate.bind(jet.symbol, inputs.back());
    }
    const auto angles = angles_of(system);
    for (std::size_t k = 0; k < angles.size(); ++k)
        translate.bind_angle(angles[k], coefficients.angle(k), program.sum({}));
    std::vector<SeriesProgram::Node> lines;
    for (std::size_t v = 0; v < system.variables.size(); ++v) {
        const Place place = place_of(system.equations[v].source);
        lines.push_back(at_place(place, [&] { return translate(line_expression(first_order, v), place); }));
    }

    SeriesRun run(program);
    for (int n = 0; n <= last; ++n) {
        for (std::size_t k = 0; k < jets.size(); ++k)
            run.set_input(inputs[k], n,
                          n == jets[k].weight ? coefficients.ring()->gen(coefficients.fast(k))
                                              : Polynomial());
        run.advance(n);
    }
    EquationSeries result{shared, coefficients.ring(), coefficients.eps(), through, {}};
    for (std::size_t v = 0; v < system.variables.size(); ++v)
        result.lines.push_back(
            make_line(v, system.variables[v].role == Role::fast, run.series(lines[v]), result));
    return result;
}

std::vector<GeneratorId> EquationSeries::outer() const {
    std::vector<GeneratorId> outer;
    for (GeneratorId id = 0; id < ring->size(); ++id) {
        const GeneratorKind kind = ring->generator(id).kind;
        if (kind == GeneratorKind::fast || kind == GeneratorKind::phase) outer.push_back(id);
    }
    outer.push_back(eps);
    return outer;
}

} // namespace resonform
