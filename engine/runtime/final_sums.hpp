// SPDX-License-Identifier: MIT
// Quadratures and phases at one time, with nothing tabulated or allocated.
//
// All integrands are evaluated at the same Gauss nodes of [0, end]; where the last coefficients of their
// Legendre series do not decay, the interval is halved, as often as the tables of an evaluator would. n nodes
// show n coefficients and integrate 2n of them exactly, so the last one shown need not be as small as the
// error. A slow flow is a fixed point (runtime/flow_panel.hpp).
#ifndef RESONFORM_RUNTIME_FINAL_SUMS
#define RESONFORM_RUNTIME_FINAL_SUMS

#include "runtime/flow_panel.hpp"
#include "runtime/gauss.hpp"
#include "runtime/layer.hpp"
#include "runtime/pieces.hpp"
#include "runtime/status.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace resonform {

template <class Real> inline constexpr std::size_t final_nodes = math::digits<Real> / 4 + 11;

// The first elements of an array.
template <std::size_t Count, class Real, std::size_t All>
std::array<Real, Count> first(const std::array<Real, All>& all) {
    std::array<Real, Count> result;
    std::copy_n(all.begin(), Count, result.begin());
    return result;
}

// Rates of phases may be summed in two types: Number has more digits than Real, but not twice as many, or not
// to have them all.
template <class Number, class Real>
inline constexpr bool divides_rates =
    !std::is_same_v<Number, Real> &&
    (!std::is_same_v<Number, WideNumber<Real>> || !std::is_same_v<typename OneOf<Real>::type, Real>);

// Course: the integrands that the emitted class of a scene has. Columns are values of the flow and of tables.
// The rates of a level depend on the columns of earlier levels; those of a flow, level 0, on its own.
//
//   static constexpr bool flow, nested;                    some rates need columns
//   static constexpr bool steady;                          there are no columns, and all rates are constant
//   static constexpr std::array<std::size_t, L> levels;    the number of columns of each
//   static constexpr std::size_t columns, angles;
//   static constexpr std::array<bool, angles> rounded;     the rate of a phase needs columns
//   static constexpr std::array<bool, angles> decays;      it is an exponent
//   static constexpr std::array<unsigned long long, angles> fades;   what turns with it decays with these
//   std::array<Real, columns> start() const;
//   std::array<Real, levels[L]> rates(std::integral_constant<std::size_t, L>, const Real& T,
//                                     const std::array<Real, columns>&) const;
//   template <class Number> struct Angles {
//       explicit Angles(const Course&); Cause lost; std::array<Number, angles> start;
//       std::array<Number, angles> operator()(const Course&, const Number& T,
//                                             const std::array<Real, columns>&) const;
//       std::array<Number, angles> main(...) const;     the same as a sum, where some
//       std::array<Real, angles> small(const Course&, const Real& T) const;      rates are divided
//   };
//   std::array<Real, m> margins(const Real& T) const;                            of layers, if there are any;
//   std::array<Real, m> margins(const Real& T, const std::array<Real, columns>&) const;      or of the flow
//   static constexpr int samples;

