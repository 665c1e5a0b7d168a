// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judging/judge.hpp"

#include "algebra/number/number.hpp"
#include "model/text/eps_powers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace resonform {

namespace {

constexpr double above_floor = 100;  // a rung this far above its floor is polluted by 1 % at most
constexpr double near_integer = 0.3; // a limit this close to an integer names it
constexpr double near_straight =
    0.05;                          // a straight line has no limit to wait for: its slope must be this near
constexpr double one_slope = 0.02; // local slopes this close are one straight line
constexpr double settled_distance = 0.02; // of the last slopes from their integer and from each other
constexpr double free_bend = 0.05;        // a smaller step between local slopes may be noise
constexpr double free_departure = 0.03;   // 1 % of noise moves a slope no farther from its integer
constexpr double well_below = 1e-3;       // share of the allowed error that noise may hide in a pass

struct Point {
    double small, error; // small: eps^(1/eps_root)
};

// Errors below this may be the arithmetic's or the reference's own.
double noise(const LadderRung& rung) { return above_floor * std::max(rung.reference_error, rung.floor); }

double small_of(const OutputVerdict& output, const LadderRung& rung) {
    const double eps = to_double(rung.eps);
    return output.eps_root == 1 ? eps : std::pow(eps, 1.0 / output.eps_root);
}

// Drops unusable rungs. One between usable rungs is a zero of the error, not the end of the ladder.
std::vector<Point> usable_points(const OutputVerdict& output) {
    std::vector<Point> points;
    for (const LadderRung& rung : output.ladder)
        if (usable(rung)) points.push_back({small_of(output, rung), rung.max_error});
    return points;
}

bool answered(const LadderRung& rung) { return std::isfinite(rung.max_error); }

std::string refusal_of(const LadderRung& rung) {
    return fmt::format("the evaluator refuses points of the interval at eps = {:g}{}", to_double(rung.eps),
                       rung.refusal.empty() ? "" : fmt::format(" ({})", rung.refusal));
}

// The first rung without an error below one with an error. (At large eps the formula may have no answer.)
const LadderRung* refused_rung(const std::vector<LadderRung>& ladder) {
    const auto first = std::find_if(ladder.begin(), ladder.end(), answered);
    const auto refused = std::find_if_not(first, ladder.end(), answered);
    return refused == ladder.end() ? nullptr : &*refused;
}

double slope_between(const Point& a, const Point& b) {
    return std::log(a.error / b.error) / std::log(a.small / b.small);
}

std::vector<double> slopes_of(const std::vector<Point>& points) {
    std::vector<double> slopes;
    for (std::size_t i = 1; i < points.size(); ++i) slopes.push_back(slope_between(points[i - 1], points[i]));
    return slopes;
}

// How many of the last slopes agree with the very last one.
std::size_t straight_tail(const std::vector<double>& slopes) {
    std::size_t n = 1;
    while (n < slopes.size() && std::abs(slopes[slopes.size() - 1 - n] - slopes.back()) <= one_slope) ++n;
    return n;
}

struct Line {
    double slope, at_zero;
};
// The straight line nearest to u, w = coordinates(point) of the points from `first` on, by least squares.
template <class Coordinates>
Line nearest_line(const std::vector<Point>& points, std::size_t first, const Coordinates& coordinates) {
    const double n = static_cast<double>(points.size() - first);
    double x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t i = first; i < points.size(); ++i) {
        const auto [u, w] = coordinates(points[i]);
        x += u;
        y += w;
        xx += u * u;
        xy += u * w;
    }
    const double determinant = n * xx - x * x;
    return {(n * xy - x * y) / determinant, (y * xx - x * xy) / determinant};
}

double least_squares_slope(const std::vector<Point>& points, std::size_t first) {
    const auto logarithms = [](const Point& p) { return std::pair(std::log(p.small), std::log(p.error)); };
    return nearest_line(points, first, logarithms).slope;
}

