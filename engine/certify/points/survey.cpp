// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/points/survey.hpp"

#include "algebra/ring/fractions.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>

namespace resonform {

namespace {

// Numerators over a common denominator: their largest, and the bits of the denominator.
struct NumberBits {
    mpz_class denominator = 1;
    double numerator = 0;

    void include(const Fractions& part) {
        if (part.denominator == denominator) return;
        mpz_lcm(denominator.get_mpz_t(), denominator.get_mpz_t(), part.denominator.get_mpz_t());
    }
    void include_numerators(const Fractions& part) {
        const auto own = static_cast<double>(mpz_sizeinbase(part.denominator.get_mpz_t(), 2));
        numerator = std::max(numerator, static_cast<double>(part.bits()) + denominator_bits() - own + 1);
    }
    [[nodiscard]] double denominator_bits() const {
        return static_cast<double>(mpz_sizeinbase(denominator.get_mpz_t(), 2));
    }
};

} // namespace

int Survey::exponent(GeneratorId id) const {
    const auto k = static_cast<std::size_t>(id);
    return std::max(-exponents[k].lowest, exponents[k].highest);
}

Surveyor::Surveyor(const Ring& ring) : ring_(ring), exponents_(ring) {
    sizes_.reserve(static_cast<std::size_t>(ring.size()));
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const Generator& g = ring.generator(id);
        GeneratorSize size{g.kind == GeneratorKind::imaginary ? 0.0 : 1.0, 0, 0};
        if (g.kind == GeneratorKind::root) {
            const Size radicand = size_of(g.radicand); // of generators before it
            size.denominator = radicand.denominator;
            size.radicand_bits = radicand.bits / g.index;
            size.degree = std::max(1.0, std::ceil(radicand.degree / g.index)) + radicand.denominator;
        }
        if (is_circle(id)) size.degree = size.denominator = 2;
        sizes_.push_back(size);
        tallies_.push_back({static_cast<std::int64_t>(std::min(size.degree, largest_degree)),
                            static_cast<std::int64_t>(std::min(size.denominator, largest_degree)), g.weight});
    }
}

bool Surveyor::is_circle(GeneratorId id) const {
    const Generator& g = ring_.generator(id);
    return g.kind == GeneratorKind::function &&
           (g.of.function == Function::sine || g.of.function == Function::cosine);
}

const Survey& Surveyor::operator()(const Series& s) {
    const auto [known, is_new] = known_.try_emplace(&s);
    if (is_new) known->second = read(s);
    return known->second;
}

auto Surveyor::add(Sums sums, std::span<const ExponentReader::Power> word) -> Sums {
    for (const auto& [generator, e] : word) {
        Tally& t = tallies_[static_cast<std::size_t>(generator)];
        t.range.lowest = std::min(t.range.lowest, e);
        t.range.highest = std::max(t.range.highest, e);
        sums.weight += t.weight * e;
        sums.degree += t.degree * e;
        sums.own += t.denominator * std::abs(e);
    }
    return sums;
}

// The norm is at most denominator + terms * (largest numerator), over the common denominator of the numbers
// and the lowest power of each generator.
Survey Surveyor::read(const Series& s) {
    Survey survey;
    survey.exponents.reserve(sizes_.size());
    for (Tally& t : tallies_) t.range = {};
    std::size_t terms = 0;
    std::int64_t degree = 0, own = 0; // the largest of all monomials
    NumberBits numbers;
    const auto words = static_cast<std::size_t>(exponents_.words());
    exponents_.forget();
    for (int n = 0; n <= s.through(); ++n) {
        if (s.part(n).empty()) continue;
        const Fractions& part = s.part(n).fractions();
        if (survey.is_empty()) survey.first = n;
        survey.last = n;
        terms += part.size();
        numbers.include(part);
        for (const Monomial& m : part.monomials) {
            for (int from = exponents_.read(m); from < exponents_.words(); ++from) {
                const auto word = static_cast<std::size_t>(from);
                sums_[word + 1] = add(sums_[word], exponents_.powers(from));
            }
            survey.homogeneous = survey.homogeneous && sums_[words].weight == n;
            degree = std::max(degree, sums_[words].degree);
            own = std::max(own, sums_[words].own);
        }
    }
    for (const Tally& t : tallies_) survey.exponents.push_back(t.range);
    if (survey.is_empty()) return survey;
    for (int n = survey.first; n <= survey.last; ++n)
        if (!s.part(n).empty()) numbers.include_numerators(s.part(n).fractions());
    Size& size = survey.size;
    for (std::size_t id = 0; id < sizes_.size(); ++id)
        size.denominator -= sizes_[id].degree * survey.exponents[id].lowest;
    size.denominator += static_cast<double>(own);
    size.degree = size.denominator + static_cast<double>(degree);
    const double numerator_bits = numbers.numerator + std::log2(static_cast<double>(terms + 1));
    size.bits = 1 + std::max(numbers.denominator_bits(), numerator_bits) + static_cast<double>(own);
    return survey;
}

} // namespace resonform
