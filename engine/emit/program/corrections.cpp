// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/corrections.hpp"

#include "emit/display/quantity.hpp"
#include "emit/graph/conditioning.hpp"
#include "emit/program/layers.hpp"
#include "emit/program/prune.hpp"

#include <algorithm>
#include <utility>

namespace resonform {

namespace {

class GraphAlgebra {
public:
    GraphAlgebra(Graph& graph, const std::set<Graph::Node>& positive) : graph_(graph), positive_(positive) {}
    [[nodiscard]] Graph::Node rational(const Rational& x) const { return graph_.rational(x); }
    [[nodiscard]] Graph::Node add(std::vector<Graph::Node> terms) const {
        return graph_.add(std::move(terms));
    }
    [[nodiscard]] Graph::Node multiply(const std::vector<Graph::Node>& factors) const {
        return graph_.multiply(factors);
    }
    [[nodiscard]] Graph::Node power(Graph::Node x, int n) const { return graph_.power(x, n); }
    [[nodiscard]] Graph::Node hypot(Graph::Node x, Graph::Node y) const {
        if (graph_.is_rational(y, 0)) return magnitude(x);
        if (graph_.is_rational(x, 0)) return magnitude(y);
        return graph_.function(Graph::Op::sqrt_sum_squares, {x, y});
    }

private:
    // Factor by factor: those of a known sign need no root.
    [[nodiscard]] Graph::Node magnitude(Graph::Node x) const {
        const Graph::Entry entry = graph_.at(x);
        if (entry.op == Graph::Op::rational) return graph_.rational(cln::abs(entry.value));
        if (entry.op == Graph::Op::power)
            return graph_.power(magnitude(entry.operands.front()), entry.exponent);
        if (entry.op == Graph::Op::multiply) {
            std::vector<Graph::Node> factors;
            for (const Graph::Node factor : entry.operands) factors.push_back(magnitude(factor));
            return graph_.multiply(factors);
        }
        if (entry.op == Graph::Op::sqrt_sum_squares || !signs_of(graph_, x, positive_).negative) return x;
        return graph_.function(Graph::Op::sqrt_sum_squares, {x, graph_.rational(0)});
    }

    Graph& graph_;
    const std::set<Graph::Node>& positive_;
};

const Ring& ring_of(const Solution& solution) {
    return solution.flow ? *solution.normalization->normal_form.field->ring : *solution.ring;
}

class Corrections {
public:
    Corrections(Program& program, const Solution& solution, const Surroundings& surroundings,
                const std::vector<FlowUnit>& modes,
                const std::function<Graph::Node(const Polynomial&)>& lower)
        : program_(program), ring_(ring_of(solution)), lower_(lower),
          algebra_(program.graph, surroundings.positive) {
        for (const FlowUnit& a : modes) moduli_.push_back(algebra_.hypot(a.u, a.v));
    }

    [[nodiscard]] const GraphAlgebra& algebra() const { return algebra_; }
    [[nodiscard]] Graph::Node modulus(std::size_t mode) const { return moduli_[mode]; }
    [[nodiscard]] Graph::Node size(const Polynomial& p) const {
        const auto [re, im] = real_and_imaginary(ring_, p, lower_);
        return algebra_.hypot(re, im);
    }
    [[nodiscard]] Graph::Node margin(const FirstCorrection& correction) const {
        std::vector<Graph::Node> sizes;
        for (const Polynomial& p : correction.polynomials()) sizes.push_back(size(p));
        return margin_of(algebra_, correction, program_.small, moduli_, sizes);
    }

private:
    Program& program_;
    const Ring& ring_;
    const std::function<Graph::Node(const Polynomial&)>& lower_;
    GraphAlgebra algebra_;
    std::vector<Graph::Node> moduli_;
};

} // namespace

Graph::Node corrections_of(Program& program, const Solution& solution, const Surroundings& surroundings,
                           std::size_t growing, const std::vector<FlowUnit>& modes,
                           const std::function<Graph::Node(const Polynomial&)>& lower) {
    const Corrections corrections(program, solution, surroundings, modes, lower);
    const GraphAlgebra& algebra = corrections.algebra();
    std::vector<Graph::Node> addends;
    for (const FirstCorrection& correction : first_corrections(solution)) {
        const auto place = std::find(correction.modes.begin(), correction.modes.end(), growing);
        if (place == correction.modes.end() || correction.quantity) continue;
        const auto own = static_cast<std::size_t>(place - correction.modes.begin());
        for (const FirstCorrection::Term& term : correction.sums.front()) {
            if (term.powers[own] < 1) continue;
            std::vector<Graph::Node> factors{corrections.size(term.coefficient),
                                             algebra.power(program.small, term.power_of_eps)};
            for (std::size_t k = 0; k < correction.modes.size(); ++k)
                if (k != own)
                    factors.push_back(
                        algebra.power(corrections.modulus(correction.modes[k]), term.powers[k]));
            const Graph::Node size = algebra.multiply(factors);
            addends.push_back(term.powers[own] == 1 ? size : program.graph.root(size, term.powers[own]));
        }
    }
    return algebra.multiply({corrections.modulus(growing), algebra.add(std::move(addends))});
}

void add_corrections(Program& program, const Solution& solution, const Surroundings& surroundings,
                     const std::vector<FlowUnit>& modes,
                     const std::function<Graph::Node(const Polynomial&)>& lower) {
    const Corrections corrections(program, solution, surroundings, modes, lower);
    for (const FirstCorrection& correction : first_corrections(solution)) {
        const Graph::Node margin = corrections.margin(correction);
        const bool moves = varies(program, margin);
        // Corrections of modes with constant amplitudes were checked at the start.
        if ((!moves && !correction.quantity) ||
            signs_of(program.graph, margin, surroundings.positive).is_positive())
            continue;
        const std::string name =
            correction.name.empty() ? quantity(ring_of(solution), *correction.quantity) : correction.name;
        if (!moves || needs_quadratures(solution, correction))
            program.positive.push_back({margin, name});
        else
            program.layers.push_back({margin, name, false, true});
    }
}

void add_start_corrections(Program& program, const Solution& solution, const Surroundings& surroundings,
                           const std::vector<FlowUnit>& modes,
                           const std::function<Graph::Node(const Polynomial&)>& lower) {
    const Corrections corrections(program, solution, surroundings, modes, lower);
    for (const FirstCorrection& correction : transient_corrections(solution))
        program.positive.push_back({corrections.margin(correction), correction.name});
}

} // namespace resonform
