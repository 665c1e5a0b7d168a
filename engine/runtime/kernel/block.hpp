// SPDX-License-Identifier: MIT
// V vectors of points of one piece. Each number comes from the same operations in the same order whatever V
// is.
#ifndef RESONFORM_RUNTIME_KERNEL_BLOCK
#define RESONFORM_RUNTIME_KERNEL_BLOCK

#include "runtime/kernel/lanes.hpp"
#include "runtime/kernel/view.hpp"

namespace resonform::kernel {
inline namespace RESONFORM_WIDTH {

// Cosine and sine of (f + whole) quarter turns, |f| <= 1/2 and a little; `whole` in the last bits of
// `turned`. Chebyshev fits in f^2, errors 4e-18 and 1e-19.
template <int N>
[[gnu::always_inline]] inline void
cosine_and_sine(typename Lanes<N>::Vector f, typename Lanes<N>::Vector turned,
                typename Lanes<N>::Vector& cosine, typename Lanes<N>::Vector& sine) {
    using L = Lanes<N>;
    using Vector = typename L::Vector;
    using Bits = typename L::Bits;
    const Vector z = L::product(f, f);
    Vector s = L::all(5.633912950662773e-08), c = L::all(-6.329375614927176e-09);
    s = L::multiply_add(s, z, L::all(-3.5986432112080418e-06));
    c = L::multiply_add(c, z, L::all(4.710678264238564e-07));
    s = L::multiply_add(s, z, L::all(0.00016044115070638467));
    c = L::multiply_add(c, z, L::all(-2.5202039024455834e-05));
    s = L::multiply_add(s, z, L::all(-0.004681754132336862));
    c = L::multiply_add(c, z, L::all(0.0009192602745464332));
    s = L::multiply_add(s, z, L::all(0.0796926262460428));
    c = L::multiply_add(c, z, L::all(-0.020863480763340752));
    s = L::multiply_add(s, z, L::all(-0.6459640975062443));
    c = L::multiply_add(c, z, L::all(0.2536695079010478));
    s = L::multiply_add(s, z, L::all(1.5707963267948966));
    c = L::multiply_add(c, z, L::all(-1.2337005501361697));
    s = L::product(s, f);
    c = L::multiply_add(c, z, L::all(1.0));
    const Bits quadrant = L::bits(turned), odd = -(quadrant & 1);
    const Bits x = (L::bits(s) & odd) | (L::bits(c) & ~odd), y = (L::bits(c) & odd) | (L::bits(s) & ~odd);
    cosine = L::number(x ^ (((quadrant + 1) & 2) << 62));
    sine = L::number(y ^ ((quadrant & 2) << 62));
}

// 2^(f + whole), |f| <= 1/2 and a little, 0 below 2^-1021. Chebyshev fit, error 2e-17.
template <int N>
[[gnu::always_inline]] inline typename Lanes<N>::Vector power_of_two(typename Lanes<N>::Vector f,
                                                                     typename Lanes<N>::Vector turned) {
    using L = Lanes<N>;
    using Vector = typename L::Vector;
    using Bits = typename L::Bits;
    constexpr double least = -1021;
    Vector p = L::all(4.4558179083744e-10);
    p = L::multiply_add(p, f, L::all(7.0741942973604436e-09));
    p = L::multiply_add(p, f, L::all(1.0178057087733725e-07));
    p = L::multiply_add(p, f, L::all(1.321543253591197e-06));
    p = L::multiply_add(p, f, L::all(1.5252733841556773e-05));
    p = L::multiply_add(p, f, L::all(0.00015403530463724356));
    p = L::multiply_add(p, f, L::all(0.001333355814640647));
    p = L::multiply_add(p, f, L::all(0.009618129107587256));
    p = L::multiply_add(p, f, L::all(0.055504108664821625));
    p = L::multiply_add(p, f, L::all(0.24022650695910158));
    p = L::multiply_add(p, f, L::all(0.6931471805599453));
    p = L::multiply_add(p, f, L::all(1.0));
    const Bits whole = L::bits(turned) - L::bits(L::all(rounding_shift));
    const Bits left = turned >= L::all(rounding_shift + least);
    return L::number(L::bits(L::product(p, L::number((whole + 1023) << 52))) & left);
}

// Where V vectors of points stand in a piece.
template <int N, int V> struct Place {
    typename Lanes<N>::template Several<V> d, v, low; // low: the exact time less its rounded value t
};

// A polynomial, highest power first, coefficients `stride` apart. One jump instead of a loop whose end would
// be mispredicted for each row.
template <int N, int V>
[[gnu::always_inline]] inline void polynomial(const double* c, std::size_t stride, unsigned degree,
                                              const typename Lanes<N>::Vector* x,
                                              typename Lanes<N>::Vector* value) {
    using L = Lanes<N>;
    using Vector = typename L::Vector;
    RESONFORM_UNROLL for (int i = 0; i < V; ++i) value[i] = L::all(c[0]);
    const auto step = [&]() __attribute__((always_inline)) {
        c += stride;
        const Vector next = L::all(*c);
        RESONFORM_UNROLL for (int i = 0; i < V; ++i) value[i] = L::multiply_add(value[i], x[i], next);
    };
    for (; degree > 9; --degree) step();
    switch (degree) {
    case 9: step(); [[fallthrough]];
    case 8: step(); [[fallthrough]];
    case 7: step(); [[fallthrough]];
    case 6: step(); [[fallthrough]];
    case 5: step(); [[fallthrough]];
    case 4: step(); [[fallthrough]];
    case 3: step(); [[fallthrough]];
    case 2: step(); [[fallthrough]];
    case 1: step(); [[fallthrough]];
    default: break;
    }
}

// The same with its derivative, of coefficients next to each other.
template <int N, int V>
[[gnu::always_inline]] inline void
polynomial_and_slope(const double* c, unsigned degree, const typename Lanes<N>::Vector* x,
                     typename Lanes<N>::Vector* value, typename Lanes<N>::Vector* slope) {
    using L = Lanes<N>;
    RESONFORM_UNROLL for (int i = 0; i < V; ++i) {
        value[i] = L::all(c[0]);
        slope[i] = L::all(0);
    }
    for (; degree > 0; --degree) {
        ++c;
        RESONFORM_UNROLL for (int i = 0; i < V; ++i) {
            slope[i] = L::multiply_add(slope[i], x[i], value[i]);
            value[i] = L::multiply_add(value[i], x[i], L::all(*c));
        }
    }
}

// A phase in quarter turns: f[i] + whole, `turned` holds the whole. Products of halves are exact, so that no
// contraction changes them.
template <int N, int V, bool Low>
[[gnu::always_inline]] inline void phase_of(const View& w, const PhaseRow& p, const double* piece,
                                            const Place<N, V>& at, typename Lanes<N>::Vector* f,
                                            typename Lanes<N>::Vector* turned) {
    using L = Lanes<N>;
    using Vector = typename L::Vector;
    const double* c = piece + p.offset;
    typename L::template Several<V> large = {}, rest = {};
    if (p.wide == 0) {
        typename L::template Several<V> slope;
        if constexpr (Low)
            polynomial_and_slope<N, V>(c, p.degree, at.v, rest, slope);
        else
            polynomial<N, V>(c, 1, p.degree, at.v, rest);
        c += p.degree + 1;
        const Vector high = L::all(c[0]), low = L::all(c[1]);
        RESONFORM_UNROLL for (int i = 0; i < V; ++i) {
            const Vector d1 = L::upper(at.d[i]), d2 = at.d[i] - d1;
            if constexpr (Low) {
                slope[i] = L::multiply_add(slope[i], L::all(w.to_local), high);
                rest[i] = L::multiply_add(slope[i], at.low[i], rest[i]);
            }
            rest[i] = L::multiply_add(low, at.d[i], rest[i]);
            rest[i] = L::multiply_add(high, d2, rest[i]);
            large[i] = high * d1; // exact
        }
        c += 2;
    } else {
        typename L::template Several<V> u, x, y, slope;
        const Vector unit = L::all(w.to_local / 2);
        RESONFORM_UNROLL for (int i = 0; i < V; ++i) u[i] = at.d[i] * unit; // exact
        if constexpr (Low)
            polynomial_and_slope<N, V>(c, p.degree, u, y, slope);
        else
            polynomial<N, V>(c, 1, p.degree, u, y);
        c += p.degree + 1;
        const Vector high = L::all(c[0]), low = L::all(c[1]);
        RESONFORM_UNROLL for (int i = 0; i < V; ++i) {
            x[i] = high;
            if constexpr (Low) slope[i] = L::multiply_add(slope[i], u[i], y[i]);
            y[i] = L::multiply_add(y[i], u[i], low);
        }
        c += 2;
        for (unsigned j = p.wide; j > 0; c += j == 1 ? 1 : 2, --j) {
            const Vector above = L::all(c[0]), below = L::all(c[1]);
            RESONFORM_UNROLL for (int i = 0; i < V; ++i) {
                const Vector product = L::product(x[i], u[i]);
                Vector error = L::multiply_add(y[i], u[i], L::product_error(x[i], u[i], product));
                if constexpr (Low) {
                    slope[i] = L::multiply_add(slope[i], u[i], x[i] + y[i]);
                    if (j == 1) error = L::multiply_add(slope[i], at.low[i] * unit, error);
                }
                if (j == 1) { // nothing more is multiplied: the constant is small
                    large[i] = product;
                    rest[i] = error + above;
                } else {
                    const Vector sum = product + above, part = sum - product;
                    x[i] = sum;
                    y[i] = error + (below + ((product - (sum - part)) + (above - part)));
                }
            }
        }
    }
    const Vector shift = L::all(c[0]); // rounding_shift + whole quarter turns
    RESONFORM_UNROLL for (int i = 0; i < V; ++i) {
        turned[i] = (large[i] + rest[i]) + shift;
        f[i] = (large[i] - (turned[i] - shift)) + rest[i];
    }
}

template <int N, int V> struct Factors { typename Lanes<N>::template Several<V> at[most_factors]; };

template <int N, int V> [[gnu::always_inline]] inline void turn(const Step& s, Factors<N, V>& g) {
    using L = Lanes<N>;
    using Vector = typename L::Vector;
    const Vector sign = L::all(s.sign);
    RESONFORM_UNROLL for (int i = 0; i < V; ++i) {
        const Vector a = g.at[2 * s.from][i], b = g.at[2 * s.from + 1][i];
        const Vector c = g.at[2 * s.by][i], d = sign * g.at[2 * s.by + 1][i]; // exact
        g.at[2 * s.to][i] = L::multiply_add(a, c, -L::product(b, d));
        g.at[2 * s.to + 1][i] = L::multiply_add(b, c, L::product(a, d));
    }
}

// The exponential or the cosine and sine of a phase.
template <int N, int V, bool Low>
[[gnu::always_inline]] inline void turn(const View& w, const PhaseRow& p, const double* piece,
                                        const Place<N, V>& at, Factors<N, V>& g) {
    typename Lanes<N>::template Several<V> f, turned;
    phase_of<N, V, Low>(w, p, piece, at, f, turned);
    auto& cosine = g.at[2 * p.harmonic];
    auto& sine = g.at[2 * p.harmonic + 1];
    if (p.exponent) {
        RESONFORM_UNROLL for (int i = 0; i < V; ++i) {
            cosine[i] = power_of_two<N>(f[i], turned[i]);
            sine[i] = typename Lanes<N>::Vector{};
        }
    } else {
        RESONFORM_UNROLL for (int i = 0; i < V; ++i) cosine_and_sine<N>(f[i], turned[i], cosine[i], sine[i]);
    }
}

template <int N, int V>
[[gnu::always_inline]] inline void operate(const Operation& o, const double* constant, Factors<N, V>& g) {
    using L = Lanes<N>;
    const auto &a = g.at[o.a], &b = g.at[o.b], &c = g.at[o.c];
    auto& to = g.at[o.to];
    const double* k = constant + o.a;
    switch (o.kind) {
    case Kind::product: RESONFORM_UNROLL for (int i = 0; i < V; ++i) to[i] = L::product(a[i], b[i]); break;
    case Kind::scaled:
        RESONFORM_UNROLL for (int i = 0; i < V; ++i) to[i] = L::product(L::all(*k), b[i]);
        break;
    case Kind::sum: RESONFORM_UNROLL for (int i = 0; i < V; ++i) to[i] = a[i] + b[i]; break;
    case Kind::difference: RESONFORM_UNROLL for (int i = 0; i < V; ++i) to[i] = a[i] - b[i]; break;
    case Kind::shifted: RESONFORM_UNROLL for (int i = 0; i < V; ++i) to[i] = L::all(*k) + b[i]; break;
    case Kind::multiply_add:
        RESONFORM_UNROLL for (int i = 0; i < V; ++i) to[i] = L::multiply_add(a[i], b[i], c[i]);
        break;
    case Kind::multiply_subtract:
        RESONFORM_UNROLL for (int i = 0; i < V; ++i) to[i] = L::multiply_add(-a[i], b[i], c[i]);
        break;
    case Kind::scaled_add:
        RESONFORM_UNROLL for (int i = 0; i < V; ++i) to[i] = L::multiply_add(L::all(*k), b[i], c[i]);
        break;
    case Kind::scaled_subtract:
        RESONFORM_UNROLL for (int i = 0; i < V; ++i) to[i] = L::multiply_add(L::all(-*k), b[i], c[i]);
        break;
    case Kind::constant: RESONFORM_UNROLL for (int i = 0; i < V; ++i) to[i] = L::all(*k); break;
    }
}

// The outputs as operations on atoms and turned modes.
template <int N, int V>
[[gnu::always_inline]] inline void operations(const View& w, const double* piece, const Place<N, V>& at,
                                              Factors<N, V>& g, unsigned long long wanted, double* const* to,
                                              std::size_t first) {
    for (unsigned r = 0; r < w.rows; ++r)
        if ((w.row[r].outputs & wanted) != 0)
            polynomial<N, V>(piece + w.row[r].offset, group, w.row[r].degree, at.v, g.at[w.row[r].factor]);
    for (unsigned k = 0; k < w.operations; ++k)
        if ((w.operation[k].outputs & wanted) != 0) operate<N, V>(w.operation[k], w.constant, g);
    for (unsigned o = 0; o < w.outputs; ++o)
        if ((wanted >> o & 1) != 0)
            RESONFORM_UNROLL for (int i = 0; i < V; ++i)
                Lanes<N>::store(to[o] + first + i * N, g.at[w.output[o].first][i]);
}

// The outputs `wanted` (bits) of V*N points of one piece. faded: no exponential is left in it.
template <int N, int V, bool Low>
[[gnu::always_inline]] inline void block(const View& w, const double* piece, const double* t,
                                         const double* low, unsigned long long wanted, double* const* to,
                                         std::size_t first, bool faded) {
    using L = Lanes<N>;
    using Vector = typename L::Vector;
    Place<N, V> at;
    Factors<N, V> g;
    const Vector left = L::all(piece[0]), to_local = L::all(w.to_local), middle = L::all(w.middle);
    RESONFORM_UNROLL for (int i = 0; i < V; ++i) {
        at.d[i] = L::load(t + i * N) - left;
        at.v[i] = at.d[i] * to_local - middle; // the product is exact
        if constexpr (Low) at.low[i] = L::load(low + i * N);
    }
    for (unsigned k = 0; k < w.phases; ++k) {
        const PhaseRow& p = w.phase[k];
        if (((faded ? p.lasting : p.outputs) & wanted) != 0) turn<N, V, Low>(w, p, piece, at, g);
    }
    if (w.constant != nullptr) return operations<N, V>(w, piece, at, g, wanted, to, first);
    for (unsigned k = 0; k < w.steps; ++k)
        if (((faded ? w.step[k].lasting : w.step[k].outputs) & wanted) != 0) turn<N, V>(w.step[k], g);
    for (unsigned o = 0; o < w.outputs; ++o) {
        if ((wanted >> o & 1) == 0) continue;
        const Output& output = w.output[o];
        typename L::template Several<V> sum;
        RESONFORM_UNROLL for (int i = 0; i < V; ++i) sum[i] = Vector{};
        for (unsigned r = output.first + (faded ? output.fading : 0); r < output.first + output.count; ++r) {
            const Row& row = w.row[r];
            typename L::template Several<V> value;
            polynomial<N, V>(piece + row.offset, group, row.degree, at.v, value);
            if (row.factor == no_factor) {
                RESONFORM_UNROLL for (int i = 0; i < V; ++i) sum[i] = value[i] + sum[i];
            } else {
                RESONFORM_UNROLL for (int i = 0; i < V; ++i) sum[i] =
                    L::multiply_add(value[i], g.at[row.factor][i], sum[i]);
            }
        }
        RESONFORM_UNROLL for (int i = 0; i < V; ++i) L::store(to[o] + first + i * N, sum[i]);
    }
}

} // namespace RESONFORM_WIDTH
} // namespace resonform::kernel

#endif
