// SPDX-License-Identifier: GPL-3.0-or-later
// Lies about a normal form with coefficients in a graph: its certificate finds each.
#include "normalize/certified.hpp"
#include "support/system_text.hpp"

#include <gtest/gtest.h>

namespace resonform {
namespace {

class GraphLies : public ::testing::Test {
protected:
    static constexpr int order = 3;

    using List = std::vector<BasicSeries<GraphPart>>;
    [[nodiscard]] List& rates() { return n_.result.normal_form.mode; }
    [[nodiscard]] List& shifts() { return n_.result.map.mode; }
    [[nodiscard]] Certificate certificate() const { return certify(n_); }

    std::shared_ptr<const GradedField> field_ = test::field_from(test::system_text(
        "two", {{"x", "fast", "x'' + w1^2*x + 2*x*y = 0"}, {"y", "fast", "y'' + w2^2*y + x^2 = 0"}},
        "[parameters]\nw1 = { positive = true }\nw2 = { positive = true }\n"));
    GraphNormalization n_ = normalize_in_graph(field_, order);
};

// + 1, the other sign, dropped.
TEST_F(GraphLies, EveryCoefficient) {
    const auto plus_one = [&](const Coefficient& c) {
        return n_.domain.graph().sum(c, n_.domain.graph().number(1));
    };
    const auto turned = [](const Coefficient& c) { return c.negative(); };
    const auto dropped = [&](const Coefficient& /*c*/) { return n_.domain.graph().number(0); };
    int lies = 0;
    const auto lie = [&](BasicSeries<GraphPart>& series, int weight, std::size_t k, const auto& change) {
        const GraphPart truth = series.part(weight);
        GraphPart wrong = truth;
        wrong.coefficients[k] = change(wrong.coefficients[k]);
        series.set(weight, wrong);
        EXPECT_FALSE(certificate().holds) << "weight " << weight << ", term " << k;
        series.set(weight, truth);
        ++lies;
    };
    for (List* list : {&rates(), &shifts()})
        for (auto& series : *list)
            for (int weight = 0; weight <= order; ++weight)
                for (std::size_t k = 0; k < series.part(weight).size(); ++k) {
                    lie(series, weight, k, plus_one);
                    lie(series, weight, k, turned);
                    lie(series, weight, k, dropped);
                }
    EXPECT_EQ(lies, 75);
    EXPECT_TRUE(certificate().holds) << certificate().complaint;
}

// A resonant monomial of the top weight in the map, with the coefficient that it has in the normal form: no
// residual through that weight is changed by it.
TEST_F(GraphLies, KernelTermInTheMap) {
    for (std::size_t m = 0; m < shifts().size(); ++m) {
        const GraphPart truth = shifts()[m].part(order);
        shifts()[m].set(order, n_.domain.combination({{1, &truth}, {1, &rates()[m].part(order)}}));
        const Certificate c = certificate();
        EXPECT_TRUE(c.residual_zero) << c.complaint;
        EXPECT_FALSE(c.normal_form_scan);
        shifts()[m].set(order, truth);
    }
    EXPECT_TRUE(certificate().holds);
}

// A divisor taken for zero that is not: its monomial stays in the normal form.
TEST_F(GraphLies, RemovableTermsThatAreKept) {
    const FieldSeries f = evaluate_field(*field_, order);
    for (std::size_t m = 0; m < rates().size(); ++m) {
        const GraphPart linear = n_.domain.constant(field_->linear_part(m));
        rates()[m] = {};
        rates()[m].set(1, linear);
        for (int weight = 2; weight <= order; ++weight)
            rates()[m].set(weight, n_.domain.constant(f.mode[m].part(weight)));
        shifts()[m] = {};
    }
    const Certificate c = certificate();
    EXPECT_TRUE(c.residual_zero) << c.complaint;
    EXPECT_FALSE(c.normal_form_scan);
    EXPECT_FALSE(c.holds);
}

} // namespace
} // namespace resonform
