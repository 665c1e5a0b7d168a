// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/styles/poisson.hpp"

#include "algebra/number/error.hpp"
#include "model/text/diagnostic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace resonform {

namespace {

struct Coordinate {
    GeneratorId id;
    std::size_t mode;
    std::vector<Polynomial> row; // by index in ModalBasis::states
};

Place place_of_energy(const GradedField& field) { return place_of(field.system().hamiltonian->source); }

void require_pairs(const GradedField& field) {
    const System& system = field.system();
    if (!system.hamiltonian)
        bad_input({"the style hamiltonian is for systems that are given by their energy",
                   "no [hamiltonian] in " + system.name,
                   "write [hamiltonian] with energy and momenta, or take style = \"poincare\"",
                   whole_file(system.file)});
    const Variable& first = system.variables[system.hamiltonian->pairs.front().first];
    for (std::size_t v = 0; v < system.variables.size(); ++v) {
        const Variable& variable = system.variables[v];
        if (system.hamiltonian->has(v) && variable.weight != first.weight)
            refuse({"in the style hamiltonian all coordinates and momenta have one weight",
                    fmt::format("{} has weight {}, {} has weight {}", first.name,
                                to_string(system.weight(first.weight)), variable.name,
                                to_string(system.weight(variable.weight))),
                    "give them one weight, or take style = \"poincare\"", variable.place});
        if (system.hamiltonian->has(v)) continue;
        refuse({"in the style hamiltonian every variable is a coordinate or a momentum",
                fmt::format("'{}' is {} and belongs to no pair", variable.name, to_string(variable.role)),
                "take style = \"poincare\", which works with such equations", variable.place});
    }
}

std::vector<Coordinate> coordinates_of(const GradedField& field) {
    std::vector<Coordinate> result;
    const Place place = place_of_energy(field);
    for (std::size_t m = 0; m < field.modes.size(); ++m) {
        const Mode& mode = field.modes[m];
        std::vector<Polynomial> row, conjugate;
        for (const Complex& entry : field.basis.modes[m].row) {
            row.push_back(field.coefficients->convert(entry, place));
            conjugate.push_back(field.ring->conjugate(row.back()));
        }
        result.push_back({mode.z, m, std::move(row)});
        if (!mode.is_real()) result.push_back({mode.zbar, m, std::move(conjugate)});
    }
    return result;
}

Polynomial bracket(const GradedField& field, const Coordinate& a, const Coordinate& b) {
    const auto position = [&](std::size_t variable) {
        const std::size_t state = field.first_order->index(variable, 0);
        const auto& states = field.basis.states;
        return static_cast<std::size_t>(std::find(states.begin(), states.end(), state) - states.begin());
    };
    std::vector<Product> products;
    for (const auto& [coordinate, momentum] : field.system().hamiltonian->pairs) {
        const std::size_t q = position(coordinate), p = position(momentum);
        products.push_back({1, &a.row[q], &b.row[p]});
        products.push_back({-1, &a.row[p], &b.row[q]});
    }
    return field.ring->dot(products);
}

bool is_nonzero(const GradedField& field, const Polynomial& value, const Coordinate& a, const Coordinate& b) {
    if (value.empty()) return false;
    const Zero zero = field.ring->is_zero(value);
    if (zero != Zero::unknown) return zero == Zero::no;
    refuse(Reason::undecided,
           {"a bracket of two modes is proved to be zero or to be non-zero",
            fmt::format("{{{}, {}}}", field.ring->generator(a.id).name, field.ring->generator(b.id).name),
            std::string(field.system().parameters.empty()
                            ? ""
                            : "give parameters numeric values with --set NAME=VALUE, or ") +
                "take style = \"poincare\"",
            place_of_energy(field)});
}

} // namespace

std::vector<HamiltonianForm::Bracket> brackets_of_modes(const GradedField& field) {
    require_pairs(field);
    const std::vector<Coordinate> coordinates = coordinates_of(field);
    std::vector<HamiltonianForm::Bracket> brackets;
    std::set<GeneratorId> taken;
    for (std::size_t a = 0; a < coordinates.size(); ++a)
        for (std::size_t b = a + 1; b < coordinates.size(); ++b) {
            Polynomial value = bracket(field, coordinates[a], coordinates[b]);
            if (!is_nonzero(field, value, coordinates[a], coordinates[b])) continue;
            const bool first = taken.insert(coordinates[a].id).second;
            const bool second = taken.insert(coordinates[b].id).second;
            if (!first || !second)
                refuse(
                    {"modes of equal frequency are canonically independent of each other: each has a "
                     "bracket with one partner only",
                     fmt::format("{} has several", field.ring->generator(coordinates[first ? b : a].id).name),
                     "choose coordinates in which the quadratic part of the energy is a sum over pairs, "
                     "or take style = \"poincare\"",
                     place_of_energy(field)});
            brackets.push_back({coordinates[a].id, coordinates[b].id, std::move(value)});
        }
    return brackets;
}

HamiltonianVector::HamiltonianVector(const Ring& ring, const Brackets& brackets, const Polynomial& f) {
    for (const HamiltonianForm::Bracket& b : brackets) {
        components_[b.left] = ring.multiply(b.value, ring.derivative(f, b.right));
        components_[b.right] = -ring.multiply(b.value, ring.derivative(f, b.left));
    }
}

} // namespace resonform
