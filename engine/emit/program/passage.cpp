// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/passage.hpp"

#include "solve/flow/passage.hpp"
#include "solve/flow/slow_flow.hpp"

#include <algorithm>

namespace resonform {

namespace {

using Node = Graph::Node;

class Passing {
public:
    Passing(Program& program, const Solution& solution, const RealForm& real, const Passage& passage,
            FlowMoment& now, FlowMoment& start)
        : graph_(program.graph), small_(program.small), solution_(solution),
          field_(*solution.normalization->normal_form.field), mode_(field_.modes[passage.mode]), real_(real),
          passage_(passage), now_(now), mu_(at(now, mode_.growth)), mu_0_(at(start, mode_.growth)) {}

    [[nodiscard]] std::vector<std::vector<Node>> conditions() {
        std::vector<std::vector<Node>> all{{graph_.negate(mu_0_), mu_}};
        if (const Node driving = driven(); !graph_.is_rational(driving, 0))
            all.push_back({graph_.negate(mu_), graph_.negate(at(now_, slope_in_time(field_, mode_.growth))),
                           before_buffer(driving)});
        if (divides_by_growth()) all.push_back({clear_of_zero()});
        return all;
    }

private:
    [[nodiscard]] Node at(FlowMoment& moment, const Polynomial& p) const {
        return moment.lowering.polynomial(real_(p).re);
    }
    [[nodiscard]] Node number(int numerator, int denominator = 1) const {
        return graph_.rational(Rational(numerator) / Rational(denominator));
    }
    [[nodiscard]] Node size(Node x, Node y) const {
        return graph_.function(Graph::Op::sqrt_sum_squares, {x, y});
    }

    // |g|: the terms of the map without modes are -g/lambda.
    [[nodiscard]] Node driven() const {
        std::vector<Node> sizes;
        const Series& map = solution_.normalization->map.mode[passage_.mode];
        for (int n = 0; n <= map.through(); ++n) {
            std::vector<Term> terms;
            for (const Term& t : map.part(n).terms())
                if (degree_in(field_, t.monomial, passage_.mode) == 0) terms.push_back(t);
            if (terms.empty()) continue;
            const RealForm::Value h = real_(Polynomial::from_terms(std::move(terms)));
            sizes.push_back(size(now_.lowering.polynomial(h.re), now_.lowering.polynomial(h.im)));
        }
        if (sizes.empty()) return number(0);
        return graph_.multiply({graph_.add(std::move(sizes)), size(mu_, at(now_, mode_.omega))});
    }

    // 1 - 10^3 |g| sqrt(2 pi/|lambda'|) e^B/eps^w
    [[nodiscard]] Node before_buffer(Node driving) const {
        const Node omega = at(now_, mode_.omega), mu_slope = at(now_, slope_in_time(field_, mode_.growth)),
                   omega_slope = at(now_, slope_in_time(field_, mode_.omega));
        const Node square = graph_.add({graph_.power(mu_slope, 2), graph_.power(omega_slope, 2)});
        if (graph_.is_rational(square, 0)) return number(1); // with the values under [fix] lambda rests
        // Re lambda^2 conj(lambda')
        const Node real_part = graph_.add(
            {graph_.multiply(
                 {graph_.add({graph_.power(mu_, 2), graph_.negate(graph_.power(omega, 2))}), mu_slope}),
             graph_.multiply({number(2), mu_, omega, omega_slope})});
        const Node b = graph_.multiply({number(1, 2), real_part, graph_.power(square, -1)});
        const Node width = graph_.multiply({number(251, 100), graph_.power(graph_.root(square, 4), -1)});
        const int weight = field_.ring->generator(mode_.z).weight;
        const Node left = graph_.multiply({number(1000), driving, width, graph_.function(Graph::Op::exp, {b}),
                                           graph_.power(small_, -weight)});
        return graph_.add({number(1), graph_.negate(left)});
    }

    [[nodiscard]] bool divides_by_growth() const {
        const Ring& ring = *field_.ring;
        for (GeneratorId id = 0; id < ring.size(); ++id) {
            const Generator& g = ring.generator(id);
            if (g.kind == GeneratorKind::root && g.index == 1 &&
                is_multiple_of_growth(field_, passage_.mode, g.radicand))
                return true;
        }
        return false;
    }

    [[nodiscard]] Node clear_of_zero() const {
        const int power = 4 * solution_.order + 2;
        const Node gone =
            graph_.multiply({number(4), graph_.power(passage_.ratio, 4),
                             graph_.power(passage_.exponential, 4), graph_.power(mu_0_, power)});
        return graph_.add({graph_.power(mu_, power), graph_.negate(gone)});
    }

    Graph& graph_;
    Node small_;
    const Solution& solution_;
    const GradedField& field_;
    const Mode& mode_;
    const RealForm& real_;
    const Passage& passage_;
    FlowMoment& now_;
    Node mu_, mu_0_;
};

} // namespace

std::vector<std::vector<Graph::Node>> precision_of(Program& program, const Solution& solution,
                                                   const RealForm& real, const Passage& passage,
                                                   FlowMoment& now, FlowMoment& start) {
    return Passing(program, solution, real, passage, now, start).conditions();
}

} // namespace resonform
