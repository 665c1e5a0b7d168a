// SPDX-License-Identifier: GPL-3.0-or-later
// Normal forms with coefficients in a graph: the same as in the ring and as with numbers, and certified.
#include "algebra/graph/expansion.hpp"
#include "normalize/certified.hpp"
#include "support/error_when.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace resonform {
namespace {

using test::certificate_of;
using test::field_from;

using Numbers = std::map<std::string, Rational>; // of parameters and slow variables

std::string oscillators(const std::string& equations, const std::string& variables,
                        const std::string& parameters) {
    return "[system]\nname = \"oscillators\"\n[parameters]\n" + parameters + "[variables]\n" + variables +
           "[equations]\n" + equations;
}

std::shared_ptr<const GradedField> coupled(const std::string& first, const std::string& second,
                                           const std::string& parameters) {
    return field_from(oscillators("x = \"x'' + " + first + "*x + 2*x*y + x^3/3 = 0\"\ny = \"y'' + " + second +
                                      "*y + x^2 - y^2 + x*y^2/2 = 0\"\n",
                                  "x = { role = \"fast\" }\ny = { role = \"fast\" }\n", parameters));
}

const std::string two_frequencies = "w1 = { positive = true }\nw2 = { positive = true }\n";

// A polynomial of the ring with numbers for parameters and slow variables: by outer monomial, i included.
std::map<std::vector<int>, Rational> at(const GradedField& field, const Polynomial& p,
                                        const Numbers& numbers) {
    const Ring& ring = *field.ring;
    std::map<GeneratorId, Rational> values;
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const Generator& g = ring.generator(id);
        if (const auto known = numbers.find(g.name); known != numbers.end()) values[id] = known->second;
        const auto holds = [&](const Term& t) { return ring.exponent(t.monomial, id) != 0; };
        const auto terms = p.terms();
        if (g.kind == GeneratorKind::root && std::any_of(terms.begin(), terms.end(), holds)) { // a divisor
            Rational value = 0;
            for (const auto& [powers, number] : at(field, g.radicand, numbers)) value = value + number;
            values[id] = value;
        }
    }
    std::map<std::vector<int>, Rational> result;
    for (const Term& t : p.terms()) {
        Rational number = t.coefficient;
        std::vector<int> outer = ring.exponents(t.monomial);
        for (const auto& [id, value] : values)
            number = number * cln::expt(value, std::exchange(outer[static_cast<std::size_t>(id)], 0));
        outer.resize(static_cast<std::size_t>(field.eps) + 1); // modes and eps come first
        Rational& sum = result[outer];
        sum = sum + number;
    }
    std::erase_if(result, [](const auto& entry) { return cln::zerop(entry.second); });
    return result;
}

std::map<std::vector<int>, Rational> at(const GraphNormalization& n, const GraphPart& part,
                                        const Numbers& numbers) {
    const GradedField& field = *n.result.normal_form.field;
    const GraphReplay replay(n.domain.graph(), part.coefficients);
    const auto values =
        replay.evaluate<Rational>([&](LeafId id) { return numbers.at(n.domain.graph().leaf_name(id)); },
                                  [](const Rational& q) { return q; });
    EXPECT_TRUE(values.has_value());
    std::map<std::vector<int>, Rational> result;
    for (std::size_t k = 0; k < part.size(); ++k) {
        std::vector<int> outer = field.ring->exponents(n.domain.monomial(part.keys[k]));
        outer.resize(static_cast<std::size_t>(field.eps) + 1);
        if (!cln::zerop((*values)[k])) result[outer] = (*values)[k];
    }
    return result;
}

void expect_same(const GraphNormalization& graph, const Normalization& ring, const Numbers& numbers,
                 int through) {
    for (std::size_t k = 0; k < ring.normal_form.mode.size(); ++k)
        for (int weight = 1; weight <= through; ++weight) {
            EXPECT_EQ(at(graph, graph.result.normal_form.mode[k].part(weight), numbers),
                      at(*ring.normal_form.field, ring.normal_form.mode[k].part(weight), numbers))
                << k << " " << weight;
            EXPECT_EQ(at(graph, graph.result.map.mode[k].part(weight), numbers),
                      at(*ring.normal_form.field, ring.map.mode[k].part(weight), numbers))
                << k << " " << weight;
        }
}

