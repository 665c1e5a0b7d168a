// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/drawn_expression.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform::test {

namespace {

using Texts = std::vector<std::string>;

// {0} is any expression.
const Texts of_any_sign = {"{0}",
                           "sin({0})",
                           "cos(2*({0}))",
                           "tanh({0})",
                           "atan({0})",
                           "sinh({0})",
                           "asinh({0})",
                           "erf({0})",
                           "({0})^2 - 1/2",
                           "({0})*exp(-({0})^2)",
                           "sin({0})*cos({0})",
                           "({0})/(1 + ({0})^2)"};
const Texts above_zero = {"(1 + ({0})^2)",       "sqrt(1 + ({0})^2)",   "1/(1 + ({0})^2)",
                          "1/sqrt(2 + ({0})^2)", "(1 + ({0})^2)^(1/3)", "exp(-({0}))",
                          "exp(({0})/2)",        "cosh({0})",           "(2 + cos({0}))",
                          "(3 + 2*sin({0}))",    "(1 + exp(-({0})^2))", "sqrt(2 + cos({0}))",
                          "log(2 + ({0})^2)",    "(1 + tanh({0})^2)",   "log(1 + exp({0}))"};
// {0} is positive.
const Texts of_positive = {"sqrt({0})", "1/({0})", "({0})^(2/3)", "({0})^(-3/2)", "{0}", "1/(1 + {0})"};

std::string with(const std::string& form, const std::string& argument) {
    return fmt::format(fmt::runtime(form), argument);
}

} // namespace

std::string decimal(Draw& draw, double low, double high) {
    constexpr int rounded = 3; // digits that keep it between low and high
    const int digits = 1 + draw.pick(20);
    std::string text = fmt::format("{:.{}g}", draw.uniform(low, high), std::min(digits, rounded));
    if (digits <= rounded) return text;
    if (text.find('.') == std::string::npos) text += ".";
    for (int k = rounded; k < digits; ++k)
        text += std::to_string(k + 1 < digits ? draw.pick(10) : 1 + draw.pick(9));
    return text;
}

std::string number(Draw& draw, double low, double high) {
    static const Texts exact = {"sqrt(2)", "1/sqrt(3)", "(1 + sqrt(5))/2", "2/3", "7/5", "1"};
    return draw.chance(4) ? draw.any(exact) : decimal(draw, low, high);
}

std::string drawn_function(Draw& draw, const Names& names, bool positive) {
    if (!names.functions.empty() && draw.chance(3)) return draw.any(names.functions);
    if (!names.positive.empty() && draw.chance(3)) {
        const std::string& form = draw.any(of_positive);
        return with(form, draw.any(names.positive));
    }
    Texts all = names.slow;
    all.insert(all.end(), names.positive.begin(), names.positive.end());
    all.insert(all.end(), names.free.begin(), names.free.end());
    if (all.empty()) return "";
    std::string argument = draw.any(all);
    if (draw.chance(4)) argument += "*" + draw.any(all);
    if (draw.chance(6)) argument += " - 1/3";
    return with(draw.any(positive || draw.chance(2) ? above_zero : of_any_sign), argument);
}

std::string drawn_coefficient(Draw& draw, const Names& names, double low, double high) {
    static const Texts simple = {"1", "1/2", "1/3", "2/3", "3/4", "5/4"};
    std::string c = draw.chance(2) ? "-" : "";
    c += draw.chance(3) ? draw.any(simple) : number(draw, low, high);
    c = "(" + c + ")";
    if (!names.free.empty() && draw.chance(4)) c += "*" + draw.any(names.free);
    if (draw.chance(3))
        if (const std::string f = drawn_function(draw, names, false); !f.empty()) c += "*(" + f + ")";
    return c;
}

} // namespace resonform::test
