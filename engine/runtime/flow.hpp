// SPDX-License-Identifier: MIT
// The solution of y' = f(T, y), y(0) given, as piecewise polynomials on 0 <= T <= end, computed once and
// looked up afterwards:
//
//   y' = -y, y(0) = 1   ->   exp(-T) to about the precision of Real, in any real type
//
// In each panel y is the fixed point of y(T) = y(left) + int f(T', y(T')) dT' at Chebyshev nodes; a panel
// is halved until the iteration contracts and the coefficients of f decay to the precision of Real, each
// value measured by its size within the panel: what falls by 1e-30 and rises again keeps its digits.
// For slow flows, which are smooth and not stiff. Errors of the panels add up, and the flow carries them
// on: where neighbouring solutions separate by a factor, digits are lost by that factor.
#ifndef RESONFORM_RUNTIME_FLOW
#define RESONFORM_RUNTIME_FLOW

#include "runtime/panels.hpp"

namespace resonform {

template <class Values> class FlowPanels;

// Values: std::array<Real, n>, or std::vector<Real> where n is not known before.
template <class Values> class FlowTable {
public:
    using Real = typename Values::value_type;

    // A flow that takes more panels than this turns too often for a table: at fast rates in slow time.
    static constexpr std::size_t most_panels = 16384;

    // Solves y' = rates(T, y) from y(0) = start. Status: overflow, outside_domain: a rate is infinite, or
    // not a number; outside_domain too where 4096 panels do not resolve the solution (it may be infinite at a
    // finite T), overflow where a value that fell below the range of Real would rise above it again;
    // outside_interval: `most` panels end before `end` does. `end` is drawn back to where the solution is
    // known, 0 if nowhere. Rates are known to what the last places of T and y make of them and, if there is a
    // rates.scale(T, y), how large their terms are, to the last place of this.
    template <class Rates>
    Status build(const Rates& rates, const Values& start, Real& end, std::size_t most = most_panels) {
        return build_while(
            rates, [](const Real&, const Values&) { return true; }, start, end, most);
    }

    // The same up to a panel at whose end goes_on(T, y) is false, outside_domain: behind the layer around a
    // resonance surface thousands of panels may lead to where a rate is infinite, and nothing is asked of
    // them.
    template <class Rates, class GoesOn>
    Status build_while(const Rates& rates, const GoesOn& goes_on, const Values& start, Real& end,
                       std::size_t most = most_panels) {
        FlowPanels<Values> fitted(start);
        const Status status = fitted.solve(rates, goes_on, end, most);
        start_ = start;
        panels_ = std::move(fitted.panels);
        if (!panels_.empty()) index_ = PanelIndex<Real>(std::move(fitted.lefts), end);
        return status;
    }

    // Precondition: build() left an end > 0.
    [[nodiscard]] Values operator()(const Real& T) const noexcept {
        const typename FlowPanels<Values>::Panel& panel = panels_[index_.find(T)];
        const Real x = (T - panel.middle) / panel.half;
        Values value = start_;
        for (std::size_t k = 0; k < value.size(); ++k) {
            const auto& c = panel.coefficient[k];
            value[k] = c.back();
            for (std::size_t j = c.size() - 1; j > 0; --j) value[k] = value[k] * x + c[j - 1];
        }
        return value;
    }

    [[nodiscard]] std::size_t panels() const { return panels_.size(); }

private:
    Values start_{};
    std::vector<typename FlowPanels<Values>::Panel> panels_;
    PanelIndex<Real> index_;
};

// The panels under construction.
template <class Values> class FlowPanels {
public:
    using Real = typename Values::value_type;
    static constexpr std::size_t most_halved = 4096; // where a step was refused
    struct Panel { // y_k = sum_j coefficient[k][j] x^j, T = middle + half x; of the first panel middle = 0
        Real middle{}, half{};
        std::vector<std::array<Real, Chebyshev<Real>::n + 1>> coefficient;
    };
    std::vector<Panel> panels;
    std::vector<Real> lefts;

    explicit FlowPanels(const Values& start)
        : values_(start.size()), size_(start.size()), blur_(start.size()), at_nodes_(start.size()),
          rates_(start.size()), coefficients_(start.size()), argument_(start),
          seen_(start.size(), Seen::never) {
        for (std::size_t k = 0; k < start.size(); ++k) values_[k].add(start[k]);
    }

    template <class Rates, class GoesOn>
    Status solve(const Rates& rates, const GoesOn& goes_on, Real& end, std::size_t most) {
        Real left = Real(0), step = end, refused = Real(-1);
        while (left < end) {
            const Real stop = end_of_piece(rates, left, end);
            if (panels.size() == most) {
                end = left;
                return Status::outside_interval;
            }
            if (stop - left < step * (Real(1) + Real(64) * math::epsilon<Real>())) step = stop - left;
            const Status tried = iterate(rates, left, step);
            const bool contracts = tried == Status::ok && contracted_;
            const Real rest = contracts ? remainder(step) : Real(-1);
            // Where halving gains nothing close to the tolerance, the rounding of the rates itself is seen.
            const bool rounding =
                Real(1) < rest && rest < Real(1000) && Real(0) < refused && refused < Real(4) * rest;
            if (contracts && (rounding || !(Real(1) < rest)) && resolves_lost(rates, left, step)) {
                if (Real(0) < rise_of_lost_ || !append(left, step)) {
                    end = left;
                    return Status::overflow;
                }
                left = stop - left > step ? left + step : stop;
                if (left < end && !goes_on(left, values())) {
                    end = left;
                    return Status::outside_domain;
                }
                refused = Real(-1);
                // Among rounding the next panel would be halved again: this one is not for good.
                if (rounding || rest < Real(1) / Real(4096)) step = step * Real(2);
                continue;
            }
            refused = rest;
            step = step / Real(2);
            if (panels.size() < most_halved && step * Real(1e9) > end) continue;
            end = left;
            return tried == Status::overflow && leaves_range(rates, left) ? tried : Status::outside_domain;
        }
        return Status::ok;
    }

private:
    using Nodes = typename Chebyshev<Real>::Values;
    static constexpr std::size_t n = Chebyshev<Real>::n;
    static constexpr int most_iterations = 100;
    enum class Seen : unsigned char { never, now, before };

    // The solution where the next panel begins.
    const Values& values() {
        for (std::size_t k = 0; k < values_.size(); ++k) argument_[k] = values_[k].value();
        return argument_;
    }

    // The fixed point on [left, left + step]; contracted_ says whether it was reached.
    template <class Rates> Status iterate(const Rates& rates, const Real& left, const Real& step) {
        const Real half = step / Real(2);
        estimate_blur(rates, Real(left + half));
        for (std::size_t k = 0; k < values_.size(); ++k) at_nodes_[k].fill(values_[k].value());
        Real before = Real(-1);
        contracted_ = false;
        for (int i = 0; i < most_iterations && !contracted_; ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                const Values f = at_node(rates, j, left, half);
                for (std::size_t k = 0; k < values_.size(); ++k) {
                    if (math::is_not_a_number(f[k])) return Status::outside_domain;
                    if (!math::finite(f[k])) return Status::overflow;
                    rates_[k][j] = f[k];
                }
            }
            const Real change = update(half);
            if (!math::finite(change)) return Status::overflow;
            // Either nothing changes any more, or only the last digits do.
            const bool stalls = Real(0) < before && !(change < before);
            contracted_ = change <= Real(2) || (stalls && change <= Real(64));
            if (stalls && i > 12 && !contracted_) return Status::ok; // it does not contract
            before = change;
        }
        return Status::ok;
    }