// The integrals over [0, end], end > 0, phases in Number, with n nodes a panel.
template <class Real, class Course, class Number, std::size_t n = final_nodes<Real>> class FinalSums {
public:
    static constexpr std::size_t columns = Course::columns, phases = Course::angles;
    using Columns = std::array<Real, columns>;
    using Turning = typename Course::template Angles<Number>;

    FinalSums(const Course& course, const Turning& turning)
        : course_(course), turning_(turning), tables_(course.start()) {}

    [[nodiscard]] const Columns& tables() const { return tables_; }
    [[nodiscard]] const std::array<Number, phases>& angles() const { return angles_; } // without their start

    static constexpr bool divides =
        divides_rates<Number, Real> && requires(const Turning& turning, const Course& course) {
        turning.small(course, Real());
    };
    // Whether what Real sums turns by so little that the digits of Real suffice.
    [[nodiscard]] auto turns_little() const { return largest_small_ * right_ < Real(0.25); }

    // How far a phase that lasts turns at its first rate, in radians: the farthest of them.
    [[nodiscard]] Real first_turn(const Number& end) const {
        std::array<Number, phases> rate;
        if constexpr (divides)
            rate = turning_.main(course_, Number(0), tables_);
        else
            rate = turning_(course_, Number(0), tables_);
        Real farthest = Real(0);
        for (std::size_t k = 0; k < phases; ++k)
            if (!Course::decays[k] && Course::fades[k] == 0)
                farthest = math::larger(farthest, Real(math::magnitude(narrow(Number(rate[k] * end)))));
        return farthest;
    }

    // Status as fit_panels: overflow, outside_domain; that of a flow, or where margins are in doubt, says no
    // more than that there is no result.
    Status integrate(const Number& end) {
        if constexpr (Course::steady) {
            return turn_steadily(end);
        } else if constexpr (requires { turning_.edges; }) {
            Status status = Status::ok;
            for (Number left = Number(0), right = left; status == Status::ok && left < end; left = right) {
                right = end_of_piece(turning_, left, end);
                status = integrate(left, right);
            }
            return status;
        } else {
            return integrate(Number(0), end);
        }
    }
    Status integrate(const Number& begin, const Number& end) {
        struct Part {
            Number right;
            Real rest; // of the interval that it was part of
        };
        std::array<Part, most_halvings + 2> parts;
        std::size_t open = 1, panels = 0;
        parts[0] = {end, Real(-1)};
        for (Number left = begin; open > 0;) {
            const Part part = parts[open - 1];
            const Status tried = panel(left, part.right);
            if (tried == Status::ok && converged(rest_, part.rest)) {
                add();
                left = part.right;
                --open;
                ++panels;
                continue;
            }
            const Real right = narrow(part.right);
            const bool too_narrow = narrow(part.right - left) < Real(1024) * math::epsilon<Real>() * right;
            if (too_narrow || open > most_halvings || panels >= most_panels)
                return tried == Status::ok ? Status::outside_domain : tried;
            parts[open - 1].rest = tried == Status::ok ? rest_ : Real(-1);
            parts[open] = {(left + part.right) / Number(2), parts[open - 1].rest};
            ++open;
        }
        return Status::ok;
    }

    // For numbers that are several side by side: in equal parts; where the integrals are resolved.
    auto integrate_evenly(const Number& end, int parts) {
        Number left = Number(0);
        Real worst = Real(0);
        if constexpr (Course::steady) turn_steadily(end);
        for (int part = 1; part <= parts && !Course::steady; ++part) {
            const Number right = part == parts ? end : Number(end * (Number(part) / Number(parts)));
            panel(left, right);
            worst = math::larger(worst, rest_);
            add();
            left = right;
        }
        auto resolved = clear_ & ~(worst > Real(1));
        if constexpr (divides) resolved = resolved & turns_little();
        for (const Real& table : tables_) resolved = resolved & (table - table == Real(0));
        for (const Number& angle : angles_) resolved = resolved & (narrow(angle - angle) == Real(0));
        return resolved;
    }

private:
    // An evaluator has more patience with a flow.
    static constexpr std::size_t most_halvings = Course::flow ? 12 : 100,
                                 most_panels = Course::flow ? 128 : 2048;
    // Of phases in the wide type the series is judged in it, too; otherwise Real sees enough.
    static constexpr bool wide = std::is_same_v<Number, WideNumber<Real>>;
    using Lanes = LanesOf<Real>;
    static constexpr bool several = Lanes::several;
    using Seen = std::conditional_t<wide && !several, Number, Real>;
    using AngleSums = std::array<GaussSum<Number, Seen, n>, phases>;
    // No rate needs an integral. All are evaluated in one loop, so that the compiler computes common
    // sub-expressions once.
    static constexpr bool together = Course::levels.size() == 1 && !Course::flow;

    static Real narrow(const Number& x) { return static_cast<Real>(x); }

    // As PanelFitter: where halving gains nothing, rounding is seen.
    static bool converged(const Real& rest, const Real& parent) {
        return !(Real(1) < rest) || (rest < Real(1000) && parent < Real(4) * rest && Real(0) < parent);
    }

    Status turn_steadily(const Number& end) {
        const std::array<Number, phases> rate = turning_(course_, end, tables_);
        for (std::size_t k = 0; k < phases; ++k) {
            if constexpr (!several)
                if (!math::finite(narrow(rate[k]))) return fault<Real>(rate);
            angles_[k] = rate[k] * end;
        }
        return Status::ok;
    }

    Status panel(const Number& left, const Number& right) {
        middle_ = (left + right) / Number(2);
        half_ = (right - left) / Number(2);
        right_ = narrow(right);
        rest_ = Real(0);
        panel_small_ = {};
        const Real middle = narrow(middle_), half = narrow(half_);
        for (std::size_t j = 0; j < n; ++j) T_[j] = middle + half * Real(gauss_.node[j]);
        AngleSums angle = angle_sums(std::make_index_sequence<phases>());
        if constexpr (columns > 0)
            if (const Status status = levels(angle, std::make_index_sequence<Course::levels.size()>());
                status != Status::ok)
                return status;
        if constexpr (requires { course_.margins(T_[0], at_node_[0]); })
            if (const Status status = clear_on_panel(); status != Status::ok) return status;
        return angles_of_panel(angle);
    }

    template <std::size_t... Level> Status levels(AngleSums& angle, std::index_sequence<Level...>) {
        Status status = Status::ok;
        (void)((status = level<Level>(angle), status == Status::ok) && ...);
        return status;
    }

    template <std::size_t Level> static constexpr std::size_t first_of() {
        std::size_t sum = 0;
        for (std::size_t k = 0; k < Level; ++k) sum += Course::levels[k];
        return sum;
    }

    template <std::size_t Level> Status level(AngleSums& angle) {
        constexpr std::size_t from = first_of<Level>(), count = Course::levels[Level];
        std::array<std::array<Real, n>, count> rate;
        if constexpr (Course::flow && Level == 0) {
            if (const Status status = flow(rate); status != Status::ok) return status;
        } else {
            for (std::size_t j = 0; j < n; ++j) {
                const std::array<Real, count> value =
                    course_.rates(std::integral_constant<std::size_t, Level>(), T_[j], at_node_[j]);
                if constexpr (together) add_angles(j, angle); // nothing is stored between them: common roots
                for (std::size_t k = 0; k < count; ++k) rate[k][j] = value[k];
            }
        }
        const Real half = narrow(half_);
        for (std::size_t k = 0; k < count; ++k) {
            GaussSum<Real, Real, n> sum{gauss_, gauss_};
            for (std::size_t j = 0; j < n; ++j) sum.add(j, rate[k][j]);
            if constexpr (!several)
                if (!math::finite(sum.whole)) return fault<Real>(rate[k]);
            panel_[from + k] = half * sum.whole;
            panel_sizes_[from + k] = half * Real(2) * sum.size;
            Real scale = math::larger(sum.size, Real(sizes_[from + k] / right_));
            if (Course::flow && Level == 0)
                scale = math::larger(scale, Real(math::magnitude(tables_[k]) / (half * Real(2))));
            judge(sum.end(), scale,
                  Course::nested ? Real(Real(16) * math::epsilon<Real>())
                                 : square_enough<Real>(math::epsilon<Real>()));
            if constexpr (Course::nested && !(Course::flow && Level == 0)) {
                const std::array<Real, n> before = gauss_.integrals(rate[k]);
                for (std::size_t j = 0; j < n; ++j)
                    at_node_[j][from + k] = tables_[from + k] + half * before[j];
            }
        }
        return Status::ok;
    }

    // Level 0 on the panel: its columns at the nodes, and their rates.
    template <std::size_t count> Status flow(std::array<std::array<Real, n>, count>& rate) {
        FlowPanel<Real, n, count, Columns> panel{gauss_, narrow(half_), tables_, at_node_, rate};
        const auto rates = [this](std::size_t j) {
            return course_.rates(std::integral_constant<std::size_t, 0>(), T_[j], at_node_[j]);
        };
        const Status status = panel.contract(rates);
        if constexpr (several) clear_ = clear_ & panel.converged;
        return status;
    }

    // Margins along the flow.
    Status clear_on_panel() {
        const auto one = course_.margins(T_[0], at_node_[0]);
        std::array<std::array<Real, n>, std::tuple_size_v<std::remove_const_t<decltype(one)>>> margin;
        for (std::size_t j = 0; j < n; ++j) {
            const auto value = course_.margins(T_[j], at_node_[j]);
            for (std::size_t k = 0; k < value.size(); ++k) margin[k][j] = value[k];
        }
        auto clear = Lanes::all();
        for (const std::array<Real, n>& values : margin) {
            GaussSum<Real, Real, n> sum{gauss_, gauss_};
            for (std::size_t j = 0; j < n; ++j) sum.add(j, values[j]);
            clear = clear & clearly_positive(values, Real(Real(64) * sum.end()));
        }
        if constexpr (several) clear_ = clear_ & clear;
        return Lanes::any(clear) ? Status::ok : Status::outside_domain;
    }

    [[nodiscard]] std::array<Number, phases> rates_at(std::size_t j) const {
        if constexpr (divides) {
            std::array<Number, phases> rate = turning_.main(course_, place(j), at_node_[j]);
            const std::array<Real, phases> small = turning_.small(course_, T_[j]);
            for (std::size_t k = 0; k < phases; ++k) rate[k] = rate[k] + Number(small[k]);
            return rate;
        } else {
            return turning_(course_, place(j), at_node_[j]);
        }
    }

    void add_angles(std::size_t j, AngleSums& sum) {
        if constexpr (divides) {
            const std::array<Number, phases> main = turning_.main(course_, place(j), at_node_[j]);
            const std::array<Real, phases> small = turning_.small(course_, T_[j]);
            for (std::size_t k = 0; k < phases; ++k) {
                sum[k].add(j, main[k], Seen(static_cast<Seen>(main[k]) + Seen(small[k])));
                panel_small_[k] = panel_small_[k] + Real(gauss_.weight[j]) * small[k];
                largest_small_ = math::larger(largest_small_, Real(math::magnitude(small[k])));
            }
        } else {
            const std::array<Number, phases> rate = rates_at(j);
            for (std::size_t k = 0; k < phases; ++k) sum[k].add(j, rate[k]);
        }
    }

    Status angles_of_panel(AngleSums& sum) {
        if constexpr (!together && phases > 0)
            for (std::size_t j = 0; j < n; ++j) add_angles(j, sum);
        for (std::size_t k = 0; k < phases; ++k) {
            if constexpr (divides) sum[k].whole = sum[k].whole + Number(panel_small_[k]);
            if constexpr (!several)
                if (!math::finite(narrow(sum[k].whole))) return fault_of_angle(k);
            panel_angles_[k] = half_ * sum[k].whole;
            panel_angle_sizes_[k] = narrow(half_) * Real(2) * static_cast<Real>(sum[k].size);
            const Real scale = math::larger(static_cast<Real>(sum[k].size), Real(angle_sizes_[k] / right_));
            judge(static_cast<Real>(sum[k].end()), scale, tolerance(k, Real(scale * right_)));
        }
        return Status::ok;
    }

    template <std::size_t... k> AngleSums angle_sums(std::index_sequence<k...>) const {
        return {((void)k, GaussSum<Number, Seen, n>{gauss_wide_, GaussFor<Seen, n>::once()})...};
    }

    Status fault_of_angle(std::size_t k) const {
        std::array<Number, n> values;
        for (std::size_t j = 0; j < n; ++j) values[j] = rates_at(j)[k];
        return fault<Real>(values);
    }

    // A node of the panel.
    [[nodiscard]] Number place(std::size_t j) const {
        if constexpr (std::is_same_v<Number, Real>)
            return T_[j];
        else
            return added_product(middle_, half_, Number(gauss_wide_.node[j]));
    }

    // Of the last coefficient of a phase that is about `size`, relative to its rate: the error is to be below
    // the last place of Real.
    static Real tolerance(std::size_t k, const Real& size) {
        if (Course::rounded[k]) return Real(16) * math::epsilon<Real>();
        // Of exponents beyond this nothing is left but e^chi = 0.
        const Real counts = Course::decays[k] ? math::smaller(Real(4096), size) : size;
        const Real wanted = math::epsilon<Real>() / math::larger(Real(1), counts);
        return math::larger(square_enough<Real>(wanted),
                            Real(static_cast<Real>(Seen(16) * math::epsilon<Seen>())));
    }

    // 0/0 is passed over.
    void judge(const Real& last, const Real& scale, const Real& relative) {
        rest_ = math::larger(rest_, Real(last / (relative * scale)));
    }

    void add() {
        for (std::size_t k = 0; k < columns; ++k) {
            tables_[k] = tables_[k] + panel_[k];
            sizes_[k] = sizes_[k] + panel_sizes_[k];
        }
        for (std::size_t k = 0; k < phases; ++k) {
            angles_[k] = angles_[k] + panel_angles_[k];
            angle_sizes_[k] = angle_sizes_[k] + panel_angle_sizes_[k];
        }
    }

    const GaussFor<Real, n>& gauss_ = GaussFor<Real, n>::once();
    const GaussFor<Number, n>& gauss_wide_ = GaussFor<Number, n>::once();
    const Course& course_;
    const Turning& turning_;
    Number middle_{}, half_{};
    Real right_{}, rest_{}, largest_small_{};
    // Where several are integrated: no margin is in doubt, and the flow contracts.
    typename Lanes::Truth clear_ = Lanes::all();
    std::array<Real, n> T_;
    std::array<Columns, n> at_node_{};
    Columns tables_, sizes_{}, panel_{}, panel_sizes_{};
    std::array<Number, phases> angles_{}, panel_angles_{};
    std::array<Real, phases> angle_sizes_{}, panel_angle_sizes_{}, panel_small_{};
};

} // namespace resonform

#endif
