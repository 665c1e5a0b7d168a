// SPDX-License-Identifier: MIT
// The tables of a scene (runtime/kernel/scene.hpp): built once, read by the loops of every width.
#ifndef RESONFORM_RUNTIME_KERNEL_TABLES
#define RESONFORM_RUNTIME_KERNEL_TABLES

#include "runtime/kernel/amplitude_rows.hpp"
#include "runtime/kernel/atoms.hpp"
#include "runtime/kernel/parts.hpp"
#include "runtime/kernel/phase_rows.hpp"
#include "runtime/twice.hpp"

#include <new>

namespace resonform::kernel {

// x rounded to 20 bits, up or down: multiples up to 2^33 of it are exact.
inline double to_20_bits(double x, bool up) {
    int exponent = 0;
    const double part = std::ldexp(std::frexp(x, &exponent), 20);
    return std::ldexp(up ? std::ceil(part) : std::floor(part), exponent - 20);
}

// The largest t with eps t <= end as the processor multiplies.
inline double last_time(double eps, double end) {
    double t = end / eps;
    while (eps * t > end) t = std::nextafter(t, 0.0);
    for (double next = std::nextafter(t, 2 * t); eps * next <= end; next = std::nextafter(t, 2 * t)) t = next;
    return t;
}

struct Options {
    int levels = 5;        // 2^levels pieces at least
    int most_straight = 9; // beyond, phases are curved within a piece
    double resolution = 0; // relative error of the rates, if it is more than that of their type
    bool ends = false;     // the scene must not be asked beyond its reach
};

class Tables {
public:
    Tables() = default;
    Tables(const Tables&) = delete;

    const View& view() const { return view_; }
    // For as much of the scene's reach as can be tabulated. no_memory; outside_domain, overflow: for nothing.
    template <class Scene> Status build(const Scene& scene, const Options& options = {}) noexcept {
        try {
            Status status = options.ends
                                ? Status::outside_domain
                                : construct(scene, options, to_20_bits(scene.reach, true), scene.reach);
            for (const double share : {1.0, 0.984375, 0.875, 0.5}) { // a singularity may stand at its end
                if (status == Status::ok) break;
                const double root = to_20_bits(share * scene.reach, false);
                *this = Tables();
                status = construct(scene, options, root, root);
            }
            return status;
        } catch (const std::bad_alloc&) {
            return Status::no_memory;
        }
    }
    std::size_t bytes() const { return numbers_.size() * sizeof(double); }

private:
    Tables& operator=(Tables&&) = default;

    // Pieces of [0, root]; answers up to `reach`.
    template <class Scene>
    Status construct(const Scene& scene, const Options& options, double root, double reach) {
        const auto made = harmonics_of<Scene>();
        if (!made.fits) return Status::outside_domain;
        constexpr std::size_t count = Scene::terms.size();
        const double eps = scene.eps;
        view_.reach = reach;
        AmplitudeFit<count> rows;
        const auto fit = [&](const auto& sizes) {
            rows.fit([&](double t) { return scene.amplitudes(Fine(eps) * t); }, root, parts_of<Scene>(),
                     lasts<Scene>, sizes, most_levels);
        };
        if constexpr (has_atoms<Scene>) {
            fit(OutputSizes<Scene>(scene));
            const auto constants = scene.constants();
            constant_.assign(constants.begin(), constants.end());
        } else {
            fit(typename AmplitudeFit<count>::None{});
        }
        if (rows.status != Status::ok) return rows.status;
        if (!rows.resolved) return Status::outside_domain;
        if constexpr (Scene::phases == 0) {
            const int levels = std::max(options.levels, rows.deepest);
            const double width = std::ldexp(root, -levels);
            set_pieces(levels, width);
            if (!keep_strong(rows, levels, width)) return Status::outside_domain;
            lay_out<Scene>(rows, made, levels);
            fill(rows, width);
            return Status::ok;
        } else {
            // QuickNumber is good enough, and much faster, as long as there are not many turns.
            double turns = 0;
            for (const double rate : scene.template rates<double>()(0.5 * eps * reach))
                turns = std::max(turns, std::abs(rate) * (eps * reach));
            if (turns < 1500) return with_phases<QuickNumber<double>>(scene, options, rows, made, root);
            return with_phases<Twice<double>>(scene, options, rows, made, root);
        }
    }

