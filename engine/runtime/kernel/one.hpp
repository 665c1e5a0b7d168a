// SPDX-License-Identifier: MIT
// One point: the rows of a piece side by side, then the sums of the batch in its order.
#ifndef RESONFORM_RUNTIME_KERNEL_ONE
#define RESONFORM_RUNTIME_KERNEL_ONE

#include "runtime/kernel/batch.hpp"

namespace resonform::kernel {
inline namespace RESONFORM_WIDTH {

inline Status one(const View& w, double t, double* values) noexcept {
    using L = Lanes<lanes>;
    constexpr int parts = static_cast<int>(group) / lanes;
    const Status status = status_of(w, t);
    if (!answers(status)) {
        for (unsigned o = 0; o < w.outputs; ++o) values[o] = __builtin_nan("");
        return status;
    }
    const double* piece = w.pieces + static_cast<std::size_t>(piece_of(w, t)) * w.stride;
    if (w.constant != nullptr) {
        const double times[] = {t, t};
        double both[most_outputs][2];
        double* to[most_outputs];
        for (unsigned o = 0; o < most_outputs; ++o) to[o] = both[o];
        block<2, 1, false>(w, piece, times, nullptr, ~0ULL, to, 0, false);
        for (unsigned o = 0; o < w.outputs; ++o) values[o] = both[o][0];
        return status;
    }
    Place<2, 1> at;
    at.d[0] = Lanes<2>::all(t - piece[0]);
    at.v[0] = at.d[0] * Lanes<2>::all(w.to_local) - Lanes<2>::all(w.middle);
    Factors<2, 1> g;
    for (unsigned k = 0; k < w.phases; ++k) {
        const PhaseRow& p = w.phase[k];
        if (p.outputs != 0) turn<2, 1, false>(w, p, piece, at, g);
    }
    for (unsigned k = 0; k < w.steps; ++k) turn<2, 1>(w.step[k], g);
    double row_values[most_rows];
    const L::Vector v = L::all(at.v[0][0]);
    for (unsigned n = 0; n < w.groups; ++n) {
        const double* c = piece + w.groups_of_rows[n].offset;
        L::Vector value[parts];
        RESONFORM_UNROLL for (int i = 0; i < parts; ++i) value[i] = L::load(c + i * lanes);
        for (unsigned j = w.groups_of_rows[n].degree; j > 0; --j) {
            c += group;
            RESONFORM_UNROLL for (int i = 0; i < parts; ++i) value[i] =
                L::multiply_add(value[i], v, L::load(c + i * lanes));
        }
        RESONFORM_UNROLL for (int i = 0; i < parts; ++i)
            L::store(row_values + n * group + i * lanes, value[i]);
    }
    for (unsigned o = 0; o < w.outputs; ++o) {
        Lanes<2>::Vector sum{};
        for (unsigned r = w.output[o].first; r < w.output[o].first + w.output[o].count; ++r) {
            const Row& row = w.row[r];
            const Lanes<2>::Vector value = Lanes<2>::all(row_values[row.place]);
            sum = row.factor == no_factor ? value + sum
                                          : Lanes<2>::multiply_add(value, g.at[row.factor][0], sum);
        }
        values[o] = sum[0];
    }
    return status;
}

} // namespace RESONFORM_WIDTH
} // namespace resonform::kernel

#endif