// e = a eps^k + b eps^{k+1} has the local slope k + c m at the logarithmic mean m of its two eps:
// the last two slopes are continued to m = 0.
double extrapolated_slope(const std::vector<Point>& points, const std::vector<double>& slopes) {
    const auto mean = [&points](std::size_t i) {
        return (points[i].small - points[i + 1].small) / std::log(points[i].small / points[i + 1].small);
    };
    const std::size_t last = slopes.size() - 1;
    const double m1 = mean(last), m2 = mean(last - 1);
    return slopes[last] - (slopes[last - 1] - slopes[last]) * m1 / (m2 - m1);
}

// The slopes bend away instead of settling: the last step is larger than the one before it.
bool bends_away(const std::vector<double>& slopes) {
    const std::size_t n = slopes.size();
    const double last = std::abs(slopes[n - 1] - slopes[n - 2]);
    return last > free_bend && (n < 3 || last >= std::abs(slopes[n - 2] - slopes[n - 3]));
}

// The slopes leave their integer, each farther than the one before: a lower power comes up.
bool departs(const std::vector<double>& slopes, int order) {
    const std::size_t n = slopes.size();
    const auto distance = [&](std::size_t i) { return std::abs(slopes[i] - order); };
    return n >= 3 && distance(n - 1) > free_departure && distance(n - 1) > distance(n - 2) &&
           distance(n - 2) > distance(n - 3) && (slopes[n - 1] > order) == (slopes[n - 2] > order);
}

// The limit of error/eps^order: the straight line in eps through the points from `first` on, at 0.
double limiting_constant(const std::vector<Point>& points, std::size_t first, int order) {
    const auto ratio = [order](const Point& p) {
        return std::pair(p.small, p.error / std::pow(p.small, order));
    };
    return nearest_line(points, first, ratio).at_zero;
}

void undecided(OutputVerdict& output, std::string reason) {
    output.verdict = Verdict::undecided;
    output.reason = std::move(reason);
}

// No rung shows an error. That is a pass only where the noise hides little of the error the claim allows,
// with a constant of 1 or, for a small output, of its size: a large output is not allowed larger errors.
void judge_unseen(OutputVerdict& output) {
    const auto allowed = [&](const LadderRung& rung) {
        return well_below * std::min(1.0, rung.scale) *
               std::pow(small_of(output, rung), output.claimed_order);
    };
    const auto telling = std::count_if(output.ladder.begin(), output.ladder.end(),
                                       [&](const LadderRung& rung) { return noise(rung) <= allowed(rung); });
    const auto needed = std::max<std::size_t>(3, (output.ladder.size() + 1) / 2);
    if (static_cast<std::size_t>(telling) < needed)
        return undecided(
            output,
            fmt::format("no error is seen, but noise hides what {} allows: it is small enough "
                        "on {} of {} rungs, {} are needed (at eps = {:g}: noise {:.2g}, at most {:.2g})",
                        spell_eps_power(output.order(output.claimed_order)), telling, output.ladder.size(),
                        needed, to_double(output.ladder.front().eps), noise(output.ladder.front()),
                        allowed(output.ladder.front())));
    output.verdict = Verdict::pass;
    output.found_order = output.claimed_order;
    output.reason =
        "the error stays below what the arithmetic can show at every eps: exact as far as can be seen";
}

void judge_few(OutputVerdict& output, const std::vector<Point>& points) {
    const auto refused = std::find_if_not(output.ladder.begin(), output.ladder.end(), answered);
    if (refused != output.ladder.end())
        return undecided(output, refusal_of(*refused) + ": no error to judge");
    if (output.ladder.size() < 3)
        return undecided(output, fmt::format("the ladder has {} rung{}, 3 are needed", output.ladder.size(),
                                             output.ladder.size() == 1 ? "" : "s"));
    if (points.empty()) return judge_unseen(output);
    undecided(output, fmt::format("{} of {} rungs lie clear of the arithmetic's floor, 3 are needed",
                                  points.size(), output.ladder.size()));
}

