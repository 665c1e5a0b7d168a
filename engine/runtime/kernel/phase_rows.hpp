// SPDX-License-Identifier: MIT
// A phase on [0, root], root = 2^levels pieces, in quarter turns: its rate is interpolated in panels, which
// are halved until 32 terms are enough, integrated from exact edge to exact edge, and halved on to the
// pieces. An exponent the same, in units of ln 2, as far as something is left of its exponential.
#ifndef RESONFORM_RUNTIME_KERNEL_PHASE_ROWS
#define RESONFORM_RUNTIME_KERNEL_PHASE_ROWS

#include "runtime/kernel/chebyshev.hpp"
#include "runtime/kernel/view.hpp"
#include "runtime/panels.hpp"
#include "runtime/twice.hpp"

#include <algorithm>
#include <vector>

namespace resonform::kernel {

inline constexpr int most_levels = 12;
inline constexpr double gone = -1100; // 2^gone is no number that counts

template <class Wide> Wide ln_two() { return Wide(0.6931471805599453) + Wide(2.3190468138462996e-17); }

template <class Wide> class PhaseFit {
public:
    using Series = std::array<Wide, nodes + 1>;
    struct Panel {
        int level;
        std::size_t index;
        std::size_t size;
        Series theta; // quarter turns
    };
    std::vector<Panel> panels;
    bool resolved = true, exponent = false;

    // rate(t) in quarter turns per time
    template <class Rate> void fit(const Rate& rate, double root, const Wide& start) {
        at_left_ = start;
        divide(rate, root, 0, 0, -1);
    }
    // Levels of halving until all but constant and slope is below one quarter turn in each piece.
    int straight_at() const {
        int levels = 0;
        for (const Panel& p : panels) levels = std::max(levels, straight_at(p.theta.data(), p.size, p.level));
        return levels;
    }
    // Nothing is left of the exponential of a piece.
    bool is_gone(const Wide* c, std::size_t size) const {
        double highest = static_cast<double>(c[0]);
        for (std::size_t k = 1; k < size; ++k) highest += std::abs(static_cast<double>(c[k]));
        return exponent && highest < gone;
    }
    double steepest() const { // quarter turns in units of the root
        double most = 0;
        for (const Panel& p : panels) {
            if (is_gone(p.theta.data(), p.size)) continue;
            double slope = 0;
            for (std::size_t k = 1; k < p.size; ++k)
                slope += static_cast<double>(k * k) * std::abs(static_cast<double>(p.theta[k]));
            most = std::max(most, 2 * slope * std::ldexp(1.0, p.level));
        }
        return most;
    }
    int deepest() const {
        int level = 0;
        for (const Panel& p : panels) level = std::max(level, p.level);
        return level;
    }
    // done(index, series, size) for each piece
    template <class Done> void pieces(int levels, const Done& done) const {
        for (const Panel& p : panels) descend(p.theta.data(), p.size, p.level, p.index, levels, done);
    }

private:
    int straight_at(const Wide* c, std::size_t size, int level) const {
        double bent = most_bent(c, size) / 2; // of x^2, x from -1 to 1
        if (is_gone(c, size) || bent <= 1.0) return level;
        if (exponent && level < most_levels) { // it may be gone in a part
            Series left, right;
            halve(c, size, left.data(), right.data());
            return std::max(straight_at(left.data(), size, level + 1),
                            straight_at(right.data(), size, level + 1));
        }
        for (; bent > 1.0 && level < 60; ++level) bent /= 4;
        return level;
    }
    // A bound of the second derivative on [-1, 1]: of c_3 T_3 it is 24 |c_3|, at the edges.
    static double most_bent(const Wide* c, std::size_t size) {
        std::array<double, nodes + 4> series{};
        for (std::size_t k = 0; k < size; ++k) series[k] = static_cast<double>(c[k]);
        for (int times = 0; times < 2; ++times) {
            std::array<double, nodes + 4> derivative{};
            for (std::size_t k = size; k-- > 0;)
                derivative[k] = derivative[k + 2] + 2 * static_cast<double>(k + 1) * series[k + 1];
            derivative[0] /= 2;
            series = derivative;
        }
        double most = 0;
        for (std::size_t k = 0; k < size; ++k) most += std::abs(series[k]);
        return most;
    }
    template <class Rate>
    void divide(const Rate& rate, double root, int level, std::size_t index, double parent) {
        if (!resolved) return;
        const double width = std::ldexp(root, -level), left = width * static_cast<double>(index);
        std::array<Wide, nodes> values;
        const Wide half(width / 2), middle(left + width / 2); // both exact
        for (std::size_t j = 0; j < nodes; ++j) values[j] = rate(Wide(middle + half * node<Wide>(j))) * half;
        const auto c = interpolated<Wide>(values);
        double most = 0, tail = 0;
        for (const Wide& x : c) most = std::max(most, std::abs(static_cast<double>(x)));
        for (std::size_t k = nodes - 2; k < nodes; ++k)
            tail = std::max(tail, std::abs(static_cast<double>(c[k])));
        const double rounding = 16 * static_cast<double>(math::epsilon<Wide>()) * most;
        const bool fine = tail <= std::max(rounding, 0x1p-57);
        const bool hopeless =
            level == most_levels || (parent >= 0 && tail > parent / 4 && tail < 1e3 * rounding);
        if (!fine && !hopeless) {
            divide(rate, root, level + 1, 2 * index, tail);
            divide(rate, root, level + 1, 2 * index + 1, tail);
            return;
        }
        if (!fine && !(tail < 1e3 * rounding)) resolved = false;
        Panel p{level, index, nodes + 1, {}};
        Wide at_left{}, whole{}; // of the primitive without a constant
        for (std::size_t k = 1; k <= nodes; ++k) {
            const Wide above = k + 1 < nodes ? c[k + 1] : Wide{};
            p.theta[k] = (Wide(k == 1 ? 2 : 1) * c[k - 1] - above) / Wide(static_cast<int>(2 * k));
            at_left = k % 2 == 0 ? at_left + p.theta[k] : at_left - p.theta[k];
            whole = k % 2 == 0 ? whole : whole + p.theta[k] + p.theta[k];
        }
        p.theta[0] = at_left_ - at_left;
        at_left_ = at_left_ + whole;
        p.size = cut(p.theta.data(), p.size);
        panels.push_back(p);
    }
    static std::size_t cut(const Wide* c, std::size_t size) {
        double rest = 0;
        while (size > 2 && rest + std::abs(static_cast<double>(c[size - 1])) < 0x1p-58)
            rest += std::abs(static_cast<double>(c[--size]));
        return size;
    }
    template <class Done>
    static void descend(const Wide* c, std::size_t size, int level, std::size_t index, int levels,
                        const Done& done) {
        size = cut(c, size);
        if (level == levels) {
            done(index, c, size);
            return;
        }
        Series left, right;
        halve(c, size, left.data(), right.data());
        descend(left.data(), size, level + 1, 2 * index, levels, done);
        descend(right.data(), size, level + 1, 2 * index + 1, levels, done);
    }
    Wide at_left_{};
};

// The phase of one piece by powers, as the loops want it.
struct PhasePiece {
    double shift = 0;                            // whole quarter turns of the constant, modulo 4
    std::array<double, 2> w{};                   // straight: per time, by halves
    std::array<double, nodes + 1> high{}, low{}; // straight: q, high only; else the pairs
    unsigned size = 0;
    double largest = 0;
};

template <class Wide> double low_part(const Wide& x, double high) {
    return static_cast<double>(x - Wide(high));
}

template <class Wide> Wide whole_turns(const Wide& x) { // a whole number near x, which may be large
    const double a = std::round(static_cast<double>(x));
    return Wide(a) + Wide(std::round(static_cast<double>(x - Wide(a))));
}

template <class Wide> void reduce(Wide& c, PhasePiece& p, bool exponent) {
    const Wide whole = whole_turns(c);
    c = c - whole;
    if (exponent) {
        p.shift = static_cast<double>(whole);
        return;
    }
    const double quarters = static_cast<double>(whole - Wide(4) * whole_turns(Wide(whole / Wide(4))));
    p.shift = quarters < 0 ? quarters + 4 : quarters;
}

template <class Wide>
PhasePiece straight_piece(const Wide* series, std::size_t size, double width, double middle, bool exponent) {
    std::array<Wide, nodes + 1> c{};
    std::copy(series, series + size, c.begin());
    to_powers(c.data(), size);
    PhasePiece p;
    const Wide slope = c[1] * Wide(2) / Wide(width), half(width / 2);
    p.w[0] = upper_half(static_cast<double>(slope));
    p.w[1] = low_part(slope, p.w[0]);
    const Wide taken = (Wide(p.w[0]) + Wide(p.w[1])) * half;
    p.largest = std::abs(static_cast<double>(c[0])) + std::abs(static_cast<double>(c[1]));
    c[0] = c[0] - taken;
    c[1] = c[1] - taken;
    reduce(c[0], p, exponent);
    p.size = static_cast<unsigned>(size);
    double power = 1;
    for (std::size_t j = 0; j < size; ++j, power *= middle) p.high[j] = static_cast<double>(c[j]) / power;
    return p;
}

// By powers of u = d to_unit: the piece from its left edge.
template <class Wide>
PhasePiece curved_piece(const Wide* series, std::size_t size, double width, double to_unit, bool exponent) {
    std::array<Wide, nodes + 1> c{};
    std::copy(series, series + size, c.begin());
    to_powers(c.data(), size);
    c = recentred(c, Wide(-1), size);
    const Wide unit = Wide(2) / (Wide(width) * Wide(to_unit));
    Wide power = unit;
    for (std::size_t j = 1; j < size; ++j, power = power * unit) c[j] = c[j] * power;
    PhasePiece p;
    p.largest = std::abs(static_cast<double>(c[0])) + std::abs(static_cast<double>(c[1]));
    reduce(c[0], p, exponent);
    p.size = static_cast<unsigned>(size);
    for (std::size_t j = 0; j < size; ++j) {
        p.high[j] = static_cast<double>(c[j]);
        p.low[j] = low_part(c[j], p.high[j]);
    }
    return p;
}

// Of an exponent where nothing is left of its exponential.
inline PhasePiece gone_piece() {
    PhasePiece p;
    p.shift = gone;
    p.size = 2;
    return p;
}

} // namespace resonform::kernel

#endif
