// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/bound.hpp"

#include "algebra/number/modular.hpp"
#include "certify/hamiltonian.hpp"
#include "certify/inner_product.hpp"
#include "certify/points/readings.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace resonform {

namespace {

double bits_of(const Integer& n) { return static_cast<double>(cln::integer_length(cln::abs(n))) + 1; }

// The larger of two sizes, over the common denominator of both.
Size together(const Size& a, const Size& b) {
    return {std::max(a.degree + b.denominator, b.degree + a.denominator), a.denominator + b.denominator,
            a.bits + b.bits + 1};
}

// Runs a program with sizes instead of residues.
class SizeRun {
public:
    SizeRun(Surveyor& surveys, int through)
        : surveys_(surveys), ring_(surveys.ring()), through_(through), length_bits_(std::log2(through + 1)) {}

    // By slot; nullopt: zero, or not needed.
    [[nodiscard]] std::vector<std::optional<Size>>
    run(const CertificatePlan& plan, const NormalForm& normal_form, const NearIdentityMap& map) const {
        const std::vector<Instruction>& steps = plan.program.steps();
        std::vector<std::optional<Size>> sizes(steps.size());
        SeriesName name{};
        const Survey* survey = nullptr; // the series `name`: neighbouring steps often read the same one
        for (std::size_t k = 0; k < steps.size(); ++k) {
            if (!plan.needed[k]) continue;
            const Instruction& step = steps[k];
            if (step.operation != Operation::value && step.operation != Operation::slope) {
                sizes[k] = size_of(step, sizes);
                continue;
            }
            if (survey == nullptr || name != step.series) {
                name = step.series;
                survey = &surveys_(series_of(name, plan.program, normal_form, map));
            }
            if (step.operation == Operation::slope)
                sizes[k] = slope(*survey, step.index);
            else if (!survey->is_empty())
                sizes[k] = survey->size;
        }
        return sizes;
    }

    // g ds/dg / g
    [[nodiscard]] std::optional<Size> slope(const Survey& survey, GeneratorId by) const {
        if (survey.is_empty() || survey.exponent(by) == 0) return std::nullopt;
        Size slope = survey.size;
        slope.degree += surveys_.generator(by).denominator;
        slope.denominator += surveys_.generator(by).degree;
        slope.bits += std::bit_width(static_cast<unsigned>(survey.exponent(by)));
        return slope;
    }

    // 1 and -1 cost nothing: how many of them stand in an equation is up to the expression library.
    [[nodiscard]] Size number(const Rational& value) const {
        if (cln::abs(value) == 1) return {};
        return {0, 0, bits_of(cln::numerator(value)) + bits_of(cln::denominator(value))};
    }
    [[nodiscard]] Size generator(GeneratorId id, int power) const {
        const double degree = surveys_.generator(id).degree * std::abs(power);
        const double denominator = surveys_.generator(id).denominator * std::abs(power);
        // 2 t and 1 + t^2, 1 - t^2 have coefficients that add up to 2
        const double bits = surveys_.is_circle(id) ? std::abs(power) : 0;
        return power < 0 ? Size{denominator, degree, bits} : Size{degree, denominator, bits};
    }
    [[nodiscard]] Size multiply(const Size& a, const Size& b) const {
        if (is_unit_number(a)) return b;
        if (is_unit_number(b)) return a;
        return {a.degree + b.degree, a.denominator + b.denominator, a.bits + b.bits + length_bits_};
    }
    [[nodiscard]] Size function(Function function, const Size& u) const {
        const Size sum = taylor(u, 4 * through_ * std::log2(2 * through_ + 2));
        if (function != Function::tangent && function != Function::hyperbolic_tangent) return sum;
        return multiply(sum, inverse_power(sum, 1));
    }
    // (a/a_0 - 1)^k has the numerator of a_0 below.
    [[nodiscard]] Size power(const Size& a, const Rational& exponent, const Size& lead) const {
        const double numbers = bits_of(cln::numerator(exponent)) + bits_of(cln::denominator(exponent));
        return multiply(lead, taylor({a.degree, a.degree, a.bits}, 2 * through_ * (numbers + length_bits_)));
    }
    [[nodiscard]] Size inverse_power(const Size& a, int n) const {
        return power(a, -n, {n * a.denominator, n * a.degree, n * a.bits});
    }
    // K of the header, and log2 |P|_1 / k at its largest.
    [[nodiscard]] double field_degree() const {
        double degree = 2;
        for (GeneratorId id = 0; id < ring_.size(); ++id)
            if (ring_.generator(id).kind == GeneratorKind::root) degree *= ring_.generator(id).index;
        return degree;
    }
    [[nodiscard]] double radicand_bits() const {
        double bits = 0;
        for (GeneratorId id = 0; id < ring_.size(); ++id)
            bits = std::max(bits, surveys_.generator(id).radicand_bits);
        return bits;
    }

private:
    [[nodiscard]] static bool is_unit_number(const Size& a) {
        return a.degree == 0 && a.denominator == 0 && a.bits == 0;
    }
    // nullopt: zero.
    [[nodiscard]] std::optional<Size> size_of(const Instruction& step,
                                              const std::vector<std::optional<Size>>& sizes) const {
        const auto operand = [&](Slot slot) -> const std::optional<Size>& {
            return sizes[static_cast<std::size_t>(slot)];
        };
        switch (step.operation) {
        case Operation::number: return number(step.number);
        case Operation::generator: return generator(step.index, step.power);
        default: break;
        }
        const auto& left = operand(step.left);
        const Size some = left.value_or(Size{});
        switch (step.operation) {
        case Operation::add: {
            const auto& right = operand(step.right);
            if (!left || !right) return left ? left : right;
            return together(*left, *right);
        }
        case Operation::multiply: {
            const auto& right = operand(step.right);
            return left && right ? std::optional(multiply(*left, *right)) : std::nullopt;
        }
        case Operation::integral: {
            Size product = multiply(some, operand(step.right).value_or(Size{}));
            product.bits += 2 * through_ + length_bits_; // 1/n, and the least common multiple of all n
            return product;
        }
        case Operation::function: return function(static_cast<Function>(step.index), some);
        case Operation::power: return power(some, step.number, operand(step.right).value_or(Size{}));
        case Operation::inverse_power: return inverse_power(some, step.index);
        default: return left; // at_origin
        }
    }
    // sum_{k <= M} c_k u^k over the common denominator Q^M and `numbers` bits for those of the c_k.
    [[nodiscard]] Size taylor(const Size& u, double numbers) const {
        const double m = through_;
        return {m * std::max(u.degree, u.denominator), m * u.denominator,
                m * (u.bits + length_bits_) + numbers + length_bits_};
    }

