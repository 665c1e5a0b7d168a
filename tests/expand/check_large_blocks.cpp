// SPDX-License-Identifier: GPL-3.0-or-later
// Modes of blocks of more than two states: A T = T Lambda and rows from the inverse, for known spectra and
// for random matrices made from them.
#include "model/text/enclosure.hpp"
#include "support/error_when.hpp"
#include "support/exact.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <sstream>

namespace resonform {

namespace {

using Number = std::complex<double>;

// Parameters near one.
GiNaC::exmap point_of(const System& system) {
    GiNaC::exmap point;
    for (const Parameter& p : system.parameters)
        point[p.symbol] = 1 + GiNaC::numeric(static_cast<long>(point.size() + 1), 100);
    return point;
}

Number value(const Complex& e, const GiNaC::exmap& point) {
    const auto re = enclose(e.re, point), im = enclose(e.im, point);
    EXPECT_TRUE(re && im);
    return {nearest_double(re.value()), nearest_double(im.value())};
}

// The laws of a modal basis; returns the eigenvalues, those of both of a pair.
std::vector<Number> eigenvalues_checked(const GradedField& field) {
    const GiNaC::exmap point = point_of(field.system());
    const ModalBasis& basis = field.basis;
    GiNaC::exmap at_rest{{field.system().eps, 0}};
    for (const State& s : field.first_order->states) at_rest[s.symbol] = 0;
    const std::size_t n = basis.states.size();
    std::vector<Number> eigenvalues;
    for (const ModeShape& mode : basis.modes) {
        const Number lambda = value(mode.eigenvalue, point);
        eigenvalues.push_back(lambda);
        if (!mode.is_real()) {
            eigenvalues.push_back(std::conj(lambda));
            EXPECT_GT(lambda.imag(), 0);
        }
        for (std::size_t s = 0; s < n; ++s) {
            const State& state = field.first_order->states[basis.states[s]];
            Number residual = -lambda * value(mode.column[s], point);
            for (std::size_t t = 0; t < n; ++t) {
                const GiNaC::symbol& u = field.first_order->states[basis.states[t]].symbol;
                residual +=
                    value({state.rate.diff(u).subs(at_rest), 0}, point) * value(mode.column[t], point);
            }
            EXPECT_LT(std::abs(residual), 1e-9);
            if (basis.states[s] == mode.pivot) {
                EXPECT_NEAR(std::abs(value(mode.column[s], point)), mode.is_real() ? 1 : 0.5, 1e-9);
            }
        }
        for (const ModeShape& other : basis.modes) {
            Number product, conjugate;
            for (std::size_t s = 0; s < n; ++s) {
                product += value(mode.row[s], point) * value(other.column[s], point);
                conjugate += value(mode.row[s], point) * std::conj(value(other.column[s], point));
            }
            EXPECT_NEAR(std::abs(product - Number(&mode == &other ? 1 : 0)), 0, 1e-9);
            if (!other.is_real()) {
                EXPECT_NEAR(std::abs(conjugate), 0, 1e-9);
            }
        }
    }
    EXPECT_EQ(eigenvalues.size(), n);
    return eigenvalues;
}

std::string file(const std::string& parameters,
                 const std::vector<std::pair<std::string, std::string>>& equations) {
    std::string text = "[system]\nname = \"s\"\n[parameters]\n" + parameters + "[variables]\n";
    for (const auto& [name, equation] : equations) text += name + " = { role = \"fast\" }\n";
    text += "[equations]\n";
    for (const auto& [name, equation] : equations) text += name + " = \"" + equation + "\"\n";
    return text;
}

std::string message(const std::string& toml) {
    const Error e = test::error_when([&] { test::field_from(toml); }, toml);
    EXPECT_EQ(e.kind(), ErrorKind::refused) << e.what();
    return e.what();
}

// n oscillators in a row between walls, k and m symbols.
std::string chain(int n) {
    std::vector<std::pair<std::string, std::string>> equations;
    for (int j = 1; j <= n; ++j) {
        std::string force = fmt::format("2*x{}", j);
        if (j > 1) force += fmt::format(" - x{}", j - 1);
        if (j < n) force += fmt::format(" - x{}", j + 1);
        equations.emplace_back(fmt::format("x{}", j), fmt::format("m*x{}'' + k*({}) = 0", j, force));
    }
    return file("k = { positive = true }\nm = { positive = true }\n", equations);
}

} // namespace

TEST(LargeBlocks, ChainsOfOscillators) {
    for (const int n : {3, 4, 5}) {
        const auto field = test::field_from(chain(n));
        const std::vector<Number> found = eigenvalues_checked(*field);
        ASSERT_EQ(field->modes.size(), static_cast<std::size_t>(n));
        for (int j = 1; j <= n; ++j) { // 2 sqrt(k/m) sin(j pi/(2 n + 2)), lower ones first
            const double omega = 2 * std::sqrt(1.01 / 1.02) * std::sin(j * std::acos(-1.0) / (2 * n + 2));
            EXPECT_NEAR(found[2 * static_cast<std::size_t>(j) - 2].imag(), omega, 1e-9) << n;
        }
    }
}

TEST(LargeBlocks, GyroscopicWithSymbols) {
    // lambda^4 + (a + b + 4 w^2) lambda^2 + a b
    const auto field =
        test::field_from(file("a = { positive = true }\nb = { positive = true }\nw = { positive = "
                              "true }\n[domain]\npositive = [\"(a + b + 4*w^2)^2 - 4*a*b\"]\n",
                              {{"x", "x'' - 2*w*y' + a*x = 0"}, {"y", "y'' + 2*w*x' + b*y = 0"}}));
    const std::vector<Number> found = eigenvalues_checked(*field);
    const double a = 1.01, b = 1.02, w = 1.03, sum = a + b + 4 * w * w;
    EXPECT_NEAR(found[0].imag(), std::sqrt((sum - std::sqrt(sum * sum - 4 * a * b)) / 2), 1e-9);
}

TEST(LargeBlocks,
     FoucaultsPendulumDenests) { // lambda^4 + (2 a + 4 w^2) lambda^2 + a^2: roots w +- sqrt(a + w^2)
    const auto field =
        test::field_from(file("a = { positive = true }\nw = { positive = true }\n",
                              {{"x", "x'' - 2*w*y' + a*x = 0"}, {"y", "y'' + 2*w*x' + a*y = 0"}}));
    const std::vector<Number> found = eigenvalues_checked(*field);
    EXPECT_NEAR(found[0].imag(), std::sqrt(1.01 + 1.02 * 1.02) - 1.02, 1e-9);
    EXPECT_NEAR(found[2].imag(), std::sqrt(1.01 + 1.02 * 1.02) + 1.02, 1e-9);
}

TEST(LargeBlocks, QuadruplesAndSaddles) {
    for (const auto& [b, c] :
         std::vector<std::pair<int, int>>{{1, 1}, {-1, 1}, {0, 2}, {-5, 3}, {1, -3}, {-1, -3}}) {
        const std::string equation = fmt::format("x'''' + ({})*x'' + ({})*x = 0", b, c);
        for (const Number& lambda : eigenvalues_checked(*test::field_from(file("", {{"x", equation}}))))
            EXPECT_LT(std::abs(std::pow(lambda, 4) + double(b) * lambda * lambda + double(c)), 1e-9);
    }
}

// A = P D P^-1 with D of blocks (a, w; -w, a) and numbers, P of small integers: with multiplicities.
TEST(LargeBlocks, RandomMatricesOfKnownSpectra) {
    std::mt19937 random(3);
    const auto integer = [&](int low, int high) {
        return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
    };
    for (int trial = 0; trial < 12; ++trial) {
        constexpr unsigned n = 5;
        GiNaC::matrix d(n, n), p(n, n);
        std::vector<Number> expected;
        for (unsigned k = 0; k < n; ++k) {
            const int a = integer(-2, 1), w = integer(1, 3);
            if (k % 2 == 0 && k + 1 < n) {
                d(k, k) = d(k + 1, k + 1) = a;
                d(k, k + 1) = w;
                d(k + 1, k) = -w;
                expected.insert(expected.end(), {Number(a, w), Number(a, -w)});
                ++k;
            } else {
                d(k, k) = a;
                expected.emplace_back(a, 0);
            }
        }
        do {
            for (unsigned i = 0; i < n; ++i)
                for (unsigned j = 0; j < n; ++j) p(i, j) = integer(-2, 2);
        } while (p.determinant().is_zero());
        const GiNaC::matrix a = p.mul(d).mul(p.inverse());
        std::vector<std::pair<std::string, std::string>> equations;
        for (unsigned i = 0; i < n; ++i) {
            std::string rate;
            for (unsigned j = 0; j < n; ++j) {
                std::ostringstream number;
                number << a(i, j);
                rate += fmt::format(" + ({})*x{}", number.str(), j);
            }
            equations.emplace_back(fmt::format("x{}", i), fmt::format("x{}' = 0{}", i, rate));
        }
        std::vector<Number> found = eigenvalues_checked(*test::field_from(file("", equations)));
        for (const Number& lambda : expected) {
            const auto at = std::find_if(found.begin(), found.end(),
                                         [&](const Number& f) { return std::abs(f - lambda) < 1e-9; });
            ASSERT_NE(at, found.end()) << "trial " << trial << ", " << lambda;
            found.erase(at);
        }
    }
}

TEST(LargeBlocks, WhatHasNoClosedFormIsRefusedWithTheMend) {
    const std::string cubic = message(file("", {{"x", "x''' + x' + x = 0"}}));
    EXPECT_NE(cubic.find("lambda^3"), std::string::npos) << cubic;
    EXPECT_NE(cubic.find("[modes]"), std::string::npos) << cubic;
    const std::string sign = message(file(
        "a = { positive = true }\n", {{"x", "x'' - 2*y' + a*x = 0"}, {"y", "y'' + 2*x' - a^2*y + y = 0"}}));
    EXPECT_NE(sign.find("declare what is positive"), std::string::npos) << sign;
}

TEST(LargeBlocks, NotSemisimple) { // (lambda^2 + 1)^2 with one eigenvector
    const std::string m = message(file("", {{"x", "x'''' + 2*x'' + x = 0"}}));
    EXPECT_NE(m.find("semisimple"), std::string::npos) << m;
    EXPECT_NE(m.find("2-fold factor"), std::string::npos) << m;
}

TEST(LargeBlocks, AreDrivenAndDrive) { // a chain of three drives one more, and is driven by a damped one
    const std::string text = file("", {{"f", "f' + f = 0"},
                                       {"x", "x'' + 2*x - y + f = 0"},
                                       {"y", "y'' + 2*y - x - w = 0"},
                                       {"w", "w'' + 2*w - y = 0"},
                                       {"v", "v'' + 7*v + x' = 0"}});
    EXPECT_EQ(eigenvalues_checked(*test::field_from(text)).size(), 9U);
}

} // namespace resonform
