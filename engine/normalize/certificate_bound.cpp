// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/certificate_bound.hpp"

#include "algebra/fractions.hpp"
#include "algebra/modular.hpp"
#include "normalize/certificate_hamiltonian.hpp"
#include "normalize/certificate_inner_product.hpp"
#include "normalize/certificate_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>

namespace resonform {

namespace {

double bits_of(const Integer& n) { return static_cast<double>(cln::integer_length(cln::abs(n))) + 1; }

// A t-series s: with one polynomial Q of degree <= denominator, all Q s_n are polynomials of degree
// <= degree, and the sum of the sizes of the integer coefficients of each Q s_n, and of Q, is <= 2^bits.
struct Size {
    double degree = 0, denominator = 0, bits = 0;
};

// The largest of some sizes, over the common denominator of all.
Size together(const std::vector<Size>& sizes) {
    Size all = sizes.front();
    for (std::size_t k = 1; k < sizes.size(); ++k) {
        const Size& s = sizes[k];
        all.degree = std::max(all.degree + s.denominator, s.degree + all.denominator);
        all.denominator += s.denominator;
        all.bits += s.bits + 1;
    }
    return all;
}

// Runs a program with sizes instead of residues.
class SizeRun {
public:
    struct Gradient {
        Size value;
        std::vector<int> exponents; // by generator: the largest absolute value, 0 where it does not occur
    };

    SizeRun(const Ring& ring, int through) : ring_(ring), through_(through) {
        for (GeneratorId id = 0; id < ring.size(); ++id) {
            const Generator& g = ring.generator(id);
            double degree = g.kind == GeneratorKind::imaginary ? 0 : 1;
            double denominator = 0;
            if (g.kind == GeneratorKind::root) {
                const Size radicand = size_of(g.radicand);
                degree = std::max(1.0, std::ceil(radicand.degree / g.index)) + radicand.denominator;
                denominator = radicand.denominator;
            }
            if (is_circle(g)) degree = denominator = 2;
            degrees_.push_back(degree);
            denominators_.push_back(denominator);
        }
    }

    // By slot; nullopt: zero, or not needed.
    [[nodiscard]] std::vector<std::optional<Size>>
    run(const CertificatePlan& plan, const NormalForm& normal_form, const NearIdentityMap& map) const {
        std::map<SeriesName, std::optional<Gradient>> read;
        const auto gradient = [&](SeriesName name) -> const std::optional<Gradient>& {
            const auto [known, is_new] = read.try_emplace(name);
            if (is_new) known->second = gradient_of(series_of(name, plan.program, normal_form, map));
            return known->second;
        };
        const std::vector<Step>& steps = plan.program.steps();
        std::vector<std::optional<Size>> sizes(steps.size());
        for (std::size_t k = 0; k < steps.size(); ++k) {
            if (!plan.needed[k]) continue;
            const Step& step = steps[k];
            if (step.operation == Operation::value) {
                if (const auto& g = gradient(step.series)) sizes[k] = g->value;
            } else if (step.operation == Operation::slope) {
                if (const auto& g = gradient(step.series)) sizes[k] = slope(*g, step.index);
            } else {
                sizes[k] = size_of(step, sizes);
            }
        }
        return sizes;
    }