    template <class Rates>
    Values at_node(const Rates& rates, std::size_t j, const Real& left, const Real& half) {
        for (std::size_t k = 0; k < values_.size(); ++k) argument_[k] = at_nodes_[k][j];
        return rates(Real(left + half * (Real(1) + chebyshev_.node(j))), argument_);
    }

    // blur_: what the last places of T and of all values make of each rate, over epsilon; seen where this
    // panel begins and, halved from one to the next, where others did.
    template <class Rates> void estimate_blur(const Rates& rates, const Real& T) {
        const Real ulp = math::epsilon<Real>();
        const Values f = rates(T, values());
        Values terms = f;
        for (Real& x : terms) x = Real(0);
        if constexpr (requires { rates.scale(T, argument_); }) terms = rates.scale(T, argument_);
        // Each moves by another number of places, so that what cancels among them is seen.
        for (std::size_t k = 0; k < values_.size(); ++k)
            argument_[k] = argument_[k] + argument_[k] * ulp * Real(static_cast<int>(1 + k % 7));
        const Values moved = rates(Real(T + T * ulp), argument_);
        for (std::size_t k = 0; k < values_.size(); ++k) {
            const Real seen = math::magnitude(Real(moved[k] - f[k])) / ulp;
            blur_[k] = std::max(Real(blur_[k] / Real(2)), terms[k]);
            if (math::finite(seen)) blur_[k] = std::max(blur_[k], seen);
        }
    }

