// SPDX-License-Identifier: GPL-3.0-or-later
// More divisors for a field: its ring is built anew with an inverse for each.
#include "algebra/number/error.hpp"
#include "algebra/ring/division.hpp"
#include "algebra/ring/fractions.hpp"
#include "algebra/ring/number_field.hpp"
#include "algebra/ring/polynomial.hpp"
#include "expand/expansion/graph_fit.hpp"
#include "expand/modes/number_fit.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace resonform {

Polynomial primitive_part(const Ring& ring, const Polynomial& p) {
    Monomial common;
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        if (!ring.generator(id).invertible || id == Ring::imaginary_unit) continue;
        common = common + ring.monomial(id, ring.lowest_exponent(p, id));
    }
    const bool minus = cln::minusp(p.terms().front().coefficient);
    const Rational number = minus ? -content(p) : content(p);
    return 1 / number * divided(p, common);
}

std::vector<Polynomial> small_divisors(const GradedField& field) {
    std::vector<Polynomial> divisors;
    for (const GeneratorId id : field.coefficients->divisors())
        divisors.push_back(field.ring->generator(id).radicand);
    return divisors;
}

std::shared_ptr<const GradedField> with_derivatives(std::shared_ptr<const GradedField> field, int count) {
    if (field->system().functions.empty() || field->coefficients->derivatives() >= count) return field;
    return std::make_shared<const GradedField>(
        expand(field->first_order, {field->ring, small_divisors(*field), count}));
}

namespace {

// p divided by all radicands of several terms that divide it: those have inverses already.
Polynomial without_radicands(const Ring& ring, Polynomial p) {
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        if (ring.generator(id).kind != GeneratorKind::root || is_numeric_root(ring, id)) continue;
        const Polynomial radicand = ring.reduce(ring.generator(id).radicand);
        if (radicand.size() < 2) continue;
        while (auto quotient = divide_exactly(ring, p, radicand)) p = *std::move(quotient);
    }
    return p.size() > 1 ? primitive_part(ring, p) : p;
}

// Factors of p, generators and the rest: if each of them has an inverse, p has one.
std::vector<Polynomial> factors_to_invert(const Ring& ring, const Polynomial& p) {
    Polynomial rest = primitive_part(ring, p);
    std::vector<Polynomial> factors;
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const int exponent = ring.lowest_exponent(rest, id);
        if (exponent <= 0) continue;
        factors.push_back(ring.gen(id));
        rest = divided(rest, ring.monomial(id, exponent));
    }
    rest = without_radicands(ring, std::move(rest));
    if (rest.size() > 1) factors.push_back(std::move(rest));
    return factors;
}

std::string instead_of_more_divisors(const GradedField& field) {
    const bool parameters = !field.system().parameters.empty();
    std::vector<std::string> ways{"ask for a lower order"};
    if (parameters) ways.emplace_back("give parameters numeric values with --set NAME=VALUE");
    if (fits_graph(field)) ways.emplace_back("take --format json with --coefficients graph");
    if (!hindrance_to_numbers(field.system()))
        ways.emplace_back(std::string(parameters ? "with a value for every parameter " : "") +
                          "take numbers: --digits 30");
    return fmt::format("{}", fmt::join(ways, ", or "));
}

} // namespace

GradedField with_divisors(const GradedField& field, const std::vector<Polynomial>& divisors) {
    Divisors all{field.ring, small_divisors(field), field.coefficients->derivatives()};
    const std::size_t held = all.values.size();
    for (const Polynomial& divisor : divisors)
        for (Polynomial& factor : factors_to_invert(*field.ring, divisor))
            if (std::find(all.values.begin(), all.values.end(), factor) == all.values.end())
                all.values.push_back(std::move(factor));
    if (all.values.size() == held)
        refuse({"small divisors are polynomials that the ring can learn to divide by",
                field.system().name,
                "declare the parameters in it nonzero or positive, or give them numbers with --set",
                {}});
    const std::size_t needed = static_cast<std::size_t>(field.ring->size()) - held + all.values.size();
    if (needed > static_cast<std::size_t>(Packing::most_fields))
        refuse(Reason::size,
               {fmt::format("i, eps, parameters, variables, roots and small divisors are at most {} together",
                            Packing::most_fields),
                fmt::format("{}, of which {} are small divisors", needed, all.values.size()),
                instead_of_more_divisors(field),
                {}});
    return expand(field.first_order, all);
}

} // namespace resonform
