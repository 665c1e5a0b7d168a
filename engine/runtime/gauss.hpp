// SPDX-License-Identifier: MIT
// Gauss's quadrature with n nodes on [-1, 1], exact up to degree 2n - 1, and what else follows from values at
// its nodes. Computed once for a type, in its own memory:
//
//   Gauss<double, 24>::once().sum([](double x) { return std::exp(x); })   ->   exp(1) - exp(-1)
#ifndef RESONFORM_RUNTIME_GAUSS
#define RESONFORM_RUNTIME_GAUSS

#include "runtime/status.hpp"
#include "runtime/twice.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace resonform {

template <class Number, std::size_t n> class Gauss {
public:
    using Values = std::array<Number, n>;

    Values node{}, weight{};
    // Row 0 and 1: the last and the last but one coefficient of the Legendre series, from the values at the
    // nodes.
    std::array<Values, 2> last{};
    // Row m: what the value at node m adds to the integrals from -1 to each node.
    std::array<Values, n> before{};

    static const Gauss& once() {
        static const Gauss table;
        return table;
    }

    // The integrals from -1 to each node, from the values there; side by side, so that no sum waits for its
    // last term.
    template <class Value> std::array<Value, n> integrals(const std::array<Value, n>& values) const {
        std::array<Value, n> sums{};
        for (std::size_t m = 0; m < n; ++m)
            for (std::size_t j = 0; j < n; ++j) sums[j] = sums[j] + Value(before[m][j]) * values[m];
        return sums;
    }

    // The integral over [-1, 1].
    template <class Function> Number sum(const Function& f) const {
        Number result = Number(0);
        for (std::size_t j = 0; j < n; ++j) result = result + weight[j] * f(node[j]);
        return result;
    }

private:
    using Wide = WideNumber<Number>;
    using Legendre = std::array<Wide, n + 1>; // P_0(x) ... P_n(x)

    static Wide whole(std::size_t k) { return Wide(static_cast<int>(k)); }

    static Legendre legendre(const Wide& x) {
        Legendre p{};
        p[0] = Wide(1);
        p[1] = x;
        for (std::size_t k = 1; k < n; ++k)
            p[k + 1] = (whole(2 * k + 1) * x * p[k] - whole(k) * p[k - 1]) / whole(k + 1);
        return p;
    }

    static Wide slope(const Wide& x, const Legendre& p) {
        return whole(n) * (p[n - 1] - x * p[n]) / (Wide(1) - x * x);
    }

    Gauss() {
        std::array<Legendre, n> p{};
        std::array<Wide, n> weights{};
        for (std::size_t j = 0; j < n; ++j) {
            using std::cos;
            const double guess =
                cos(math::pi<double>() * (static_cast<double>(j) + 0.75) / (static_cast<double>(n) + 0.5));
            Wide x{guess};
            for (int digits = 6; digits < 2 * math::digits<Wide>; digits *= 2) {
                const Legendre at_x = legendre(x);
                x = x - at_x[n] / slope(x, at_x);
            }
            p[j] = legendre(x);
            const Wide steep = slope(x, p[j]);
            weights[j] = Wide(2) / ((Wide(1) - x * x) * steep * steep);
            node[j] = static_cast<Number>(x);
            weight[j] = static_cast<Number>(weights[j]);
        }
        const Wide half = Wide(1) / Wide(2);
        for (std::size_t m = 0; m < n; ++m) {
            for (const std::size_t k : {n - 1, n - 2})
                last[n - 1 - k][m] = static_cast<Number>(whole(2 * k + 1) * half * weights[m] * p[m][k]);
            for (std::size_t j = 0; j < n; ++j) {
                Wide integral = p[j][1] + Wide(1);
                for (std::size_t k = 1; k < n; ++k)
                    integral = integral + p[m][k] * (p[j][k + 1] - p[j][k - 1]);
                before[m][j] = static_cast<Number>(half * weights[m] * integral);
            }
        }
    }
};

// Nodes and weights for a number, or for the lanes of several.
template <class Number, std::size_t n> using GaussFor = Gauss<typename OneOf<Number>::type, n>;

// sum + a b; numbers of several parts have their own.
template <class Number> Number added_product(const Number& sum, const Number& a, const Number& b) {
    return sum + a * b;
}

// A sum over the nodes, value by value, with what tells whether it is resolved in the type Seen.
template <class Number, class Seen, std::size_t n> struct GaussSum {
    const GaussFor<Number, n>& gauss;
    const GaussFor<Seen, n>& seen;
    Number whole = Number(0);
    Seen last = Seen(0), before = Seen(0), size = Seen(0); // coefficients; the largest value

    void add(std::size_t j, const Number& number) { add(j, number, static_cast<Seen>(number)); }
    // number is summed. value is the whole integrand there, of which number may be a part; it tells whether
    // the nodes suffice.
    void add(std::size_t j, const Number& number, const Seen& value) {
        whole = added_product(whole, Number(gauss.weight[j]), number);
        last = last + Seen(seen.last[0][j]) * value;
        before = before + Seen(seen.last[1][j]) * value;
        size = math::larger(size, Seen(math::magnitude(value)));
    }
    // The last coefficient, or 1/8 of the one before.
    [[nodiscard]] Seen end() const {
        return math::larger(Seen(math::magnitude(last)), Seen(math::magnitude(before) / Seen(8)));
    }
};

// A last coefficient, relative to the integrand, that leaves the sum resolved to `wanted`, relative to it,
// too: the error is about its square, or up to a million times that where a small part is far less smooth
// than all else.
template <class Real> Real square_enough(const Real& wanted) {
    using math::sqrt;
    return sqrt(wanted) / Real(1000);
}

// Of values with an infinite sum.
template <class Real, class Values> Status fault(const Values& values) {
    for (const auto& value : values) {
        const Real x = static_cast<Real>(value);
        if (math::is_not_a_number(x)) return Status::outside_domain;
        if (!math::finite(x)) return Status::overflow;
    }
    return Status::overflow;
}

} // namespace resonform

#endif
