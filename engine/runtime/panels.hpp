// SPDX-License-Identifier: MIT
// The primitive of smooth functions as a piecewise polynomial: [0, end] is bisected until the
// Chebyshev coefficients of every integrand decay to the precision of Number within each panel; the
// series is integrated exactly and stored by powers of the local variable.
//
//   fit_panels<double, 1>([](double T) { return std::array{std::cos(T)}; }, 1.0)   ->   sin(T)
//
// With n coefficients for n/5 digits a panel ends where the coefficients fall by about 1/32 each, so
// that the powers (growth 1 + sqrt(2) each) lose nothing against the Chebyshev form.
#ifndef RESONFORM_RUNTIME_PANELS
#define RESONFORM_RUNTIME_PANELS

#include "runtime/math.hpp"
#include "runtime/pieces.hpp"
#include "runtime/status.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace resonform {

template <class Number> inline constexpr std::size_t panel_nodes = math::digits<Number> / 5 + 2;

// On |x| <= 1, T = middle + half x:  int_0^T f_k = sum_j coefficient[k][j] x^j.
template <class Number, std::size_t Count, std::size_t Nodes = panel_nodes<Number>> struct Panel {
    static constexpr std::size_t size = Nodes + 1;
    Number middle{}, half{};
    std::array<std::array<Number, size>, Count> coefficient{};
};

// The polynomial sum_j c[j] x^j by powers of x - centre (Horner's scheme, repeated); c[j] = 0 for
// j >= used.
template <class Coefficients, class Number>
Coefficients recentred(Coefficients c, const Number& centre, std::size_t used) {
    for (std::size_t from = 0; from + 1 < used; ++from)
        for (std::size_t j = used - 1; j > from; --j) c[j - 1] = c[j - 1] + centre * c[j];
    return c;
}

template <class Number, std::size_t Count, std::size_t Nodes = panel_nodes<Number>> struct Panels {
    Status status = Status::ok;
    Number end = Number(0); // of the last panel: what was asked for if the status is ok
    std::vector<Panel<Number, Count, Nodes>> panels; // ascending, without gaps
};

// Chebyshev interpolation at n nodes, and what follows from it for primitives.
template <class Number, std::size_t Nodes = panel_nodes<Number>> class Chebyshev {
public:
    static constexpr std::size_t n = Nodes;
    using Values = std::array<Number, n>;

    Chebyshev() {
        using math::cos;
        for (std::size_t k = 0; k <= n; ++k)
            quadrant_[k] =
                cos(math::pi<Number>() * Number(static_cast<int>(k)) / Number(static_cast<int>(2 * n)));
        find_polynomials();
    }

    // For all fits of this type: the cosines take longer than many a fit.
    static const Chebyshev& once() {
        static const Chebyshev made;
        return made;
    }

    // cos((2j + 1) pi/(2n)), descending from near 1 to near -1
    [[nodiscard]] Number node(std::size_t j) const { return cosine(2 * j + 1); }

    // c_k of f = sum_k c_k T_k(x) from the values at the nodes
    [[nodiscard]] Values coefficients(const Values& values) const {
        Values result{};
        for (std::size_t k = 0; k < n; ++k) {
            Number sum = Number(0);
            for (std::size_t j = 0; j < n; ++j) sum = sum + values[j] * cosine(k * (2 * j + 1));
            result[k] = sum * Number(k == 0 ? 1 : 2) / Number(static_cast<int>(n));
        }
        return result;
    }

    // The primitive that vanishes at x = -1, by powers of x.
    [[nodiscard]] std::array<Number, n + 1> primitive(const Values& c) const {
        std::array<Number, n + 1> result = powers(integrated(c));
        Number at_left = Number(0);
        for (std::size_t k = n + 1; k > 0; --k) at_left = result[k - 1] - at_left;
        result[0] = result[0] - at_left;
        return result;
    }

    // Row j: the integral from -1 to node(j) as a linear combination of the values at the nodes.
    [[nodiscard]] std::array<Values, n> integration() const {
        std::array<Values, n> result{};
        for (std::size_t m = 0; m < n; ++m) {
            Values unit{};
            unit[m] = Number(1);
            const std::array<Number, n + 1> series = integrated(coefficients(unit));
            Number at_left = Number(0);
            for (std::size_t k = n + 1; k > 0; --k) at_left = series[k - 1] - at_left;
            for (std::size_t j = 0; j < n; ++j) {
                Number sum = Number(-at_left);
                for (std::size_t k = 1; k <= n; ++k) sum = sum + series[k] * cosine(k * (2 * j + 1));
                result[j][m] = sum;
            }
        }
        return result;
    }

private:
    // A primitive by its Chebyshev coefficients, without a constant.
    [[nodiscard]] static std::array<Number, n + 1> integrated(const Values& c) {
        std::array<Number, n + 1> series{};
        for (std::size_t k = 1; k <= n; ++k) {
            const Number above = k + 1 < n ? c[k + 1] : Number(0);
            series[k] = (Number(k == 1 ? 2 : 1) * c[k - 1] - above) / Number(static_cast<int>(2 * k));
        }
        return series;
    }

    // cos(k pi/(2n)), reduced to the first quadrant
    [[nodiscard]] Number cosine(std::size_t k) const {
        k %= 4 * n;
        if (k > 2 * n) k = 4 * n - k;
        return k > n ? Number(-quadrant_[2 * n - k]) : quadrant_[k];
    }

    // sum_k series[k] T_k(x) by powers of x
    [[nodiscard]] std::array<Number, n + 1> powers(const std::array<Number, n + 1>& series) const {
        std::array<Number, n + 1> result{};
        for (std::size_t k = 0; k <= n; ++k)
            for (std::size_t j = k % 2; j <= k; j += 2) result[j] = result[j] + series[k] * polynomial_[k][j];
        return result;
    }

    // Those of T_k, through T_{k+1} = 2 x T_k - T_{k-1}
    void find_polynomials() {
        polynomial_[0][0] = Number(1);
        polynomial_[1][1] = Number(1);
        for (std::size_t k = 1; k < n; ++k) {
            for (std::size_t j = 0; j <= k; ++j) polynomial_[k + 1][j + 1] = Number(2) * polynomial_[k][j];
            for (std::size_t j = 0; j < k; ++j)
                polynomial_[k + 1][j] = polynomial_[k + 1][j] - polynomial_[k - 1][j];
        }
    }

    std::array<Number, n + 1> quadrant_{};
    std::array<std::array<Number, n + 1>, n + 1> polynomial_{};
};

