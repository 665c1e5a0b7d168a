// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/certificate_bound.hpp"

#include "algebra/fractions.hpp"
#include "algebra/modular.hpp"
#include "normalize/certificate_flow.hpp"
#include "normalize/certificate_hamiltonian.hpp"
#include "normalize/certificate_inner_product.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace resonform {

namespace {

double bits_of(const Integer& n) { return static_cast<double>(cln::integer_length(cln::abs(n))) + 1; }

// A t-series s: with one polynomial Q of degree <= denominator, all Q s_n are polynomials of degree
// <= degree, and the sum of the sizes of the integer coefficients of each Q s_n, and of Q, is <= 2^bits.
struct Size {
    double degree = 0, denominator = 0, bits = 0;
};

class SizeAlgebra {
public:
    using Value = Size;

    SizeAlgebra(const Ring& ring, int through) : ring_(ring), through_(through) {
        for (GeneratorId id = 0; id < ring.size(); ++id) {
            const Generator& g = ring.generator(id);
            double degree = g.kind == GeneratorKind::imaginary ? 0 : 1;
            double denominator = 0;
            if (g.kind == GeneratorKind::root) {
                const Size radicand = polynomial(g.radicand);
                degree = std::max(1.0, std::ceil(radicand.degree / g.index)) + radicand.denominator;
                denominator = radicand.denominator;
            }
            if (is_circle(g)) degree = denominator = 2;
            degrees_.push_back(degree);
            denominators_.push_back(denominator);
        }
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
    [[nodiscard]] Size add(const Size& a, const Size& b) const {
        return {std::max(a.degree + b.denominator, b.degree + a.denominator), a.denominator + b.denominator,
                a.bits + b.bits + 1};
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
    [[nodiscard]] Size at_origin(const Size& a) const { return a; }
    [[nodiscard]] Gradient<Size> gradient(const Series& s, Side /*side*/) const {
        std::vector<Polynomial> parts;
        for (int n = 0; n <= through_; ++n) parts.push_back(s.part(n));
        const Polynomial total = sum(parts);
        Gradient<Size> result{polynomial(total), {}};
        std::vector<int> largest(static_cast<std::size_t>(ring_.size()), 0);
        for (const Monomial& m : total.fractions().monomials)
            for (std::size_t id = 0; id < largest.size(); ++id)
                largest[id] =
                    std::max(largest[id], std::abs(ring_.exponent(m, static_cast<GeneratorId>(id))));
        for (GeneratorId id = 0; id < ring_.size(); ++id) {
            const int exponent = largest[static_cast<std::size_t>(id)];
            if (exponent == 0) continue;
            Size slope = result.value; // g ds/dg / g
            slope.degree += denominators_[static_cast<std::size_t>(id)];
            slope.denominator += degrees_[static_cast<std::size_t>(id)];
            slope.bits += std::log2(exponent);
            result.slopes.emplace_back(id, slope);
        }
        return result;
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
            if (g.kind == GeneratorKind::root) bits = std::max(bits, polynomial(g.radicand).bits / g.index);
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
    // sum_{k <= M} c_k u^k over the common denominator Q^M and `numbers` bits for those of the c_k.
    [[nodiscard]] Size taylor(const Size& u, double numbers) const {
        const double m = through_;
        return {m * std::max(u.degree, u.denominator), m * u.denominator,
                m * (u.bits + std::log2(m + 1)) + numbers + std::log2(m + 1)};
    }

    // Over the common denominator of its numbers and the lowest power of each generator. Its norm is at
    // most denominator + size * (largest numerator).
    [[nodiscard]] Size polynomial(const Polynomial& p) const {
        const Fractions& f = p.fractions();
        std::vector<int> lowest(degrees_.size(), 0);
        double highest = 0; // degree before denominators are cleared
        double own = 0;     // and that of the denominators of generators themselves
        for (const Monomial& m : f.monomials) {
            double degree = 0, denominator = 0;
            for (std::size_t id = 0; id < degrees_.size(); ++id) {
                const int e = ring_.exponent(m, static_cast<GeneratorId>(id));
                lowest[id] = std::min(lowest[id], e);
                degree += degrees_[id] * e;
                denominator += denominators_[id] * std::abs(e);
            }
            highest = std::max(highest, degree);
            own = std::max(own, denominator);
        }
        Size size;
        for (std::size_t id = 0; id < degrees_.size(); ++id) size.denominator -= degrees_[id] * lowest[id];
        size.denominator += own;
        size.degree = size.denominator + highest;
        const auto denominator_bits = static_cast<double>(mpz_sizeinbase(f.denominator.get_mpz_t(), 2));
        const auto numerator_bits =
            static_cast<double>(f.bits()) + std::log2(static_cast<double>(f.size() + 1));
        size.bits = 1 + std::max(denominator_bits, numerator_bits) + own;
        return size;
    }

    const Ring& ring_;
    int through_;
    std::vector<double> degrees_;      // of the numerator of each generator
    std::vector<double> denominators_; // and of its denominator: 1 + t^2 of a sine
};

} // namespace

namespace {

int weight_of_modes(const GradedField& field) { return field.ring->generator(field.modes.front().z).weight; }

// The largest of some sizes, over the common denominator of all.
Size together(const std::vector<Size>& sizes) {
    Size all;
    for (const Size& s : sizes) {
        all.degree = std::max(all.degree + s.denominator, s.degree + all.denominator);
        all.denominator += s.denominator;
        all.bits += s.bits + 1;
    }
    return all;
}

// What canonical_complaint() compares. With {w_a, chi} = P/Q, Q free of w, the k-th iterate of the Lie
// series is a polynomial over Q^k, whose degree grows by that of P and whose norm by that of P, times the
// degree, for each of the 2n coordinates.
std::vector<Size> canonical_sizes(const SizeAlgebra& algebra, const NormalForm& normal_form,
                                  const NearIdentityMap& map) {
    const HamiltonianForm& form = *normal_form.hamiltonian;
    const auto slopes_of = [&](const std::vector<const Series*>& list) {
        std::vector<Size> slopes;
        for (const Series* s : list)
            for (const auto& [id, slope] : algebra.gradient(*s, Side::itself).slopes) slopes.push_back(slope);
        return together(slopes);
    };
    std::vector<Size> values;
    std::vector<const Series*> maps;
    for (const HamiltonianForm::Bracket& b : form.brackets)
        values.push_back(algebra.gradient(Series({b.value}), Side::itself).value);
    for (const Series& s : map.mode) maps.push_back(&s);
    const Size brackets = together(values), jacobian = slopes_of(maps);
    const Size vector = algebra.multiply(brackets, slopes_of({&form.generator}));
    const double coordinates = 2 * static_cast<double>(form.brackets.size());
    const double orders = normal_form.through;
    const double degree = orders * std::max(vector.degree, vector.denominator) + 1;
    const Size flow{degree, orders * vector.denominator,
                    orders * (vector.bits + std::log2(coordinates * degree) + std::log2(orders + 1)) +
                        std::log2(orders + 1)};
    const Size products = algebra.multiply(brackets, algebra.multiply(jacobian, jacobian));
    const Size rates = algebra.multiply(brackets, slopes_of({&form.energy}));
    std::vector<Size> sizes{algebra.add(products, brackets)};
    sizes.back().bits += std::log2(2 * coordinates);
    for (const Series& s : normal_form.mode)
        sizes.push_back(algebra.add(algebra.gradient(s, Side::itself).value, rates));
    for (const Series& s : map.mode)
        sizes.push_back(algebra.add(algebra.gradient(s, Side::itself).value, flow));
    return sizes;
}

} // namespace

double point_error_bound(const NormalForm& normal_form, const NearIdentityMap& map, CertificateRoots& roots) {
    const GradedField& field = *normal_form.field;
    SizeAlgebra algebra(*field.ring,
                        normal_form.through + (normal_form.hamiltonian ? weight_of_modes(field) : 0));
    const Jets<Size> jets = Flow(algebra, roots, normal_form, map).jets();
    double degree = 0, bits = 0;
    const auto include = [&](const Size& s) {
        degree = std::max(degree, s.degree);
        bits = std::max(bits, s.bits);
    };
    for (const auto& [variable, defect] : jets.velocity_defects) include(defect);
    for (const Equation& equation : field.system().equations)
        include(EquationEvaluator(algebra, roots, jets.values, equation)(equation.residual));
    if (normal_form.hamiltonian) {
        const Equation energy = energy_as_equation(field.system());
        include(algebra.add(EquationEvaluator(algebra, roots, jets.values, energy)(energy.residual),
                            algebra.gradient(normal_form.hamiltonian->energy, Side::itself).value));
        for (const Size& s : canonical_sizes(algebra, normal_form, map)) include(s);
    }

    bits += inner_product_bits(normal_form, map);
    const double k = algebra.field_degree();
    const double norm_bits = k * (bits + degree * algebra.radicand_bits());
    return 2 * k * (k * degree / std::pow(2.0, 60) + norm_bits / 60 / primes_to_choose_from);
}

} // namespace resonform