void judge_ladder(OutputVerdict& output) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    output.slope = output.slope_low_eps = output.slope_high_eps = output.constant = none;
    output.found_order.reset();
    output.reason.clear();
    output.local_slopes.clear();
    for (std::size_t i = 1; i < output.ladder.size(); ++i) {
        const LadderRung &a = output.ladder[i - 1], &b = output.ladder[i];
        output.local_slopes.push_back(
            slope_between({to_double(a.eps), a.max_error}, {to_double(b.eps), b.max_error}));
    }
    const std::vector<Point> points = usable_points(output);
    if (points.size() < 3) return judge_few(output, points);
    if (const LadderRung* refused = refused_rung(output.ladder))
        return undecided(output, refusal_of(*refused));

    const std::vector<double> slopes = slopes_of(points);
    const std::size_t tail = std::max<std::size_t>(straight_tail(slopes), 2);
    const std::size_t first = points.size() - 1 - tail;
    const bool straight = straight_tail(slopes) >= 3;
    const double limit = straight ? least_squares_slope(points, first) : extrapolated_slope(points, slopes);
    const auto eps_of = [&](const Point& point) { return std::pow(point.small, output.eps_root); };
    output.slope = limit / output.eps_root;
    output.slope_low_eps = eps_of(points.back());
    output.slope_high_eps = eps_of(points[first]);
    const int order = static_cast<int>(std::lround(limit));

    if (std::abs(limit - slopes.back()) > near_integer || (!straight && bends_away(slopes)) ||
        departs(slopes, order)) {
        output.slope = slopes.back() / output.eps_root; // the last local slope: no limit is known
        return undecided(
            output,
            fmt::format("the slope still bends ({:.2f}, then {:.2f}) at eps = {:g}: add smaller eps",
                        slopes[slopes.size() - 2] / output.eps_root, output.slope, output.slope_low_eps));
    }
    // A straight line a little above an integer is at least of that order.
    if (std::abs(limit - order) > near_integer || (straight && limit < order - near_straight))
        return undecided(output, fmt::format("the slope {:.2f} is not near {}", output.slope,
                                             output.eps_root == 1
                                                 ? "an integer"
                                                 : fmt::format("a multiple of 1/{}", output.eps_root)));
    output.found_order = order;
    output.constant = limiting_constant(points, straight ? first : points.size() - 2, order);
    const bool holds = order >= output.claimed_order;
    output.verdict = holds ? Verdict::pass : Verdict::fail;
    if (!holds)
        output.reason = fmt::format("claimed {}, found {}: max|error| -> {:.3g} {}",
                                    spell_eps_power(output.order(output.claimed_order)),
                                    spell_eps_power(output.order(order)), output.constant,
                                    spell_eps_power(output.order(order)));
}

} // namespace

bool usable(const LadderRung& rung) {
    return std::isfinite(rung.max_error) && rung.max_error > 0 && rung.max_error >= noise(rung);
}

void judge(OutputVerdict& output) {
    judge_ladder(output);
    output.layer_slope = std::numeric_limits<double>::quiet_NaN();
    if (output.layer.empty()) return;
    OutputVerdict within;
    within.eps_root = output.eps_root;
    within.claimed_order = output.claimed_order;
    within.ladder = output.layer;
    judge_ladder(within);
    output.layer_slope = within.slope;
    if (within.verdict != Verdict::fail || output.verdict == Verdict::fail) return;
    output.verdict = Verdict::fail;
    output.found_order.reset();
    output.reason = "within the layer, t <= 20/|Re lambda|: " + within.reason;
}

void weigh(OutputVerdict& output, const Guarantee& guarantee) {
    output.guaranteed_order = guarantee.order;
    if (guarantee.order && *guarantee.order >= output.claimed_order) return;
    if (guarantee.refuted) {
        output.verdict = Verdict::fail;
        output.reason = guarantee.reason;
    } else if (output.verdict != Verdict::fail)
        leave_open(output, guarantee.reason);
}

void leave_open(OutputVerdict& output, std::string reason) {
    undecided(output, std::move(reason));
    output.found_order.reset();
    output.constant = std::numeric_limits<double>::quiet_NaN();
}

bool settled(const OutputVerdict& output) {
    const std::vector<Point> points = usable_points(output);
    if (output.ladder.empty() || !usable(output.ladder.back())) return true; // the floor is reached
    if (points.size() < 3) return false;
    const std::vector<double> slopes = slopes_of(points);
    const double last = slopes.back();
    return std::abs(last - std::round(last)) <= settled_distance &&
           std::abs(last - slopes[slopes.size() - 2]) <= 2 * settled_distance;
}

} // namespace resonform
