// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/integrals/circular_integral.hpp"

#include "model/integrals/rational_integral.hpp"
#include "model/text/canonical.hpp"
#include "model/text/function_call.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace resonform {

namespace {

using GiNaC::ex;

constexpr std::size_t most_terms = 1024; // of a product of sines and cosines

bool is_circular(Function f) { return f == Function::sine || f == Function::cosine; }
bool is_hyperbolic(Function f) { return f == Function::hyperbolic_sine || f == Function::hyperbolic_cosine; }

// exp(growth)*(c*cos(angle) + s*sin(angle)), or with cosh and sinh
struct Wave {
    ex growth = 0, angle = 0, c = 1, s = 0;
};

class CircularProduct {
public:
    CircularProduct(const GiNaC::symbol& x, const PositiveThere& positive) : x_(x), positive_(positive) {}

    bool take(const ex& factor) {
        const bool power = GiNaC::is_a<GiNaC::power>(factor) && factor.op(1).info(GiNaC::info_flags::integer);
        const ex base = power ? factor.op(0) : factor;
        const int n = power ? GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_int() : 1;
        if (!factor.has(x_)) {
            constant_ *= factor;
        } else if (base.is_equal(x_) && n > 0) {
            degree_ += n;
        } else if (function_of(base) == Function::exponential) {
            for (Wave& wave : waves_) wave.growth += n * base.op(0);
        } else if (const std::optional<Function> f = function_of(base); f && n > 0 && is_wave(*f)) {
            for (int k = 0; k < n; ++k) multiply(row_of(*f).parity == Parity::even, base.op(0));
        } else {
            return false;
        }
        return waves_.size() <= most_terms;
    }

    std::optional<ex> integral() const {
        ex sum = 0;
        for (const Wave& wave : waves_) {
            const auto part = integral_of(wave);
            if (!part) return std::nullopt;
            sum += *part;
        }
        return constant_ * sum;
    }

private:
    // All circular, or all hyperbolic.
    bool is_wave(Function f) {
        const bool circular = is_circular(f), hyperbolic = is_hyperbolic(f);
        if ((circular && hyperbolic_) || (hyperbolic && circular_)) return false;
        circular_ = circular_ || circular;
        hyperbolic_ = hyperbolic_ || hyperbolic;
        return circular || hyperbolic;
    }
    [[nodiscard]] int square() const { return hyperbolic_ ? 1 : -1; } // of the imaginary unit, or of 1

    // cos(u)*cos(v) = (cos(u + v) + cos(u - v))/2, and so on.
    void multiply(bool cosine, const ex& v) {
        std::vector<Wave> result;
        for (const Wave& w : waves_) {
            if (w.angle.is_zero()) {
                result.push_back({w.growth, v, cosine ? w.c : ex(0), cosine ? ex(0) : w.c});
                continue;
            }
            for (const int sign : {1, -1}) {
                Wave term{w.growth, (w.angle + sign * v).expand(), w.c / 2, w.s / 2};
                if (!cosine) {
                    term.c = sign * square() * w.s / 2;
                    term.s = sign * w.c / 2;
                }
                result.push_back(term);
            }
        }
        waves_ = std::move(result);
    }

    // By parts: x^n times the integral, minus the integral of n x^(n-1) times it.
    [[nodiscard]] std::optional<ex> integral_of(Wave wave) const {
        const ex g = wave.growth.diff(x_).expand(), a = wave.angle.diff(x_).expand();
        if (g.has(x_) || a.has(x_)) return std::nullopt;
        if (g.is_zero() && a.is_zero()) return GiNaC::pow(x_, degree_ + 1) / (degree_ + 1) * value(wave);
        const ex divisor = (g * g - square() * a * a).expand();
        const ex other = g.is_zero() ? a : a.is_zero() ? g : divisor;
        if (!may_divide(other, positive_)) return std::nullopt;
        ex sum = 0, factor = 1;
        for (int n = degree_; n >= 0; --n) {
            const ex c = (g * wave.c - a * wave.s) / divisor,
                     s = (g * wave.s - square() * a * wave.c) / divisor;
            wave.c = c;
            wave.s = s;
            sum += factor * GiNaC::pow(x_, n) * value(wave);
            factor *= -n;
        }
        return sum;
    }

    [[nodiscard]] ex value(const Wave& wave) const {
        const ex cosine = hyperbolic_ ? GiNaC::cosh(wave.angle) : GiNaC::cos(wave.angle);
        const ex sine = hyperbolic_ ? GiNaC::sinh(wave.angle) : GiNaC::sin(wave.angle);
        return GiNaC::exp(wave.growth) * (wave.c * cosine + wave.s * sine);
    }

    const GiNaC::symbol& x_;
    const PositiveThere& positive_;
    bool circular_ = false, hyperbolic_ = false;
    int degree_ = 0;
    ex constant_ = 1;
    std::vector<Wave> waves_{Wave{}};
};

// A rational function of the sine and cosine of one argument.
class Substitution {
public:
    Substitution(const GiNaC::symbol& x, const PositiveThere& positive) : x_(x), positive_(positive) {}

