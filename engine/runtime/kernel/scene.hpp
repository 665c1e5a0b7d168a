// SPDX-License-Identifier: MIT
// What a scene hands to its tables, and which products of turned modes its harmonics are made of.
//
//   struct Scene {
//       static constexpr std::size_t phases, outputs;
//       static constexpr std::size_t decays;                             // if any; else it may be missing
//       static constexpr std::array<Term<phases>, R> terms;              // the rows
//       double eps, reach;                                               // T = eps t, 0 <= t <= reach
//       std::array<Number, R> amplitudes(const Fine& T) const;           // of all rows
//       template <class Wide> Phases<Wide> rates() const;
//   };
//   template <class Wide> struct Phases {
//       std::array<Wide, phases> start;                                  // theta at t = 0
//       std::array<Wide, phases> operator()(const Wide& T) const;        // dtheta/dT
//   };
//
// Where the rows are atoms (runtime/kernel/view.hpp), each of them is an output of its own in `terms`, and
// there are, too,
//
//       static constexpr std::array<Operation, P> operations;            // their `outputs` are found later
//       static constexpr std::array<unsigned short, outputs> results;    // slots
//       static constexpr int turns, fades;  // highest degrees in cosines and sines, and in exponentials
//       std::array<double, K> constants() const;
//
// The last `decays` of the phases are exponents chi, and a term is A e^{d.chi} cos(k.theta), d >= 0: the last
// of its k are d.
#ifndef RESONFORM_RUNTIME_KERNEL_SCENE
#define RESONFORM_RUNTIME_KERNEL_SCENE

#include "runtime/kernel/view.hpp"
#include "runtime/math.hpp"
#include "runtime/rows.hpp"

#include <array>
#include <cstddef>

namespace resonform::kernel {

// Amplitudes are sampled in this type: a rounding error at a node shifts the fit of the whole panel around
// it.
using Fine = math::Fine<double>;

template <class Scene> constexpr std::size_t decays_of() {
    if constexpr (requires { Scene::decays; })
        return Scene::decays;
    else
        return 0;
}

template <class Scene> inline constexpr bool has_atoms = requires { Scene::operations; };

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

    [[nodiscard]] unsigned index(const std::array<int, Phases>& k) const {
        for (std::size_t at = hash(k); place[at] != 0; at = (at + 1) % place.size())
            if (made[place[at] - 1].k == k) return place[at] - 1U;
        return most;
    }
    unsigned add(const std::array<int, Phases>& k) {
        if (const unsigned known = index(k); known < most) return known;
        for (std::size_t i = count; i-- > 0;) // one more product
            for (const int sign : {1, -1}) {
                std::array<int, Phases> by{};
                for (std::size_t p = 0; p < Phases; ++p)
                    by[p] = (p < angles ? sign : 1) * (k[p] - made[i].k[p]);
                if (const unsigned j = index(by); j < most)
                    return append(k, static_cast<unsigned>(i), j, sign);
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

    unsigned append(const std::array<int, Phases>& k, unsigned i, unsigned j, int sign) {
        if (count == most) {
            fits = false;
            return 0;
        }
        made[count] = {k, i, j, sign};
        std::size_t at = hash(k);
        while (place[at] != 0) at = (at + 1) % place.size();
        place[at] = static_cast<unsigned short>(count + 1);
        return static_cast<unsigned>(count++);
    }

private:
    static std::size_t hash(const std::array<int, Phases>& k) {
        std::size_t sum = 0;
        for (const int n : k) sum = 131 * sum + static_cast<std::size_t>(n + 128);
        return sum % (4 * most);
    }
    std::array<unsigned short, 4 * most> place{}; // by hash: 1 + the index, 0 where there is none
};

template <class Scene> using HarmonicsOf = Harmonics<Scene::phases, decays_of<Scene>()>;

// When tables are built: what compilers may evaluate grows as the third power of their number.
template <class Scene> HarmonicsOf<Scene> harmonics_of() {
    HarmonicsOf<Scene> result;
    for (std::size_t p = 0; p < Scene::phases; ++p) {
        std::array<int, Scene::phases> k{};
        k[p] = 1;
        result.append(k, 0, 0, 1);
    }
    for (int size = 1; size < 128; ++size) // the small ones first
        for (const auto& term : Scene::terms) {
            int sum = 0;
            for (const int n : term.k) sum += n < 0 ? -n : n;
            if (term.wave != Wave::one && sum == size) result.add(term.k);
        }
    return result;
}

} // namespace resonform::kernel

#endif
