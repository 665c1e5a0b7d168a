// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/integrals/rational_integral.hpp"

#include "model/exact/substitution.hpp"
#include "model/text/canonical.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::numeric;

struct Factor {
    ex base; // a polynomial in x
    int exponent;
};

// (c1 x + c0)/base^exponent, c1 = 0 for a linear base
struct Piece {
    ex base;
    int exponent;
    GiNaC::symbol c0{"c0"}, c1{"c1"};
};

class Integrator {
public:
    Integrator(const GiNaC::symbol& x, const PositiveThere& positive) : x_(x), positive_(positive) {}

    std::optional<ex> integrate(const ex& numerator, const ex& denominator) const {
        ex content = 1;
        const auto factors = factors_of(denominator, content);
        if (!factors) return std::nullopt;
        // Times so many powers of the leading coefficient, quotient and rest have no fractions.
        const int steps = std::max(0, numerator.degree(x_) - denominator.degree(x_) + 1);
        const ex scale = GiNaC::pow(denominator.lcoeff(x_), steps), scaled = (scale * numerator).expand();
        const ex whole = GiNaC::quo(scaled, denominator, x_), rest = GiNaC::rem(scaled, denominator, x_);
        ex sum = 0;
        for (int n = 0; n <= whole.degree(x_); ++n)
            sum += (whole.coeff(x_, n) / scale).normal() * GiNaC::pow(x_, n + 1) / (n + 1);
        if (rest.is_zero()) return sum;
        for (const auto& [piece, c1, c0] : partial_fractions(rest / (scale * content), *factors)) {
            const auto part = piece.base.degree(x_) == 1 ? of_linear(piece.base, piece.exponent, c0)
                                                         : of_quadratic(piece.base, piece.exponent, c1, c0);
            if (!part) return std::nullopt;
            sum += *part;
        }
        return sum;
    }

private:
    struct Solved {
        Piece piece;
        ex c1, c0;
    };

    // Factors of degree 1 and 2; those without x go into the content.
    std::optional<std::vector<Factor>> factors_of(const ex& polynomial, ex& content) const {
        std::vector<Factor> factors;
        const ex product = GiNaC::factor(polynomial);
        const auto take = [&](const ex& factor) {
            const bool power = GiNaC::is_a<GiNaC::power>(factor);
            const ex base = (power ? factor.op(0) : factor).expand();
            if (!factor.has(x_))
                content *= factor;
            else
                factors.push_back({base, power ? GiNaC::ex_to<numeric>(factor.op(1)).to_int() : 1});
        };
        if (GiNaC::is_a<GiNaC::mul>(product))
            for (const ex& factor : operands(product)) take(factor);
        else
            take(product);
        for (const Factor& f : factors)
            if (f.base.degree(x_) > 2 || !may_divide(f.base.lcoeff(x_), positive_)) return std::nullopt;
        return factors;
    }

    // value/product = sum of pieces, times the product
    std::vector<Solved> partial_fractions(const ex& value, const std::vector<Factor>& factors) const {
        std::vector<Piece> pieces;
        ex sum = -value;
        GiNaC::lst unknowns, equations;
        int degree = 0;
        for (const Factor& f : factors) {
            ex others = 1;
            for (const Factor& other : factors)
                if (&other != &f) others *= GiNaC::pow(other.base, other.exponent);
            const bool linear = f.base.degree(x_) == 1;
            degree += f.exponent * f.base.degree(x_);
            for (int k = 1; k <= f.exponent; ++k) {
                const Piece& p = pieces.emplace_back(Piece{f.base, k});
                const ex above = linear ? ex(p.c0) : p.c0 + p.c1 * x_;
                sum += above * others * GiNaC::pow(f.base, f.exponent - k);
                unknowns.append(p.c0);
                if (!linear) unknowns.append(p.c1);
            }
        }
        sum = sum.expand();
        for (int n = 0; n < degree; ++n) equations.append(sum.coeff(x_, n) == 0);
        const ex solution = GiNaC::lsolve(equations, unknowns);
        std::vector<Solved> solved;
        for (const Piece& p : pieces)
            solved.push_back(
                {p, p.base.degree(x_) == 1 ? ex(0) : ex(p.c1).subs(solution), ex(p.c0).subs(solution)});
        return solved;
    }

    std::optional<ex> of_linear(const ex& base, int exponent, const ex& c) const {
        const ex a = base.coeff(x_, 1);
        if (exponent == 1) return c / a * log_of_size(base, positive_);
        return c * GiNaC::pow(base, 1 - exponent) / ((1 - exponent) * a);
    }

    // c1/(2a) p'/p^n + (c0 - c1 b/(2a))/p^n
    std::optional<ex> of_quadratic(const ex& p, int n, const ex& c1, const ex& c0) const {
        const ex a = p.coeff(x_, 2), b = p.coeff(x_, 1);
        const ex slope = n == 1 ? log_of_size(p, positive_) : GiNaC::pow(p, 1 - n) / (1 - n);
        const ex still = (c0 - c1 * b / (2 * a)).normal();
        if (still.is_zero()) return c1 / (2 * a) * slope;
        const auto inverse = of_inverse_power(p, n);
        if (!inverse) return std::nullopt;
        return c1 / (2 * a) * slope + still * *inverse;
    }

    // 1/p^n, with d = 4ac - b^2
    std::optional<ex> of_inverse_power(const ex& p, int n) const {
        const ex a = p.coeff(x_, 2), b = p.coeff(x_, 1), slope = 2 * a * x_ + b;
        const ex d = (4 * a * p.coeff(x_, 0) - b * b).expand();
        if (n > 1) {
            const auto lower = of_inverse_power(p, n - 1);
            if (!lower || !may_divide(d, positive_)) return std::nullopt;
            return (slope / GiNaC::pow(p, n - 1) + 2 * (2 * n - 3) * a * *lower) / ((n - 1) * d);
        }
        if (positive_(d)) return 2 / GiNaC::sqrt(d) * GiNaC::atan(slope / GiNaC::sqrt(d));
        if (!positive_(-d)) return std::nullopt;
        const ex root = GiNaC::sqrt(-d);
        return (log_of_size(slope - root, positive_) - log_of_size(slope + root, positive_)) / root;
    }

    const GiNaC::symbol& x_;
    const PositiveThere& positive_;
};

} // namespace

bool may_divide(const ex& e, const PositiveThere& positive) {
    if (e.is_zero()) return false;
    return !GiNaC::is_a<GiNaC::add>(e) || positive(GiNaC::pow(e, 2));
}

ex log_of_size(const ex& u, const PositiveThere& positive) {
    if (positive(u)) return GiNaC::log(u);
    if (positive(-u)) return GiNaC::log(-u);
    return GiNaC::log(GiNaC::pow(u, 2)) / 2;
}

std::optional<ex> integral_of_rational(const ex& e, const GiNaC::symbol& x, const PositiveThere& positive) {
    GiNaC::exmap functions; // free of x, or there is no result
    const ex fraction = e.to_rational(functions).numer_denom();
    for (const auto& [symbol, function] : functions)
        if (function.has(x)) return std::nullopt;
    const PositiveThere meant = [&](const ex& u) { return positive(put(u, functions)); };
    const auto result = Integrator(x, meant).integrate(fraction.op(0).expand(), fraction.op(1).expand());
    return result ? std::optional<ex>(put(*result, functions)) : std::nullopt;
}

} // namespace resonform