    // New values at the nodes from the rates there, and how large each value is within the panel, to the last
    // place of which it is known; the largest change in units of this place.
    Real update(const Real& half) {
        Real change = Real(0);
        for (std::size_t k = 0; k < values_.size(); ++k) {
            const Real start = values_[k].value();
            Real moved = Real(0);
            size_[k] = std::max(std::max(math::magnitude(start), Real(blur_[k] * half * Real(2))), least());
            for (std::size_t j = 0; j < n; ++j) {
                Real integral = Real(0);
                for (std::size_t m = 0; m < n; ++m) integral = integral + integration_[j][m] * rates_[k][m];
                const Real next = start + half * integral;
                size_[k] = std::max(size_[k], Real(math::magnitude(next)));
                moved = std::max(moved, Real(math::magnitude(Real(next - at_nodes_[k][j]))));
                at_nodes_[k][j] = next;
            }
            change = std::max(change, Real(moved / (size_[k] * math::epsilon<Real>())));
        }
        return change;
    }

    // What the last coefficients of the rates leave open of the values, in units of the tolerance.
    Real remainder(const Real& step) {
        Real worst = Real(0);
        for (std::size_t k = 0; k < values_.size(); ++k) {
            coefficients_[k] = chebyshev_.coefficients(rates_[k]);
            const Real last = math::magnitude(coefficients_[k].back());
            const Real before = math::magnitude(coefficients_[k][n - 2]) / Real(8);
            const Real tolerance = Real(8) * math::epsilon<Real>() * size_[k];
            worst = std::max(worst, Real(std::max(last, before) * step / tolerance));
        }
        return worst;
    }

    // Whether values or their rates are near the end of the range of Real: where they are not, an iteration
    // that overflows says no more than that it does not contract.
    template <class Rates> bool leaves_range(const Rates& rates, const Real& left) {
        using math::sqrt;
        const Real near_end = Real(1) / sqrt(math::smallest<Real>());
        const Values f = rates(left, values());
        for (std::size_t k = 0; k < values_.size(); ++k)
            if (!(math::magnitude(argument_[k]) < near_end && math::magnitude(f[k]) < near_end)) return true;
        return false;
    }

    // Below this, values and what rates make of them lose digits to the end of the range of Real.
    static Real least() {
        const Real ulp = math::epsilon<Real>();
        return math::smallest<Real>() / (ulp * ulp);
    }

