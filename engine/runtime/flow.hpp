// SPDX-License-Identifier: MIT
// The solution of y' = f(T, y), y(0) given, as piecewise polynomials on 0 <= T <= end, computed once and
// looked up afterwards:
//
//   y' = -y, y(0) = 1   ->   exp(-T) to about the precision of Real, in any real type
//
// In each panel y is the fixed point of y(T) = y(left) + int f(T', y(T')) dT' at Chebyshev nodes; a panel
// is halved until the iteration contracts and the coefficients of f decay to the precision of Real.
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
    // not a number, or 512 panels do not resolve the solution (it may be infinite at a finite T);
    // outside_interval: `most` panels end before `end` does. `end` is drawn back to where the solution is
    // known, 0 if nowhere. If there is a rates.scale(T, y), that is how large the terms of the rates are:
    // they are known to the last place of this only.
    template <class Rates>
    Status build(const Rates& rates, const Values& start, Real& end, std::size_t most = most_panels) {
        FlowPanels<Values> fitted(start);
        const Status status = fitted.solve(rates, end, most);
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
    static constexpr std::size_t most_halved = 512; // where a step was refused
    struct Panel { // y_k = sum_j coefficient[k][j] x^j, T = middle + half x; of the first panel middle = 0
        Real middle{}, half{};
        std::vector<std::array<Real, Chebyshev<Real>::n + 1>> coefficient;
    };
    std::vector<Panel> panels;
    std::vector<Real> lefts;

    explicit FlowPanels(const Values& start)
        : values_(start.size()), scale_(start.size()), at_nodes_(start.size()), rates_(start.size()),
          coefficients_(start.size()), argument_(start), noise_(start) {
        for (std::size_t k = 0; k < start.size(); ++k) {
            values_[k].add(start[k]);
            scale_[k] = math::magnitude(start[k]);
            noise_[k] = Real(0);
        }
    }

    template <class Rates> Status solve(const Rates& rates, Real& end, std::size_t most) {
        Real left = Real(0), step = end, refused = Real(-1);
        while (left < end) {
            if (panels.size() == most) {
                end = left;
                return Status::outside_interval;
            }
            if (end - left < step * (Real(1) + Real(64) * math::epsilon<Real>())) step = end - left;
            if constexpr (requires { rates.scale(left, argument_); }) {
                for (std::size_t k = 0; k < values_.size(); ++k) argument_[k] = values_[k].value();
                noise_ = rates.scale(left, argument_);
                for (Real& x : noise_) x = x * step;
            }
            const Status tried = iterate(rates, left, step);
            const bool contracts = tried == Status::ok && contracted_;
            const Real rest = contracts ? remainder(step) : Real(-1);
            if (contracts && accepted(rest, refused)) {
                append(left, step);
                left = end - left > step ? left + step : end;
                refused = Real(-1);
                if (rest < Real(1) / Real(4096)) step = step * Real(2);
                continue;
            }
            refused = rest;
            step = step / Real(2);
            if (panels.size() < most_halved && step * Real(1e9) > end) continue;
            end = left;
            return tried == Status::ok ? Status::outside_domain : tried;
        }
        return Status::ok;
    }

private:
    using Nodes = typename Chebyshev<Real>::Values;
    static constexpr std::size_t n = Chebyshev<Real>::n;
    static constexpr int most_iterations = 100;

    // The fixed point on [left, left + step]; contracted_ says whether it was reached.
    template <class Rates> Status iterate(const Rates& rates, const Real& left, const Real& step) {
        const Real half = step / Real(2);
        for (std::size_t k = 0; k < values_.size(); ++k) at_nodes_[k].fill(values_[k].value());
        Real before = Real(-1);
        contracted_ = false;
        for (int i = 0; i < most_iterations && !contracted_; ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                for (std::size_t k = 0; k < values_.size(); ++k) argument_[k] = at_nodes_[k][j];
                const Values f = rates(Real(left + half * (Real(1) + chebyshev_.node(j))), argument_);
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

    // New values at the nodes from the rates there; the largest change in units of the last place.
    Real update(const Real& half) {
        Real change = Real(0);
        for (std::size_t k = 0; k < values_.size(); ++k) {
            const Real start = values_[k].value();
            for (std::size_t j = 0; j < n; ++j) {
                Real integral = Real(0);
                for (std::size_t m = 0; m < n; ++m) integral = integral + integration_[j][m] * rates_[k][m];
                const Real next = start + half * integral;
                const Real unit = size(k, next) * math::epsilon<Real>();
                if (Real(0) < unit)
                    change = std::max(change, Real(math::magnitude(Real(next - at_nodes_[k][j])) / unit));
                at_nodes_[k][j] = next;
            }
        }
        return change;
    }

    [[nodiscard]] Real size(std::size_t k, const Real& value) const {
        return std::max(std::max(scale_[k], noise_[k]), Real(math::magnitude(value)));
    }

    // What the last coefficients of the rates leave open of the values, in units of the tolerance.
    Real remainder(const Real& step) {
        Real worst = Real(0);
        for (std::size_t k = 0; k < values_.size(); ++k) {
            coefficients_[k] = chebyshev_.coefficients(rates_[k]);
            Real largest = Real(0);
            for (const Real& y : at_nodes_[k]) largest = std::max(largest, size(k, y));
            const Real last = math::magnitude(coefficients_[k].back());
            const Real before = math::magnitude(coefficients_[k][n - 2]) / Real(8);
            const Real tolerance = Real(8) * math::epsilon<Real>() * largest;
            if (Real(0) < tolerance) worst = std::max(worst, Real(std::max(last, before) * step / tolerance));
        }
        return worst;
    }

    // Where halving gains nothing close to the tolerance, the rounding of the rates themselves is seen.
    static bool accepted(const Real& rest, const Real& refused) {
        return !(Real(1) < rest) || (rest < Real(1000) && Real(0) < refused && refused < Real(4) * rest);
    }

    void append(const Real& left, const Real& step) {
        Panel panel;
        panel.half = step / Real(2);
        const bool first = panels.empty();
        panel.middle = first ? left : left + panel.half;
        for (std::size_t k = 0; k < values_.size(); ++k) {
            auto coefficient = Chebyshev<Real>::primitive(coefficients_[k]);
            Real whole = Real(0);
            for (Real& x : coefficient) {
                x = x * panel.half;
                whole = whole + x;
            }
            // About T = 0 in the first panel: what starts small is known to its own digits there.
            if (first) coefficient = recentred(coefficient, Real(-1), coefficient.size());
            coefficient[0] = first ? values_[k].value() : coefficient[0] + values_[k].value();
            panel.coefficient.push_back(coefficient);
            values_[k].add(whole);
            for (const Real& y : at_nodes_[k]) scale_[k] = std::max(scale_[k], Real(math::magnitude(y)));
        }
        panels.push_back(std::move(panel));
        lefts.push_back(left);
    }

    // The same for all flows; in many digits they take a while.
    static const Chebyshev<Real>& chebyshev() {
        static const Chebyshev<Real> once;
        return once;
    }
    static const std::array<Nodes, n>& integration() {
        static const std::array<Nodes, n> once = chebyshev().integration();
        return once;
    }

    const Chebyshev<Real>& chebyshev_ = chebyshev();
    const std::array<Nodes, n>& integration_ = integration();
    std::vector<CompensatedSum<Real>> values_; // at the left end of what is next
    std::vector<Real> scale_;                  // of each value so far
    std::vector<Nodes> at_nodes_, rates_, coefficients_;
    Values argument_, noise_;
    bool contracted_ = false;
};

} // namespace resonform

#endif
