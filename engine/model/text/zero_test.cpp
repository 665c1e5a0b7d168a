// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/text/zero_test.hpp"

#include "model/text/constant_sign.hpp"
#include "model/text/named_function.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace resonform {

namespace {

using GiNaC::ex;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-14; // relative, generous for every libm function used

// Adds the rounding error of the last operation; anything not finite is unknown.
Ball rounded(double middle, double radius) {
    const double total = radius + rounding * std::abs(middle) + std::numeric_limits<double>::min();
    if (!std::isfinite(middle) || !std::isfinite(total)) return {0, infinity};
    return {middle, total};
}

Ball ball_of_number(const GiNaC::numeric& n) {
    constexpr int largest_bits = 1000; // beyond this a double may overflow
    if (!n.is_rational() || n.numer().int_length() > largest_bits || n.denom().int_length() > largest_bits) {
        return {0, infinity};
    }
    return rounded(n.to_double(), 0);
}

Ball add(const Ball& a, const Ball& b) { return rounded(a.middle + b.middle, a.radius + b.radius); }

Ball multiply(const Ball& a, const Ball& b) {
    return rounded(a.middle * b.middle,
                   std::abs(a.middle) * b.radius + std::abs(b.middle) * a.radius + a.radius * b.radius);
}

// f(a) for a monotone f on the ball, whose ends lie in the domain of f.
Ball monotone(const Ball& a, double lowest, const std::function<double(double)>& f) {
    if (!(a.middle - a.radius > lowest)) return {0, infinity};
    const double middle = f(a.middle);
    const double below = std::abs(middle - f(a.middle - a.radius));
    const double above = std::abs(f(a.middle + a.radius) - middle);
    return rounded(middle, std::max(below, above) + 2 * rounding * (std::abs(middle) + below + above));
}

// f(a) for |f'| <= 1.
Ball contraction(const Ball& a, const std::function<double(double)>& f) {
    return rounded(f(a.middle), a.radius);
}

Ball power(const Ball& base, double exponent) {
    if (exponent == std::floor(exponent) && exponent > 0 && exponent <= 64) {
        Ball result{1, 0};
        for (int k = 0; k < static_cast<int>(exponent); ++k) result = multiply(result, base);
        return result;
    }
    if (exponent == std::floor(exponent) && base.middle < 0) {
        const Ball positive = power({-base.middle, base.radius}, exponent);
        return std::fmod(exponent, 2) == 0 ? positive : Ball{-positive.middle, positive.radius};
    }
    return monotone(base, 0, [exponent](double x) { return std::pow(x, exponent); });
}

Ball function(const std::string& name, const Ball& x) {
    const auto quotient = [](const Ball& a, const Ball& b) { return multiply(a, power(b, -1)); };
    const auto sine = [](const Ball& a) { return contraction(a, [](double u) { return std::sin(u); }); };
    const auto cosine = [](const Ball& a) { return contraction(a, [](double u) { return std::cos(u); }); };
    if (name == "sin") return sine(x);
    if (name == "cos") return cosine(x);
    if (name == "tan") return quotient(sine(x), cosine(x));
    if (name == "exp") return monotone(x, -infinity, [](double u) { return std::exp(u); });
    if (name == "log") return monotone(x, 0, [](double u) { return std::log(u); });
    if (name == "cosh") {
        const Ball up = function("exp", x), down = power(up, -1);
        return multiply({0.5, 0}, add(up, down));
    }
    if (name == "sinh") return monotone(x, -infinity, [](double u) { return std::sinh(u); });
    const bool inside = std::abs(x.middle) + x.radius < 1;
    if (name == "asin" && inside) return monotone(x, -1, [](double u) { return std::asin(u); });
    if (name == "acos" && inside) return monotone(x, -1, [](double u) { return std::acos(u); });
    if (name == "tanh") return contraction(x, [](double u) { return std::tanh(u); });
    if (name == "atan") return contraction(x, [](double u) { return std::atan(u); });
    return {0, infinity};
}

// A function that is known by its name may be 1 + exp(u/n), with n from its name: what differs from zero for
// that differs from zero for some.
Ball of_named(const NamedCall& call, const GiNaC::exmap& point) {
    int n = 3;
    for (const char c : call.name) n = (31 * n + static_cast<unsigned char>(c)) % 97 + 3;
    const Ball slope = rounded(1.0 / n, 0);
    const Ball value = function("exp", multiply(slope, evaluate(call.argument, point)));
    if (call.derivative == 0) return add({1, 0}, value);
    return multiply(power(slope, call.derivative), value);
}

// Distinct rationals in (0, 1) or (1, 2) by turns, the same on every run; the symbols by name.
GiNaC::exmap point_for(const ex& e, int salt) {
    std::vector<ex> symbols;
    for (auto i = e.preorder_begin(); i != e.preorder_end(); ++i) {
        if (GiNaC::is_a<GiNaC::symbol>(*i)) symbols.push_back(*i);
    }
    std::sort(symbols.begin(), symbols.end(), [](const ex& a, const ex& b) {
        return GiNaC::ex_to<GiNaC::symbol>(a).get_name() < GiNaC::ex_to<GiNaC::symbol>(b).get_name();
    });
    GiNaC::exmap point;
    for (const ex& symbol : symbols) {
        const int count = static_cast<int>(point.size());
        point.emplace(symbol, salt % 2 + GiNaC::numeric(1 + (37 * count + 61 * salt) % 97, 101));
    }
    return point;
}

// Doubles first, as they are fast; where they overflow, intervals of any size.
bool differs_at(const ex& e, const GiNaC::exmap& point) {
    constexpr int bits = 64;
    const Ball ball = evaluate(e, point);
    if (std::isfinite(ball.radius)) return ball.excludes_zero();
    const std::optional<Interval> exact = enclosure(e, point, bits);
    return exact && exact->excludes_zero();
}

// The cost of normal() may grow exponentially with the number of fractions.
bool is_small(const ex& e) {
    constexpr int most_parts = 300;
    int parts = 0;
    for (auto i = e.preorder_begin(); i != e.preorder_end() && parts <= most_parts; ++i) ++parts;
    return parts <= most_parts;
}

} // namespace

