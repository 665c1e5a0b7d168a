// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/first_correction.hpp"

#include "solve/near_identity.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

namespace resonform {

namespace {

constexpr int highest_derivative = 4; // in the Taylor expansion about zeta

class Corrections {
public:
    explicit Corrections(const Solution& solution)
        : solution_(solution), field_(*solution.normalization->normal_form.field), ring_(*field_.ring) {}

    // nullopt: the map adds no term of degree 2 or more in the modes.
    [[nodiscard]] std::optional<FirstCorrection> of_mode(std::size_t mode) const {
        const std::vector<Found> found = first(solution_.normalization->map.mode[mode], 2);
        if (found.empty()) return std::nullopt;
        FirstCorrection result{name_of(field_.modes[mode]), modes_in(found, mode), {}, {{}}, {}, {}, false};
        int lightest = weight(mode);
        for (const std::size_t k : result.modes) lightest = std::min(lightest, weight(k));
        for (const std::size_t k : result.modes) result.powers_of_eps.push_back(weight(k) - lightest);
        std::vector<FirstCorrection::Term>& terms = result.sums.front();
        for (const Found& f : found) terms.push_back(term(f, result.modes, -lightest));
        if (result.modes.size() == 1)
            for (FirstCorrection::Term& t : terms) --t.powers.front();
        return result;
    }

    // nullopt: nothing is forced, or what is forced is superposed on the rest.
    [[nodiscard]] std::optional<FirstCorrection> of_forcing(std::size_t mode) const {
        if (!feels_forcing_) return std::nullopt;
        FirstCorrection result{name_of(field_.modes[mode]), {mode}, {0}, {{}}, {}, {}, true};
        for (const Found& f : first(solution_.normalization->map.mode[mode], 0)) {
            if (std::any_of(f.degrees.begin(), f.degrees.end(), [](int degree) { return degree != 0; }))
                continue;
            FirstCorrection::Term added = term(f, result.modes, -weight(mode));
            added.coefficient = Rational(1) / 4 * added.coefficient;
            result.sums.front().push_back(std::move(added));
        }
        if (result.sums.front().empty()) return std::nullopt;
        return result;
    }

    // 2 |m| < 1; nullopt: the map does not change the angle, m = 0.
    [[nodiscard]] std::optional<FirstCorrection> of_angle(std::size_t angle) const {
        std::vector<std::vector<Found>> shifts{first(solution_.normalization->map.angle[angle], 0)};
        if (shifts.front().empty()) return std::nullopt;
        return compared(name_of(field_.angles[angle]), ring_.one(), shifts);
    }

    // nullopt: the map does not change p, or a derivative of p is not known.
    [[nodiscard]] std::optional<FirstCorrection> of_quantity(const std::string& name,
                                                             const Polynomial& p) const {
        std::vector<GeneratorId> moving;
        std::vector<std::vector<Found>> shifts;
        for (std::size_t j = 0; j < field_.slow.size(); ++j) {
            const GeneratorId id = field_.slow[j].generator;
            if (!field_.slow[j].driven) continue;
            if (!ring_.derivative_known(p, id)) return std::nullopt;
            std::vector<Found> found = first(solution_.normalization->map.slow[j], 0);
            if (found.empty() || ring_.derivative(p, id).empty()) continue;
            moving.push_back(id);
            shifts.push_back(std::move(found));
        }
        if (moving.empty()) return std::nullopt;
        FirstCorrection result = compared(name, p, shifts);
        std::vector<int> powers(moving.size(), 0);
        add_slopes(p, moving, 0, powers, highest_derivative, result.slopes);
        return result;
    }