    template <class Wide, class Scene, class Rows>
    Status with_phases(const Scene& scene, const Options& options, Rows& rows, const HarmonicsOf<Scene>& made,
                       double root) {
        const Wide per_quarter = Wide(2) / math::pi<Wide>(), eps(scene.eps);
        const auto rates = scene.template rates<Wide>();
        std::array<PhaseFit<Wide>, Scene::phases> fits;
        int levels = std::max(options.levels, rows.deepest), straight = 0;
        bool steep = false;
        for (std::size_t p = 0; p < Scene::phases; ++p) {
            fits[p].exponent = is_exponent<Scene>(p);
            const Wide per_unit = fits[p].exponent ? Wide(1) / ln_two<Wide>() : per_quarter;
            fits[p].fit([&](const Wide& t) { return Wide(rates(Wide(eps * t))[p] * (eps * per_unit)); }, root,
                        Wide(rates.start[p] * per_unit));
            if (!fits[p].resolved) return Status::outside_domain;
            levels = std::max(levels, fits[p].deepest());
            straight = std::max(straight, fits[p].straight_at());
            steep = steep || (!fits[p].exponent &&
                              std::ldexp(fits[p].steepest(), -std::max(levels, straight)) > 0x1p21);
        }
        const bool curved = steep || straight > options.most_straight;
        levels = curved ? std::max(levels, 8) : std::max(levels, straight);
        if (levels > most_levels) return Status::outside_domain;
        const double width = std::ldexp(root, -levels);
        set_pieces(levels, width);
        if (!keep_strong(rows, levels, width)) return Status::outside_domain;
        const std::size_t pieces = std::size_t{1} << levels;
        std::vector<PhasePiece> phases(pieces * Scene::phases);
        for (std::size_t p = 0; p < Scene::phases; ++p)
            fits[p].pieces(levels, [&](std::size_t index, const Wide* c, std::size_t size) {
                const bool exponent = fits[p].exponent, is_gone = fits[p].is_gone(c, size);
                phases[index * Scene::phases + p] =
                    is_gone  ? gone_piece()
                    : curved ? curved_piece(c, size, width, view_.to_local / 2, exponent)
                             : straight_piece(c, size, width, view_.middle, exponent);
                if (exponent && !is_gone) view_.faded = std::max(view_.faded, static_cast<int>(index) + 1);
            });
        for (std::size_t p = 0; p < Scene::phases; ++p) {
            phase_.push_back(shape(phases, p, Scene::phases, curved));
            phase_.back().exponent = fits[p].exponent;
        }
        lay_out<Scene>(rows, made, levels);
        fill(rows, width);
        fill_phases(phases);
        const double resolution = std::max(options.resolution, static_cast<double>(math::epsilon<Wide>()));
        const double most = std::min(1e-9 / resolution, 1e14) * (2 / 3.141592653589793);
        for (std::size_t i = 0; i < pieces; ++i)
            for (std::size_t p = 0; p < Scene::phases; ++p)
                if (!is_exponent<Scene>(p) && phases[i * Scene::phases + p].largest > most)
                    view_.precise = std::min(view_.precise, width * static_cast<double>(i));
        std::array<double, Scene::phases> fastest; // radians per time
        for (std::size_t p = 0; p < Scene::phases; ++p)
            fastest[p] =
                fits[p].steepest() / root /
                static_cast<double>(fits[p].exponent ? 1 / ln_two<double>() : 2 / math::pi<double>());
        set_periods<Scene>(fastest, made);
        return Status::ok;
    }

    // By the largest sum of multiples, as if all phases were the fastest.
    template <class Scene>
    void set_periods(const std::array<double, Scene::phases>& rates, const HarmonicsOf<Scene>& made) {
        std::array<double, 2> fastest{}; // of angles and exponents
        for (std::size_t p = 0; p < Scene::phases; ++p) {
            double& most = fastest[is_exponent<Scene>(p) ? 1 : 0];
            most = std::max(most, rates[p]);
        }
        int lasting = 1, turns = 1, decays = 1;
        if constexpr (has_atoms<Scene>) {
            lasting = turns = std::max(1, Scene::turns);
            decays = std::max(1, Scene::fades);
        } else {
            for (std::size_t h = 0; h < made.count; ++h) {
                std::array<int, 2> sum{}; // of angles and exponents
                for (std::size_t p = 0; p < Scene::phases; ++p)
                    sum[is_exponent<Scene>(p) ? 1 : 0] += std::abs(made.made[h].k[p]);
                if (lasting_[h] != 0) lasting = std::max(lasting, sum[0]);
                if (needed_[h] == 0) continue;
                turns = std::max(turns, sum[0]);
                decays = std::max(decays, sum[1]);
            }
        }
        const double turn = 2 * math::pi<double>();
        view_.shortest_period = turn / (fastest[0] * lasting);
        view_.shortest_layer = turn / (fastest[0] * turns + fastest[1] * decays);
    }