    Surveyor& surveys_;
    const Ring& ring_;
    int through_;
    double length_bits_; // of the number of weights
};

// Degree and height of the comparison in lie.hpp. With {w_a, chi} = P/Q, Q free of w, the k-th iterate of the
// Lie series is a polynomial over Q^k, whose degree grows by that of P and whose norm by that of P, times the
// degree, for each of the 2n coordinates.
Size size_of_flow(const SizeRun& run, Surveyor& surveys, const NormalForm& normal_form) {
    const HamiltonianForm& form = *normal_form.hamiltonian;
    Size brackets, slopes;
    for (const HamiltonianForm::Bracket& b : form.brackets)
        brackets = together(brackets, surveys.size_of(b.value));
    const Survey& generator = surveys(form.generator);
    for (GeneratorId id = 0; id < surveys.ring().size(); ++id)
        if (const auto slope = run.slope(generator, id)) slopes = together(slopes, *slope);
    const Size vector = run.multiply(brackets, slopes);
    const double coordinates = 2 * static_cast<double>(form.brackets.size());
    const double orders = normal_form.through;
    const double degree = orders * std::max(vector.degree, vector.denominator) + 1;
    return {degree, orders * vector.denominator,
            orders * (vector.bits + std::log2(coordinates * degree) + std::log2(orders + 1)) +
                std::log2(orders + 1)};
}

} // namespace

double point_error_bound(const CertificatePlan& plan, const NormalForm& normal_form,
                         const NearIdentityMap& map, Surveyor& surveys) {
    const GradedField& field = *normal_form.field;
    const SizeRun run(surveys, normal_form.through + (normal_form.hamiltonian ? weight_of_modes(field) : 0));
    const std::vector<std::optional<Size>> sizes = run.run(plan, normal_form, map);
    double degree = 0, bits = 0;
    const auto include = [&](const Size& s) {
        degree = std::max(degree, s.degree);
        bits = std::max(bits, s.bits);
    };
    for (const VanishingCheck& check : plan.checks)
        if (const auto& size = sizes[static_cast<std::size_t>(check.slot)]) include(*size);
    if (normal_form.hamiltonian) {
        const Size flow = size_of_flow(run, surveys, normal_form);
        for (const CertificatePlan::Coordinate& c : plan.coordinates)
            include(together(sizes[static_cast<std::size_t>(c.mapped)].value_or(Size{}), flow));
    }

    bits += inner_product_bits(normal_form, map);
    const double k = run.field_degree();
    const double norm_bits = k * (bits + degree * run.radicand_bits());
    return 2 * k * (k * degree / std::pow(2.0, 60) + norm_bits / 60 / primes_to_choose_from);
}

} // namespace resonform
