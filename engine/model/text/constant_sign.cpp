// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/text/constant_sign.hpp"

#include "algebra/ring/interval_functions.hpp"
#include "model/text/named_function.hpp"

#include <algorithm>
#include <string>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;

using Value = std::optional<Interval>;

constexpr int largest_exponent = 100000;

long length(const Integer& n) { return static_cast<long>(cln::integer_length(n)); }

// About the binary logarithm of |r|, which is not zero.
long magnitude(const Rational& r) { return length(cln::numerator(r)) - length(cln::denominator(r)); }

Interval times_power_of_two(const Interval& a, long n) {
    return a * Interval(cln::expt(Rational(2), Integer(n)));
}

// A long fraction becomes one of `bits` significant bits: relative to its size, so that 1e-400 stays
// positive.
Rational shortened(const Rational& r, int bits, bool up) {
    if (length(cln::numerator(r)) + length(cln::denominator(r)) <= 4L * bits) return r;
    const Rational scale = cln::expt(Rational(2), Integer(bits - magnitude(r)));
    return Rational(up ? cln::ceiling1(r * scale) : cln::floor1(r * scale)) / scale;
}

Interval shortened(const Interval& a, int bits) {
    return {shortened(a.low, bits, false), shortened(a.high, bits, true)};
}

class Enclosure {
public:
    Enclosure(const GiNaC::exmap& point, int bits) : point_(point), bits_(bits) {}

    [[nodiscard]] Value of(const ex& e) const {
        if (is_a<GiNaC::numeric>(e)) return of_number(ex_to<GiNaC::numeric>(e));
        if (e.is_equal(GiNaC::Pi)) return pi();
        if (is_a<GiNaC::symbol>(e)) {
            const auto found = point_.find(e);
            return found == point_.end() ? std::nullopt : of(found->second);
        }
        if (is_a<GiNaC::add>(e) || is_a<GiNaC::mul>(e)) return of_operands(e, is_a<GiNaC::add>(e));
        if (is_a<GiNaC::power>(e)) return of_power(e);
        if (is_a<GiNaC::function>(e) && e.nops() == 1 && !is_named(e)) {
            const Value u = of(e.op(0));
            return u ? of_function(ex_to<GiNaC::function>(e).get_name(), *u) : std::nullopt;
        }
        return std::nullopt;
    }

private:
    [[nodiscard]] static Value of_number(const GiNaC::numeric& n) {
        if (!n.is_rational()) return std::nullopt;
        return Interval(cln::the<cln::cl_RA>(n.to_cl_N()));
    }

    [[nodiscard]] Interval pi() const {
        return Interval(Rational(4)) * *function(Function::arc_tangent, Interval(Rational(1)), bits_);
    }

    [[nodiscard]] Value of_operands(const ex& e, bool sum) const {
        Interval total{Rational(sum ? 0 : 1)};
        for (const ex& part : e) {
            const Value value = of(part);
            if (!value) return std::nullopt;
            total = shortened(sum ? total + *value : total * *value, bits_);
        }
        return total;
    }

    [[nodiscard]] Value of_power(const ex& e) const {
        const Value base = of(e.op(0));
        if (!base) return std::nullopt;
        if (!is_a<GiNaC::numeric>(e.op(1)) || !ex_to<GiNaC::numeric>(e.op(1)).is_rational()) {
            const Value exponent = of(e.op(1)), log = of_function("log", *base);
            return exponent && log ? function(Function::exponential, *exponent * *log, bits_) : std::nullopt;
        }
        const GiNaC::numeric n = ex_to<GiNaC::numeric>(e.op(1));
        if (GiNaC::abs(n.numer()) > largest_exponent || n.denom() > largest_exponent) return std::nullopt;
        const Value rooted = n.denom().is_equal(1) ? base : root_of(*base, n.denom().to_int());
        if (!rooted) return std::nullopt;
        const Interval raised = whole_power(*rooted, GiNaC::abs(n.numer()).to_int());
        return n.is_negative() ? inverse(raised) : raised;
    }