    // Radicands and denominators of the equations, and slow variables declared positive or nonzero.
    [[nodiscard]] std::vector<FirstCorrection> of_quantities() const {
        std::vector<FirstCorrection> result;
        const auto add = [&](const std::string& name, const Polynomial& p) {
            const auto same = [&](const FirstCorrection& known) { return known.quantity == p; };
            if (std::any_of(result.begin(), result.end(), same)) return;
            if (auto correction = of_quantity(name, p)) result.push_back(std::move(*correction));
        };
        for (const SlowVariable& slow : field_.slow) {
            const Variable& variable = field_.system().variables[slow.variable];
            if (variable.positive || variable.nonzero) add(variable.name, ring_.gen(slow.generator));
        }
        const std::vector<GeneratorId>& divisors = field_.coefficients->divisors();
        for (GeneratorId id = 0; id < ring_.size(); ++id)
            if (ring_.generator(id).kind == GeneratorKind::root &&
                std::find(divisors.begin(), divisors.end(), id) == divisors.end())
                add("", ring_.generator(id).radicand);
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

    template <class Part> [[nodiscard]] const std::string& name_of(const Part& part) const {
        return field_.system().variables[part.variable].name;
    }

    [[nodiscard]] std::vector<std::size_t> modes_in(const std::vector<Found>& found,
                                                    std::optional<std::size_t> itself) const {
        std::vector<std::size_t> modes;
        for (std::size_t k = 0; k < field_.modes.size(); ++k)
            if (k == itself ||
                std::any_of(found.begin(), found.end(), [&](const Found& f) { return f.degrees[k] != 0; }))
                modes.push_back(k);
        return modes;
    }

    [[nodiscard]] FirstCorrection::Term term(const Found& f, const std::vector<std::size_t>& modes,
                                             int power_of_eps) const {
        FirstCorrection::Term term{{}, f.power_of_eps + power_of_eps, lifted(f.coefficient)};
        for (const std::size_t k : modes) {
            term.powers.push_back(f.degrees[k]);
            term.power_of_eps += f.degrees[k] * weight(k);
        }
        return term;
    }

    [[nodiscard]] FirstCorrection compared(const std::string& name, const Polynomial& quantity,
                                           const std::vector<std::vector<Found>>& shifts) const {
        std::vector<Found> all;
        for (const std::vector<Found>& found : shifts) all.insert(all.end(), found.begin(), found.end());
        FirstCorrection result{name, modes_in(all, std::nullopt), {}, {}, quantity, {}, false};
        for (const std::vector<Found>& found : shifts) {
            result.sums.emplace_back();
            for (const Found& f : found) result.sums.back().push_back(term(f, result.modes, 0));
        }
        return result;
    }

    // Taylor coefficients of p in the variables from `first_moving` on, up to a total degree `left`.
    void add_slopes(const Polynomial& p, const std::vector<GeneratorId>& moving, std::size_t first_moving,
                    std::vector<int>& powers, int left, std::vector<FirstCorrection::Slope>& slopes) const {
        for (std::size_t j = first_moving; j < moving.size() && left > 0; ++j) {
            if (!ring_.derivative_known(p, moving[j])) continue;
            const Polynomial slope = (Rational(1) / ++powers[j]) * ring_.derivative(p, moving[j]);
            if (!slope.empty()) {
                slopes.push_back({powers, slope});
                add_slopes(slope, moving, j, powers, left - 1, slopes);
            }
            --powers[j];
        }
    }

    [[nodiscard]] std::vector<Found> first(const Series& added, int least_degree) const {
        const bool of_modes = least_degree > 0;
        std::map<std::vector<int>, int> first_weight; // by degree, or by product of modes
        std::optional<int> lowest;                    // of all
        std::vector<Found> found;
        for (int n = 0; n <= std::min(added.through(), solution_.truncation); ++n)
            for (const auto& [monomial, coefficient] : ring_.collect(added.part(n), field_.outer())) {
                Found f{degrees(monomial), ring_.exponent(monomial, field_.eps), coefficient};
                const int degree = std::accumulate(f.degrees.begin(), f.degrees.end(), 0);
                if (degree < least_degree) continue;
                if (!lowest) lowest = n;
                if (first_weight.emplace(of_modes ? std::vector{degree} : f.degrees, n).first->second == n &&
                    (degree <= 3 || n == lowest))
                    found.push_back(std::move(f));
            }
        return found;
    }

    const Solution& solution_;
    const GradedField& field_;
    const Ring& ring_;
    bool feels_forcing_ = feels_what_is_forced(*field_.first_order);
};

} // namespace

std::vector<Polynomial> FirstCorrection::polynomials() const {
    std::vector<Polynomial> all;
    for (const std::vector<Term>& terms : sums)
        for (const Term& term : terms) all.push_back(term.coefficient);
    for (const Slope& slope : slopes) all.push_back(slope.coefficient);
    if (quantity) all.push_back(*quantity);
    return all;
}

std::vector<FirstCorrection> first_corrections(const Solution& solution) {
    const Corrections corrections(solution);
    std::vector<FirstCorrection> result;
    for (std::size_t k = 0; k < solution.normalization->normal_form.field->modes.size(); ++k)
        for (auto& correction : {corrections.of_mode(k), corrections.of_forcing(k)})
            if (correction) result.push_back(*correction);
    if (solution.flow) {
        for (std::size_t k = 0; k < solution.normalization->normal_form.field->angles.size(); ++k)
            if (auto correction = corrections.of_angle(k)) result.push_back(std::move(*correction));
        for (FirstCorrection& correction : corrections.of_quantities())
            result.push_back(std::move(correction));
    }
    for (const ModeSolution& mode : solution.modes)
        if (Polynomial rest = mode.factor.total(solution.truncation) - solution.ring->one(); !rest.empty())
            result.push_back({solution.system().variables[mode.variable].name,
                              {0},
                              {0},
                              {{{{0}, 0, std::move(rest)}}},
                              {},
                              {}});
    return result;
}

std::vector<FirstCorrection> transient_corrections(const Solution& solution) {
    const std::vector<Mode>& modes = solution.normalization->normal_form.field->modes;
    std::vector<FirstCorrection> result;
    for (FirstCorrection& correction : first_corrections(solution))
        if (!correction.quantity && !correction.forced &&
            std::any_of(correction.modes.begin(), correction.modes.end(),
                        [&](std::size_t k) { return modes[k].is_damped(); }))
            result.push_back(std::move(correction));
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
           std::any_of(correction.sums.front().begin(), correction.sums.front().end(),
                       [&](const FirstCorrection::Term& term) { return needs(term.coefficient, needs); });
}

} // namespace resonform