// A sum with its rounding errors carried along (Neumaier), each addition beginning with what is left of them:
// a sum that falls by any factor loses digits no faster than its addends.
template <class Number> class CompensatedSum {
public:
    void add(const Number& x) {
        const Number rounded = split(sum_, x, sum_);
        carry_ = split(sum_, Number(carry_ + rounded), sum_);
    }
    [[nodiscard]] Number value() const { return sum_ + carry_; }

private:
    // sum = a + b rounded; the rest of it.
    static Number split(const Number& a, const Number& b, Number& sum) {
        const Number large = math::magnitude(a) < math::magnitude(b) ? b : a;
        const Number small = math::magnitude(a) < math::magnitude(b) ? a : b;
        sum = large + small;
        return (large - sum) + small;
    }

    Number sum_ = Number(0), carry_ = Number(0);
};

// The last coefficient that a panel may have: relative to the size of the integrand, in the panel or on the
// average before it, or absolute, whichever is larger. What is cut off is about 1/16 of it. What comes after
// does not count: an integral has all its digits before its integrand becomes large.
template <class Number> struct FitTolerance {
    Number relative = Number(16) * math::epsilon<Number>();
    Number absolute = Number(0);
    Number resolution = math::epsilon<Number>(); // no panel is narrower than 1024 of it
};

