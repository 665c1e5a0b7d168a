// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials with integer coefficients in many variables: those of FLINT.
#pragma once

#include "algebra/number/flint.hpp"
#include <flint/fmpz_mpoly.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace resonform {

struct NoQuotient {}; // thrown where an expression is no quotient of polynomials, or too large for FLINT

// The variables of polynomials.
class PolynomialContext {
public:
    explicit PolynomialContext(std::size_t variables) {
        fmpz_mpoly_ctx_init(context_, static_cast<slong>(variables), ORD_LEX);
    }
    ~PolynomialContext() { fmpz_mpoly_ctx_clear(context_); }
    PolynomialContext(const PolynomialContext&) = delete;
    PolynomialContext& operator=(const PolynomialContext&) = delete;
    [[nodiscard]] const fmpz_mpoly_ctx_struct* get() const { return context_; }

private:
    fmpz_mpoly_ctx_t context_;
};

class Packed { // a polynomial
public:
    explicit Packed(const PolynomialContext& context, slong value = 0) : context_(&context) {
        fmpz_mpoly_init(value_, context.get());
        fmpz_mpoly_set_si(value_, value, context.get());
    }
    Packed(const PolynomialContext& context, const Whole& value) : Packed(context) {
        fmpz_mpoly_set_fmpz(value_, value.get(), context.get());
    }
    Packed(const Packed& other) : context_(other.context_) {
        fmpz_mpoly_init(value_, context_->get());
        fmpz_mpoly_set(value_, other.value_, context_->get());
    }
    Packed(Packed&& other) noexcept : context_(other.context_) {
        fmpz_mpoly_init(value_, context_->get());
        fmpz_mpoly_swap(value_, other.value_, context_->get());
    }
    Packed& operator=(Packed other) noexcept {
        fmpz_mpoly_swap(value_, other.value_, context_->get());
        return *this;
    }
    ~Packed() { fmpz_mpoly_clear(value_, context_->get()); }

    [[nodiscard]] const PolynomialContext& context() const { return *context_; }
    [[nodiscard]] fmpz_mpoly_struct* get() { return value_; }
    [[nodiscard]] const fmpz_mpoly_struct* get() const { return value_; }
    [[nodiscard]] bool is_one() const { return fmpz_mpoly_is_one(value_, context_->get()) != 0; }
    [[nodiscard]] bool is_constant() const { return fmpz_mpoly_is_fmpz(value_, context_->get()) != 0; }
    [[nodiscard]] bool is_zero() const { return fmpz_mpoly_is_zero(value_, context_->get()) != 0; }

    [[nodiscard]] slong terms() const { return fmpz_mpoly_length(value_, context_->get()); }

    using Exponents = std::vector<ulong>; // one a variable
    // visit(exponents, coefficient)
    template <class Visit> void visit_terms(const Visit& visit) const {
        Exponents exponents(static_cast<std::size_t>(fmpz_mpoly_ctx_nvars(context_->get())));
        Whole coefficient;
        for (slong n = 0; n < fmpz_mpoly_length(value_, context_->get()); ++n) {
            fmpz_mpoly_get_term_exp_ui(exponents.data(), value_, n, context_->get());
            fmpz_mpoly_get_term_coeff_fmpz(coefficient.get(), value_, n, context_->get());
            visit(exponents, coefficient);
        }
    }
    // Terms are given in any order, put in order at the end.
    void give(const Exponents& exponents, const Whole& coefficient) {
        fmpz_mpoly_push_term_fmpz_ui(value_, coefficient.get(), exponents.data(), context_->get());
    }
    void put_in_order() {
        fmpz_mpoly_sort_terms(value_, context_->get());
        fmpz_mpoly_combine_like_terms(value_, context_->get());
    }

    [[nodiscard]] bool begins_negative() const { return !is_zero() && fmpz_sgn(value_->coeffs) < 0; }
    [[nodiscard]] Packed negative() const {
        Packed result(*context_);
        fmpz_mpoly_neg(result.value_, value_, context_->get());
        return result;
    }

    friend bool operator==(const Packed& a, const Packed& b) {
        return fmpz_mpoly_equal(a.value_, b.value_, a.context_->get()) != 0;
    }
    friend Packed operator+(const Packed& a, const Packed& b) {
        Packed sum(*a.context_);
        fmpz_mpoly_add(sum.value_, a.value_, b.value_, a.context_->get());
        return sum;
    }
    friend Packed operator*(const Packed& a, const Packed& b) {
        if (a.is_one()) return b;
        if (b.is_one()) return a;
        Packed product(*a.context_);
        fmpz_mpoly_mul(product.value_, a.value_, b.value_, a.context_->get());
        return product;
    }
    [[nodiscard]] Packed raised(ulong n) const {
        Packed power(*context_);
        if (fmpz_mpoly_pow_ui(power.value_, value_, n, context_->get()) == 0) throw NoQuotient{};
        return power;
    }
    // nullopt: it does not divide.
    [[nodiscard]] std::optional<Packed> quotient_by(const Packed& divisor) const {
        Packed quotient(*context_);
        if (fmpz_mpoly_divides(quotient.value_, value_, divisor.value_, context_->get()) == 0)
            return std::nullopt;
        return quotient;
    }
    // Of a divisor.
    [[nodiscard]] Packed divided_by(const Packed& divisor) const {
        if (divisor.is_one()) return *this;
        auto quotient = quotient_by(divisor);
        if (!quotient) throw NoQuotient{};
        return *std::move(quotient);
    }
    friend Packed common_divisor(const Packed& a, const Packed& b) {
        if (a.is_one() || b.is_one()) return Packed(*a.context_, 1);
        Packed divisor(*a.context_);
        if (fmpz_mpoly_gcd(divisor.value_, a.value_, b.value_, a.context_->get()) == 0) throw NoQuotient{};
        return divisor;
    }

private:
    const PolynomialContext* context_;
    fmpz_mpoly_t value_;
};

} // namespace resonform
