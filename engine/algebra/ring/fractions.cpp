// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/fractions.hpp"

#include "algebra/number/flint.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace resonform {
namespace {

// How many limbs are needed, at least one.
std::size_t significant_limbs(const mp_limb_t* limbs, std::size_t count) {
    while (count > 1 && limbs[count - 1] == 0) --count;
    return count;
}

void swap_terms(Fractions& f, std::size_t a, std::size_t b) {
    std::swap(f.monomials[a], f.monomials[b]);
    std::swap(f.negative[a], f.negative[b]);
    mp_limb_t* limbs = f.magnitudes.data();
    std::swap_ranges(limbs + a * f.limbs, limbs + (a + 1) * f.limbs, limbs + b * f.limbs);
}

void sort_by_monomial(Fractions& f) {
    if (std::is_sorted(f.monomials.begin(), f.monomials.end())) return;
    constexpr std::size_t few = 12; // sorted where they are
    if (f.size() <= few) {
        for (std::size_t k = 1; k < f.size(); ++k)
            for (std::size_t j = k; j > 0 && f.monomials[j] < f.monomials[j - 1]; --j)
                swap_terms(f, j, j - 1);
        return;
    }
    std::vector<std::uint32_t> order(f.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return f.monomials[a] < f.monomials[b]; });
    Fractions sorted;
    sorted.monomials.reserve(f.size());
    sorted.magnitudes.reserve(f.magnitudes.size());
    sorted.negative.reserve(f.size());
    for (const std::uint32_t k : order) sorted.append(f.monomials[k], f, k);
    f = std::move(sorted);
}

// gcd(denominator, all numerators)
mpz_class common_factor(const Fractions& f) {
    mpz_class factor = f.denominator;
    mpz_t numerator;
    for (std::size_t k = 0; k < f.size() && mpz_size(factor.get_mpz_t()) > 1; ++k)
        mpz_gcd(factor.get_mpz_t(), factor.get_mpz_t(),
                mpz_roinit_n(numerator, f.magnitude(k), static_cast<mp_size_t>(f.limbs)));
    mp_limb_t word = factor.get_ui();
    if (mpz_size(factor.get_mpz_t()) > 1) return factor;
    for (std::size_t k = 0; k < f.size() && word != 1; ++k)
        word = mpn_gcd_1(f.magnitude(k), static_cast<mp_size_t>(f.limbs), word);
    return word;
}

void divide_numerators(Fractions& f, const mpz_class& factor) {
    if (f.limbs == 1) { // the factor divides them, so it has one limb, too
        const mp_limb_t divisor = factor.get_ui();
        if (divisor == 0) throw std::logic_error("divide_numerators: the common factor is not zero");
        for (mp_limb_t& n : f.magnitudes) n /= divisor;
        return;
    }
    mpz_t numerator;
    mpz_class quotient;
    for (std::size_t k = 0; k < f.size(); ++k) {
        const mpz_srcptr n = mpz_roinit_n(numerator, f.magnitude(k), static_cast<mp_size_t>(f.limbs));
        mpz_divexact(quotient.get_mpz_t(), n, factor.get_mpz_t());
        const std::size_t size = mpz_size(quotient.get_mpz_t());
        mp_limb_t* target = f.magnitudes.data() + k * f.limbs;
        std::copy_n(mpz_limbs_read(quotient.get_mpz_t()), size, target);
        std::fill(target + size, target + f.limbs, 0);
    }
}

void trim(Fractions& f) {
    std::size_t needed = 1;
    for (std::size_t k = 0; k < f.size() && needed < f.limbs; ++k)
        needed = std::max(needed, significant_limbs(f.magnitude(k), f.limbs));
    if (needed >= f.limbs) return;
    for (std::size_t k = 0; k < f.size(); ++k)
        std::copy_n(f.magnitudes.data() + k * f.limbs, needed, f.magnitudes.data() + k * needed);
    f.limbs = needed;
    f.magnitudes.resize(f.size() * needed);
}

} // namespace

std::size_t Fractions::bits() const {
    std::size_t most = 0;
    for (std::size_t k = 0; k < size(); ++k) {
        const mp_limb_t* limb = magnitude(k);
        const std::size_t count = significant_limbs(limb, limbs);
        most = std::max(most, 64 * (count - 1) + static_cast<std::size_t>(std::bit_width(limb[count - 1])));
    }
    return most;
}

void Fractions::append(const Monomial& monomial, const Fractions& from, std::size_t k) {
    if (monomials.empty()) {
        limbs = from.limbs;
        denominator = from.denominator;
    }
    monomials.push_back(monomial);
    magnitudes.insert(magnitudes.end(), from.magnitude(k), from.magnitude(k) + limbs);
    negative.push_back(from.negative[k]);
}

Fractions constant_fraction(const Rational& value) {
    Fractions f;
    f.denominator = to_mpz(cln::denominator(value));
    const mpz_class numerator = to_mpz(cln::numerator(value));
    const mpz_srcptr limbs = numerator.get_mpz_t();
    f.monomials.emplace_back();
    f.limbs = std::max<std::size_t>(1, mpz_size(limbs));
    f.magnitudes.resize(f.limbs, 0);
    std::copy_n(mpz_limbs_read(limbs), mpz_size(limbs), f.magnitudes.begin());
    f.negative.push_back(sgn(numerator) < 0 ? 1 : 0);
    return f;
}

Fractions to_fractions(const std::vector<Term>& terms) {
    Integer denominator = 1;
    for (const Term& t : terms) denominator = cln::lcm(denominator, cln::denominator(t.coefficient));
    Fractions f;
    f.denominator = to_mpz(denominator);
    std::vector<mpz_class> numerators;
    for (const Term& t : terms) {
        const Integer cofactor = cln::exquo(denominator, cln::denominator(t.coefficient));
        numerators.push_back(to_mpz(cln::numerator(t.coefficient) * cofactor));
        f.limbs = std::max(f.limbs, mpz_size(numerators.back().get_mpz_t()));
        f.monomials.push_back(t.monomial);
        f.negative.push_back(sgn(numerators.back()) < 0 ? 1 : 0);
    }
    f.magnitudes.resize(terms.size() * f.limbs, 0);
    for (std::size_t k = 0; k < terms.size(); ++k) {
        const mpz_srcptr n = numerators[k].get_mpz_t();
        std::copy_n(mpz_limbs_read(n), mpz_size(n), f.magnitudes.data() + k * f.limbs);
    }
    return f;
}

std::vector<Term> to_terms(const Fractions& f) {
    const Integer denominator =
        from_limbs(mpz_limbs_read(f.denominator.get_mpz_t()), mpz_size(f.denominator.get_mpz_t()));
    std::vector<Term> terms;
    terms.reserve(f.size());
    for (std::size_t k = 0; k < f.size(); ++k) {
        const Integer size = from_limbs(f.magnitude(k), f.limbs);
        terms.push_back({f.monomials[k], Rational(f.negative[k] != 0 ? -size : size) / denominator});
    }
    return terms;
}

void make_canonical(Fractions& f) {
    if (f.denominator != 1) {
        const mpz_class factor = common_factor(f);
        if (factor != 1) {
            divide_numerators(f, factor);
            mpz_divexact(f.denominator.get_mpz_t(), f.denominator.get_mpz_t(), factor.get_mpz_t());
        }
    }
    trim(f);
    sort_by_monomial(f);
    f.monomials.shrink_to_fit(); // they live long
    f.magnitudes.shrink_to_fit();
    f.negative.shrink_to_fit();
}

} // namespace resonform
