// SPDX-License-Identifier: MIT
// The times t0 + i dt, exactly. Where many lie within a part of the shortest period, the outputs are
// interpolated there: windows of a power of two, nodes that are exact doubles, one polynomial for each
// output.
#ifndef RESONFORM_RUNTIME_KERNEL_GRID
#define RESONFORM_RUNTIME_KERNEL_GRID

#include "runtime/kernel/batch.hpp"
#include "runtime/kernel/chebyshev_powers.hpp"

namespace resonform::kernel {
inline namespace RESONFORM_WIDTH {

inline constexpr int window_nodes = 12;
inline constexpr std::size_t windows_at_once = 32, least_in_window = 24;

// Chebyshev nodes, ascending, rounded to 2^-20; and from the values there to Chebyshev coefficients.
struct WindowRule {
    static constexpr long node[window_nodes] = {-1039605, -968758, -831891, -638333, -401273, -136867,
                                                136867,   401273,  638333,  831891,  968758,  1039605};
    double to_series[window_nodes][window_nodes] = {}; // [node][coefficient]
    constexpr WindowRule() {
        constexpr int n = window_nodes;
        long double a[n][2 * n] = {}; // T_k(x_j) | 1, by Gauss and Jordan
        for (int j = 0; j < n; ++j) {
            const long double x = static_cast<long double>(node[j]) / 1048576;
            a[j][0] = 1;
            a[j][1] = x;
            for (int k = 2; k < n; ++k) a[j][k] = 2 * x * a[j][k - 1] - a[j][k - 2];
            a[j][n + j] = 1;
        }
        for (int k = 0; k < n; ++k) {
            int best = k;
            for (int j = k; j < n; ++j)
                if (a[j][k] * a[j][k] > a[best][k] * a[best][k]) best = j;
            for (int i = 0; i < 2 * n; ++i) {
                const long double kept = a[k][i];
                a[k][i] = a[best][i];
                a[best][i] = kept;
            }
            const long double pivot = a[k][k];
            for (int i = 0; i < 2 * n; ++i) a[k][i] /= pivot;
            for (int j = 0; j < n; ++j) {
                const long double factor = a[j][k];
                for (int i = 0; i < 2 * n; ++i)
                    if (j != k) a[j][i] -= factor * a[k][i];
            }
        }
        for (int k = 0; k < n; ++k)
            for (int j = 0; j < n; ++j) to_series[j][k] = static_cast<double>(a[k][n + j]);
    }
};
inline constexpr WindowRule window_rule{};
inline constexpr ChebyshevPowers<window_nodes - 1> window_powers{};

// t0 + i dt as an unevaluated sum high + low, high rounded.
struct ExactTimes {
    double t0, dt;
    template <int N> struct Sum { typename Lanes<N>::Vector high, low; };
    template <int N> [[gnu::always_inline]] Sum<N> at(typename Lanes<N>::Vector i) const {
        using L = Lanes<N>;
        const typename L::Vector step = L::all(dt), p = L::product(i, step), a = L::all(t0), s = a + p,
                                 part = s - a;
        const typename L::Vector rest = ((a - (s - part)) + (p - part)) + L::product_error(i, step, p),
                                 sum = s + rest;
        return {sum, (s - sum) + rest};
    }
    [[gnu::always_inline]] void at(std::size_t i, double& high, double& low) const {
        const Sum<2> sum = at<2>(Lanes<2>::all(static_cast<double>(i)));
        high = sum.high[0];
        low = sum.low[0];
    }
    // Of from, from + 1, ...; there is room for whole vectors.
    void list(std::size_t from, std::size_t n, double* high, double* low) const {
        using L = Lanes<lanes>;
        typename L::Vector steps{};
        for (int j = 0; j < lanes; ++j) steps[j] = j;
        for (std::size_t k = 0; k < n; k += lanes) {
            const Sum<lanes> sum = at<lanes>(L::all(static_cast<double>(from + k)) + steps);
            L::store(high + k, sum.high);
            L::store(low + k, sum.low);
        }
    }
};

// Up to `chunk` points one by one.
inline void point_by_point(const View& w, const ExactTimes& times, std::size_t from, std::size_t n,
                           const Target& target, Status* status, const Direct* direct, BatchReport& report) {
    static_assert(chunk % lanes == 0);
    double t[chunk], exact_low[chunk];
    const auto is_ok = [&](std::size_t i) {
        double time = 0, rest = 0;
        times.at(i, time, rest);
        return status_of(w, time) == Status::ok;
    };
    times.list(from, n, t, exact_low);
    if (is_ok(from) && is_ok(from + n - 1)) { // and so are those between
        values_at<true>(w, t, exact_low, n, times.dt >= 0, target.wanted, target.from(from).to);
        all_fine(status == nullptr ? nullptr : status + from, n);
        return;
    }
    double used[chunk], low[chunk];
    double last = w.begin, last_low = 0;
    for (std::size_t i = 0; i < n; ++i) {
        if (answers(status_of(w, t[i]))) {
            last = t[i];
            last_low = exact_low[i];
        }
        used[i] = last;
        low[i] = last_low;
    }
    values_at<true>(w, used, low, n, look(w, used, n).ascend, target.wanted, target.from(from).to);
    repair(w, t, exact_low, from, n, target, status, direct, report);
}

// The coefficients of one output in several windows, by powers: that of u^j in window k is at[j][k].
struct WindowPolynomials {
    double at[window_nodes][windows_at_once];

    // Several windows side by side: sums for one of them would wait for each other.
    void set(const double* values, std::size_t count) {
        using L = Lanes<lanes>;
        for (std::size_t first = 0; first < count; first += lanes) {
            L::Vector value[window_nodes], series[window_nodes] = {};
            for (std::size_t j = 0; j < window_nodes; ++j)
                for (std::size_t k = 0; k < lanes; ++k) {
                    const std::size_t window = first + k < count ? first + k : count - 1;
                    value[j][k] = values[window * window_nodes + j];
                }
            const L::Vector base = value[window_nodes / 2];
            for (std::size_t j = 0; j < window_nodes; ++j)
                for (std::size_t k = 0; k < window_nodes; ++k)
                    series[k] =
                        L::multiply_add(value[j] - base, L::all(window_rule.to_series[j][k]), series[k]);
            for (std::size_t j = 0; j < window_nodes; ++j) {
                L::Vector sum{};
                for (std::size_t k = window_nodes - 1 - (window_nodes - 1 - j) % 2;;
                     k -= 2) { // of its parity
                    sum = L::multiply_add(series[k], L::all(window_powers.at[k][j]), sum);
                    if (k == j) break;
                }
                L::store(at[j] + first, j == 0 ? sum + base : sum);
            }
        }
    }
};

// The polynomial of one window at the points u0 + j du.
inline void in_window(const WindowPolynomials& polynomials, std::size_t window, double u0, double du,
                      std::size_t n, double* to) {
    using L = Lanes<lanes>;
    double c[window_nodes];
    for (std::size_t j = 0; j < window_nodes; ++j) c[j] = polynomials.at[j][window];
    L::Vector steps{};
    for (int j = 0; j < lanes; ++j) steps[j] = j;
    const L::Vector origin = L::all(u0), step = L::all(du);
    constexpr std::size_t many = lanes * at_once;
    for (std::size_t i = 0; i < n; i += many) {
        L::Vector u[at_once], x[at_once];
        RESONFORM_UNROLL for (int k = 0; k < at_once; ++k) {
            const L::Vector j = steps + L::all(static_cast<double>(i + static_cast<std::size_t>(k * lanes)));
            u[k] = L::multiply_add(j, step, origin);
            x[k] = L::all(c[window_nodes - 1]);
        }
        for (int j = window_nodes - 1; j > 0; --j) {
            const L::Vector next = L::all(c[j - 1]);
            RESONFORM_UNROLL for (int k = 0; k < at_once; ++k) x[k] = L::multiply_add(x[k], u[k], next);
        }
        if (i + many <= n) {
            RESONFORM_UNROLL for (int k = 0; k < at_once; ++k) L::store(to + i + k * lanes, x[k]);
        } else {
            for (std::size_t k = 0; i + k < n; ++k) to[i + k] = x[k / lanes][k % lanes];
        }
    }
}

struct Window {
    std::size_t first, count;
    double centre, half;
};

// A power of two: at most 0.4 radians of what changes with this period, and a quarter of a piece.
inline double half_window(const View& w, double period) {
    double longest = 0.25 / w.per_width, half = 1;
    if (period > 0 && 0.06 * period < longest) longest = 0.06 * period;
    while (half > longest) half /= 2;
    while (2 * half <= longest) half *= 2;
    return half;
}

inline BatchReport grid(const View& w, double t0, double dt, std::size_t n, double* const* outputs,
                        Status* status, const Direct* direct) noexcept {
    BatchReport report{Status::ok, 0, n};
    const Target target(w, outputs);
    const ExactTimes times{t0, dt};
    const double highest = highest_ok(w);
    const double size = dt < 0 ? -dt : dt;
    const double wide = half_window(w, w.shortest_period), narrow = half_window(w, w.shortest_layer);
    const double layer_end = static_cast<double>(w.faded) / w.per_width; // as far as exponentials count
    const auto many_in = [&](double half) { return 2 * half / size >= static_cast<double>(least_in_window); };
    const bool windows = t0 - t0 == 0 && many_in(wide) && size > 0x1p-900;
    Window window[windows_at_once];
    double at[windows_at_once * window_nodes], values[most_outputs][windows_at_once * window_nodes];
    WindowPolynomials polynomials;
    double* to[most_outputs];
    for (unsigned o = 0; o < w.outputs && o < most_outputs; ++o) to[o] = values[o];
    for (std::size_t i = 0; i < n;) {
        std::size_t count = 0, next = i;
        while (windows && next < n && count < windows_at_once) {
            double t = 0, low = 0;
            times.at(next, t, low);
            if (!(t >= w.begin && t <= highest)) break;
            const auto left_of = [t](double half_width) {
                return 2 * half_width * static_cast<double>(static_cast<long long>(t / (2 * half_width)));
            };
            const double half = left_of(wide) < layer_end ? narrow : wide;
            if (!many_in(half)) break;
            const double k = static_cast<double>(static_cast<long long>(t / (2 * half)));
            const double left = 2 * half * k, right = left + 2 * half;
            if (left < w.begin || right > highest || (dt < 0 && k == 0)) break;
            const double inside = (dt > 0 ? right - t : t - left) / size;
            std::size_t points = inside < 1e15 ? static_cast<std::size_t>(inside) + 1 : n;
            if (points > n - next) points = n - next;
            window[count] = {next, points, left + half, half};
            for (int j = 0; j < window_nodes; ++j)
                at[count * window_nodes + static_cast<std::size_t>(j)] =
                    left + half + half * (static_cast<double>(WindowRule::node[j]) / 1048576);
            ++count;
            next += points;
        }
        if (count == 0) { // near an end, outside, or few points in a window
            std::size_t points = windows ? least_in_window : chunk;
            if (windows) {
                double t = 0, low = 0;
                times.at(i, t, low);
                if (!(t >= w.begin && t <= highest) || t < layer_end) points = chunk / 4;
            }
            if (points > n - i) points = n - i;
            point_by_point(w, times, i, points, target, status, direct, report);
            i += points;
            continue;
        }
        values_at<false>(w, at, nullptr, count * window_nodes, dt > 0, target.wanted, to);
        for (unsigned o = 0; o < w.outputs; ++o) {
            if ((target.wanted >> o & 1) == 0) continue;
            polynomials.set(values[o], count);
            for (std::size_t k = 0; k < count; ++k) {
                double t = 0, low = 0;
                times.at(window[k].first, t, low);
                in_window(polynomials, k, ((t - window[k].centre) + low) / window[k].half,
                          dt / window[k].half, window[k].count, target.to[o] + window[k].first);
            }
        }
        all_fine(status == nullptr ? nullptr : status + i, next - i);
        i = next;
    }
    return report;
}

} // namespace RESONFORM_WIDTH
} // namespace resonform::kernel

#endif
