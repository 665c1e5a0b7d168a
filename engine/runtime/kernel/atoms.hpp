// SPDX-License-Identifier: MIT
// Outputs that are made of atoms and turned modes by operations (runtime/kernel/view.hpp): how large they
// are, and what each of them needs.
#ifndef RESONFORM_RUNTIME_KERNEL_ATOMS
#define RESONFORM_RUNTIME_KERNEL_ATOMS

#include "runtime/kernel/scene.hpp"

#include <cmath>
#include <vector>

namespace resonform::kernel {

// Of each output the sum of the sizes of its terms; cosines, sines and exponentials count as 1.
template <class Scene> class OutputSizes {
public:
    explicit OutputSizes(const Scene& scene) : constants_(scene.constants()) {
        for (double& k : constants_) k = std::abs(k);
    }

    template <std::size_t Atoms>
    std::array<double, Scene::outputs> operator()(const std::array<double, Atoms>& atoms) const {
        std::array<double, most_factors> g{};
        for (std::size_t p = 0; p < 2 * Scene::phases; ++p) g[p] = 1;
        for (std::size_t r = 0; r < Atoms; ++r) g[2 * Scene::phases + r] = std::abs(atoms[r]);
        for (const Operation& o : Scene::operations) g[o.to] = size_of(o, g);
        std::array<double, Scene::outputs> sizes{};
        for (std::size_t o = 0; o < Scene::outputs; ++o) sizes[o] = g[Scene::results[o]];
        return sizes;
    }

private:
    double size_of(const Operation& o, const std::array<double, most_factors>& g) const {
        switch (o.kind) {
        case Kind::product: return g[o.a] * g[o.b];
        case Kind::scaled: return constants_[o.a] * g[o.b];
        case Kind::sum:
        case Kind::difference: return g[o.a] + g[o.b];
        case Kind::shifted: return constants_[o.a] + g[o.b];
        case Kind::multiply_add:
        case Kind::multiply_subtract: return g[o.c] + g[o.a] * g[o.b];
        case Kind::scaled_add:
        case Kind::scaled_subtract: return g[o.c] + constants_[o.a] * g[o.b];
        case Kind::constant: break;
        }
        return constants_[o.a];
    }

    decltype(std::declval<const Scene&>().constants()) constants_;
};

// Whether a, b, c of an operation are slots.
inline bool reads_a(Kind kind) {
    return kind == Kind::product || kind == Kind::sum || kind == Kind::difference ||
           kind == Kind::multiply_add || kind == Kind::multiply_subtract;
}
inline bool reads_b(Kind kind) { return kind != Kind::constant; }
inline bool reads_c(Kind kind) { return kind >= Kind::multiply_add && kind <= Kind::scaled_subtract; }

// The operations with the outputs that need each, and those that need each slot at the beginning.
template <class Scene> std::vector<Operation> needed_operations(std::vector<unsigned long long>& slots) {
    std::vector<Operation> list(Scene::operations.begin(), Scene::operations.end());
    slots.assign(most_factors, 0);
    for (std::size_t o = 0; o < Scene::outputs; ++o) slots[Scene::results[o]] |= 1ULL << o;
    for (std::size_t k = list.size(); k-- > 0;) {
        Operation& o = list[k];
        o.outputs = slots[o.to];
        slots[o.to] = 0; // what was there before is another number
        if (reads_a(o.kind)) slots[o.a] |= o.outputs;
        if (reads_b(o.kind)) slots[o.b] |= o.outputs;
        if (reads_c(o.kind)) slots[o.c] |= o.outputs;
    }
    return list;
}

} // namespace resonform::kernel

#endif
