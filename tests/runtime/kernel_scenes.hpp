// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes for the evaluator kernel in any real type, and their values by the formula.
#pragma once

#include "runtime/kernel/tables.hpp"
#include "runtime/table.hpp"
#include "runtime/twice.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <array>
#include <cmath>
#include <string>

namespace resonform::test {

using kernel::Term;
using kernel::Wave;
using Fifty = boost::multiprecision::cpp_bin_float_50;

// The phases of a scene in one type of number.
template <class Wide, class Scene> struct PhasesOf {
    const Scene& scene;
    std::array<Wide, Scene::phases> start;
    std::array<Wide, Scene::phases> operator()(const Wide& T) const { return scene.rate(T); }
};

// The pendulum at order 3, as emitted into generated/almost_holonomic_pendulum/third_order.hpp.
template <class Real> struct Pendulum {
    static constexpr std::size_t phases = 1, outputs = 3;
    static constexpr std::array<Term<1>, 12> terms{{{0, Wave::one, {0}},
                                                    {0, Wave::cosine, {1}},
                                                    {0, Wave::sine, {1}},
                                                    {0, Wave::cosine, {3}},
                                                    {1, Wave::one, {0}},
                                                    {1, Wave::cosine, {1}},
                                                    {1, Wave::sine, {1}},
                                                    {1, Wave::sine, {2}},
                                                    {2, Wave::one, {0}},
                                                    {2, Wave::cosine, {1}},
                                                    {2, Wave::sine, {1}},
                                                    {2, Wave::sine, {2}}}};
    Real eps, end;
    double reach;                // in t
    std::array<double, 3> scale; // what errors are judged by
    PrimitiveTable<Real, 1> drift{};

    explicit Pendulum(double e, double last = 1)
        : eps(e), end(last), reach(kernel::last_time(e, last)), scale{e, 2, 2.5} {
        Real reach = end;
        drift.build(
            [](const Real& T) {
                const Powers<Real> p(T);
                return std::array<Real, 1>{T * T * p.per * p.per + p.quarter * p.per / Real(4)};
            },
            reach);
    }
    template <class Number> struct Powers { // of s = 1 + T^2
        Number s, per, half, quarter, eighth;
        explicit Powers(const Number& T) {
            using math::sqrt;
            s = T * T + Number(1);
            per = Number(1) / s;
            half = sqrt(s);
            quarter = sqrt(half);
            eighth = sqrt(quarter);
        }
    };
    template <class Number> std::array<Real, 12> amplitudes(const Number& fine) const {
        const auto T = static_cast<Real>(fine);
        using math::asinh;
        const Powers<Real> p(T);
        const Real e2 = eps * eps, e3 = e2 * eps;
        const Real m12 = p.half * p.per, m38 = p.half * p.eighth * p.per, m78 = p.eighth * p.per;
        const Real m98 = p.half * p.quarter * p.eighth * p.per * p.per,
                   m138 = p.quarter * p.eighth * p.per * p.per;
        const Real q = -drift(T)[0] * e2;
        return {e2 * T * p.half * p.per * p.per,
                eps * (p.half * p.quarter * p.eighth * p.per +
                       e2 * (m138 * (Real(1) / Real(16) - Real(3) / Real(128) * T * T) + m38 / Real(32))),
                e2 * T * m78 / Real(8),
                -e3 * m38 / Real(192),
                asinh(T) + q + Real(1),
                -e3 * m98 * (T * T / Real(8) + Real(1)),
                -e2 * T * m38,
                -e3 * m12 / Real(8),
                p.half + Real(1) - e2 / Real(2) * (p.per + p.quarter),
                -e3 * Real(7) / Real(8) * T * m98,
                e2 * m38,
                -e3 * T * m12 / Real(8)};
    }
    template <class Wide> std::array<Wide, 1> rate(const Wide& T) const {
        const Powers<Wide> p(T);
        const Wide e(eps);
        return {(p.half * p.quarter * p.per -
                 e * e * (T * T * p.quarter * p.per * p.per / Wide(32) + p.half * p.per / Wide(16))) /
                e};
    }
    template <class Wide> PhasesOf<Wide, Pendulum> rates() const { return {*this, {}}; }
};

// Two phases with 20 rows, three with 31: amplitudes fall with the size of the harmonic.
template <class Real, std::size_t Phases> struct Many {
    static constexpr std::size_t phases = Phases, outputs = 3, count = Phases == 2 ? 20 : 31;
    static constexpr std::array<Term<Phases>, count> terms = [] {
        std::array<Term<Phases>, count> result{};
        std::size_t n = 0;
        for (unsigned o = 0; o < outputs; ++o) result[n++].output = o;
        for (int size = 1; n < count; ++size)
            for (int i = 0; i <= size && n < count; ++i)
                for (int sign : {1, -1}) {
                    if (n >= count || (i == 0 && sign < 0)) continue;
                    Term<Phases> t;
                    t.output = static_cast<unsigned>(n % outputs);
                    t.wave = n % 2 == 0 ? Wave::cosine : Wave::sine;
                    if (i > 0) t.k[0] = i;
                    t.k[size % 2 == 1 && i == 1 ? Phases - 1 : 1] += i == 0 ? size : sign * (size - i);
                    if (i == size && sign < 0) continue;
                    result[n++] = t;
                }
        return result;
    }();
    Real eps, end;
    double reach;
    std::array<double, 3> scale{1, 1, 1};

    explicit Many(double e, double last = 1) : eps(e), end(last), reach(kernel::last_time(e, last)) {}
    template <class Number> std::array<Real, count> amplitudes(const Number& fine) const {
        const auto T = static_cast<Real>(fine);
        std::array<Real, count> result;
        for (std::size_t r = 0; r < count; ++r) {
            int size = 0;
            for (const int k : terms[r].k) size += k < 0 ? -k : k;
            Real x = Real(1) / (Real(2) + T * Real(static_cast<int>(r % 5)) / Real(7));
            for (int i = 1; i < size; ++i) x = x * eps;
            result[r] = x;
        }
        return result;
    }
    template <class Wide> PhasesOf<Wide, Many> rates() const {
        PhasesOf<Wide, Many> result{*this, {}};
        for (std::size_t p = 0; p < Phases; ++p) result.start[p] = Wide(static_cast<int>(p)) / Wide(4);
        return result;
    }
    template <class Wide> std::array<Wide, Phases> rate(const Wide& T) const {
        std::array<Wide, Phases> result;
        for (std::size_t p = 0; p < Phases; ++p)
            result[p] = (Wide(1) + Wide(static_cast<int>(p)) / Wide(3) + T / (Wide(5) + T)) / Wide(eps);
        return result;
    }
};

// Two angles and two exponents: an output that keeps something, one of which nothing is left, one that does
// not turn.
template <class Real> struct Layers {
    static constexpr std::size_t phases = 4, decays = 2, outputs = 3;
    static constexpr std::array<Term<4>, 9> terms{{{0, Wave::one, {}},
                                                   {0, Wave::cosine, {1, 0, 0, 0}},
                                                   {0, Wave::sine, {1, -1, 1, 0}},
                                                   {0, Wave::cosine, {1, 1, 1, 1}},
                                                   {1, Wave::cosine, {0, 1, 1, 0}},
                                                   {1, Wave::sine, {0, 1, 1, 0}},
                                                   {1, Wave::cosine, {0, 0, 2, 0}},
                                                   {1, Wave::sine, {2, 1, 3, 1}},
                                                   {2, Wave::cosine, {0, 0, 0, 1}}}};
    Real eps, end;
    double reach;

    explicit Layers(double e, double last = 1) : eps(e), end(last), reach(kernel::last_time(e, last)) {}
    template <class Number> std::array<Real, 9> amplitudes(const Number& fine) const {
        const auto T = static_cast<Real>(fine);
        const Real s = Real(1) + T * T;
        return {eps * s,       Real(1), eps * eps * T, eps * s, Real(1) / s, eps / (s + Real(1)), eps * s,
                eps * eps * T, s};
    }
    // What errors are judged by: the slower exponential, e^chi, chi = -(10 T + T^2/2)/eps; the last -2T/eps.
    std::array<double, 3> scale_at(const Fifty& t) const {
        const Fifty e(eps), T = e * t, slow = exp(-(10 * T + T * T / 2) / e), last = exp(-2 * T / e);
        return {1, static_cast<double>(slow), static_cast<double>(last)};
    }
    template <class Wide> PhasesOf<Wide, Layers> rates() const {
        return {*this, {Wide(0), Wide(1) / Wide(4), Wide(0), Wide(0)}};
    }
    template <class Wide> std::array<Wide, 4> rate(const Wide& T) const {
        const Wide per = Wide(1) / Wide(eps);
        return {per * (Wide(1) + T / (Wide(5) + T)), per * Wide(3) / Wide(2), -per * (Wide(10) + T),
                -Wide(2) * per};
    }
};

// Outputs made of atoms and turned modes by every kind of operation: an angle and an exponent, slots 0, 1 and
// 2; atoms 4 ... 6, one of which is 0 and one of which passes 0.
template <class Real> struct Atoms {
    static constexpr std::size_t phases = 2, decays = 1, outputs = 4;
    static constexpr std::array<Term<2>, 3> terms{{{0}, {1}, {2}}};
    using Kind = kernel::Kind;
    static constexpr std::array<kernel::Operation, 14> operations{
        {{Kind::product, 7, 0, 1},                   // cos sin
         {Kind::scaled_add, 8, 0, 7, 4},             // s + k0 cos sin
         {Kind::multiply_add, 8, 5, 0, 8},           // ... + m cos
         {Kind::difference, 9, 0, 1},                // cos - sin
         {Kind::multiply_subtract, 9, 4, 7, 9},      // ... - s cos sin
         {Kind::shifted, 9, 1, 9},                   // ... + k1
         {Kind::sum, 10, 2, 6},                      // e^chi + 0
         {Kind::scaled, 11, 0, 2},                   // k0 e^chi
         {Kind::scaled_subtract, 11, 1, 0, 11},      // ... - k1 cos
         {Kind::sum, 12, 11, 6},                     //
         {Kind::constant, 7, 1},                     // k1, in a place that is used again
         {Kind::sum, 12, 12, 7},                     // ... + k1
         {Kind::product, 13, 5, 5},                  // m^2
         {Kind::multiply_subtract, 12, 13, 1, 12}}}; // ... - m^2 sin
    static constexpr std::array<unsigned short, 4> results{8, 9, 10, 12};
    static constexpr int turns = 2, fades = 1;
    Real eps, end;
    double reach;

    explicit Atoms(double e, double last = 1) : eps(e), end(last), reach(kernel::last_time(e, last)) {}
    template <class Number> std::array<Real, 3> amplitudes(const Number& fine) const {
        const auto T = static_cast<Real>(fine);
        return {Real(2) + T * T, T - Real(1) / Real(3), Real(0)};
    }
    std::array<Real, 2> constants() const { return {Real(3) / Real(2), Real(7)}; }
    std::array<Fifty, 4> outputs_of(const std::array<Fifty, 3>& a, const std::array<Fifty, 2>& theta) const {
        const Fifty c = cos(theta[0]), s = sin(theta[0]), e = exp(theta[1]), k = Fifty(3) / 2;
        return {a[0] + k * c * s + a[1] * c, c - s - a[0] * c * s + 7, e,
                k * e - 7 * c + 7 - a[1] * a[1] * s};
    }
    std::array<double, 4> scale_at(const Fifty& t) const {
        return {4, 12, static_cast<double>(exp(-3 * t)), 16};
    }
    template <class Wide> PhasesOf<Wide, Atoms> rates() const {
        return {*this, {Wide(1) / Wide(4), Wide(0)}};
    }
    template <class Wide> std::array<Wide, 2> rate(const Wide& T) const {
        const Wide per = Wide(1) / Wide(eps);
        return {per * (Wide(1) + T / (Wide(5) + T)), -Wide(3) * per};
    }
};

// No phase at all.
template <class Real> struct Mean {
    static constexpr std::size_t phases = 0, outputs = 1;
    static constexpr std::array<Term<0>, 1> terms{{{0, Wave::one, {}}}};
    Real eps, end;
    double reach;
    std::array<double, 1> scale{1};
    explicit Mean(double e, double last = 1) : eps(e), end(last), reach(kernel::last_time(e, last)) {}
    template <class Number> std::array<Real, 1> amplitudes(const Number& T) const {
        return {static_cast<Real>(Number(1) / (Number(1) + T * T))};
    }
    template <class Wide> PhasesOf<Wide, Mean> rates() const { return {*this, {}}; }
    template <class Wide> std::array<Wide, 0> rate(const Wide&) const { return {}; }
};

// The outputs by the formula in 50 digits.
template <template <class> class Scene> class Exact {
public:
    explicit Exact(double eps, double last = 1) : scene_(eps, last) {
        Fifty end(last);
        if constexpr (Scene<Fifty>::phases > 0)
            theta_.build([this](const Fifty& T) { return scene_.rate(T); }, end);
    }
    std::array<Fifty, Scene<Fifty>::outputs> operator()(const Fifty& t) const {
        const Fifty T = t * scene_.eps;
        const auto a = scene_.amplitudes(T);
        std::array<Fifty, Scene<Fifty>::phases> theta{};
        if constexpr (Scene<Fifty>::phases > 0) {
            theta = theta_(T);
            for (std::size_t p = 0; p < theta.size(); ++p)
                theta[p] += scene_.template rates<Fifty>().start[p];
        }
        if constexpr (requires { scene_.outputs_of(a, theta); }) return scene_.outputs_of(a, theta);
        std::array<Fifty, Scene<Fifty>::outputs> result{};
        for (std::size_t r = 0; r < a.size(); ++r) {
            const auto& term = Scene<Fifty>::terms[r];
            Fifty angle(0), exponent(0);
            for (std::size_t p = 0; p < theta.size(); ++p)
                (p < theta.size() - kernel::decays_of<Scene<Fifty>>() ? angle : exponent) +=
                    term.k[p] * theta[p];
            const Fifty wave = term.wave == Wave::one      ? Fifty(1)
                               : term.wave == Wave::cosine ? Fifty(cos(angle))
                                                           : Fifty(sin(angle));
            result[term.output] += Fifty(a[r] * exp(exponent)) * wave;
        }
        return result;
    }

private:
    Scene<Fifty> scene_;
    PrimitiveTable<Fifty, Scene<Fifty>::phases == 0 ? 1 : Scene<Fifty>::phases> theta_;
};

template <class Real> using TwoPhases = Many<Real, 2>;
template <class Real> using ThreePhases = Many<Real, 3>;

} // namespace resonform::test
