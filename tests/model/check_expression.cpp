// SPDX-License-Identifier: GPL-3.0-or-later
// Random expressions: what is read has the value of what was written, computed beside the reader.
#include "algebra/number/number.hpp"
#include "model/text/expression.hpp"

#include <gtest/gtest.h>

#include <random>

namespace resonform {
namespace {

// A text, its value where x = 3/7 and y = -5/2, and how tightly its outermost operator binds.
struct Sample {
    std::string text;
    Rational value;
    int binding = 4; // 1 sum, 2 product, 3 sign, 4 power and primary
};

class Writer {
public:
    explicit Writer(unsigned seed) : random_(seed) {}

    Sample expression(int depth) {
        if (depth == 0) return leaf();
        switch (pick(6)) {
        case 0: return binary(depth, '+', 1);
        case 1: return binary(depth, '-', 1);
        case 2: return binary(depth, '*', 2);
        case 3: return binary(depth, '/', 2);
        case 4: return negation(depth);
        default: return power(depth);
        }
    }

private:
    int pick(int below) { return static_cast<int>(random_() % static_cast<unsigned>(below)); }

    Sample leaf() {
        switch (pick(4)) {
        case 0: return {"x", Rational(3) / 7, 4};
        case 1: return {"y", Rational(-5) / 2, 4};
        case 2: {
            const int n = pick(20);
            return {std::to_string(n), Rational(n), 4};
        }
        default: {
            const int n = pick(1000);
            const std::string digits = std::to_string(1000 + n).substr(1);
            return {"0." + digits, Rational(n) / 1000, 4};
        }
        }
    }

    std::string space() { return std::string(static_cast<std::size_t>(pick(2)), ' '); }

    // In parentheses where the grammar needs them, and sometimes where it does not.
    std::string inside(const Sample& s, int binding) {
        if (s.binding < binding || pick(5) == 0) return "(" + space() + s.text + ")";
        return s.text;
    }

    Sample binary(int depth, char op, int binding) {
        const Sample a = expression(depth - 1);
        const Sample b = expression(depth - 1);
        if (op == '/' && b.value == 0) return a;
        Rational value = 0;
        if (op == '+') value = a.value + b.value;
        if (op == '-') value = a.value - b.value;
        if (op == '*') value = a.value * b.value;
        if (op == '/') value = a.value / b.value;
        return {inside(a, binding) + space() + op + space() + inside(b, binding + 1), value, binding};
    }

    Sample negation(int depth) {
        const Sample a = expression(depth - 1);
        return {"-" + space() + inside(a, 3), -a.value, 3};
    }

    Sample power(int depth) {
        Sample a = expression(depth - 1);
        const int n = pick(5) - 2;
        if (a.value == 0 && n <= 0) return a;
        const std::string base =
            a.binding < 4 || a.text.find('^') != std::string::npos || a.text.find("**") != std::string::npos
                ? "(" + a.text + ")"
                : a.text;
        const Rational value = n == 0 ? Rational(1) : cln::expt(a.value, n);
        return {base + (pick(2) == 0 ? "^" : "**") + std::to_string(n), value, 4};
    }

    std::mt19937 random_;
};

// y at -5/2 and x at 3/7 make no denominator of a sample vanish: its value was computed there. The
// reader may still find a denominator that is zero for all values only if it is zero there.
TEST(CheckExpression, ReadingKeepsTheValue) {
    const GiNaC::symbol x("x"), y("y");
    Scope scope;
    scope.define("x", x);
    scope.define("y", y);
    const GiNaC::exmap point{{x, GiNaC::numeric(3, 7)}, {y, GiNaC::numeric(-5, 2)}};
    for (unsigned seed = 1; seed <= 2000; ++seed) {
        const Sample sample = Writer(seed).expression(1 + static_cast<int>(seed % 5));
        const GiNaC::ex read = read_expression(sample.text, scope, SourceText{});
        const GiNaC::ex expected = GiNaC::numeric(cln::cl_N(sample.value));
        ASSERT_TRUE((read.subs(point) - expected).is_zero())
            << "seed " << seed << ": " << sample.text << " is " << to_string(sample.value) << ", read as "
            << read.subs(point);
    }
}

} // namespace
} // namespace resonform
