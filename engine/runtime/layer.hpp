// SPDX-License-Identifier: MIT
// Where the layer around a resonance surface is entered: a margin, > 0 outside of it, is sampled, and its
// minima between samples are looked for.
//
//   clear_of_layers([](double T) { return std::array{(T - 0.3)*(T - 0.3) - 0.01}; }, std::array{"D"}, reach)
//   ->  {outside_domain, "D"}, reach = 0.2
#ifndef RESONFORM_RUNTIME_LAYER
#define RESONFORM_RUNTIME_LAYER

#include "runtime/bounds.hpp"
#include "runtime/math.hpp"
#include "runtime/status.hpp"

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace resonform {

// All margins on [0, end], sampled together.
template <class Real, class Margins> class LayerSearch {
public:
    LayerSearch(const Margins& margins, const Real& end, int samples)
        : margins_(margins), end_(end), samples_(samples) {}

    // The last place outside before one of them fails for the first time, and which; end, if none ever does.
    Real last_clear(std::size_t& failed) {
        auto here = margins_(Real(0)), before = here;
        for (std::size_t k = 0; k < here.size(); ++k)
            if (!(here[k] > Real(0))) {
                failed = k;
                return Real(0);
            }
        for (int i = 1; i <= samples_; ++i) {
            auto next = margins_(place(i));
            Real clear = end_;
            for (std::size_t k = 0; k < next.size(); ++k) {
                Real outside = place(i - 1), inside = place(i);
                if (next[k] > Real(0)) {
                    if (i == 1 || !(here[k] < before[k]) || next[k] < here[k]) continue;
                    outside = place(i - 2);
                    if (!minimum_fails(k, outside, place(i), inside)) continue;
                }
                const Real last = between(k, outside, inside);
                if (!(last < clear)) continue;
                clear = last;
                failed = k;
            }
            if (clear < end_) return clear;
            before = std::move(here);
            here = std::move(next);
        }
        return end_;
    }

private:
    [[nodiscard]] Real place(int i) const { return end_ * Real(i) / Real(samples_); }
    [[nodiscard]] Real margin(std::size_t k, const Real& T) const { return Real(margins_(T)[k]); }

    // By the golden section.
    bool minimum_fails(std::size_t k, Real left, Real right, Real& inside) const {
        for (int n = 0; n < 80; ++n) {
            const Real a = left + (right - left) * Real(382) / Real(1000);
            const Real b = left + (right - left) * Real(618) / Real(1000);
            const Real at_a = margin(k, a), at_b = margin(k, b);
            inside = at_a > Real(0) ? b : a;
            if (!(at_a > Real(0)) || !(at_b > Real(0))) return true;
            (at_a < at_b ? right : left) = at_a < at_b ? b : a;
        }
        return false;
    }

    // clear at `good`, not at `bad`
    [[nodiscard]] Real between(std::size_t k, Real good, Real bad) const {
        for (int n = 0; n < 60; ++n) {
            const Real middle = (good + bad) / Real(2);
            (margin(k, middle) > Real(0) ? good : bad) = middle;
        }
        return good;
    }

    const Margins& margins_;
    Real end_;
    int samples_;
};

// NaN is not > 0.
template <class Margins> bool all_clear(const Margins& margins) {
    using Real = typename Margins::value_type;
    for (const Real& margin : margins)
        if (!(margin > Real(0))) return false;
    return true;
}

// Places at which margins are sampled: divisors pass zero within a layer, amplitudes grow and fall slowly.
inline constexpr int layer_samples = 256, broad_layer_samples = 32;

// Of margins of which nobody asks which one fails.
struct Nameless {
    const char* operator[](std::size_t) const { return ""; }
};

// margins(T) -> an array of margins, each smooth on 0 <= T <= reach, of the divisors or variables named. If
// one is not > 0 somewhere (NaN is not), `reach` is drawn back to before that place; 0: there is none. What
// is narrower than two samples and has no slope outside is not seen.
template <class Margins, class Names, class Real>
Cause clear_of_layers(const Margins& margins, const Names& names, Real& reach, int samples = layer_samples) {
    const Real end = reach;
    std::size_t failed = 0;
    reach = LayerSearch<Real, Margins>(margins, end, samples).last_clear(failed);
    return reach < end ? Cause{Status::outside_domain, names[failed]} : Cause{};
}

// Whether a smooth function with these values at the nodes of an interpolation is > 0 between them too,
// beyond doubt: each value is larger than its steps to its neighbours and than `unseen`. False says nothing.
// Lane by lane where a number is several side by side.
template <class Values, class Real> auto clearly_positive(const Values& values, const Real& unseen) {
    auto clear = Real(0) < Real(1);
    Real step = Real(0);
    for (std::size_t j = 0; j < values.size(); ++j) {
        const Real next =
            j + 1 < values.size() ? Real(math::magnitude(Real(values[j + 1] - values[j]))) : Real(0);
        clear = clear & (values[j] > step + next + unseen);
        step = next;
    }
    return clear;
}

// The same for margins on [left, right], from eight places each or up to 64; lane by lane where a number is
// several side by side (runtime/pack.hpp).
template <class Margins, class Real, class Answer = decltype(std::declval<Real>() < std::declval<Real>())>
Answer clear_beyond_doubt(const Margins& margins, const Real& left, const Real& right, int halvings = 3) {
    constexpr std::size_t n = 8; // Chebyshev nodes, and what gives the last two coefficients
    constexpr std::array<double, n> node{0.9807852804032304,  0.8314696123025452,  0.5555702330196022,
                                         0.1950903220161283,  -0.1950903220161283, -0.5555702330196022,
                                         -0.8314696123025452, -0.9807852804032304};
    constexpr std::array<double, n> seventh{0.0487725805040321,  -0.1388925582549005, 0.2078674030756363,
                                            -0.2451963201008076, 0.2451963201008076,  -0.2078674030756363,
                                            0.1388925582549005,  -0.0487725805040321};
    constexpr std::array<double, n> sixth{0.0956708580912725,  -0.2309698831278217, 0.2309698831278217,
                                          -0.0956708580912725, -0.0956708580912725, 0.2309698831278217,
                                          -0.2309698831278217, 0.0956708580912725};
    const Real middle = (left + right) / Real(2), half = (right - left) / Real(2);
    auto before = margins(Real(middle + half * Real(node[0])));
    auto last = before, last_but_one = before, room = before, step = before;
    Answer clear = left < right;
    for (std::size_t k = 0; k < before.size(); ++k) {
        last[k] = Real(seventh[0]) * before[k];
        last_but_one[k] = Real(sixth[0]) * before[k];
        step[k] = Real(0);
    }
    for (std::size_t j = 1; j < n; ++j) {
        const auto value = margins(Real(middle + half * Real(node[j])));
        for (std::size_t k = 0; k < value.size(); ++k) {
            const Real next = math::magnitude(Real(value[k] - before[k]));
            room[k] = lesser(room[k], Real(before[k] - step[k] - next));
            step[k] = next;
            last[k] = last[k] + Real(seventh[j]) * value[k];
            last_but_one[k] = last_but_one[k] + Real(sixth[j]) * value[k];
        }
        before = value;
    }
    for (std::size_t k = 0; k < before.size(); ++k) {
        const Real unseen = Real(8) * (math::magnitude(last[k]) + math::magnitude(last_but_one[k]));
        clear = clear & (lesser(room[k], Real(before[k] - step[k])) > unseen); // a number, if all are
    }
    if (halvings == 0 || clear) return clear;
    const Answer first = clear_beyond_doubt(margins, left, middle, halvings - 1);
    if constexpr (std::is_same_v<Answer, bool>) {
        return first && clear_beyond_doubt(margins, middle, right, halvings - 1);
    } else {
        return clear | (first & clear_beyond_doubt(margins, middle, right, halvings - 1));
    }
}

// The same for the margins of a scene on [0, end]: first by bounds over all of it, which are no estimate, if
// its functions have them.
template <class Course, class Real, class Answer = decltype(std::declval<Real>() < std::declval<Real>())>
Answer clear_of_doubt(const Course& course, const Real& end) {
    const auto margins = [&course](const Real& T) { return course.margins(T); };
    if constexpr (requires { course.margins(Bounds<Real>(end)); }) {
        Answer clear = Real(0) < end;
        for (const Bounds<Real>& margin : course.margins(Bounds<Real>(Real(0), end)))
            clear = clear & margin.is_positive();
        if (clear) return clear;
        return clear | clear_beyond_doubt(margins, Real(0), end);
    } else {
        return clear_beyond_doubt(margins, Real(0), end);
    }
}

} // namespace resonform

#endif
