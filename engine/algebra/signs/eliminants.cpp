// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/signs/eliminants.hpp"

#include <acb.h>
#include <arb_fmpz_poly.h>
#include <flint/fmpz_mpoly_factor.h>
#include <flint/fmpz_poly.h>

#include <algorithm>
#include <memory>

namespace resonform {

namespace {

struct Univariate {
    Univariate() { fmpz_poly_init(value); }
    ~Univariate() { fmpz_poly_clear(value); }
    Univariate(const Univariate&) = delete;
    Univariate& operator=(const Univariate&) = delete;
    fmpz_poly_t value;
};

struct Factors {
    explicit Factors(const fmpz_mpoly_ctx_struct* of) : context(of) { fmpz_mpoly_factor_init(value, of); }
    ~Factors() { fmpz_mpoly_factor_clear(value, context); }
    Factors(const Factors&) = delete;
    Factors& operator=(const Factors&) = delete;
    const fmpz_mpoly_ctx_struct* context;
    fmpz_mpoly_factor_t value;
};

Packed multiple(const Packed& p, const Integer& by) {
    Packed result(p.context());
    fmpz_mpoly_scalar_mul_fmpz(result.get(), p.get(), Whole(by).get(), p.context().get());
    return result;
}

} // namespace

FactoredPolynomial factored(const Packed& p) {
    if (p.is_constant()) return {sign_of_number(p), {}};
    const fmpz_mpoly_ctx_struct* const context = p.context().get();
    Factors factors(context);
    if (fmpz_mpoly_factor(factors.value, p.get(), context) == 0) throw NoQuotient{};
    FactoredPolynomial result{fmpz_sgn(factors.value->constant), {}};
    for (slong k = 0; k < factors.value->num; ++k) {
        Packed base(p.context());
        fmpz_mpoly_set(base.get(), factors.value->poly + k, context);
        result.factors.push_back({std::move(base), fmpz_is_odd(factors.value->exp + k) != 0});
    }
    return result;
}

slong degree(const Packed& p, slong variable) {
    return fmpz_mpoly_degree_si(p.get(), variable, p.context().get());
}

std::vector<slong> variables_of(const std::vector<Packed>& all) {
    std::vector<slong> result;
    for (slong v = 0; v < fmpz_mpoly_ctx_nvars(all.front().context().get()); ++v)
        if (std::any_of(all.begin(), all.end(), [v](const Packed& p) { return degree(p, v) > 0; }))
            result.push_back(v);
    return result;
}

Packed coefficient(const Packed& p, slong variable, slong power) {
    Packed result(p.context());
    const ulong exponent = static_cast<ulong>(power);
    fmpz_mpoly_get_coeff_vars_ui(result.get(), p.get(), &variable, &exponent, 1, p.context().get());
    return result;
}

Packed discriminant(const Packed& p, slong variable) {
    Packed result(p.context());
    if (fmpz_mpoly_discriminant(result.get(), p.get(), variable, p.context().get()) == 0) throw NoQuotient{};
    return result;
}

Packed resultant(const Packed& p, const Packed& q, slong variable) {
    Packed result(p.context());
    if (fmpz_mpoly_resultant(result.get(), p.get(), q.get(), variable, p.context().get()) == 0)
        throw NoQuotient{};
    return result;
}

// The positive number is the power of the denominator that makes the value an integer polynomial.
Packed value_at(const Packed& p, slong variable, const Rational& value) {
    const slong highest = degree(p, variable);
    if (highest <= 0) return p;
    const Integer above = cln::numerator(value), below = cln::denominator(value);
    Packed sum = coefficient(p, variable, highest);
    Integer scale = 1;
    for (slong k = highest - 1; k >= 0; --k) { // Horner's scheme
        scale = scale * below;
        sum = multiple(sum, above) + multiple(coefficient(p, variable, k), scale);
    }
    return sum;
}

int sign_of_number(const Packed& p) { return p.is_zero() ? 0 : p.begins_negative() ? -1 : 1; }

std::vector<RealBall> real_roots(const std::vector<Packed>& polynomials, slong variable) {
    constexpr slong bits = 64;
    Univariate product, factor;
    fmpz_poly_one(product.value);
    for (const Packed& p : polynomials) {
        if (fmpz_mpoly_get_fmpz_poly(factor.value, p.get(), variable, p.context().get()) == 0)
            throw NoQuotient{};
        fmpz_poly_mul(product.value, product.value, factor.value);
    }
    const slong count = fmpz_poly_degree(product.value);
    std::vector<RealBall> result;
    if (count == 0) return result;
    if (fmpz_poly_is_squarefree(product.value) == 0) throw NoQuotient{};
    const auto clear = [count](acb_ptr roots) { _acb_vec_clear(roots, count); };
    const std::unique_ptr<acb_struct, decltype(clear)> roots(_acb_vec_init(count), clear);
    arb_fmpz_poly_complex_roots(roots.get(), product.value, 0, bits); // the real ones first, in order
    for (slong k = 0; k < count && acb_is_real(roots.get() + k) != 0; ++k) {
        RealBall root;
        arb_set(root.get(), acb_realref(roots.get() + k));
        result.push_back(std::move(root));
    }
    return result;
}

} // namespace resonform
