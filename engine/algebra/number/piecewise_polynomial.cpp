// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/piecewise_polynomial.hpp"

#include <cln/cln.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace resonform {

namespace {

using Values = std::vector<Rational>;

constexpr int most_halvings = 40;

// sum_j c_j (h x)^j on 0 <= x <= 1 by its Bernstein coefficients b_i = sum_{j <= i} C(i, j)/C(n, j) c_j h^j.
Values bernstein(Values c, const Rational& h) {
    const int n = static_cast<int>(c.size()) - 1;
    Rational power = 1;
    for (Rational& x : c) {
        x = x * power;
        power = power * h;
    }
    Values b(c.size());
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= i; ++j)
            b[static_cast<std::size_t>(i)] =
                b[static_cast<std::size_t>(i)] +
                Rational(cln::binomial(static_cast<unsigned>(i), static_cast<unsigned>(j))) /
                    cln::binomial(static_cast<unsigned>(n), static_cast<unsigned>(j)) *
                    c[static_cast<std::size_t>(j)];
    return b;
}

// The two halves (de Casteljau).
std::pair<Values, Values> halves(Values b) {
    Values left, right;
    for (std::size_t n = b.size(); n > 0; --n) {
        left.push_back(b.front());
        right.insert(right.begin(), b[n - 1]);
        for (std::size_t k = 0; k + 1 < n; ++k) b[k] = (b[k] + b[k + 1]) / 2;
    }
    return {std::move(left), std::move(right)};
}

// The values lie between the least and the largest coefficient, and are the first and the last at the ends.
bool is_positive(const Values& b, int halvings) {
    if (std::all_of(b.begin(), b.end(), [](const Rational& x) { return x > 0; })) return true;
    if (halvings == 0 || !(b.front() > 0) || !(b.back() > 0)) return false;
    const auto [left, right] = halves(b);
    return is_positive(left, halvings - 1) && is_positive(right, halvings - 1);
}

} // namespace

bool PiecewisePolynomial::holds(const Rational& x) const {
    return !(x < exact_rational(breakpoints.front())) && !(exact_rational(breakpoints.back()) < x);
}

Rational PiecewisePolynomial::at(const Rational& x, int derivative) const {
    std::size_t piece = pieces() - 1;
    while (piece > 0 && x < exact_rational(breakpoints[piece])) --piece;
    const Rational u = x - exact_rational(breakpoints[piece]);
    const auto terms = static_cast<std::size_t>(degree) + 1;
    Rational sum = 0;
    for (int j = degree; j >= derivative; --j) {
        Rational factor = 1;
        for (int k = 0; k < derivative; ++k) factor = factor * (j - k);
        sum = sum * u + factor * exact_rational(coefficients[piece * terms + static_cast<std::size_t>(j)]);
    }
    return sum;
}

int PiecewisePolynomial::sign() const {
    const int wanted = coefficients.front() > 0 ? 1 : -1;
    const auto terms = static_cast<std::size_t>(degree) + 1;
    for (std::size_t k = 0; k < pieces(); ++k) {
        Values c;
        for (std::size_t j = 0; j < terms; ++j)
            c.push_back(wanted * exact_rational(coefficients[k * terms + j]));
        const Rational width = exact_rational(breakpoints[k + 1]) - exact_rational(breakpoints[k]);
        if (!is_positive(bernstein(std::move(c), width), most_halvings)) return 0;
    }
    return wanted;
}

std::string PiecewisePolynomial::text() const {
    std::string out = fmt::format("data {} {}\n", name, degree);
    for (const auto* list : {&breakpoints, &coefficients}) {
        for (const double x : *list) out += fmt::format("{:a} ", x);
        out += "\n";
    }
    return out;
}

} // namespace resonform
