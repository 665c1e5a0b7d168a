// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/stability/lost_digits.hpp"

#include "verify/evaluate/interpreter.hpp"
#include "verify/stability/slopes.hpp"
#include "verify/stability/spelled.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>

namespace resonform {

namespace {

constexpr double rounding = 0x1p-53;
constexpr double most_of_error = 0.5; // passes through what is told
constexpr double nearly_as_much = 0.8;
constexpr std::size_t listed_operands = 3;

template <class Real>
std::vector<Real> trace(const std::shared_ptr<const Interpretation>& shared, const SweepPoint& at, double end,
                        double t) {
    const Interpreter<Real> evaluator(shared, Real(at.eps), {at.parameters.begin(), at.parameters.end()},
                                      {at.start.begin(), at.start.end()}, Real(end));
    std::vector<Real> nodes;
    evaluator.trace(Real(t), nodes);
    return nodes;
}

// The nodes of one call in both arithmetics, and what they do to an output.
class TwoWalks {
public:
    TwoWalks(const Program& program, std::vector<double> rounded, std::vector<Wide> exact, Graph::Node output,
             const Wide& unit)
        : program_(program), rounded_(std::move(rounded)), exact_(std::move(exact)),
          slopes_(slopes_of_output(program.graph, output, exact_)), unit_(unit) {
        for (const ProgramPhase& phase : program.phases)
            if (!phase.decays()) turning_.insert({phase.cosine, phase.sine});
    }

    [[nodiscard]] bool is_behind(Graph::Node n) const { return slopes_[index(n)] != 0; }
    [[nodiscard]] const Wide& exact(Graph::Node n) const { return exact_[index(n)]; }
    // What its error makes of the output's, in units.
    [[nodiscard]] double passed(Graph::Node n) const { return in_units(error(n), n); }
    // What a relative error of the operands, or a rounding, would make of it.
    [[nodiscard]] double passed_at_best(Graph::Node n) const {
        return in_units(size(n) * error_of_operands(n), n);
    }
    // The growth of the relative error.
    [[nodiscard]] double growth(Graph::Node n) const {
        const Wide fair = size(n) * error_of_operands(n);
        return fair > 0 ? static_cast<double>(Wide(error(n) / fair))
                        : std::numeric_limits<double>::infinity();
    }

private:
    static std::size_t index(Graph::Node n) { return static_cast<std::size_t>(n); }
    [[nodiscard]] Wide error(Graph::Node n) const { return abs(Wide(Wide(rounded_[index(n)]) - exact(n))); }
    // Cosines and sines are as large as 1.
    [[nodiscard]] Wide size(Graph::Node n) const {
        return turning_.count(n) > 0 ? Wide(1) : Wide(abs(exact(n)));
    }
    [[nodiscard]] double in_units(const Wide& change, Graph::Node n) const {
        const Wide passed = abs(slopes_[index(n)]) * change / unit_;
        return isfinite(passed) ? static_cast<double>(passed) : 0;
    }
    [[nodiscard]] double error_of_operands(Graph::Node n) const {
        double most = rounding;
        for (const Graph::Node operand : program_.graph.at(n).operands) {
            const Wide whole = size(operand);
            const double relative = whole > 0 ? static_cast<double>(Wide(error(operand) / whole)) : 0;
            if (std::isfinite(relative)) most = std::max(most, relative);
        }
        return most;
    }

    const Program& program_;
    std::vector<double> rounded_;
    std::vector<Wide> exact_, slopes_;
    Wide unit_;
    std::set<Graph::Node> turning_;
};

// -1: none.
Graph::Node loser(const TwoWalks& walks, Graph::Node output) {
    std::vector<double> lost(static_cast<std::size_t>(output) + 1, 0.0);
    for (Graph::Node n = 0; n <= output; ++n)
        if (walks.is_behind(n)) lost[static_cast<std::size_t>(n)] = walks.passed(n) - walks.passed_at_best(n);
    const double most = *std::max_element(lost.begin(), lost.end());
    if (!(most >= most_of_error * walks.passed(output))) return -1;
    const auto first =
        std::find_if(lost.begin(), lost.end(), [&](double l) { return l >= nearly_as_much * most; });
    return static_cast<Graph::Node>(first - lost.begin());
}

LostDigits told_of(const Program& program, const TwoWalks& walks, Graph::Node n, Graph::Node output) {
    const Graph::Entry& e = program.graph.at(n);
    LostDigits lost{spelled(program, n),
                    static_cast<double>(walks.exact(n)),
                    {},
                    1,
                    walks.growth(n),
                    walks.passed(n) / walks.passed(output),
                    walks.passed(output)};
    std::vector<Graph::Node> operands = e.operands;
    std::stable_sort(operands.begin(), operands.end(),
                     [&](Graph::Node a, Graph::Node b) { return abs(walks.exact(a)) > abs(walks.exact(b)); });
    if (e.op == Graph::Op::add && walks.exact(n) != 0)
        lost.cancellation = static_cast<double>(abs(Wide(walks.exact(operands.front()) / walks.exact(n))));
    operands.resize(std::min(operands.size(), listed_operands));
    for (const Graph::Node operand : operands)
        lost.operands.push_back({spelled(program, operand), static_cast<double>(walks.exact(operand))});
    return lost;
}

} // namespace

std::optional<LostDigits> DigitTracer::operator()(const SweepPoint& at, double end, double t,
                                                  std::size_t output, double unit) const {
    const Program& program = *shared_->program;
    std::vector<double> rounded = trace<double>(shared_, at, end, t);
    if (rounded.empty() || !(unit > 0)) return std::nullopt;
    std::vector<Wide> exact = trace<Wide>(shared_, at, end, t);
    if (exact.empty()) return std::nullopt;
    const Graph::Node root = program.outputs[output].value;
    const TwoWalks walks(program, std::move(rounded), std::move(exact), root, Wide(unit));
    if (!(walks.passed(root) > most_of_error)) return std::nullopt;
    const Graph::Node n = loser(walks, root);
    if (n < 0) return std::nullopt;
    return told_of(program, walks, n, root);
}

} // namespace resonform
