// SPDX-License-Identifier: MIT
// What a scene hands to its tables, and which products of turned modes its harmonics are made of.
//
//   struct Scene {
//       static constexpr std::size_t phases, outputs;
//       static constexpr std::size_t decays;                             // if any; else it may be missing
//       static constexpr std::array<Term<phases>, R> terms;              // the rows
//       double eps, reach;                                               // T = eps t, 0 <= t <= reach
//       std::array<double, R> amplitudes(double T) const;                // of all rows
//       template <class Wide> Phases<Wide> rates() const;
//   };
//   template <class Wide> struct Phases {
//       std::array<Wide, phases> start;                                  // theta at t = 0
//       std::array<Wide, phases> operator()(const Wide& T) const;        // dtheta/dT
//   };
//
// The last `decays` of the phases are exponents chi, and a term is A e^{d.chi} cos(k.theta), d >= 0: the last
// of its k are d.
#ifndef RESONFORM_RUNTIME_KERNEL_SCENE
#define RESONFORM_RUNTIME_KERNEL_SCENE

#include "runtime/kernel/view.hpp"

#include <array>
#include <cstddef>

namespace resonform::kernel {

enum class Wave : unsigned char { one, cosine, sine };

// A row: the output it belongs to and its wave of k.theta; the first index of k that is not 0 is positive.
// One that decays and does not turn is a cosine.
template <std::size_t Phases> struct Term {
    unsigned output = 0;
    Wave wave = Wave::one;
    std::array<int, Phases> k{};
};

template <class Scene> constexpr std::size_t decays_of() {
    if constexpr (requires { Scene::decays; })
        return Scene::decays;
    else
        return 0;
}

// Each harmonic as a sum or difference of two that come before it (their exponents add up); the first ones
// are the phases themselves.
template <std::size_t Phases, std::size_t Decays = 0> struct Harmonics {
    static constexpr std::size_t angles = Phases - Decays;
    static constexpr std::size_t most = most_factors / 2;
    struct Made {
        std::array<int, Phases> k{};
        unsigned from = 0, by = 0;
        int sign = 1;
    };
    std::array<Made, most> made{};
    std::size_t count = 0;
    bool fits = true;

    constexpr unsigned index(const std::array<int, Phases>& k) const {
        for (std::size_t i = 0; i < count; ++i)
            if (made[i].k == k) return static_cast<unsigned>(i);
        return most;
    }
    constexpr unsigned add(const std::array<int, Phases>& k) {
        if (const unsigned known = index(k); known < most) return known;
        for (std::size_t i = count; i-- > 0;) // one more product
            for (std::size_t j = 0; j < count; ++j)
                for (const int sign : {1, -1}) {
                    bool same = true;
                    for (std::size_t p = 0; p < Phases; ++p)
                        same = same && made[i].k[p] + (p < angles ? sign : 1) * made[j].k[p] == k[p];
                    if (same) return append(k, static_cast<unsigned>(i), static_cast<unsigned>(j), sign);
                }
        std::array<int, Phases> half{}, rest = k; // by halves: few steps, small errors
        int sum = 0;
        for (const int n : k) sum += n < 0 ? -n : n;
        int left = (sum + 1) / 2;
        for (std::size_t p = 0; p < Phases; ++p)
            while (left > 0 && rest[p] != 0) {
                const int unit = rest[p] > 0 ? 1 : -1;
                half[p] += unit;
                rest[p] -= unit;
                --left;
            }
        int sign = 1;
        for (std::size_t p = 0; p < angles; ++p)
            if (rest[p] != 0) {
                sign = rest[p] < 0 ? -1 : 1;
                break;
            }
        for (std::size_t p = 0; p < angles; ++p) rest[p] *= sign;
        const unsigned i = add(half), j = add(rest);
        return append(k, i, j, sign);
    }

private:
    constexpr unsigned append(const std::array<int, Phases>& k, unsigned i, unsigned j, int sign) {
        if (count == most) {
            fits = false;
            return 0;
        }
        made[count] = {k, i, j, sign};
        return static_cast<unsigned>(count++);
    }
};

template <class Scene> constexpr auto harmonics_of() {
    Harmonics<Scene::phases, decays_of<Scene>()> result;
    for (std::size_t p = 0; p < Scene::phases; ++p) {
        result.made[p].k[p] = 1;
        ++result.count;
    }
    for (int size = 1; size < 128; ++size) // the small ones first
        for (const auto& term : Scene::terms) {
            int sum = 0;
            for (const int n : term.k) sum += n < 0 ? -n : n;
            if (term.wave != Wave::one && sum == size) result.add(term.k);
        }
    return result;
}

template <class Scene> inline constexpr auto harmonics = harmonics_of<Scene>();

} // namespace resonform::kernel

#endif