    [[nodiscard]] Interval whole_power(Interval base, int n) const {
        Interval result{Rational(1)};
        for (; n > 0; n /= 2) {
            if (n % 2 == 1) result = shortened(result * base, bits_);
            if (n > 1) base = shortened(base * base, bits_);
        }
        return result;
    }

    [[nodiscard]] static Value inverse(const Interval& a) {
        return a.excludes_zero() ? Value(reciprocal(a)) : std::nullopt;
    }

    [[nodiscard]] Value root_of(const Interval& a, int k) const {
        if (!a.positive()) return std::nullopt;
        const long shift = -magnitude(a.low) / k;
        return times_power_of_two(root(times_power_of_two(a, shift * k), k, bits_), -shift);
    }

    [[nodiscard]] Value logarithm(const Interval& a) const {
        if (!a.positive()) return std::nullopt;
        const long shift = -magnitude(a.low);
        const Value rest = function(Function::logarithm, times_power_of_two(a, shift), bits_);
        const Value two = function(Function::logarithm, Interval(Rational(2)), bits_);
        return rest ? Value(*rest + Interval(Rational(-shift)) * *two) : std::nullopt;
    }

    // atan(u/sqrt(1 - u^2))
    [[nodiscard]] Value arc_sine(const Interval& u) const {
        const Value below = root_of(Interval(Rational(1)) + Interval(Rational(-1)) * u * u, 2);
        const Value inverted = below ? inverse(*below) : std::nullopt;
        return inverted ? function(Function::arc_tangent, u * *inverted, bits_) : std::nullopt;
    }

    // (e^u + sign e^-u)/2
    [[nodiscard]] Value hyperbolic(const Interval& u, int sign) const {
        const Value up = function(Function::exponential, u, bits_);
        const Value down = up ? inverse(*up) : std::nullopt;
        if (!down) return std::nullopt;
        return Interval(Rational(1) / 2) * (*up + Interval(Rational(sign)) * *down);
    }

    [[nodiscard]] static Value quotient(const Value& a, const Value& b) {
        const Value inverted = b ? inverse(*b) : std::nullopt;
        return a && inverted ? Value(*a * *inverted) : std::nullopt;
    }

    [[nodiscard]] Value of_function(const std::string& name, const Interval& u) const {
        if (name == "exp") return function(Function::exponential, u, bits_);
        if (name == "log") return logarithm(u);
        if (name == "sin") return function(Function::sine, u, bits_);
        if (name == "cos") return function(Function::cosine, u, bits_);
        if (name == "atan") return function(Function::arc_tangent, u, bits_);
        if (name == "tan") return quotient(of_function("sin", u), of_function("cos", u));
        if (name == "cosh") return hyperbolic(u, 1);
        if (name == "sinh") return hyperbolic(u, -1);
        if (name == "tanh") return quotient(hyperbolic(u, -1), hyperbolic(u, 1));
        if (name == "asin") return arc_sine(u);
        if (name == "acos") {
            const Value sine = arc_sine(u);
            if (!sine) return std::nullopt;
            return Interval(Rational(1) / 2) * pi() + Interval(Rational(-1)) * *sine;
        }
        return std::nullopt;
    }

    const GiNaC::exmap& point_;
    int bits_;
};

} // namespace

bool is_constant(const ex& e) {
    return std::none_of(e.preorder_begin(), e.preorder_end(),
                        [](const ex& part) { return is_a<GiNaC::symbol>(part) || is_named(part); });
}

std::optional<Interval> enclosure(const ex& e, const GiNaC::exmap& point, int bits) {
    return Enclosure(point, bits).of(e);
}

ConstantSign sign_of_constant(const ex& e) {
    for (const int bits : {64, 512}) {
        const std::optional<Interval> value = enclosure(e, {}, bits);
        if (value && value->excludes_zero())
            return value->positive() ? ConstantSign::positive : ConstantSign::negative;
    }
    return ConstantSign::unknown;
}

} // namespace resonform
