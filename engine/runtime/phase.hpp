// SPDX-License-Identifier: MIT
// cos theta and sin theta of theta(t) = theta_0 + int_0^{eps t} rate(T) dT, where rate is large (of
// order 1/eps): the integral is tabulated in twice the precision of Real and reduced to one turn before
// it is rounded, so that a phase of 10^14 costs no digits.
#ifndef RESONFORM_RUNTIME_PHASE
#define RESONFORM_RUNTIME_PHASE

#include "runtime/panels.hpp"
#include "runtime/twice.hpp"

#include <type_traits>

namespace resonform {

// What a phase is known to in radians, or it ends.
inline constexpr double known_radians = 1e-3;

template <class Real, class WideReal = WideNumber<Real>> class Phase {
public:
    using Wide = WideReal;

    // Tabulates rate(T) -> std::array<Wide, 1>, T from 0 to end. `rounded`: the rate has the precision of
    // Real only (it contains tables). Status as fit_panels, or outside_interval: the phase gets so large that
    // it is not known to known_radians. If it is not ok, `end` is drawn back to where the phase is known, 0
    // if nowhere. `fades`: what turns with it decays, so that it ends nowhere.
    template <class Rate>
    Status build(const Rate& rate, const Wide& start, const Real& eps, Real& end, bool rounded = false,
                 bool fades = false) {
        eps_ = eps;
        fades_ = fades;
        FitTolerance<Wide> tolerance;
        tolerance.absolute = Wide(math::epsilon<Real>() / end);
        resolution_ = narrow(math::epsilon<Wide>());
        if (rounded) {
            tolerance.relative = Wide(Real(4) * math::epsilon<Real>());
            resolution_ = math::epsilon<Real>();
        }
        // Of an interval that is far too long even the first row may be unknown as a whole.
        const Real asked = end;
        Status status = tabulate(rate, start, tolerance, end);
        for (Real shorter = asked;
             status == Status::outside_interval && rows_.empty() && shorter > Real(1e-250);) {
            shorter = shorter / Real(1048576);
            end = shorter;
            status = tabulate(rate, start, tolerance, end);
            if (status == Status::ok) status = Status::outside_interval;
        }
        return status;
    }

    // low_precision: theta may exceed 10^14, or be wrong by more than 10^-9 radians, as estimated from
    // |theta| at t and the precision of its rate; the numbers are set all the same.
    // Precondition: build() left an end > 0. low: for t + low, |low| below the last place of t.
    Status operator()(const Real& t, Real& cosine, Real& sine) const noexcept {
        return (*this)(t, Real(0), cosine, sine);
    }
    Status operator()(const Real& t, const Real& low, Real& cosine, Real& sine) const noexcept {
        using math::cos;
        using math::floor;
        using math::sin;
        const Wide T = slow_time(t, low);
        const Row& r = rows_[index_.find(narrow(T))];
        const Wide y = local(T, r);
        const Real rough = narrow(y);
        Real tail = Real(0);
        for (std::size_t j = length_; j > wide_length_; --j) tail = (tail + r.low[j - 1]) * rough;
        Wide turns = r.coefficient[wide_length_ - 1] + Wide(tail);
        for (std::size_t j = wide_length_ - 1; j > 0; --j)
            turns = multiply_add(turns, y, r.coefficient[j - 1]);
        const Real whole = floor(narrow(turns) + Real(1) / Real(2));
        Real rest;
        const Real angle = radians(turns, whole, rest);
        const Real c = cos(angle), s = sin(angle);
        cosine = c - s * rest;
        sine = s + c * rest;
        return math::magnitude(r.whole + narrow(turns)) <= r.most ? Status::ok : Status::low_precision;
    }

    // False: some times are answered with low_precision.
    [[nodiscard]] bool precise() const noexcept {
        for (const Row& r : rows_)
            if (!r.precise) return false;
        return true;
    }

private:
    static constexpr std::size_t terms = Panel<Wide, 1>::size;
    using Coefficients = std::array<Wide, terms>;
    struct Row { // theta/(2 pi) = sum_j coefficient[j] y^j, y = (T - middle) scale
        Real middle{}, scale{};
        Coefficients coefficient{};    // the constant term without whole turns
        std::array<Real, terms> low{}; // the same, rounded
        Real whole{}, most{};          // those turns; the largest |theta|/(2 pi) that is precise
        bool precise = true, known = true;
    };

    static Real narrow(const Wide& x) { return static_cast<Real>(x); }
    [[nodiscard]] Wide slow_time(const Real& t, const Real& low) const noexcept {
        if constexpr (std::is_same_v<Wide, Real>) {
            return eps_ * (t + low);
        } else {
            const Wide T = Wide::product(eps_, t);
            return {T.high, T.low + eps_ * low};
        }
    }
    static Wide multiply_add(const Wide& a, const Wide& b, const Wide& c) {
        if constexpr (std::is_same_v<Wide, Real>)
            return a * b + c;
        else
            return Wide::multiply_add(a, b, c);
    }
    // 2 pi (turns - whole) = result + rest, |turns - whole| at most about 1/2.
    [[nodiscard]] Real radians(const Wide& turns, const Real& whole, Real& rest) const noexcept {
        if constexpr (std::is_same_v<Wide, Real>) {
            rest = Real(0);
            return (turns - whole) * turn_;
        } else {
            const Wide part = Wide::sum(turns.high - whole, turns.low); // the difference is exact
            const Wide angle = Wide::product(part.high, turn_.high);
            rest = angle.low + (part.high * turn_.low + part.low * turn_.high);
            return angle.high;
        }
    }
    // scale is a power of two: only T - middle has to be computed with care.
    static Wide local(const Wide& T, const Row& r) {
        if constexpr (std::is_same_v<Wide, Real>) {
            return (T - r.middle) * r.scale;
        } else {
            const Wide difference = Wide::sum(T.high, -r.middle);
            return Wide::sorted_sum(difference.high * r.scale, (difference.low + T.low) * r.scale);
        }
    }

    // The rows up to `end`, which is drawn back to where they are known.
    template <class Rate>
    Status tabulate(const Rate& rate, const Wide& start, const FitTolerance<Wide>& tolerance, Real& end) {
        const Panels<Wide, 1> fitted = fit_panels<Wide, 1>(rate, Wide(end), tolerance);
        Status status = fitted.status;
        end = narrow(fitted.end);
        rows_.clear();
        std::vector<Real> lefts;
        for (const Panel<Wide, 1>& panel : fitted.panels) divide(panel, start, lefts);
        for (std::size_t k = 0; k < rows_.size(); ++k) {
            if (rows_[k].known || fades_) continue;
            status = Status::outside_interval;
            end = k == 0 ? Real(0) : lefts[k];
            rows_.resize(k);
            lefts.resize(k);
        }
        if (rows_.empty()) return status;
        choose_lengths();
        index_ = PanelIndex<Real>(std::move(lefts), end);
        return status;
    }

    // Cuts a panel into 2^k rows in which the terms from the second on are below 1/4 of a turn, so that
    // few of them have to be evaluated in Wide, and few at all.
    void divide(const Panel<Wide, 1>& panel, const Wide& start, std::vector<Real>& lefts) {
        Coefficients c = panel.coefficient[0];
        c[0] = c[0] + start;
        for (Wide& x : c) x = x * per_turn_;
        Real curved = Real(0);
        for (std::size_t j = 2; j < terms; ++j) curved = curved + math::magnitude(narrow(c[j]));
        curved = curved / Real(least_parts * least_parts);
        const Wide inverse = Wide(1) / panel.half;
        int parts = least_parts;
        for (; parts < most_parts && curved > Real(1) / Real(4); parts *= 2) curved = curved / Real(4);
        for (int k = 0; k < parts; ++k) {
            const Wide left = Wide(Real(2 * k - parts) / Real(parts)); // in units of panel.half, exact
            lefts.push_back(narrow(panel.middle + panel.half * left));
            rows_.push_back(row(panel, c, inverse, left + Wide(Real(1) / Real(parts)), parts));
        }
    }

    // The part of a panel around x, the panel's own variable, re-expanded (Horner's scheme, repeated).
    // inverse: 1/panel.half.
    Row row(const Panel<Wide, 1>& panel, const Coefficients& c, const Wide& inverse, const Wide& x,
            int parts) const {
        Row result;
        result.middle = narrow(panel.middle + panel.half * x);
        result.scale = Real(1);
        // |y| <= 1 within the row: the coefficients say how large their terms are.
        while (result.scale * narrow(panel.half) > Real(parts)) result.scale = result.scale / Real(2);
        while (Real(2) * result.scale * narrow(panel.half) <= Real(parts))
            result.scale = result.scale * Real(2);
        const Wide centre = (Wide(result.middle) - panel.middle) * inverse;
        const Wide unit = inverse * Wide(Real(1) / result.scale); // scale is a power of two
        result.coefficient = around(c, centre);
        Wide power(1);
        Real largest = Real(0);
        for (Wide& coefficient : result.coefficient) {
            coefficient = coefficient * power;
            power = power * unit;
            largest = largest + math::magnitude(narrow(coefficient));
        }
        const Real radians = largest * narrow(turn_);
        // A rounded rate costs digits in proportion to theta, at any time. A row of 10^14 radians is as
        // wrong at all of its times: its own terms are known to the last place of Real only up to there.
        const Real most = radians <= Real(1e14) ? Real(1e-9) / resolution_ : Real(-1);
        result.most = most / narrow(turn_);
        result.precise = radians <= most;
        result.known = radians * resolution_ <= Real(known_radians);
        using math::floor;
        result.whole = floor(narrow(result.coefficient[0]));
        result.coefficient[0] = result.coefficient[0] - Wide(result.whole);
        for (std::size_t j = 0; j < terms; ++j) result.low[j] = narrow(result.coefficient[j]);
        return result;
    }

    // The polynomial by powers of x - centre. The last terms, together below 1/128 of a turn, are re-expanded
    // in Real: they grow by little within a row, so that its rounding stays below a last place of the angle.
    static Coefficients around(const Coefficients& c, const Wide& centre) {
        const Real negligible = math::epsilon<Real>() / Real(4096);
        std::size_t used = terms;
        while (used > 1 && math::magnitude(narrow(c[used - 1])) < negligible) --used;
        if constexpr (std::is_same_v<Wide, Real>) {
            return recentred(c, centre, used);
        } else {
            std::array<Real, terms> small{};
            std::size_t large = used;
            for (Real rest(0); large > 1; --large) {
                small[large - 1] = narrow(c[large - 1]);
                rest = math::magnitude(small[large - 1]) + Real(5) / Real(4) * rest;
                if (rest > Real(1) / Real(128)) break;
            }
            Coefficients result{};
            for (std::size_t j = 0; j < large; ++j) {
                result[j] = c[j];
                small[j] = Real(0);
            }
            result = recentred(result, centre, large);
            small = recentred(small, narrow(centre), used);
            for (std::size_t j = 0; j < used; ++j) result[j] = result[j] + Wide(small[j]);
            return result;
        }
    }

    // Terms beyond `length_` are below ulp(1)/64 of a turn, and so is the rounding of those beyond
    // `wide_length_`, or nearly.
    void choose_lengths() {
        const Real ulp = math::epsilon<Real>();
        length_ = wide_length_ = 1;
        for (const Row& r : rows_) {
            Real rest = Real(0);
            for (std::size_t j = terms; j > 1; --j) {
                rest = rest + math::magnitude(r.low[j - 1]);
                if (rest > ulp / Real(64)) length_ = std::max(length_, j);
                if (rest > Real(1) / Real(16)) wide_length_ = std::max(wide_length_, j);
            }
        }
    }

    static constexpr int least_parts = 8, most_parts = 32;
    Wide turn_ = Wide(2) * math::pi<Wide>(), per_turn_ = Wide(1) / turn_;
    Real eps_{}, resolution_{}; // resolution_: relative error of the rate
    bool fades_ = false;
    std::size_t length_ = 1, wide_length_ = 1;
    std::vector<Row> rows_;
    PanelIndex<Real> index_;
};

} // namespace resonform

#endif
