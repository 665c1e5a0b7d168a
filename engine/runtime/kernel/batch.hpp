// SPDX-License-Identifier: MIT
// Many points. Chunks whose times ascend are cut into runs of one piece; others are sorted by pieces first,
// by counting. Times that are not answered are replaced for the loops, and the replacements repaired
// afterwards.
#ifndef RESONFORM_RUNTIME_KERNEL_BATCH
#define RESONFORM_RUNTIME_KERNEL_BATCH

#include "runtime/kernel/block.hpp"
#include "runtime/kernel/view.hpp"

namespace resonform::kernel {
inline namespace RESONFORM_WIDTH {

inline constexpr std::size_t chunk = 4096;
inline constexpr int at_once = RESONFORM_VECTORS; // vectors of points in a block

struct Target {
    double* to[most_outputs] = {};
    unsigned long long wanted = 0;
    Target(const View& w, double* const* outputs) {
        for (unsigned o = 0; o < w.outputs; ++o) {
            to[o] = outputs[o];
            if (outputs[o] != nullptr) wanted |= 1ULL << o;
        }
    }
    // The same from point `first` on.
    [[nodiscard]] Target from(std::size_t first) const {
        Target shifted = *this;
        for (unsigned o = 0; o < most_outputs; ++o)
            if ((wanted >> o & 1) != 0) shifted.to[o] += first;
        return shifted;
    }
};

[[gnu::always_inline]] inline int piece_of(const View& w, double t) {
    const int k = static_cast<int>(t * w.per_width);
    return k < w.last ? k : w.last;
}

// Points [first, first + n) of one piece. The last block of a run covers points of the one before once more.
template <bool Low>
[[gnu::noinline]] inline void run(const View& w, int k, const double* t, const double* low, std::size_t n,
                                  unsigned long long wanted, double* const* to, std::size_t first) {
    constexpr std::size_t one = lanes, many = lanes * at_once;
    const double* piece = w.pieces + static_cast<std::size_t>(k) * w.stride;
    const bool faded = k >= w.faded;
    const auto low_at = [&](std::size_t i) { return Low ? low + i : nullptr; };
    if (n >= many) {
        for (std::size_t i = 0;; i = i + 2 * many <= n ? i + many : n - many) {
            block<lanes, at_once, Low>(w, piece, t + first + i, low_at(first + i), wanted, to, first + i,
                                       faded);
            if (i + many == n) return;
        }
    }
    for (std::size_t i = 0; i < n; i += one) {
        if (n >= one) {
            const std::size_t from = i + one <= n ? i : n - one;
            block<lanes, 1, Low>(w, piece, t + first + from, low_at(first + from), wanted, to, first + from,
                                 faded);
            continue;
        }
        double times[lanes], lows[lanes] = {}, values[most_outputs][lanes];
        double* into[most_outputs];
        for (std::size_t j = 0; j < one; ++j) times[j] = t[first + (j < n ? j : 0)];
        if constexpr (Low)
            for (std::size_t j = 0; j < one; ++j) lows[j] = low[first + (j < n ? j : 0)];
        for (unsigned o = 0; o < w.outputs && o < most_outputs; ++o) into[o] = values[o];
        block<lanes, 1, Low>(w, piece, times, lows, wanted, into, 0, faded);
        for (unsigned o = 0; o < w.outputs; ++o)
            if ((wanted >> o & 1) != 0)
                for (std::size_t j = 0; j < n; ++j) to[o][first + j] = values[o][j];
    }
}

// Ascending times.
template <bool Low>
inline void ascending(const View& w, const double* t, const double* low, std::size_t n,
                      unsigned long long wanted, double* const* to) {
    std::size_t guess = 64;
    for (std::size_t i = 0; i < n;) {
        const int k = piece_of(w, t[i]);
        std::size_t inside = i, step = guess; // the last known to lie in the piece
        std::size_t outside = n;
        if (k < w.last) {
            while (inside + step < n) {
                if (piece_of(w, t[inside + step]) != k) {
                    outside = inside + step;
                    break;
                }
                inside += step;
                step *= 2;
            }
            while (outside - inside > 1) {
                const std::size_t middle = inside + (outside - inside) / 2;
                (middle < n && piece_of(w, t[middle]) == k ? inside : outside) = middle;
            }
        }
        guess = outside - i > 1 ? outside - i : 1;
        run<Low>(w, k, t, low, outside - i, wanted, to, i);
        i = outside;
    }
}

// Any order, at most `chunk` times.
template <bool Low>
inline void shuffled(const View& w, const double* t, const double* low, std::size_t n,
                     unsigned long long wanted, double* const* to) {
    constexpr int buckets = 512;
    constexpr unsigned columns = 4; // outputs at once
    unsigned short key[chunk], place[chunk];
    unsigned count[buckets + 1] = {};
    double times[chunk], lows[Low ? chunk : 1] = {}, values[columns][chunk];
    int shift = 0;
    while ((w.last >> shift) >= buckets) ++shift;
    for (std::size_t i = 0; i < n; ++i) {
        const int k = piece_of(w, t[i]) >> shift;
        key[i] = static_cast<unsigned short>(k);
        ++count[k + 1];
    }
    for (int k = 0; k < buckets; ++k) count[k + 1] += count[k];
    for (std::size_t i = 0; i < n; ++i) {
        const unsigned p = count[key[i]]++;
        place[i] = static_cast<unsigned short>(p);
        times[p] = t[i];
        if constexpr (Low) lows[p] = low[i];
    }
    for (unsigned from = 0; from < w.outputs; from += columns) {
        double* into[most_outputs] = {};
        unsigned long long part = 0;
        for (unsigned o = from; o < w.outputs && o < from + columns; ++o) {
            into[o] = values[o - from];
            part |= wanted & 1ULL << o;
        }
        if (part == 0) continue;
        for (std::size_t i = 0; i < n;) {
            const int k = piece_of(w, times[i]);
            std::size_t next = i + 1;
            if (shift == 0)
                next = count[k];
            else
                while (next < n && piece_of(w, times[next]) == k) ++next;
            run<Low>(w, k, times, lows, next - i, part, into, i);
            i = next;
        }
        for (unsigned o = from; o < w.outputs && o < from + columns; ++o)
            if ((part >> o & 1) != 0)
                for (std::size_t i = 0; i < n; ++i) to[o][i] = values[o - from][place[i]];
    }
}

inline Status status_of(const View& w, double t) {
    if (!(t - t == 0)) return Status::bad_argument;
    if (t < w.begin || t > w.reach) return Status::outside_interval;
    return t > w.precise ? Status::low_precision : Status::ok;
}

inline bool answers(Status s) { return s == Status::ok || s == Status::low_precision; }

// The largest time that is answered with ok.
inline double highest_ok(const View& w) { return w.precise < w.reach ? w.precise : w.reach; }

// Are all ok; do they ascend.
struct Seen {
    bool ok, ascend;
};
inline Seen look(const View& w, const double* t, std::size_t n) {
    using L = Lanes<lanes>;
    const double highest = highest_ok(w);
    const typename L::Vector least = L::all(w.begin), most = L::all(highest);
    typename L::Bits ok = ~typename L::Bits{}, ascend = ok;
    std::size_t i = 0;
    for (; i + lanes + 1 <= n; i += lanes) {
        const typename L::Vector x = L::load(t + i), y = L::load(t + i + 1);
        ok &= (x >= least) & (x <= most);
        ascend &= x <= y;
    }
    bool all_ok = true, all_ascend = true;
    for (int j = 0; j < lanes; ++j) {
        all_ok = all_ok && ok[j] != 0;
        all_ascend = all_ascend && ascend[j] != 0;
    }
    for (; i < n; ++i) {
        all_ok = all_ok && t[i] >= w.begin && t[i] <= highest;
        if (i + 1 < n) all_ascend = all_ascend && t[i] <= t[i + 1];
    }
    return {all_ok, all_ascend};
}

// The outputs at n <= chunk answered times t, or at t + low.
template <bool Low>
inline void values_at(const View& w, const double* t, const double* low, std::size_t n, bool ascend,
                      unsigned long long wanted, double* const* to) {
    if (wanted == 0) return;
    if (ascend)
        ascending<Low>(w, t, low, n, wanted, to);
    else
        shuffled<Low>(w, t, low, n, wanted, to);
}

// Points from + i, i < n <= chunk, at t[i], or t[i] + low[i]: those that are not ok are asked of `direct` if
// there is one; numbers that nobody has are NaN.
inline void repair(const View& w, const double* t, const double* low, std::size_t from, std::size_t n,
                   const Target& target, Status* status, const Direct* direct, BatchReport& report) {
    for (std::size_t i = 0; i < n; ++i) {
        Status s = status_of(w, t[i]);
        double values[most_outputs];
        const bool asked = s != Status::ok && direct != nullptr;
        if (asked) s = direct->at(direct->evaluator, t[i], low == nullptr ? 0 : low[i], values);
        if (status != nullptr) status[from + i] = s;
        note(report, s, from + i);
        if (answers(s) && !asked) continue;
        for (unsigned o = 0; o < w.outputs; ++o)
            if ((target.wanted >> o & 1) != 0)
                target.to[o][from + i] = answers(s) ? values[o] : __builtin_nan("");
    }
}

inline void all_fine(Status* status, std::size_t n) {
    if (status != nullptr) __builtin_memset(status, 0, n);
}

inline BatchReport batch(const View& w, const double* t, std::size_t n, double* const* outputs,
                         Status* status, const Direct* direct) noexcept {
    BatchReport report{Status::ok, 0, n};
    const Target target(w, outputs);
    for (std::size_t from = 0; from < n; from += chunk) {
        const std::size_t size = n - from < chunk ? n - from : chunk;
        const Target here = target.from(from);
        const Seen seen = look(w, t + from, size);
        if (seen.ok) {
            all_fine(status == nullptr ? nullptr : status + from, size);
            values_at<false>(w, t + from, nullptr, size, seen.ascend, here.wanted, here.to);
            continue;
        }
        double kept[chunk],
            last = w.begin; // the times, with the last answered one in place of each unanswered
        for (std::size_t i = 0; i < size; ++i) {
            if (answers(status_of(w, t[from + i]))) last = t[from + i];
            kept[i] = last;
        }
        values_at<false>(w, kept, nullptr, size, look(w, kept, size).ascend, here.wanted, here.to);
        repair(w, t + from, nullptr, from, size, target, status, direct, report);
    }
    return report;
}

} // namespace RESONFORM_WIDTH
} // namespace resonform::kernel

#endif
