// SPDX-License-Identifier: MIT
// e^chi of an exponent chi(t) = chi_0 + int_0^{eps t} rate(T) dT, where rate is large (of order 1/eps) and
// negative: the integral is tabulated in twice the precision of Real, so that the relative error of e^chi is
// not |chi| ulp. Below the range of Real e^chi is 0.
#ifndef RESONFORM_RUNTIME_DECAY
#define RESONFORM_RUNTIME_DECAY

#include "runtime/lanes.hpp"
#include "runtime/panels.hpp"
#include "runtime/twice.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

namespace resonform {

// eps (t + low), not rounded to Real; |low| is below the last place of t.
template <class Number, class Real>
Number wide_product(const Real& eps, const Real& t, const Real& low = Real(0)) {
    if constexpr (std::is_same_v<Number, Twice<Real>>) {
        const Number product = Number::product(eps, t);
        return {product.high, product.low + eps * low};
    } else {
        return Number(eps) * (Number(t) + Number(low));
    }
}

// e^x with the relative error of Real.
template <class Real, class Number> Real exponential(const Number& x) {
    using math::exp;
    const Real high = static_cast<Real>(x), low = static_cast<Real>(x - Number(high)), value = exp(high);
    return value + value * low;
}

// A power of e below this is taken for 0, as tables do (runtime/kernel/block.hpp). A larger one is kept: it
// may be all that an output has left.
inline constexpr double faded_power = 0x1p-1021;

// Of all that decays with these powers of e nothing is left that a phase beside them could turn.
template <class Real, class... More> bool faded(const Real& power, const More&... more) {
    return power < Real(faded_power) && (faded(more) && ...);
}

// Likewise of several side by side, with those powers whose bits are set; not, if none is.
template <class Real, std::size_t Count>
typename LanesOf<Real>::Truth all_faded(unsigned long long bits, const std::array<Real, Count>& power) {
    using Lanes = LanesOf<Real>;
    auto gone = bits == 0 ? Lanes::negated(Lanes::all()) : Lanes::all();
    for (std::size_t k = 0; k < Count; ++k)
        if ((bits >> k & 1U) != 0) gone = Lanes::both(gone, power[k] < Real(faded_power));
    return gone;
}

template <class Real, class WideReal = WideNumber<Real>> class Decay {
public:
    using Wide = WideReal;

    // Tabulates rate(T) -> std::array<Wide, 1>, T from 0 to end. `rounded`: the rate has the precision of
    // Real only (it contains tables). Status as fit_panels; `end` is drawn back to where the exponent is
    // known.
    template <class Rate>
    Status build(const Rate& rate, const Wide& start, const Real& eps, Real& end, bool rounded = false) {
        eps_ = eps;
        FitTolerance<Wide> tolerance;
        tolerance.absolute = Wide(math::epsilon<Real>() / end);
        if (rounded) tolerance.relative = Wide(Real(4) * math::epsilon<Real>());
        Panels<Wide, 1> fitted = fit_panels<Wide, 1>(rate, Wide(end), tolerance);
        end = static_cast<Real>(fitted.end);
        rows_.clear();
        std::vector<Real> lefts;
        for (const Panel<Wide, 1>& panel : fitted.panels) {
            lefts.push_back(static_cast<Real>(panel.middle - panel.half));
            rows_.push_back(row(panel, start, rows_.empty()));
        }
        if (!rows_.empty()) index_ = PanelIndex<Real>(std::move(lefts), end);
        return fitted.status;
    }

    // Precondition: build() left an end > 0. low: for t + low, |low| below the last place of t.
    Real operator()(const Real& t, const Real& low = Real(0)) const noexcept {
        const Wide T = wide_product<Wide>(eps_, t, low);
        const Row& r = rows_[index_.find(static_cast<Real>(T))];
        const Wide y = (T - r.middle) * r.scale;
        const Real rough = static_cast<Real>(y);
        Real about = Real(0);
        for (std::size_t j = r.length; j > 0; --j)
            about = about * rough + static_cast<Real>(r.coefficient[j - 1]);
        if (about < r.surely_gone) return Real(0);
        Wide x = r.coefficient[r.length - 1];
        for (std::size_t j = r.length - 1; j > 0; --j) x = x * y + r.coefficient[j - 1];
        return exponential<Real>(x);
    }

private:
    static constexpr std::size_t terms = Panel<Wide, 1>::size;
    struct Row { // chi = sum_j coefficient[j] y^j, y = (T - middle) scale
        Wide middle{}, scale{};
        std::array<Wide, terms> coefficient{};
        std::size_t length = 1;
        Real surely_gone{}; // an exponent below this, in Real, leaves no number
    };

    // About T = 0 in the first panel: an exponent of 10^18 at its end leaves the digits of a small one there.
    static Row row(const Panel<Wide, 1>& panel, const Wide& start, bool first) {
        using math::log;
        Row r{panel.middle, Wide(1) / panel.half, panel.coefficient[0], 1, {}};
        Real reach = Real(1), size = Real(0); // reach: the largest y^j
        if (first) {
            r.middle = Wide(0);
            r.coefficient = recentred(r.coefficient, Wide(-1), terms);
            r.coefficient[0] = start;
        } else {
            r.coefficient[0] = r.coefficient[0] + start;
        }
        for (std::size_t j = 0; j < terms; ++j) {
            const Real c = reach * math::magnitude(static_cast<Real>(r.coefficient[j]));
            size = size + c;
            if (c > math::epsilon<Real>() / Real(4096)) r.length = j + 1;
            if (first) reach = Real(2) * reach;
        }
        const Real least = log(math::smallest<Real>()), digits = Real(math::digits<Real>);
        r.surely_gone = least - digits - Real(64) * math::epsilon<Real>() * size;
        return r;
    }

    Real eps_{};
    std::vector<Row> rows_;
    PanelIndex<Real> index_;
};

} // namespace resonform

#endif
