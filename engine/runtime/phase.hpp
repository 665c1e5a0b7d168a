// SPDX-License-Identifier: MIT
// cos theta and sin theta of theta(t) = theta_0 + int_0^{eps t} rate(T) dT, where rate is large (of
// order 1/eps): the integral is tabulated in twice the precision of Real and reduced to one turn before
// it is rounded, so that a phase of 10^14 costs no digits.
#pragma once

#include "runtime/panels.hpp"
#include "runtime/twice.hpp"

#include <type_traits>

namespace resonform {

// In which type the rate is evaluated and the phase is kept. Multiprecision has digits to spare.
template <class Real> struct PhaseNumber {
    using type = std::conditional_t<std::is_floating_point_v<Real>, Twice<Real>, Real>;
};
#ifdef RESONFORM_FLOAT128
template <> struct PhaseNumber<Float128> { using type = Twice<Float128>; };
#endif

template <class Real> class Phase {
public:
    using Wide = typename PhaseNumber<Real>::type;

    // Tabulates rate(T) -> std::array<Wide, 1>, T from 0 to end. Status as fit_panels.
    template <class Rate>
    Status build(const Rate& rate, const Wide& start, const Real& eps, const Real& end) {
        eps_ = eps;
        const Panels<Wide, 1> fitted = fit_panels<Wide, 1>(rate, Wide(end));
        if (fitted.status != Status::ok) return fitted.status;
        choose_lengths(fitted);
        std::vector<Real> lefts;
        rows_.clear();
        for (const Panel<Wide, 1>& panel : fitted.panels) {
            lefts.push_back(narrow(panel.middle - panel.half));
            rows_.push_back(row(panel, start));
        }
        index_ = PanelIndex<Real>(std::move(lefts), end);
        return Status::ok;
    }

    // low_precision: the rounding of theta exceeds 1/1000 of a radian; the numbers are set all the same.
    // Precondition: build() answered ok.
    Status operator()(const Real& t, Real& cosine, Real& sine) const noexcept {
        using math::cos;
        using math::sin;
        const Wide T = exact_product(eps_, t);
        const Row& r = rows_[index_.find(narrow(T))];
        const Wide x = (T - r.middle) * r.per_half;
        const Real rough = narrow(x);
        Real tail = Real(0);
        for (std::size_t j = length_; j > wide_length_; --j) tail = tail * rough + r.low[j - 1];
        Wide theta(tail);
        for (std::size_t j = wide_length_; j > 0; --j) theta = theta * x + r.coefficient[j - 1];
        theta = reduce(theta);
        const Real angle = narrow(theta), rest = narrow(theta - Wide(angle));
        const Real c = cos(angle), s = sin(angle);
        cosine = c - s * rest;
        sine = s + c * rest;
        return r.precise ? Status::ok : Status::low_precision;
    }

private:
    static constexpr std::size_t terms = Panel<Wide, 1>::size;
    struct Row {
        Wide middle{}, per_half{};
        std::array<Wide, terms> coefficient{}; // the constant term reduced to one turn
        std::array<Real, terms> low{};         // the same, rounded
        bool precise = true;
    };

    static Real narrow(const Wide& x) { return static_cast<Real>(x); }
    static Wide exact_product(const Real& a, const Real& b) {
        if constexpr (std::is_same_v<Wide, Real>)
            return a * b;
        else
            return Wide::product(a, b);
    }
    static Wide reduce(const Wide& theta) {
        using math::floor;
        static const Wide turn = Wide(2) * math::pi<Wide>(), per_turn = Wide(1) / turn;
        const Real turns = floor(narrow(theta * per_turn) + Real(1) / Real(2));
        return theta - Wide(turns) * turn;
    }

    // An absolute error of ulp(1)/8 is asked of theta: terms beyond `length_` are below it, and the
    // rounding of terms beyond `wide_length_` is.
    void choose_lengths(const Panels<Wide, 1>& fitted) {
        const Real ulp = math::epsilon<Real>();
        length_ = wide_length_ = 1;
        for (const Panel<Wide, 1>& panel : fitted.panels) {
            Real rest = Real(0);
            for (std::size_t j = terms; j > 1; --j) {
                rest = rest + math::magnitude(narrow(panel.coefficient[0][j - 1]));
                if (rest > ulp / Real(8)) length_ = std::max(length_, j);
                if (rest > Real(1) / Real(8)) wide_length_ = std::max(wide_length_, j);
            }
        }
    }

    static Row row(const Panel<Wide, 1>& panel, const Wide& start) {
        Row result;
        result.middle = panel.middle;
        result.per_half = Wide(1) / panel.half;
        result.coefficient = panel.coefficient[0];
        Wide& base = result.coefficient[0];
        base = base + start;
        Real largest = Real(0);
        for (const Wide& c : result.coefficient) largest = largest + math::magnitude(narrow(c));
        result.precise = largest * narrow(math::epsilon<Wide>()) * Real(8000) < Real(1);
        base = reduce(base);
        for (std::size_t j = 0; j < terms; ++j) result.low[j] = narrow(result.coefficient[j]);
        return result;
    }

    Real eps_{};
    std::size_t length_ = 1, wide_length_ = 1;
    std::vector<Row> rows_;
    PanelIndex<Real> index_;
};

} // namespace resonform