    // Of a polynomial over the common denominator of its numbers and the lowest power of each generator. Its
    // norm is at most denominator + size * (largest numerator). nullopt: zero.
    [[nodiscard]] std::optional<Gradient> gradient_of(const Series& s) const {
        std::vector<int> lowest(degrees_.size(), 0), highest(degrees_.size(), 0);
        double degree = -1e300; // before denominators are cleared
        double own = 0;         // and that of the denominators of generators themselves
        std::size_t terms = 0;
        mpz_class denominator = 1;
        ExponentReader exponents(ring_);
        std::array<double, 5> degrees{}, own_degrees{}; // of the first words of a monomial
        for (int n = 0; n <= std::min(through_, s.through()); ++n) {
            const Fractions& part = s.part(n).fractions();
            if (part.size() == 0) continue;
            terms += part.size();
            mpz_lcm(denominator.get_mpz_t(), denominator.get_mpz_t(), part.denominator.get_mpz_t());
            for (const Monomial& m : part.monomials) {
                for (int word = exponents.read(m); word < exponents.words(); ++word) {
                    const auto w = static_cast<std::size_t>(word);
                    degrees[w + 1] = degrees[w];
                    own_degrees[w + 1] = own_degrees[w];
                    for (const auto& [generator, e] : exponents.powers(word)) {
                        const auto id = static_cast<std::size_t>(generator);
                        lowest[id] = std::min(lowest[id], e);
                        highest[id] = std::max(highest[id], e);
                        degrees[w + 1] += degrees_[id] * e;
                        own_degrees[w + 1] += denominators_[id] * std::abs(e);
                    }
                }
                const auto last = static_cast<std::size_t>(exponents.words());
                degree = std::max(degree, degrees[last]);
                own = std::max(own, own_degrees[last]);
            }
        }
        if (terms == 0) return std::nullopt;
        Gradient result;
        Size& size = result.value;
        for (std::size_t id = 0; id < degrees_.size(); ++id) {
            size.denominator -= degrees_[id] * lowest[id];
            result.exponents.push_back(std::max(-lowest[id], highest[id]));
        }
        size.denominator += own;
        size.degree = size.denominator + std::max(degree, 0.0);
        const auto denominator_bits = static_cast<double>(mpz_sizeinbase(denominator.get_mpz_t(), 2));
        double numerator_bits = 0; // over the common denominator
        for (int n = 0; n <= std::min(through_, s.through()); ++n) {
            const Fractions& part = s.part(n).fractions();
            if (part.size() == 0) continue;
            const auto own_bits = static_cast<double>(mpz_sizeinbase(part.denominator.get_mpz_t(), 2));
            numerator_bits =
                std::max(numerator_bits, static_cast<double>(part.bits()) + denominator_bits - own_bits + 1);
        }
        numerator_bits += std::log2(static_cast<double>(terms + 1));
        size.bits = 1 + std::max(denominator_bits, numerator_bits) + own;
        return result;
    }

    // g ds/dg / g
    [[nodiscard]] std::optional<Size> slope(const Gradient& gradient, GeneratorId by) const {
        const auto id = static_cast<std::size_t>(by);
        if (gradient.exponents[id] == 0) return std::nullopt;
        Size slope = gradient.value;
        slope.degree += denominators_[id];
        slope.denominator += degrees_[id];
        slope.bits += std::log2(gradient.exponents[id]);
        return slope;
    }

    // 1 and -1 cost nothing: how many of them stand in an equation is up to the expression library.
    [[nodiscard]] Size number(const Rational& value) const {
        if (cln::abs(value) == 1) return {};
        return {0, 0, bits_of(cln::numerator(value)) + bits_of(cln::denominator(value))};
    }
    [[nodiscard]] Size generator(GeneratorId id, int power) const {
        const auto k = static_cast<std::size_t>(id);
        const double degree = degrees_[k] * std::abs(power), denominator = denominators_[k] * std::abs(power);
        // 2 t and 1 + t^2, 1 - t^2 have coefficients that add up to 2
        const double bits = is_circle(ring_.generator(id)) ? std::abs(power) : 0;
        return power < 0 ? Size{denominator, degree, bits} : Size{degree, denominator, bits};
    }
    [[nodiscard]] Size multiply(const Size& a, const Size& b) const {
        if (is_unit_number(a)) return b;
        if (is_unit_number(b)) return a;
        return {a.degree + b.degree, a.denominator + b.denominator,
                a.bits + b.bits + std::log2(through_ + 1)};
    }
    [[nodiscard]] Size function(Elementary function, const Size& u) const {
        const Size sum = taylor(u, 4 * through_ * std::log2(2 * through_ + 2));
        if (function != Elementary::tangent && function != Elementary::hyperbolic_tangent) return sum;
        return multiply(sum, inverse_power(sum, 1));
    }
    // (a/a_0 - 1)^k has the numerator of a_0 below.
    [[nodiscard]] Size power(const Size& a, const Rational& exponent, const Size& lead) const {
        const double numbers = bits_of(cln::numerator(exponent)) + bits_of(cln::denominator(exponent));
        return multiply(
            lead, taylor({a.degree, a.degree, a.bits}, 2 * through_ * (numbers + std::log2(through_ + 1))));
    }
    [[nodiscard]] Size inverse_power(const Size& a, int n) const {
        return power(a, -n, {n * a.denominator, n * a.degree, n * a.bits});
    }
    [[nodiscard]] Size size_of(const Polynomial& p) const {
        const auto g = gradient_of(Series({p}));
        return g ? g->value : Size{};
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
        for (GeneratorId id = 0; id < ring_.size(); ++id) {
            const Generator& g = ring_.generator(id);
            if (g.kind == GeneratorKind::root) bits = std::max(bits, size_of(g.radicand).bits / g.index);
        }
        return bits;
    }

private:
    [[nodiscard]] static bool is_circle(const Generator& g) {
        return g.kind == GeneratorKind::function &&
               (g.of.function == Function::sine || g.of.function == Function::cosine);
    }
    [[nodiscard]] static bool is_unit_number(const Size& a) {
        return a.degree == 0 && a.denominator == 0 && a.bits == 0;
    }
    // nullopt: zero.
    [[nodiscard]] std::optional<Size> size_of(const Step& step,
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
            return together({*left, *right});
        }
        case Operation::multiply: {
            const auto& right = operand(step.right);
            return left && right ? std::optional(multiply(*left, *right)) : std::nullopt;
        }
        case Operation::function: return function(static_cast<Elementary>(step.index), some);
        case Operation::power: return power(some, step.number, operand(step.right).value_or(Size{}));
        case Operation::inverse_power: return inverse_power(some, step.index);
        default: return left; // at_origin
        }
    }
    // sum_{k <= M} c_k u^k over the common denominator Q^M and `numbers` bits for those of the c_k.
    [[nodiscard]] Size taylor(const Size& u, double numbers) const {
        const double m = through_;
        return {m * std::max(u.degree, u.denominator), m * u.denominator,
                m * (u.bits + std::log2(m + 1)) + numbers + std::log2(m + 1)};
    }