    void set_pieces(int levels, double width) {
        int exponent = 0;
        view_.middle = std::frexp(width, &exponent);
        view_.to_local = std::ldexp(2.0, -exponent);
        view_.last = (1 << levels) - 1;
        view_.per_width = 1 / width;
        view_.precise = view_.reach;
    }

    // Answers are for the pieces that hold all digits. False: there are none.
    template <class Rows> bool keep_strong(const Rows& rows, int levels, double width) {
        const auto [first, end] = rows.strong_pieces(levels);
        view_.begin = width * static_cast<double>(first);
        if (end <= static_cast<std::size_t>(view_.last)) // the last number of the last piece
            view_.reach = std::min(view_.reach, std::nextafter(width * static_cast<double>(end), 0.0));
        view_.precise = view_.reach;
        return first < end;
    }

    // How many coefficients of phase p have to be kept in all pieces.
    static PhaseRow shape(const std::vector<PhasePiece>& pieces, std::size_t p, std::size_t phases,
                          bool curved) {
        unsigned size = 2, wide = curved ? 1 : 0;
        for (std::size_t i = p; i < pieces.size(); i += phases) {
            const PhasePiece& piece = pieces[i];
            double rest = 0;
            unsigned used = piece.size;
            while (used > 2 && rest + std::abs(piece.high[used - 1]) < 0x1p-57)
                rest += std::abs(piece.high[--used]);
            size = std::max(size, used);
            rest = 0;
            unsigned plain = piece.size;
            while (plain > 2 && rest + std::abs(piece.high[plain - 1]) < 0.5)
                rest += std::abs(piece.high[--plain]);
            if (curved) wide = std::max(wide, plain - 1);
        }
        // plain: q of degree size - 1. wide: what is above d^wide
        const unsigned degree = wide == 0 ? size - 1 : size > wide + 2 ? size - wide - 2 : 0;
        return {0, degree, wide, static_cast<unsigned>(p), false, 0, 0};
    }

    template <class Scene, class Rows> void lay_out(Rows& rows, const HarmonicsOf<Scene>& made, int levels) {
        static_assert(Scene::outputs <= most_outputs);
        lay_out_pieces(rows, levels);
        if constexpr (has_atoms<Scene>)
            lay_out_atoms<Scene>(rows);
        else
            lay_out_rows<Scene>(rows, made);
        for (PhaseRow& p : phase_) {
            p.outputs = needed_[p.harmonic];
            p.lasting = lasting_[p.harmonic];
        }
        view_.phases = static_cast<unsigned>(phase_.size());
        view_.steps = static_cast<unsigned>(step_.size());
        view_.rows = static_cast<unsigned>(row_.size());
        view_.outputs = static_cast<unsigned>(output_.size());
        view_.groups = static_cast<unsigned>(groups_.size());
        view_.operations = static_cast<unsigned>(operation_.size());
        view_.phase = phase_.data();
        view_.step = step_.data();
        view_.row = row_.data();
        view_.output = output_.data();
        view_.groups_of_rows = groups_.data();
        view_.operation = operation_.data();
        view_.constant = has_atoms<Scene> ? constant_.data() : nullptr;
    }

    template <class Rows> void lay_out_pieces(Rows& rows, int levels) {
        rows.pieces(levels);
        unsigned offset = 1;
        for (PhaseRow& p : phase_) {
            p.offset = offset;
            offset += p.degree + 1 + (p.wide == 0 ? 2 : 2 * p.wide + 1) + 1;
        }
        offset = (offset + 7) / 8 * 8;
        for (std::size_t g = 0; g < rows.groups; ++g) {
            groups_.push_back({offset, rows.group_degree(g)});
            offset += group * (groups_.back().degree + 1);
        }
        view_.stride = offset;
    }

    // The row of a place, without a factor.
    template <class Rows> Row row_at(const Rows& rows, std::size_t place) const {
        const Group& g = groups_[place / group];
        Row row{0, rows.degree[place], no_factor, static_cast<unsigned>(place)};
        row.offset = g.offset + (g.degree - row.degree) * group + static_cast<unsigned>(place % group);
        return row;
    }

