// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/interval_length.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/real_ball.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/function_call.hpp"
#include "model/text/regular.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace resonform {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double cancelled = 1e-12; // of the largest term: a sum below this has too few digits
constexpr double tiny_angle = -30;  // ln of an angle that is its own sine, tangent, ...

// sign exp(log): a number of any size. Not known: log is NaN.
struct Size {
    int sign = 0;
    double log = -infinite;
};

constexpr Size unknown{1, none};

double plain(const Size& s) { return s.sign == 0 ? 0 : s.sign * std::exp(s.log); }

Size of_number(double x) {
    if (x == 0) return {};
    return {x < 0 ? -1 : 1, std::log(std::abs(x))};
}

// A rational number may be beyond the doubles, its logarithm is not.
Size of_constant(const GiNaC::ex& e) {
    const GiNaC::ex value = GiNaC::is_exactly_a<GiNaC::numeric>(e) ? e : e.evalf();
    if (!GiNaC::is_a<GiNaC::numeric>(value)) return unknown;
    const auto& number = GiNaC::ex_to<GiNaC::numeric>(value);
    if (!number.is_real()) return unknown;
    if (number.is_zero()) return {};
    return {number.is_positive() ? 1 : -1, GiNaC::log(GiNaC::abs(number)).to_double()};
}

Size sum(const std::vector<Size>& terms) {
    double largest = -infinite;
    for (const Size& term : terms) {
        if (std::isnan(term.log)) return unknown;
        if (term.sign != 0) largest = std::max(largest, term.log);
    }
    if (largest == -infinite) return {};
    double total = 0;
    for (const Size& term : terms)
        if (term.sign != 0)
            total += term.log == largest ? term.sign : term.sign * std::exp(term.log - largest);
    if (!(std::abs(total) >= cancelled)) return unknown;
    return {total < 0 ? -1 : 1, largest + std::log(std::abs(total))};
}

Size times(const Size& a, const Size& b) {
    if (a.sign * b.sign == 0) return std::isnan(a.log + b.log) ? unknown : Size{};
    return {a.sign * b.sign, a.log + b.log};
}

Size raised(const Size& base, const Size& exponent) {
    const double n = plain(exponent);
    if (base.sign == 0) return n > 0 ? Size{} : unknown;
    if (base.sign > 0) return {1, n == 0 ? 0 : base.log * n};
    if (n != std::floor(n)) return unknown;
    return {std::fmod(n, 2) == 0 ? 1 : -1, base.log * n};
}

// Walks an expression at one eps, given by its logarithm.
class Walk {
public:
    Walk(const GiNaC::symbol& eps, double log_eps) : eps_(eps), log_eps_(log_eps) {}

    [[nodiscard]] Size of(const GiNaC::ex& e) const {
        if (e.is_equal(eps_)) return {1, log_eps_};
        if (!e.has(eps_)) return of_constant(e);
        if (GiNaC::is_a<GiNaC::power>(e)) return raised(of(e.op(0)), of(e.op(1)));
        if (GiNaC::is_a<GiNaC::function>(e)) return function(e);
        if (!GiNaC::is_a<GiNaC::add>(e) && !GiNaC::is_a<GiNaC::mul>(e)) return unknown;
        std::vector<Size> parts;
        for (const GiNaC::ex& part : e) parts.push_back(of(part));
        if (GiNaC::is_a<GiNaC::add>(e)) return sum(parts);
        Size result{1, 0};
        for (const Size& factor : parts) result = times(result, factor);
        return result;
    }

private:
    [[nodiscard]] Size function(const GiNaC::ex& e) const {
        const Size argument = of(e.op(0));
        const std::optional<Function> f = function_of(e);
        if (!f) return unknown;
        if (f == Function::exponential) return {1, plain(argument)};
        if (f == Function::logarithm) return argument.sign > 0 ? of_number(argument.log) : unknown;
        const bool tiny = argument.sign == 0 || argument.log < tiny_angle;
        if (tiny && row_of(*f).parity == Parity::odd && f != Function::error_function) return argument;
        RealBall value;
        arb_set_d(value.get(), plain(argument));
        row_of(*f).enclose(value.get(), value.get(), 64);
        if (value.is_finite()) return of_number(nearest_double(value));
        return unknown;
    }

