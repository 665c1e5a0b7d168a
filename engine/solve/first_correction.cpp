// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/first_correction.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

namespace resonform {

namespace {

class Corrections {
public:
    explicit Corrections(const Solution& solution)
        : solution_(solution), field_(*solution.normalization->normal_form.field), ring_(*field_.ring) {}

    // nullopt: nothing that has a mode in it is added to the mode.
    [[nodiscard]] std::optional<FirstCorrection> of(std::size_t mode) const {
        const std::vector<Found> found = first(solution_.normalization->map.mode[mode]);
        if (found.empty()) return std::nullopt;
        FirstCorrection result{field_.system().variables[field_.modes[mode].variable].name, {}, {}, {}};
        for (std::size_t k = 0; k < field_.modes.size(); ++k)
            if (k == mode ||
                std::any_of(found.begin(), found.end(), [&](const Found& f) { return f.degrees[k] != 0; }))
                result.modes.push_back(k);
        int lightest = weight(mode);
        for (const std::size_t k : result.modes) lightest = std::min(lightest, weight(k));
        for (const std::size_t k : result.modes) result.powers_of_eps.push_back(weight(k) - lightest);
        for (const Found& f : found) {
            FirstCorrection::Term term{{}, f.power_of_eps - lightest, lifted(f.coefficient)};
            for (const std::size_t k : result.modes) {
                term.powers.push_back(f.degrees[k] - (result.modes.size() == 1 ? 1 : 0));
                term.power_of_eps += f.degrees[k] * weight(k);
            }
            result.terms.push_back(std::move(term));
        }
        return result;
    }

private:
    struct Found {
        std::vector<int> degrees; // in each mode and its conjugate together
        int power_of_eps;
        Polynomial coefficient;
    };

    [[nodiscard]] int weight(std::size_t mode) const { return ring_.generator(field_.modes[mode].z).weight; }
    [[nodiscard]] Polynomial lifted(const Polynomial& p) const {
        return solution_.flow ? p : (*solution_.from_normal_form)(p);
    }

    [[nodiscard]] std::vector<int> degrees(const Monomial& m) const {
        std::vector<int> result;
        for (const Mode& mode : field_.modes)
            result.push_back(ring_.exponent(m, mode.z) + (mode.is_real() ? 0 : ring_.exponent(m, mode.zbar)));
        return result;
    }

    [[nodiscard]] std::vector<Found> first(const Series& added) const {
        std::map<int, int> first_weight; // of each degree
        std::optional<int> lowest;       // of all
        std::vector<Found> found;
        for (int n = 0; n <= std::min(added.through(), solution_.truncation); ++n)
            for (const auto& [monomial, coefficient] : ring_.collect(added.part(n), field_.outer())) {
                Found f{degrees(monomial), ring_.exponent(monomial, field_.eps), coefficient};
                const int degree = std::accumulate(f.degrees.begin(), f.degrees.end(), 0);
                if (degree < 2) continue; // the divisors of linear terms that move have layers of their own
                if (!lowest) lowest = n;
                if (first_weight.emplace(degree, n).first->second == n && (degree <= 3 || n == lowest))
                    found.push_back(std::move(f));
            }
        return found;
    }

    const Solution& solution_;
    const GradedField& field_;
    const Ring& ring_;
};

} // namespace

std::vector<FirstCorrection> first_corrections(const Solution& solution) {
    const Corrections corrections(solution);
    std::vector<FirstCorrection> result;
    for (std::size_t k = 0; k < solution.normalization->normal_form.field->modes.size(); ++k)
        if (auto correction = corrections.of(k)) result.push_back(std::move(*correction));
    for (const ModeSolution& mode : solution.modes)
        if (Polynomial rest = mode.factor.total(solution.truncation) - solution.ring->one(); !rest.empty())
            result.push_back(
                {solution.system().variables[mode.variable].name, {0}, {0}, {{{0}, 0, std::move(rest)}}});
    return result;
}

Polynomial leading_modulus(const Solution& solution) {
    const ModeSolution& mode = solution.modes.front();
    return solution.ring->multiply(solution.ring->gen(mode.amplitude), mode.envelope);
}

bool needs_quadratures(const Solution& solution, const FirstCorrection& correction) {
    if (solution.flow) return false;
    const auto needs = [&](const Polynomial& p, const auto& again) -> bool {
        return std::any_of(solution.primitives.begin(), solution.primitives.end(), [&](const Primitive& q) {
            const bool occurs = std::any_of(p.terms().begin(), p.terms().end(), [&](const Term& t) {
                return solution.ring->exponent(t.monomial, q.id) != 0;
            });
            return occurs && (q.kind == PrimitiveKind::quadrature || again(q.argument, again));
        });
    };
    return needs(leading_modulus(solution), needs) ||
           std::any_of(correction.terms.begin(), correction.terms.end(),
                       [&](const FirstCorrection::Term& term) { return needs(term.coefficient, needs); });
}

} // namespace resonform