    std::optional<ex> integral(const ex& e) {
        for (auto i = e.preorder_begin(); i != e.preorder_end(); ++i)
            if (i->has(x_) && !note(*i)) return std::nullopt;
        if (argument_.is_zero()) return std::nullopt;
        const auto slope = slope_of(argument_, x_, positive_);
        const ex quotient = hyperbolic_ ? GiNaC::tanh(argument_) : GiNaC::tan(argument_);
        const ex f = e.subs(GiNaC::lst{sine() == s_, cosine() == c_, quotient == s_ / c_},
                            GiNaC::subs_options::no_pattern);
        if (!slope || f.has(x_)) return std::nullopt;
        std::optional<ex> result = by_cosine(f);
        if (!result) result = by_sine(f);
        if (!result) result = by_tangent(f);
        if (result) *result /= *slope;
        return result;
    }

private:
    // false: a function with x in it that is none of these, or of another argument.
    bool note(const ex& part) {
        if (!GiNaC::is_a<GiNaC::function>(part)) return true;
        const std::optional<Function> f = function_of(part);
        const bool hyperbolic = f && (is_hyperbolic(*f) || f == Function::hyperbolic_tangent);
        if (!hyperbolic && !(f && (is_circular(*f) || f == Function::tangent))) return false;
        if (argument_.is_zero()) {
            argument_ = part.op(0);
            hyperbolic_ = hyperbolic;
        }
        return hyperbolic == hyperbolic_ && argument_.is_equal(part.op(0));
    }
    [[nodiscard]] ex sine() const { return hyperbolic_ ? GiNaC::sinh(argument_) : GiNaC::sin(argument_); }
    [[nodiscard]] ex cosine() const { return hyperbolic_ ? GiNaC::cosh(argument_) : GiNaC::cos(argument_); }

    // f(u) with u^2 = square; nullopt: f is not even in u.
    static std::optional<ex> even_part(const ex& f, const GiNaC::symbol& u, const ex& square) {
        const ex fraction = f.normal().numer_denom();
        ex parts[2];
        for (const std::size_t k : {0U, 1U}) {
            const ex polynomial = fraction.op(k).expand();
            if (!polynomial.is_polynomial(u)) return std::nullopt;
            for (int n = 0; n <= polynomial.degree(u); ++n) {
                const ex coefficient = polynomial.coeff(u, n);
                if (n % 2 == 1 && !coefficient.is_zero()) return std::nullopt;
                parts[k] += coefficient * GiNaC::pow(square, n / 2);
            }
        }
        return parts[0] / parts[1];
    }
    [[nodiscard]] std::optional<ex> integrated(const std::optional<ex>& f, const GiNaC::symbol& t,
                                               const ex& meaning) const {
        const PositiveThere there = [&](const ex& e) { return positive_(e.subs(t == meaning)); };
        const auto result = f ? integral_of_rational(*f, t, there) : std::nullopt;
        return result ? std::optional<ex>(result->subs(t == meaning)) : std::nullopt;
    }
    // f = s*h(c): t = c, dt = -s dx
    [[nodiscard]] std::optional<ex> by_cosine(const ex& f) const {
        const int sign = hyperbolic_ ? 1 : -1;
        const auto h = even_part(f / s_, s_, -sign * (1 - c_ * c_));
        return integrated(h ? std::optional<ex>(sign * *h) : h, c_, cosine());
    }
    // f = c*h(s): t = s
    [[nodiscard]] std::optional<ex> by_sine(const ex& f) const {
        return integrated(even_part(f / c_, c_, hyperbolic_ ? 1 + s_ * s_ : 1 - s_ * s_), s_, sine());
    }
    // t = s/c, c^2 = 1/(1 + t^2), dt = (1 + t^2) dx
    [[nodiscard]] std::optional<ex> by_tangent(const ex& f) const {
        const GiNaC::symbol t("t");
        const ex square = 1 + (hyperbolic_ ? -1 : 1) * t * t;
        const auto h = even_part(f.subs(s_ == t * c_), c_, 1 / square);
        auto result = integrated(h ? std::optional<ex>(*h / square) : h, t, sine() / cosine());
        if (result) result = result->subs(GiNaC::atan(sine() / cosine()) == argument_); // without its jumps
        const auto is_arc = [](const ex& part) { return function_of(part) == Function::arc_tangent; };
        if (result && std::any_of(result->preorder_begin(), result->preorder_end(), is_arc))
            return std::nullopt;
        return result;
    }

    const GiNaC::symbol& x_;
    const PositiveThere& positive_;
    const GiNaC::symbol s_{"s"}, c_{"c"};
    ex argument_ = 0;
    bool hyperbolic_ = false;
};

} // namespace

std::optional<ex> slope_of(const ex& linear, const GiNaC::symbol& x, const PositiveThere& positive) {
    const ex slope = linear.diff(x).expand();
    if (slope.has(x) || !may_divide(slope, positive)) return std::nullopt;
    return slope;
}

std::optional<ex> integral_of_circular_product(const ex& product, const GiNaC::symbol& x,
                                               const PositiveThere& positive) {
    CircularProduct waves(x, positive);
    if (!GiNaC::is_a<GiNaC::mul>(product)) return waves.take(product) ? waves.integral() : std::nullopt;
    for (const ex& factor : operands(product))
        if (!waves.take(factor)) return std::nullopt;
    return waves.integral();
}

std::optional<ex> integral_by_substitution(const ex& e, const GiNaC::symbol& x,
                                           const PositiveThere& positive) {
    return Substitution(x, positive).integral(e);
}

} // namespace resonform
