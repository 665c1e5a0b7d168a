// SPDX-License-Identifier: MIT
// The parts of an output: the rows that decay with the same exponential.
#ifndef RESONFORM_RUNTIME_KERNEL_PARTS
#define RESONFORM_RUNTIME_KERNEL_PARTS

#include "runtime/kernel/scene.hpp"

namespace resonform::kernel {

template <class Scene> constexpr bool is_exponent(std::size_t phase) {
    return phase >= Scene::phases - decays_of<Scene>();
}

enum class Part { fading, turning, mean };
template <class Scene> constexpr Part part_of(const Term<Scene::phases>& term) {
    for (std::size_t p = 0; p < Scene::phases; ++p)
        if (is_exponent<Scene>(p) && term.k[p] != 0) return Part::fading;
    return term.wave == Wave::one ? Part::mean : Part::turning;
}

// Whether row a belongs to the output of b and decays no faster.
template <class Scene> constexpr bool lasts(unsigned a, unsigned b) {
    bool so = Scene::terms[a].output == Scene::terms[b].output;
    for (std::size_t p = 0; p < Scene::phases; ++p)
        so = so && (!is_exponent<Scene>(p) || Scene::terms[a].k[p] <= Scene::terms[b].k[p]);
    return so;
}

// Of each row what belongs to the same output and decays with the same exponential: the first such row.
template <class Scene> std::array<unsigned, Scene::terms.size()> parts_of() {
    std::array<unsigned, Scene::terms.size()> parts{};
    for (unsigned r = 0; r < parts.size(); ++r)
        for (parts[r] = 0; parts[r] < r; ++parts[r]) {
            if (lasts<Scene>(parts[r], r) && lasts<Scene>(r, parts[r])) break;
        }
    return parts;
}

} // namespace resonform::kernel

#endif
