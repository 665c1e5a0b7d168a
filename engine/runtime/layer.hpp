// SPDX-License-Identifier: MIT
// Where the layer around a resonance surface is entered: a margin, > 0 outside of it, is sampled, and its
// minima between samples are looked for.
//
//   clear_of_layers([](double T) { return std::array{(T - 0.3)*(T - 0.3) - 0.01}; }, std::array{"D"}, reach)
//   ->  {outside_domain, "D"}, reach = 0.2
#ifndef RESONFORM_RUNTIME_LAYER
#define RESONFORM_RUNTIME_LAYER

#include "runtime/math.hpp"
#include "runtime/status.hpp"

#include <cstddef>

namespace resonform {

// One margin on [0, end].
template <class Real, class Margin> class LayerSearch {
public:
    LayerSearch(const Margin& margin, const Real& end) : margin_(margin), end_(end) {}

    // The last place outside before the margin fails for the first time; end, if it never does.
    Real last_clear() {
        Real before = Real(0), here = margin_(Real(0));
        if (!(here > Real(0))) return Real(0);
        for (int i = 1; i <= samples; ++i) {
            const Real next = margin_(place(i));
            if (!(next > Real(0))) return between(place(i - 1), place(i));
            if (i > 1 && here < before && !(next < here)) {
                Real inside;
                if (minimum_fails(place(i - 2), place(i), inside)) return between(place(i - 2), inside);
            }
            before = here;
            here = next;
        }
        return end_;
    }

private:
    static constexpr int samples = 256;

    [[nodiscard]] Real place(int i) const { return end_ * Real(i) / Real(samples); }

    // By the golden section.
    bool minimum_fails(Real left, Real right, Real& inside) {
        for (int n = 0; n < 80; ++n) {
            const Real a = left + (right - left) * Real(382) / Real(1000);
            const Real b = left + (right - left) * Real(618) / Real(1000);
            const Real at_a = margin_(a), at_b = margin_(b);
            inside = at_a > Real(0) ? b : a;
            if (!(at_a > Real(0)) || !(at_b > Real(0))) return true;
            (at_a < at_b ? right : left) = at_a < at_b ? b : a;
        }
        return false;
    }

    // clear at `good`, not at `bad`
    [[nodiscard]] Real between(Real good, Real bad) {
        for (int n = 0; n < 60; ++n) {
            const Real middle = (good + bad) / Real(2);
            (margin_(middle) > Real(0) ? good : bad) = middle;
        }
        return good;
    }

    Margin margin_;
    Real end_;
};

// NaN is not > 0.
template <class Margins> bool all_clear(const Margins& margins) {
    using Real = typename Margins::value_type;
    for (const Real& margin : margins)
        if (!(margin > Real(0))) return false;
    return true;
}

// margins(T) -> an array of margins, each smooth on 0 <= T <= reach, of the divisors named. If one is not > 0
// somewhere (NaN is not), `reach` is drawn back to before that place; 0: there is none. What is narrower than
// 1/128 of the interval and has no slope outside is not seen.
template <class Margins, class Names, class Real>
Cause clear_of_layers(const Margins& margins, const Names& names, Real& reach) {
    Cause cause;
    for (std::size_t k = 0; k < names.size() && Real(0) < reach; ++k) {
        const Real end = reach;
        const auto margin = [&margins, k](const Real& T) { return Real(margins(T)[k]); };
        reach = LayerSearch<Real, decltype(margin)>(margin, end).last_clear();
        if (reach < end) cause = {Status::outside_domain, names[k]};
    }
    return cause;
}

} // namespace resonform

#endif