bool Ball::excludes_zero() const { return std::abs(middle) > radius; }

Ball evaluate(const ex& e, const GiNaC::exmap& point) {
    if (GiNaC::is_a<GiNaC::numeric>(e)) return ball_of_number(GiNaC::ex_to<GiNaC::numeric>(e));
    if (e.is_equal(GiNaC::Pi)) return rounded(std::acos(-1.0), 0);
    if (GiNaC::is_a<GiNaC::symbol>(e)) {
        const auto found = point.find(e);
        return found == point.end() ? Ball{0, infinity} : evaluate(found->second, point);
    }
    if (GiNaC::is_a<GiNaC::add>(e) || GiNaC::is_a<GiNaC::mul>(e)) {
        const bool sum = GiNaC::is_a<GiNaC::add>(e);
        Ball total{sum ? 0.0 : 1.0, 0};
        for (const ex& part : e) {
            const Ball value = evaluate(part, point);
            total = sum ? add(total, value) : multiply(total, value);
        }
        return total;
    }
    if (GiNaC::is_a<GiNaC::power>(e) && GiNaC::is_a<GiNaC::numeric>(e.op(1))) {
        return power(evaluate(e.op(0), point), GiNaC::ex_to<GiNaC::numeric>(e.op(1)).to_double());
    }
    if (is_named(e)) return of_named(named_call(e), point);
    if (GiNaC::is_a<GiNaC::function>(e) && e.nops() == 1) {
        return function(GiNaC::ex_to<GiNaC::function>(e).get_name(), evaluate(e.op(0), point));
    }
    return {0, infinity};
}

bool differs_from_zero(const ex& e, const std::vector<ex>& positive) {
    if (is_constant(e) && sign_of_constant(e) != ConstantSign::unknown) return true;
    constexpr int points = 4, tries = 97; // until they repeat
    GiNaC::lst all{e};
    for (const ex& declared : positive) all.append(declared);
    int inside = 0;
    for (int salt = 1; inside < points && salt <= tries; ++salt) {
        const GiNaC::exmap point = point_for(positive.empty() ? e : ex(all), salt);
        const bool meant = std::all_of(positive.begin(), positive.end(), [&](const ex& declared) {
            const Ball ball = evaluate(declared, point);
            return ball.middle > 0 && ball.excludes_zero();
        });
        if (meant && differs_at(e, point)) return true;
        inside += meant ? 1 : 0;
    }
    return false;
}

bool differs_from_zero(const ex& e) { return differs_from_zero(e, {}); }

Zero vanishes(const ex& e) { return vanishes(e, {}); }

Zero vanishes(const ex& e, const std::vector<ex>& positive) {
    if (e.is_zero()) return Zero::yes;
    if (differs_from_zero(e, positive)) return Zero::no;
    if (e.expand().is_zero()) return Zero::yes;
    return is_small(e) && e.normal().is_zero() ? Zero::yes : Zero::unknown;
}

} // namespace resonform
