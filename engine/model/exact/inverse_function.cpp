// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/exact/inverse_function.hpp"

#include "model/exact/written_form.hpp"
#include "model/text/canonical.hpp"
#include "model/text/function_call.hpp"

#include <algorithm>
#include <vector>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::numeric;

// The largest parts of f that hold y and are no sums or products: those of y*(x + 1) + log(y + x) are y and
// log(y + x).
void add_kernels(const ex& f, const GiNaC::symbol& y, std::vector<ex>& kernels) {
    if (!f.has(y)) return;
    if (GiNaC::is_a<GiNaC::add>(f) || GiNaC::is_a<GiNaC::mul>(f)) {
        for (const ex& part : operands(f)) add_kernels(part, y, kernels);
        return;
    }
    const bool known =
        std::any_of(kernels.begin(), kernels.end(), [&](const ex& k) { return k.is_equal(f); });
    if (!known) kernels.push_back(f);
}

class Inverter {
public:
    Inverter(const GiNaC::symbol& y, ExactForm& form, const std::function<bool(const ex&)>& positive)
        : y_(y), form_(form), positive_(positive) {}

    // f(y) = t is taken apart from outside.
    Inverse solve(ex f, ex t) {
        for (;;) {
            if (!isolate(f, t)) return {std::nullopt, ""};
            if (f.is_equal(y_)) return {form_.simplified(t), ""};
            if (!(GiNaC::is_a<GiNaC::power>(f) ? invert_power(f, t) : invert_function(f, t)))
                return {std::nullopt, obstacle_};
        }
    }

private:
    // a*kernel + b = t  ->   kernel = (t - b)/a
    bool isolate(ex& f, ex& t) {
        std::vector<ex> kernels;
        add_kernels(f, y_, kernels);
        if (kernels.size() != 1) return false;
        const GiNaC::symbol kernel("kernel");
        const ex line = f.subs(kernels.front() == kernel, GiNaC::subs_options::no_pattern).expand();
        const ex slope = line.coeff(kernel, 1), rest = line.coeff(kernel, 0);
        if (!(line - slope * kernel - rest).expand().is_zero() || form_.vanishes(slope) != Zero::no)
            return false;
        t = form_.simplified((t - rest) / slope);
        f = kernels.front();
        return true;
    }

    bool proved(const ex& e) {
        if (positive_(e)) return true;
        obstacle_ = written(form_, e) + " > 0";
        return false;
    }
    bool proved_between(const ex& low, const ex& e, const ex& high) {
        return proved(e - low) && proved(high - e);
    }
    // +1, -1, or 0 with the obstacle
    int sign(const ex& e) {
        if (positive_(-e)) return -1;
        return proved(e) ? 1 : 0;
    }

    bool invert_power(ex& f, ex& t) {
        const ex base = f.op(0), exponent = f.op(1);
        f = base;
        if (exponent.is_equal(-1)) {
            t = 1 / t;
            return proved(GiNaC::pow(t, -2));
        }
        if (!exponent.info(GiNaC::info_flags::rational)) return false;
        const bool even = exponent.info(GiNaC::info_flags::even);
        const bool whole = exponent.info(GiNaC::info_flags::integer);
        const int s = even ? sign(base) : whole ? sign(t) : proved(t) ? 1 : 0;
        t = s * GiNaC::pow(even ? t : s * t, 1 / exponent);
        return s != 0;
    }

    bool invert_function(ex& f, ex& t) {
        if (!function_of(f)) return false;
        const ex u = f.op(0);
        const std::optional<ex> value = inverse_of(*function_of(f), u, t);
        if (!value) return false;
        f = u;
        t = *value;
        return true;
    }

    // u, where f(u) = t
    std::optional<ex> inverse_of(Function f, const ex& u, const ex& t) {
        const ex right = GiNaC::Pi / 2;
        const auto where = [](bool holds, const ex& value) {
            return holds ? std::optional<ex>(value) : std::nullopt;
        };
        switch (f) {
        case Function::logarithm: return GiNaC::exp(t);
        case Function::exponential: return where(proved(t), GiNaC::log(t));
        case Function::hyperbolic_sine: return GiNaC::log(t + GiNaC::sqrt(t * t + 1));
        case Function::hyperbolic_cosine: {
            const int s = sign(u);
            return where(s != 0, s * GiNaC::log(t + GiNaC::sqrt(t * t - 1)));
        }
        case Function::hyperbolic_tangent:
            return where(proved_between(-1, t, 1), GiNaC::log((1 + t) / (1 - t)) / 2);
        case Function::arc_tangent: return where(proved_between(-right, t, right), GiNaC::tan(t));
        case Function::arc_sine: return where(proved_between(-right, t, right), GiNaC::sin(t));
        case Function::inverse_hyperbolic_sine: return GiNaC::sinh(t);
        case Function::inverse_hyperbolic_cosine: return where(proved(t), GiNaC::cosh(t));
        case Function::inverse_hyperbolic_tangent: return GiNaC::tanh(t);
        case Function::tangent: return where(proved_between(-right, u, right), GiNaC::atan(t));
        case Function::sine: return where(proved_between(-right, u, right), GiNaC::asin(t));
        case Function::cosine: return where(proved_between(0, u, GiNaC::Pi), right - GiNaC::asin(t));
        default: return std::nullopt;
        }
    }

    const GiNaC::symbol& y_;
    ExactForm& form_;
    const std::function<bool(const ex&)>& positive_;
    std::string obstacle_;
};

} // namespace

Inverse inverse_function(const ex& f, const GiNaC::symbol& y, const ex& t, ExactForm& form,
                         const std::function<bool(const ex&)>& positive) {
    return Inverter(y, form, positive).solve(f, t);
}

} // namespace resonform