    // An atom that is 0 has no row, and its slot is set.
    template <class Scene, class Rows> void lay_out_atoms(const Rows& rows) {
        constexpr std::size_t first = 2 * Scene::phases;
        std::vector<unsigned long long> slots;
        operation_ = needed_operations<Scene>(slots);
        std::vector<bool> kept(Scene::terms.size(), false);
        for (std::size_t place = 0; place < rows.kept.size(); ++place) {
            Row row = row_at(rows, place);
            row.factor = static_cast<unsigned>(first + rows.kept[place]);
            row.outputs = slots[row.factor];
            row_.push_back(row);
            kept[rows.kept[place]] = true;
        }
        const auto zero = static_cast<unsigned short>(constant_.size());
        constant_.push_back(0);
        for (std::size_t r = 0; r < kept.size(); ++r)
            if (!kept[r])
                operation_.insert(operation_.begin(), {Kind::constant, static_cast<unsigned short>(first + r),
                                                       zero, 0, 0, slots[first + r]});
        for (const unsigned short slot : Scene::results) output_.push_back({slot, 0, 0});
        needed_.assign(Scene::phases, 0);
        for (std::size_t p = 0; p < Scene::phases; ++p) needed_[p] = slots[2 * p] | slots[2 * p + 1];
        lasting_ = needed_;
    }

    template <class Scene, class Rows> void lay_out_rows(const Rows& rows, const HarmonicsOf<Scene>& made) {
        needed_.assign(made.most, 0);
        lasting_.assign(made.most, 0);
        const std::vector<std::size_t> places = rows.by_size();
        for (unsigned o = 0; o < Scene::outputs; ++o) {
            Output output{static_cast<unsigned>(row_.size()), 0, 0};
            for (const Part part : {Part::fading, Part::turning, Part::mean})
                for (const std::size_t place : places) {
                    const auto& term = Scene::terms[rows.kept[place]];
                    if (term.output != o || part_of<Scene>(term) != part) continue;
                    ++output.count;
                    if (part == Part::fading) ++output.fading;
                    Row row = row_at(rows, place);
                    if (part != Part::mean) {
                        const unsigned h = made.index(term.k);
                        row.factor = 2 * h + (term.wave == Wave::sine ? 1 : 0);
                        needed_[h] |= 1ULL << o;
                        if (part == Part::turning) lasting_[h] |= 1ULL << o;
                    }
                    row_.push_back(row);
                }
            output_.push_back(output);
        }
        for (std::size_t h = made.count; h-- > Scene::phases;) {
            const auto& m = made.made[h];
            for (std::vector<unsigned long long>* outputs : {&needed_, &lasting_}) {
                (*outputs)[m.from] |= (*outputs)[h];
                (*outputs)[m.by] |= (*outputs)[h];
            }
        }
        for (std::size_t h = Scene::phases; h < made.count; ++h) {
            const auto& m = made.made[h];
            if (needed_[h] == 0) continue;
            step_.push_back({static_cast<unsigned>(h), m.from, m.by, static_cast<double>(m.sign), needed_[h],
                             lasting_[h]});
        }
    }

    template <class Rows> void fill(Rows& rows, double width) {
        const auto pieces = static_cast<std::size_t>(view_.last) + 1;
        numbers_.assign(pieces * view_.stride, 0);
        view_.pieces = numbers_.data();
        std::array<Side, nodes> c;
        for (std::size_t i = 0; i < pieces; ++i) {
            double* piece = numbers_.data() + i * view_.stride;
            piece[0] = width * static_cast<double>(i);
            for (std::size_t g = 0; g < groups_.size(); ++g) {
                rows.powers(i, g, view_.middle, c);
                for (unsigned j = 0; j <= groups_[g].degree; ++j)
                    std::copy_n(c[groups_[g].degree - j].at, group, piece + groups_[g].offset + j * group);
            }
        }
    }

    void fill_phases(const std::vector<PhasePiece>& phases) {
        for (std::size_t i = 0; i < phases.size(); ++i) {
            const PhaseRow& p = phase_[i % phase_.size()];
            const PhasePiece& from = phases[i];
            double* to = numbers_.data() + i / phase_.size() * view_.stride + p.offset;
            const unsigned lowest = p.wide == 0 ? 0 : p.wide + 1;
            for (unsigned j = p.degree + 1; j-- > 0;) *to++ = from.high[lowest + j];
            if (p.wide == 0) {
                *to++ = from.w[0];
                *to++ = from.w[1];
            } else {
                for (unsigned j = p.wide; j > 0; --j) {
                    *to++ = from.high[j];
                    *to++ = from.low[j];
                }
                *to++ = from.high[0];
            }
            *to = rounding_shift + from.shift;
        }
    }

    View view_;
    std::vector<double> numbers_;
    std::vector<PhaseRow> phase_;
    std::vector<Step> step_;
    std::vector<Row> row_;
    std::vector<Output> output_;
    std::vector<Group> groups_;
    std::vector<Operation> operation_;
    std::vector<double> constant_;
    std::vector<unsigned long long> needed_, lasting_; // outputs, of each harmonic
};

} // namespace resonform::kernel

#endif