    const Ring& ring_;
    int through_;
    std::vector<double> degrees_;      // of the numerator of each generator
    std::vector<double> denominators_; // and of its denominator: 1 + t^2 of a sine
};

// What certificate_lie.hpp compares. With {w_a, chi} = P/Q, Q free of w, the k-th iterate of the Lie series
// is a polynomial over Q^k, whose degree grows by that of P and whose norm by that of P, times the degree,
// for each of the 2n coordinates.
Size size_of_flow(const SizeRun& run, const NormalForm& normal_form) {
    const HamiltonianForm& form = *normal_form.hamiltonian;
    std::vector<Size> brackets{Size{}}, slopes{Size{}};
    for (const HamiltonianForm::Bracket& b : form.brackets) brackets.push_back(run.size_of(b.value));
    if (const auto generator = run.gradient_of(form.generator))
        for (GeneratorId id = 0; id < normal_form.field->ring->size(); ++id)
            if (const auto slope = run.slope(*generator, id)) slopes.push_back(*slope);
    const Size vector = run.multiply(together(brackets), together(slopes));
    const double coordinates = 2 * static_cast<double>(form.brackets.size());
    const double orders = normal_form.through;
    const double degree = orders * std::max(vector.degree, vector.denominator) + 1;
    return {degree, orders * vector.denominator,
            orders * (vector.bits + std::log2(coordinates * degree) + std::log2(orders + 1)) +
                std::log2(orders + 1)};
}

} // namespace

double point_error_bound(const CertificatePlan& plan, const NormalForm& normal_form,
                         const NearIdentityMap& map) {
    const GradedField& field = *normal_form.field;
    const SizeRun run(*field.ring,
                      normal_form.through + (normal_form.hamiltonian ? weight_of_modes(field) : 0));
    const std::vector<std::optional<Size>> sizes = run.run(plan, normal_form, map);
    double degree = 0, bits = 0;
    const auto include = [&](const Size& s) {
        degree = std::max(degree, s.degree);
        bits = std::max(bits, s.bits);
    };
    for (const VanishingCheck& check : plan.checks)
        if (const auto& size = sizes[static_cast<std::size_t>(check.slot)]) include(*size);
    if (normal_form.hamiltonian) {
        const Size flow = size_of_flow(run, normal_form);
        for (const CertificatePlan::Coordinate& c : plan.coordinates)
            include(together({sizes[static_cast<std::size_t>(c.mapped)].value_or(Size{}), flow}));
    }

    bits += inner_product_bits(normal_form, map);
    const double k = run.field_degree();
    const double norm_bits = k * (bits + degree * run.radicand_bits());
    return 2 * k * (k * degree / std::pow(2.0, 60) + norm_bits / 60 / primes_to_choose_from);
}

} // namespace resonform