template <class Number, std::size_t Count, std::size_t Nodes, class Integrand> class PanelFitter {
    using Fit = Chebyshev<Number, Nodes>;
    using Coefficients = std::array<typename Fit::Values, Count>;

public:
    static constexpr std::size_t most_panels = 2048;
    static constexpr std::size_t most_halvings = 100;

    PanelFitter(const Integrand& integrand, const Number& end, const FitTolerance<Number>& tolerance)
        : integrand_(integrand), end_(end), tolerance_(tolerance) {}

    Panels<Number, Count, Nodes> fit() {
        Number left = Number(0), right = left;
        do {
            right = end_of_piece(integrand_, left, end_);
            result_.status = divide(left, right, Number(-1), 0);
            left = right;
        } while (result_.status == Status::ok && right < end_);
        return std::move(result_);
    }

private:
    // Values of the integrands at the nodes of [left, right].
    Status sample(const Number& left, const Number& right) {
        const Number middle = (left + right) / Number(2), half = (right - left) / Number(2);
        for (std::size_t j = 0; j < Fit::n; ++j) {
            const std::array<Number, Count> value = integrand_(Number(middle + half * chebyshev_.node(j)));
            for (std::size_t k = 0; k < Count; ++k) {
                if (math::is_not_a_number(value[k])) return Status::outside_domain;
                if (!math::finite(value[k])) return Status::overflow;
                values_[k][j] = value[k];
            }
        }
        return Status::ok;
    }

    // The last coefficient of each integrand, or 1/8 of the one before where parity makes it vanish, in
    // units of the tolerance; at most 1 is converged.
    [[nodiscard]] Number remainder(const Coefficients& c, const Number& right) const {
        Number worst = Number(0);
        for (std::size_t k = 0; k < Count; ++k) {
            Number scale = sizes_[k] / right;
            for (const Number& x : c[k]) scale = std::max(scale, Number(math::magnitude(x)));
            const Number last = math::magnitude(c[k].back());
            const Number before = math::magnitude(c[k][c[k].size() - 2]) / Number(8);
            const Number tolerance = std::max(Number(tolerance_.relative * scale), tolerance_.absolute);
            if (Number(0) < tolerance) worst = std::max(worst, Number(std::max(last, before) / tolerance));
        }
        return worst;
    }

    // Smooth functions gain a factor of thousands by halving; where nothing is gained close to the
    // tolerance, the rounding of the integrand itself is seen, and the panel is as good as it gets.
    static bool converged(const Number& remainder, const Number& parent) {
        return !(Number(1) < remainder) ||
               (remainder < Number(1000) && parent < Number(4) * remainder && Number(0) < parent);
    }

    Status divide(const Number& left, const Number& right, const Number& parent, std::size_t depth) {
        const Status sampled = sample(left, right);
        Number rest = Number(-1); // nothing to compare the halves with
        if (sampled == Status::ok) {
            Coefficients c;
            for (std::size_t k = 0; k < Count; ++k) c[k] = chebyshev_.coefficients(values_[k]);
            rest = remainder(c, right);
            if (converged(rest, parent)) {
                append(left, right, c);
                return Status::ok;
            }
        }
        const Number middle = (left + right) / Number(2);
        const bool narrow = right - left < Number(1024) * tolerance_.resolution * right;
        if (narrow || depth == most_halvings || result_.panels.size() >= most_panels)
            return sampled == Status::ok ? Status::outside_domain : sampled;
        if (Status status = divide(left, middle, rest, depth + 1); status != Status::ok) return status;
        return divide(middle, right, rest, depth + 1);
    }

    void append(const Number& left, const Number& right, const Coefficients& c) {
        Panel<Number, Count, Nodes> panel;
        panel.middle = (left + right) / Number(2);
        panel.half = (right - left) / Number(2);
        for (std::size_t k = 0; k < Count; ++k) {
            auto& coefficient = panel.coefficient[k];
            coefficient = chebyshev_.primitive(c[k]);
            Number whole = Number(0);
            for (Number& x : coefficient) {
                x = x * panel.half;
                whole = whole + x;
            }
            coefficient[0] = coefficient[0] + sums_[k].value();
            sums_[k].add(whole);
            const Number share = (right - left) / Number(static_cast<int>(Nodes));
            for (const Number& x : values_[k]) sizes_[k] = sizes_[k] + share * math::magnitude(x);
        }
        result_.panels.push_back(panel);
        result_.end = right;
    }

    const Integrand& integrand_;
    Number end_;
    FitTolerance<Number> tolerance_;
    const Fit& chebyshev_ = Fit::once();
    Coefficients values_{};
    std::array<Number, Count> sizes_{}; // int |f_k| so far
    std::array<CompensatedSum<Number>, Count> sums_{};
    Panels<Number, Count, Nodes> result_;
};

// Integrals over [0, end], end > 0, of the functions integrand(T) -> std::array<Number, Count>, to full
// precision unless the tolerance says otherwise.
// Status: overflow, outside_domain: an integrand is infinite, or not a number; outside_domain too when
// 2048 panels, or the spacing of numbers, do not resolve it (a singularity within or next to the interval).
// The panels then end before that place.
template <class Number, std::size_t Count, std::size_t Nodes = panel_nodes<Number>, class Integrand>
Panels<Number, Count, Nodes> fit_panels(const Integrand& integrand, const Number& end,
                                        const FitTolerance<Number>& tolerance = {}) {
    return PanelFitter<Number, Count, Nodes, Integrand>(integrand, end, tolerance).fit();
}

// Finds the panel of T in constant time: a grid of buckets, then a step or two to the right.
template <class Real> class PanelIndex {
public:
    PanelIndex() = default;
    // lefts: the left ends of the panels, ascending, the first 0.
    PanelIndex(std::vector<Real> lefts, const Real& end) : lefts_(std::move(lefts)) {
        std::size_t buckets = 1;
        while (buckets < 2 * lefts_.size()) buckets *= 2;
        per_unit_ = static_cast<double>(buckets) / static_cast<double>(end);
        std::size_t panel = 0;
        for (std::size_t b = 0; b < buckets; ++b) {
            while (panel + 1 < lefts_.size() && !(position(lefts_[panel + 1]) > static_cast<double>(b)))
                ++panel;
            first_.push_back(panel);
        }
    }

    // T slightly outside of [0, end] belongs to the first or the last panel.
    [[nodiscard]] std::size_t find(const Real& T) const noexcept {
        const double p = position(T);
        const auto bucket = p > 0 ? static_cast<std::size_t>(p) : 0;
        std::size_t panel = first_[std::min(bucket, first_.size() - 1)];
        while (panel + 1 < lefts_.size() && !(T < lefts_[panel + 1])) ++panel;
        return panel;
    }

private:
    [[nodiscard]] double position(const Real& T) const noexcept { return static_cast<double>(T) * per_unit_; }

    std::vector<Real> lefts_;
    std::vector<std::size_t> first_;
    double per_unit_ = 0;
};

} // namespace resonform

#endif
