// SPDX-License-Identifier: MIT
// The amplitudes of all rows on [0, root]: interpolated in panels, rows that do not matter dropped, the
// others cut in Chebyshev coefficients, eight of about one length side by side, halved on to the pieces, and
// turned to powers.
//
// An amplitude matters by its share of the output's scale, the sum of the sizes of all its amplitudes. (What
// decays with the same exponential is a part of its own, and its scale is that of all parts of the output
// that decay no faster.) Panels are halved until the scale changes by less than a factor of 4. Where halving
// does not help (a drift or a forced oscillation that begins with 0) the panel is weak: a table would lose
// digits there and does not answer.
//
// An atom, of which outputs are made by sums and products, has its own size in the panel as its scale; what
// must not change by more than a factor of 4 are the sums of the sizes of the terms of the outputs, then.
#ifndef RESONFORM_RUNTIME_KERNEL_AMPLITUDE_ROWS
#define RESONFORM_RUNTIME_KERNEL_AMPLITUDE_ROWS

#include "runtime/kernel/chebyshev.hpp"
#include "runtime/kernel/scene.hpp"
#include "runtime/twice.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <type_traits>
#include <vector>

namespace resonform::kernel {

inline constexpr double negligible = 1.5e-17; // of the scale of an output
inline constexpr int weak_level = 6;          // of panels that are not halved for their scale any more

template <std::size_t Rows> class AmplitudeFit {
    static constexpr std::size_t sides = (Rows + group - 1) / group;

public:
    struct Piece { // of eight rows
        std::size_t first, size;
        std::size_t chord;   // its number
        double middle, half; // of the piece, as its panel goes from -1 to 1
    };
    std::vector<std::size_t> kept;  // rows, in the order of their places
    std::vector<unsigned> degree;   // of each place
    std::vector<Piece> piece;       // [index * groups + g]
    std::vector<Side> coefficients; // Chebyshev, of all pieces
    std::size_t groups = 0;
    Status status = Status::ok;
    bool resolved = true;
    int deepest = 0;

    // amplitudes(t), finer than double, with the part that each row belongs to, part < Rows; lasts(a, b):
    // part a as long as b; sizes(amplitudes): of the outputs that are made of atoms, or None
    struct None {};
    template <class Amplitudes, class Lasts, class Sizes>
    void fit(const Amplitudes& amplitudes, double root, const std::array<unsigned, Rows>& part,
             const Lasts& lasts, const Sizes& sizes, int most) {
        most_ = most;
        part_ = part;
        for (unsigned a = 0; a < Rows; ++a)
            if (part[a] == a) parts_.push_back(a);
        for (const unsigned b : parts_) {
            slower_.emplace_back();
            for (const unsigned a : parts_)
                if (lasts(a, b)) slower_.back().push_back(a);
        }
        divide(amplitudes, sizes, root, 0, 0, -1);
        if (status == Status::ok) choose();
    }

    void pieces(int levels) {
        piece.assign((std::size_t{1} << levels) * groups, {});
        coefficients.clear();
        coefficients.reserve(piece.size() * 10);
        degree.assign(kept.size(), 0);
        std::array<Side, nodes> c;
        chords_.clear();
        for (const Panel& p : panels_) {
            const std::size_t first = chords_.size();
            chords_.resize(first + groups);
            for (std::size_t place = 0; place < kept.size(); ++place) {
                chords_[first + place / group].middle.at[place % group] = p.middle[kept[place]];
                chords_[first + place / group].slope.at[place % group] = p.slope[kept[place]];
            }
            for (std::size_t g = 0; g < groups; ++g) {
                for (std::size_t j = 0; j < nodes; ++j)
                    for (std::size_t l = 0; l < group; ++l) {
                        const std::size_t place = g * group + l;
                        c[j].at[l] = place < kept.size() ? p.at(j, kept[place]) : 0;
                    }
                descend(c.data(), nodes, g, p, p.level, p.index, levels, first);
            }
        }
    }

    // The longest run of pieces, [first, end), without weak panels.
    std::array<std::size_t, 2> strong_pieces(int levels) const {
        std::array<std::size_t, 2> best{0, 0}, run{0, 0};
        for (const Panel& p : panels_) {
            const std::size_t first = p.index << (levels - p.level), end = (p.index + 1)
                                                                           << (levels - p.level);
            if (p.weak) continue;
            run = {run[1] == first ? run[0] : first, end};
            if (run[1] - run[0] > best[1] - best[0]) best = run;
        }
        return best;
    }

    // The powers of middle*x of a group in one piece; those beyond the degree of each row are 0.
    void powers(std::size_t index, std::size_t g, double middle, std::array<Side, nodes>& c) const {
        const Piece& p = piece[index * groups + g];
        c.fill(Side{});
        std::copy_n(coefficients.begin() + static_cast<std::ptrdiff_t>(p.first), p.size, c.begin());
        for (std::size_t l = 0; l < group && g * group + l < kept.size(); ++l)
            for (std::size_t j = degree[g * group + l] + 1; j < p.size; ++j) c[j].at[l] = 0;
        to_powers(c.data(), p.size);
        const Chords& chord = chords_[p.chord + g];
        for (std::size_t l = 0; l < group; ++l) {
            // slope * middle is exact: 26 bits and at most most_levels.
            const auto [at_middle, lost] =
                Twice<double>::sum(chord.middle.at[l], chord.slope.at[l] * p.middle);
            c[0].at[l] = at_middle + (lost + c[0].at[l]);
            if (p.size > 1 && g * group + l < kept.size() && degree[g * group + l] > 0)
                c[1].at[l] += chord.slope.at[l] * p.half;
        }
        double power = 1;
        for (std::size_t j = 1; j < p.size; ++j) c[j] = c[j] * (power /= middle);
    }

    // The places, those of small rows first: sums in this order round less.
    std::vector<std::size_t> by_size() const {
        std::vector<std::size_t> places(kept.size());
        std::iota(places.begin(), places.end(), std::size_t{0});
        std::stable_sort(places.begin(), places.end(),
                         [this](std::size_t a, std::size_t b) { return size_[kept[a]] < size_[kept[b]]; });
        return places;
    }

    unsigned group_degree(std::size_t g) const {
        unsigned most = 0;
        for (std::size_t i = g * group; i < std::min((g + 1) * group, kept.size()); ++i)
            most = std::max(most, degree[i]);
        return most;
    }

private:
    using Values = std::vector<std::array<Fine, nodes>>; // of each row
    struct Panel {
        int level;
        std::size_t index;
        std::array<std::array<Side, sides>, nodes> c;
        // The straight line through each row at the outermost nodes: middle + slope x, -1 <= x <= 1. c is the
        // fit of the row without it; the line is added back when c is converted to powers of x. Where the
        // row is nearly 0, so is c, and rounding errors of the fit stay small beside the row.
        std::array<double, Rows> middle, slope;
        std::array<double, Rows> scale{}; // of each part, the smallest in the panel
        bool weak = false;
        double at(std::size_t j, std::size_t row) const { return c[j][row / group].at[row % group]; }
        // Of the chord, what belongs to coefficient j.
        double slope_at(std::size_t j, std::size_t row) const { return j == 1 ? std::abs(slope[row]) : 0; }
        double size_of_chord(std::size_t row) const { return std::abs(middle[row]) + std::abs(slope[row]); }
    };

    template <class Amplitudes, class Sizes>
    void divide(const Amplitudes& amplitudes, const Sizes& sizes, double root, int level, std::size_t index,
                double parent) {
        const double width = std::ldexp(root, -level), left = width * static_cast<double>(index);
        Values& values = values_;
        for (std::size_t j = 0; j < nodes; ++j) {
            const auto at = amplitudes(left + width / 2 * (1 + node<double>(j)));
            for (std::size_t r = 0; r < Rows; ++r) {
                if (!math::finite(static_cast<double>(at[r]))) {
                    status = math::is_not_a_number(at[r]) ? Status::outside_domain : Status::overflow;
                    return;
                }
                values[r][j] = at[r];
            }
        }
        panels_.push_back({level, index, {}, {}, {}, {}, false});
        Panel& p = panels_.back();
        const bool even = set_scale(values, sizes, p);
        if (status != Status::ok) return;
        if (!even && level >= weak_level) {
            p.weak = true;
            deepest = std::max(deepest, level);
            return;
        }
        for (std::size_t r = 0; r < Rows; ++r) {
            const Fine first = values[r][0], last = values[r][nodes - 1]; // at node(0) = -node(nodes - 1)
            p.middle[r] = static_cast<double>((first + last) / 2);
            p.slope[r] = upper_half(static_cast<double>(first - last) / (2 * node<double>(0)));
        }
        std::array<Fine, nodes> x;
        for (std::size_t j = 0; j < nodes; ++j) x[j] = node<Fine>(j);
        for (std::size_t s = 0; s < sides; ++s) {
            std::array<Side, nodes> rest{};
            for (std::size_t r = s * group; r < std::min((s + 1) * group, Rows); ++r)
                for (std::size_t j = 0; j < nodes; ++j)
                    rest[j].at[r % group] =
                        static_cast<double>(values[r][j] - (Fine(p.middle[r]) + Fine(p.slope[r]) * x[j]));
            const auto c = interpolated<double>(rest);
            for (std::size_t k = 0; k < nodes; ++k) p.c[k][s] = c[k];
        }
        double worst = 0; // the last coefficients over their tolerance
        for (std::size_t r = 0; r < Rows; ++r) {
            double most = 0;
            for (std::size_t k = 0; k < nodes; ++k) most = std::max(most, std::abs(p.at(k, r)));
            const double tail = std::max(std::abs(p.at(nodes - 1, r)), std::abs(p.at(nodes - 2, r)));
            worst = std::max(worst, tail / std::max(2e-16 * most, 8 * negligible * p.scale[part_[r]]));
        }
        if (even && (worst <= 1 || (worst < 1e3 && parent >= 0 && parent < 4 * worst))) {
            deepest = std::max(deepest, level);
            return;
        }
        if (level == most_) {
            resolved = false;
            return;
        }
        panels_.pop_back();
        divide(amplitudes, sizes, root, level + 1, 2 * index, worst);
        if (status == Status::ok && resolved)
            divide(amplitudes, sizes, root, level + 1, 2 * index + 1, worst);
    }

    // False: the scale of a part changes by more than a factor of 4.
    template <class Sizes> bool set_scale(const Values& values, const Sizes& sizes, Panel& panel) {
        if constexpr (!std::is_same_v<Sizes, None>) return set_sizes(values, sizes, panel);
        std::array<double, Rows> most{};
        for (std::size_t j = 0; j < nodes; ++j) {
            std::array<double, Rows> sum{};
            for (std::size_t r = 0; r < Rows; ++r)
                sum[part_[r]] += std::abs(static_cast<double>(values[r][j]));
            for (std::size_t p = 0; p < parts_.size(); ++p) {
                const unsigned part = parts_[p];
                double scale = 0;
                for (const unsigned slower : slower_[p]) scale += sum[slower];
                most[part] = std::max(most[part], scale);
                panel.scale[part] = j == 0 ? scale : std::min(panel.scale[part], scale);
            }
        }
        bool even = true;
        for (const unsigned o : parts_) {
            if (!(most[o] < 1e300)) status = Status::overflow; // and so might the sums in the loops
            even = even && most[o] <= 4 * panel.scale[o];
        }
        return even;
    }

    // False: the size of an output changes by more than a factor of 4.
    template <class Sizes> bool set_sizes(const Values& values, const Sizes& sizes, Panel& panel) {
        bool even = true;
        decltype(sizes(panel.scale)) least{}, most{};
        for (std::size_t j = 0; j < nodes; ++j) {
            std::array<double, Rows> at{};
            for (std::size_t r = 0; r < Rows; ++r) {
                at[r] = std::abs(static_cast<double>(values[r][j]));
                panel.scale[r] = std::max(panel.scale[r], at[r]);
            }
            const auto now = sizes(at);
            for (std::size_t o = 0; o < now.size(); ++o) {
                least[o] = j == 0 ? now[o] : std::min(least[o], now[o]);
                most[o] = std::max(most[o], now[o]);
            }
        }
        for (std::size_t o = 0; o < most.size(); ++o) {
            if (!(most[o] < 1e300)) status = Status::overflow;
            even = even && most[o] <= 4 * least[o];
        }
        return even;
    }

    void choose() {
        std::array<std::size_t, Rows> length{};
        for (std::size_t r = 0; r < Rows; ++r)
            for (Panel& p : panels_) {
                if (p.weak) continue;
                const double scale = p.scale[part_[r]];
                double most = 0, sum = p.size_of_chord(r);
                for (std::size_t k = 0; k < nodes; ++k) {
                    most = std::max(most, std::abs(p.at(k, r)));
                    sum += std::abs(p.at(k, r));
                }
                size_[r] = std::max(size_[r], sum);
                if (!(sum > negligible * scale)) continue;
                std::size_t count = nodes; // the rounding of a row is not worth a coefficient
                const double allowed = std::max(negligible / 2 * scale, 3e-17 * most);
                while (count > 1 && std::abs(p.at(count - 1, r)) + p.slope_at(count - 1, r) < allowed)
                    --count;
                for (std::size_t k = count; k < nodes; ++k) p.c[k][r / group].at[r % group] = 0;
                length[r] = std::max(length[r], count);
            }
        for (std::size_t r = 0; r < Rows; ++r)
            if (length[r] > 0) kept.push_back(r);
        std::stable_sort(kept.begin(), kept.end(),
                         [&](std::size_t a, std::size_t b) { return length[a] > length[b]; });
        groups = (kept.size() + group - 1) / group;
    }

    void descend(const Side* c, std::size_t size, std::size_t g, const Panel& panel, int level,
                 std::size_t index, int levels, std::size_t chord) {
        size = panel.weak ? 1 : cut(c, size, g, panel);
        if (level == levels) {
            const double half = std::ldexp(1.0, panel.level - levels);
            const std::size_t before = index - (panel.index << (levels - panel.level));
            const Piece& own = piece[index * groups + g] = {
                coefficients.size(), size, chord, (2 * static_cast<double>(before) + 1) * half - 1, half};
            coefficients.insert(coefficients.end(), c, c + size);
            for (std::size_t l = 0; l < group && g * group + l < kept.size(); ++l) {
                const double allowed = negligible * scale_of(panel, g * group + l);
                double rest = 0;
                std::size_t d = size;
                const auto size_at = [&](std::size_t j) {
                    return std::abs(c[j].at[l]) + own.half * panel.slope_at(j, kept[g * group + l]);
                };
                while (d > 1 && rest + size_at(d - 1) <= allowed) rest += size_at(--d);
                degree[g * group + l] = std::max(degree[g * group + l], static_cast<unsigned>(d - 1));
            }
            return;
        }
        std::array<Side, nodes> left, right;
        halve(c, size, left.data(), right.data());
        descend(left.data(), size, g, panel, level + 1, 2 * index, levels, chord);
        descend(right.data(), size, g, panel, level + 1, 2 * index + 1, levels, chord);
    }
    double scale_of(const Panel& panel, std::size_t place) const { return panel.scale[part_[kept[place]]]; }
    std::size_t cut(const Side* c, std::size_t size, std::size_t g, const Panel& panel) const {
        for (; size > 1; --size)
            for (std::size_t l = 0; l < group && g * group + l < kept.size(); ++l)
                if (std::abs(c[size - 1].at[l]) + panel.slope_at(size - 1, kept[g * group + l]) >
                    0.02 * negligible * scale_of(panel, g * group + l))
                    return size;
        return size;
    }

    Values values_ = Values(Rows); // at the nodes of one panel
    struct Chords {                // of the rows of a group in a panel
        Side middle, slope;
    };
    std::vector<Chords> chords_;
    std::array<double, Rows> size_{}; // of each row, the largest in its panels
    std::array<unsigned, Rows> part_{};
    std::vector<unsigned> parts_;               // each by its first row
    std::vector<std::vector<unsigned>> slower_; // of each part, itself among them
    int most_ = 0;
    std::vector<Panel> panels_;
};

} // namespace resonform::kernel

#endif
