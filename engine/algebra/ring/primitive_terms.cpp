// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/primitive_terms.hpp"

#include "algebra/number/flint.hpp"
#include "algebra/ring/fractions.hpp"

#include <cstddef>
#include <utility>

namespace resonform {
namespace {

// A numerator without its sign, read where it lies.
class Magnitude {
public:
    Magnitude(const Fractions& f, std::size_t k)
        : value_(mpz_roinit_n(limbs_, f.magnitude(k), static_cast<mp_size_t>(f.limbs))) {}

    [[nodiscard]] mpz_srcptr get() const { return value_; }

private:
    mpz_t limbs_;
    mpz_srcptr value_;
};

// 0 of none.
mpz_class common_divisor_of_numerators(const Fractions& f) {
    mpz_class divisor = 0;
    for (std::size_t k = 0; k < f.size() && divisor != 1; ++k)
        mpz_gcd(divisor.get_mpz_t(), divisor.get_mpz_t(), Magnitude(f, k).get());
    return divisor;
}

Integer to_integer(const mpz_class& value) {
    return from_limbs(mpz_limbs_read(value.get_mpz_t()), mpz_size(value.get_mpz_t()));
}

} // namespace

Rational content(const Polynomial& p) {
    const Fractions& f = p.fractions();
    return to_integer(common_divisor_of_numerators(f)) / Rational(to_integer(f.denominator));
}

std::vector<Term> primitive_terms(const Polynomial& p) {
    const Fractions& f = p.fractions();
    const mpz_class divisor = common_divisor_of_numerators(f);
    std::vector<Term> terms;
    terms.reserve(f.size());
    mpz_class quotient;
    for (std::size_t k = 0; k < f.size(); ++k) {
        mpz_divexact(quotient.get_mpz_t(), Magnitude(f, k).get(), divisor.get_mpz_t());
        const Integer size = to_integer(quotient);
        terms.push_back({f.monomials[k], f.negative[k] != 0 ? -size : size});
    }
    return terms;
}

} // namespace resonform