TEST(GraphCoefficients, EqualThoseOfTheRing) {
    const auto field = coupled("w1^2", "w2^2", two_frequencies);
    const GraphNormalization graph = normalize_in_graph(field, 4);
    const Normalization ring = normalize_poincare(field, 4);
    expect_same(graph, ring, {{"w1", Rational(7) / 3}, {"w2", Rational(5) / 8}}, 4);
    ASSERT_EQ(graph.result.divisors.size(), ring.divisors.size());
    for (std::size_t k = 0; k < ring.divisors.size(); ++k)
        EXPECT_EQ(graph.result.divisors[k].verdict, ring.divisors[k].verdict);
}

TEST(GraphCoefficients, EqualThoseWithNumbers) {
    const GraphNormalization graph = normalize_in_graph(coupled("w1^2", "w2^2", two_frequencies), 5);
    const Normalization numbers = normalize_poincare(coupled("49", "25/9", ""), 5);
    expect_same(graph, numbers, {{"w1", 7}, {"w2", Rational(5) / 3}}, 5);
}

TEST(GraphCoefficients, AreCertifiedWhereARingWouldNotHoldTheDivisors) {
    std::string equations;
    for (const auto& [name, frequency] : {std::pair{"x", "a"}, {"y", "b"}, {"z", "c"}})
        equations += std::string(name) + " = \"" + name + "'' + " + frequency + "^2*" + name +
                     " + (x + y + z)^2 + x*y*z = 0\"\n";
    const auto field = field_from(
        oscillators(equations, "x = { role = \"fast\" }\ny = { role = \"fast\" }\nz = { role = \"fast\" }\n",
                    "a = { positive = true }\nb = { positive = true }\nc = { positive = true }\n"));
    GraphNormalization n = normalize_in_graph(field, 4);
    const Certificate c = certify(n);
    EXPECT_TRUE(c.holds) << c.complaint;
    EXPECT_LE(c.error_probability, 1e-20);
    // A liar: one coefficient of the top weight is another one.
    GraphPart wrong = n.result.map.mode[1].part(4);
    wrong.coefficients[3] = n.domain.graph().sum(wrong.coefficients[3], n.domain.graph().number(1));
    n.result.map.mode[1].set(4, wrong);
    EXPECT_FALSE(certify(n).holds);
}

TEST(GraphCoefficients, FollowSlowFrequencies) {
    const auto field = field_from(oscillators(
        "x = \"x'' + tau^2*x + x*y + y^2 = 0\"\ny = \"y'' + w^2*y + x^2/2 = 0\"\ntau = \"tau' = eps*(1 + "
        "tau)\"\n",
        "x = { role = \"fast\" }\ny = { role = \"fast\" }\ntau = { role = \"slow\", positive = true }\n",
        "w = { positive = true }\n"));
    GraphNormalization n = normalize_in_graph(field, 4);
    const Certificate c = certify(n);
    EXPECT_TRUE(c.holds) << c.complaint;
    expect_same(n, normalize_poincare(field, 3), {{"w", Rational(7) / 3}, {"tau", Rational(5) / 8}}, 3);
    GraphPart wrong = n.result.normal_form.mode[0].part(3);
    wrong.coefficients[0] = wrong.coefficients[0].negative();
    n.result.normal_form.mode[0].set(3, wrong);
    EXPECT_FALSE(certify(n).holds);
}

TEST(GraphCoefficients, OfAlgebraicLeavesAreRefused) {
    const auto expect_refused = [](const std::string& first, const std::string& found) {
        const auto field =
            coupled(first, "w2^2", two_frequencies + "a = { positive = true }\nb = { positive = true }\n");
        const Error error = test::error_when([&] { static_cast<void>(normalize_in_graph(field, 3)); });
        EXPECT_EQ(error.kind(), ErrorKind::refused);
        EXPECT_NE(std::string(error.what()).find("independent symbols"), std::string::npos);
        EXPECT_EQ(error.diagnostic().value, found);
    };
    expect_refused("(a + b)", "a root whose radicand is a sum");
    expect_refused("2*w1^2", "2^(1/2)");
}

} // namespace
} // namespace resonform
