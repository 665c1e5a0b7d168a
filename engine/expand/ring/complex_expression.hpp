// SPDX-License-Identifier: GPL-3.0-or-later
// Complex numbers whose real and imaginary parts are expressions in real symbols.
#pragma once

#include <ginac/ginac.h>

namespace resonform {

struct Complex {
    GiNaC::ex re = 0, im = 0;

    [[nodiscard]] bool is_zero() const { return re.is_zero() && im.is_zero(); }
};

inline Complex conjugate(const Complex& a) { return {a.re, -a.im}; }
inline Complex operator-(const Complex& a) { return {-a.re, -a.im}; }
inline Complex operator+(const Complex& a, const Complex& b) { return {a.re + b.re, a.im + b.im}; }
inline Complex operator-(const Complex& a, const Complex& b) { return {a.re - b.re, a.im - b.im}; }
inline Complex operator*(const Complex& a, const Complex& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
// Precondition: b is not zero.
inline Complex operator/(const Complex& a, const Complex& b) {
    if (b.im.is_zero()) return {a.re / b.re, a.im / b.re};
    if (b.re.is_zero()) return {a.im / b.im, -a.re / b.im};
    const GiNaC::ex norm = b.re * b.re + b.im * b.im;
    const Complex product = a * conjugate(b);
    return {product.re / norm, product.im / norm};
}
// Cancels common factors, so that an expression that vanishes by rational identities becomes the number 0.
inline Complex normal(const Complex& a) { return {a.re.normal(), a.im.normal()}; }

} // namespace resonform
