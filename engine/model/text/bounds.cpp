// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/text/bounds.hpp"

#include "algebra/number/number.hpp"
#include "model/text/function_call.hpp"

#include <algorithm>
#include <string_view>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

Bounds sum(const Bounds& a, const Bounds& b) {
    Bounds result;
    if (a.low && b.low) result.low = *a.low + *b.low;
    if (a.high && b.high) result.high = *a.high + *b.high;
    return result;
}

Bounds scaled(const numeric& c, const Bounds& a) {
    Bounds result;
    if (a.low) result.low = c * *a.low;
    if (a.high) result.high = c * *a.high;
    if (c.is_negative()) std::swap(result.low, result.high);
    return result;
}

// Of factors that are bounded on both sides, or not negative.
Bounds product_of_bounds(const Bounds& a, const Bounds& b) {
    if (a.low && a.high && b.low && b.high) {
        const numeric ends[] = {*a.low * *b.low, *a.low * *b.high, *a.high * *b.low, *a.high * *b.high};
        return {*std::min_element(std::begin(ends), std::end(ends)),
                *std::max_element(std::begin(ends), std::end(ends))};
    }
    const bool positive = a.low && b.low && !a.low->is_negative() && !b.low->is_negative();
    return positive ? Bounds{*a.low * *b.low, std::nullopt} : Bounds{};
}

Bounds bounds_of_function(const ex& e) {
    const std::optional<Function> f = function_of(e);
    if (!f) return {};
    const auto bound = [](std::string_view text) {
        return text.empty() ? std::nullopt : std::optional(numeric(cln::cl_N(parse_rational(text))));
    };
    return {bound(row_of(*f).low), bound(row_of(*f).high)};
}

} // namespace

Bounds bounds_of(const ex& e, const std::function<bool(const ex&)>& nonnegative) {
    Bounds result;
    if (is_a<numeric>(e)) {
        if (ex_to<numeric>(e).is_real()) result = {ex_to<numeric>(e), ex_to<numeric>(e)};
        return result;
    }
    if (is_a<GiNaC::add>(e)) {
        result = {numeric(0), numeric(0)};
        for (const ex& term : e) result = sum(result, bounds_of(term, nonnegative));
    } else if (is_a<GiNaC::mul>(e)) {
        numeric number = 1;
        result = {numeric(1), numeric(1)};
        for (const ex& factor : e) {
            if (is_a<numeric>(factor) && ex_to<numeric>(factor).is_real())
                number *= ex_to<numeric>(factor);
            else
                result = product_of_bounds(result, bounds_of(factor, nonnegative));
        }
        result = scaled(number, result);
    } else if (is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::posint)) {
        const Bounds base = bounds_of(e.op(0), nonnegative);
        const int n = ex_to<numeric>(e.op(1)).to_int();
        result = base;
        for (int k = 1; k < n; ++k) result = product_of_bounds(result, base);
    } else if (is_a<GiNaC::function>(e)) {
        result = bounds_of_function(e);
    }
    if (!(result.low && !result.low->is_negative()) && nonnegative(e)) result.low = numeric(0);
    return result;
}

} // namespace resonform