    // Values that were there and have fallen below the range of Real: their digits are gone, which matters
    // where they would rise again. rise_of_lost_: the exponent by which they have risen at most since they
    // fell. False: the panel is too long to tell.
    template <class Rates> bool resolves_lost(const Rates& rates, const Real& left, const Real& step) {
        std::vector<std::size_t> lost;
        bool more = false;
        for (std::size_t k = 0; k < values_.size(); ++k) {
            if (size_[k] > least()) seen_[k] = Seen::now;
            if (!(size_[k] > least()) && seen_[k] == Seen::now) {
                seen_[k] = Seen::before;
                more = true;
            }
            if (seen_[k] == Seen::before) lost.push_back(k);
        }
        if (more || lost.empty()) rise_of_lost_ = std::max(rise_of_lost_, Real(0)); // begins anew
        if (lost.empty()) return true;
        Real fastest = growth(rates, lost, 0, left, step);
        for (const std::size_t j : {n / 2, n - 1})
            fastest = std::max(fastest, growth(rates, lost, j, left, step));
        const Real rise = fastest * step;
        if (!(math::magnitude(rise) < Real(4))) return false;
        rise_of_lost_ = rise_of_lost_ + rise;
        return true;
    }

    // How fast some values grow by themselves at a node, at most: by rows of the symmetric part of their
    // d rates/d values.
    template <class Rates>
    Real growth(const Rates& rates, const std::vector<std::size_t>& some, std::size_t j, const Real& left,
                const Real& step) {
        using math::sqrt;
        const Real half = step / Real(2), push = sqrt(math::smallest<Real>());
        const Values f = at_node(rates, j, left, half);
        std::vector<Values> moved;
        for (const std::size_t k : some) {
            const Real before = std::exchange(at_nodes_[k][j], Real(at_nodes_[k][j] + push));
            moved.push_back(at_node(rates, j, left, half));
            at_nodes_[k][j] = before;
        }
        const auto slope = [&](std::size_t a, std::size_t b) {
            return (moved[b][some[a]] - f[some[a]]) / push;
        };
        Real fastest = slope(0, 0);
        for (std::size_t a = 0; a < some.size(); ++a) {
            Real row = slope(a, a);
            for (std::size_t b = 0; b < some.size(); ++b)
                if (b != a) row = row + math::magnitude(Real(slope(a, b) + slope(b, a))) / Real(2);
            fastest = std::max(fastest, row);
        }
        return fastest;
    }

    // False, and nothing is appended: by powers of T the panel would be beyond the range of Real.
    bool append(const Real& left, const Real& step) {
        Panel panel;
        panel.half = step / Real(2);
        const bool first = panels.empty();
        panel.middle = first ? left : left + panel.half;
        for (std::size_t k = 0; k < values_.size(); ++k) {
            // Its digits are lost: what is left is rounding, which would rise as if it were the solution.
            if (seen_[k] == Seen::before) {
                values_[k] = CompensatedSum<Real>();
                coefficients_[k].fill(Real(0));
            }
            auto coefficient = chebyshev_.primitive(coefficients_[k]);
            Real whole = Real(0);
            for (Real& x : coefficient) {
                x = x * panel.half;
                whole = whole + x;
            }
            // About T = 0 in the first panel: what starts small is known to its own digits there.
            if (first) coefficient = recentred(coefficient, Real(-1), coefficient.size());
            coefficient[0] = first ? values_[k].value() : coefficient[0] + values_[k].value();
            for (const Real& x : coefficient)
                if (!math::finite(x)) return false;
            panel.coefficient.push_back(coefficient);
            values_[k].add(whole);
        }
        panels.push_back(std::move(panel));
        lefts.push_back(left);
        return true;
    }

    // The same for all flows; in many digits it takes a while.
    static const std::array<Nodes, n>& integration() {
        static const std::array<Nodes, n> once = Chebyshev<Real>::once().integration();
        return once;
    }

    const Chebyshev<Real>& chebyshev_ = Chebyshev<Real>::once();
    const std::array<Nodes, n>& integration_ = integration();
    std::vector<CompensatedSum<Real>> values_; // at the left end of what is next
    std::vector<Real> size_, blur_;            // of each value within the panel; of each rate
    std::vector<Nodes> at_nodes_, rates_, coefficients_;
    Values argument_;
    std::vector<Seen> seen_;
    Real rise_of_lost_{};
    bool contracted_ = false;
};

} // namespace resonform

#endif