    const GiNaC::symbol& eps_;
    double log_eps_;
};

double ln(const Rational& eps) { return GiNaC::log(GiNaC::numeric(cln::cl_N(eps))).to_double(); }

// ln of an interval; NaN: it is not a positive number, as far as can be told.
double log_length(const GiNaC::ex& fixed, const GiNaC::symbol& eps, double log_eps) {
    const Size size = Walk(eps, log_eps).of(fixed);
    return size.sign > 0 ? size.log : none;
}

[[noreturn]] void complain(const Scene& scene, const Rational& eps, const std::string& rule,
                           const std::string& found, const std::string& hint) {
    const Place place = scene.verify.interval_source
                            ? place_of(*scene.verify.interval_source)
                            : Place{scene.file.string(), 0, 0, "verify.interval", ""};
    bad_input({rule,
               fmt::format("interval = {} at eps = {}: {}", excerpt(scene.verify.interval_text),
                           to_string(eps), found),
               hint, place});
}

std::string spelled(double length) {
    return std::isinf(length) ? "beyond 1e308" : fmt::format("{:g}", length);
}

} // namespace

double length_at(const Scene& scene, const GiNaC::ex& interval, const Rational& eps) {
    constexpr double beyond_double = 1000;
    const System& system = *scene.system;
    const GiNaC::symbol& symbol = system.eps;
    const auto length = where_regular([&] {
        const GiNaC::ex fixed = scene.fixed(interval);
        const double log = log_length(fixed, symbol, ln(eps) / system.eps_root);
        if (std::abs(log) > beyond_double)
            return std::exp(log); // exp(exp(1/eps)) is more than a machine holds
        const GiNaC::ex value = fixed.subs(GiNaC::ex(symbol) == system.small_at(eps)).evalf();
        if (!GiNaC::is_a<GiNaC::numeric>(value)) return none;
        const auto& number = GiNaC::ex_to<GiNaC::numeric>(value);
        return number.is_real() && number.is_positive() ? number.to_double() : none;
    });
    return length.value_or(none);
}

double interval_length(const Scene& scene, const Rational& eps) {
    const double length = length_at(scene, scene.verify.interval, eps);
    if (std::isnan(length))
        complain(scene, eps, "the interval of verification is not a positive number", "it is none",
                 "write one such as \"1/eps\", or leave this eps out");
    if (length < shortest_interval)
        complain(scene, eps, fmt::format("the interval of verification is {:g} or longer", shortest_interval),
                 spelled(length), "lengthen verify.interval, or leave this eps out");
    return length;
}

double bounded_interval_length(const Scene& scene, const Rational& eps) {
    const double length = interval_length(scene, eps);
    if (!(length <= longest_interval))
        complain(scene, eps,
                 fmt::format("an evaluator is made for an interval of at most {:g}", longest_interval),
                 spelled(length), "shorten verify.interval, or take a larger eps");
    return length;
}

// Probes twelve eps from 10^-12 to 10^-24576, each the square of the one before: a growth that is no power
// shows. The power between two neighbours halves its distance to the limit each time if a power is multiplied
// by logarithms (eps^-1 log(1/eps)^k), and does not if there is no limit.
std::optional<int> growth_power(const Scene& scene, const GiNaC::ex& interval) {
    constexpr int probes = 12;
    constexpr double near_whole = 1e-6, settling = 0.75, largest_power = 1e6;
    const GiNaC::ex fixed = scene.fixed(interval);
    double s = 12 * std::log(10.0);
    double before = log_length(fixed, scene.system->eps, -s);
    double power = 0, step = infinite, last_step = infinite;
    for (int k = 1; k < probes; ++k, s *= 2) {
        const double length = log_length(fixed, scene.system->eps, -2 * s);
        if (length == -infinite) return 0; // exp(-1/eps)
        const double next = (length - before) / s;
        if (!std::isfinite(next)) return {};
        last_step = step;
        if (k > 1) step = next - power;
        power = next;
        before = length;
    }
    if (step > near_whole && step > settling * last_step) return {};
    if (power > largest_power) return {};
    return static_cast<int>(std::max(0.0, std::ceil(power - near_whole)));
}

} // namespace resonform
