// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/fading.hpp"

#include "solve/flow/passage.hpp"
#include "solve/flow/slow_flow.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace resonform {

namespace {

class Fading {
public:
    explicit Fading(const Solution& solution)
        : flow_(*solution.flow), normalization_(*solution.normalization),
          field_(*normalization_.normal_form.field), ring_(*field_.ring) {}

    [[nodiscard]] std::vector<FadingDivisor> all() const {
        std::vector<FadingDivisor> result;
        for (const MovingDivisor& moving : moving_divisors_at_start(normalization_))
            for (const GeneratorId id : field_.coefficients->divisors())
                if (is(id, moving.divisor))
                    if (std::optional<FadingDivisor> found = divisor(id, moving))
                        result.push_back(std::move(*found));
        return result;
    }

private:
    // A radicand of one term is written by its generator.
    [[nodiscard]] bool is(GeneratorId id, const Polynomial& divisor) const {
        return are_proportional(ring_.generator(id).radicand, divisor) ||
               are_proportional(ring_.gen(id), divisor);
    }
    [[nodiscard]] std::optional<FadingDivisor> divisor(GeneratorId id, const MovingDivisor& moving) const {
        if (ring_.conjugate(moving.divisor) != moving.divisor || stands_in_a_rate(id) ||
            stands_under_a_root(id))
            return std::nullopt;
        FadingDivisor fading{id, moving, 0, {}};
        for (const FlowOutput& output : flow_.outputs)
            for (int n = 0; n <= output.value.through(); ++n)
                for (const Term& t : output.value.part(n).terms()) {
                    const int power = -ring_.exponent(t.monomial, id);
                    if (power <= 0) continue;
                    std::optional<std::vector<int>> product = decaying(t.monomial);
                    if (!product) return std::nullopt;
                    fading.power = std::max(fading.power, power);
                    if (std::find(fading.products.begin(), fading.products.end(), *product) ==
                        fading.products.end())
                        fading.products.push_back(std::move(*product));
                }
        std::sort(fading.products.begin(), fading.products.end());
        return fading;
    }

    // How often the decays of the flow multiply it; nullopt: something in it does not decay.
    [[nodiscard]] std::optional<std::vector<int>> decaying(const Monomial& monomial) const {
        std::vector<int> product(flow_.decays.size(), 0);
        bool decays = false;
        for (std::size_t k = 0; k < field_.modes.size(); ++k) {
            const int times = degree_in(field_, monomial, k);
            const FlowMode& mode = flow_.modes[k];
            if (times == 0 || !field_.modes[k].is_damped()) continue;
            if (mode.grows || !mode.decay) return std::nullopt;
            product[*mode.decay] += times;
            decays = true;
        }
        return decays ? std::optional(product) : std::nullopt;
    }

    [[nodiscard]] bool is_divided(const Polynomial& p, GeneratorId id) const {
        return std::any_of(p.terms().begin(), p.terms().end(),
                           [&](const Term& t) { return ring_.exponent(t.monomial, id) < 0; });
    }
    [[nodiscard]] bool is_divided(const Series& series, GeneratorId id) const {
        return is_divided(series.total(series.through()), id);
    }
    [[nodiscard]] bool stands_in_a_rate(GeneratorId id) const {
        const auto one = [&](const Polynomial& p) { return is_divided(p, id); };
        const auto series = [&](const Series& s) { return is_divided(s, id); };
        const auto mode = [&](const FlowMode& m) { return is_divided(m.rate, id); };
        return std::any_of(flow_.phases.begin(), flow_.phases.end(), one) ||
               std::any_of(flow_.decays.begin(), flow_.decays.end(), one) ||
               std::any_of(flow_.modes.begin(), flow_.modes.end(), mode) ||
               std::any_of(flow_.angles.begin(), flow_.angles.end(), mode) ||
               std::any_of(flow_.slow.begin(), flow_.slow.end(), series) ||
               std::any_of(flow_.drift.begin(), flow_.drift.end(), series);
    }
    [[nodiscard]] bool stands_under_a_root(GeneratorId id) const {
        for (GeneratorId other = 0; other < ring_.size(); ++other)
            if (ring_.generator(other).kind == GeneratorKind::root &&
                is_divided(ring_.generator(other).radicand, id))
                return true;
        return false;
    }

    const SlowFlow& flow_;
    const Normalization& normalization_;
    const GradedField& field_;
    const Ring& ring_;
};

// D^2 + rho^2
Graph::Node raised_square(Graph& graph, Graph::Node now, Graph::Node start) {
    const Graph::Node least = graph.rational(cln::expt(Rational(2), -180));
    return graph.add({graph.power(now, 2), graph.multiply({least, graph.power(start, 2)})});
}

// eps^{2(N + 1)} |D|^{2(p + 1)} - 10^6 e^{2 chi} |D_0|^{2(p + 1)}
Graph::Node gone(Program& program, int order, int power, Graph::Node square, Graph::Node square_at_start,
                 const std::vector<int>& product, std::size_t first_decay) {
    Graph& graph = program.graph;
    std::vector<Graph::Node> left{graph.rational(-1'000'000), graph.power(square_at_start, power + 1)};
    for (std::size_t k = 0; k < product.size(); ++k)
        if (product[k] != 0)
            left.push_back(graph.power(program.phases[first_decay + k].exponential, 2 * product[k]));
    return graph.add(
        {graph.multiply({graph.power(program.eps, 2 * (order + 1)), graph.power(square, power + 1)}),
         graph.multiply(left)});
}

} // namespace

std::vector<FadingDivisor> fading_divisors(const Solution& solution) {
    return solution.flow ? Fading(solution).all() : std::vector<FadingDivisor>();
}

bool fades(const std::vector<FadingDivisor>& fading, GeneratorId generator) {
    return std::any_of(fading.begin(), fading.end(),
                       [&](const FadingDivisor& divisor) { return divisor.generator == generator; });
}

Graph::Node inverse_of(Graph& graph, Graph::Node now, Graph::Node start) {
    return graph.multiply({now, graph.power(raised_square(graph, now, start), -1)});
}

void add_fading(Program& program, const Solution& solution, const Surroundings& surroundings,
                const FadingDivisor& fading, const std::function<Graph::Node(const Polynomial&)>& start,
                const std::function<Graph::Node(const Polynomial&)>& now) {
    Graph& graph = program.graph;
    const Ring& ring = *solution.normalization->normal_form.field->ring;
    const Polynomial& divisor = fading.moving.divisor; // real, as a radicand is
    const Graph::Node moves = now(divisor), begins = start(divisor);
    std::vector<Graph::Node> clear = margins_of(graph, ring, fading.moving, surroundings, now);
    clear.push_back(graph.multiply({begins, moves}));
    const std::size_t first_decay = solution.flow->phases.size();
    for (const std::vector<int>& product : fading.products) {
        const auto decay = static_cast<std::size_t>(
            std::find_if(product.begin(), product.end(), [](int times) { return times != 0; }) -
            product.begin());
        const Graph::Node harmless =
            gone(program, solution.order, fading.power, raised_square(graph, moves, begins),
                 graph.power(begins, 2), product, first_decay);
        for (const Graph::Node margin : clear)
            program.phases[first_decay + decay].precision.push_back({margin, harmless});
    }
}

} // namespace resonform
