// SPDX-License-Identifier: GPL-3.0-or-later
// Errors over eps, and against run time.
#include "algebra/number/number.hpp"
#include "verify/judging/judge.hpp"
#include "verify/report/figures.hpp"
#include "verify/report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace resonform::report {

namespace {

// error/eps^order over eps: what falls like eps^order is level.
class Compensated {
public:
    explicit Compensated(double order) : order_(order) {}

    void add(Curve& curve, double eps, double error) const {
        curve.x.push_back(eps);
        curve.y.push_back(error / std::pow(eps, order_));
    }
    // constant eps^power between two eps.
    [[nodiscard]] Curve law(std::string text, double from, double to, double constant, double power) const {
        Curve curve{std::move(text), colour::blue, Curve::Style::dashed, {}, {}};
        for (const double eps : {from, to}) add(curve, eps, constant * std::pow(eps, power));
        return curve;
    }

private:
    double order_;
};

// Of emitted code the form that is meant for the task, of an integrator all.
bool is_drawn(const ComparisonRow& row, Task task) {
    return row.task == task && row.failure.empty() && row.form != Form::scalar;
}

// How wrong a row is: its worst output.
double largest_error(const ComparisonRow& row) {
    return row.max_error.empty() ? 0 : *std::max_element(row.max_error.begin(), row.max_error.end());
}

// "N = 3" of emitted code, "10⁻⁸" of a rival at every third tolerance: more would hide each other.
std::string mark_of(const ComparisonRow& row, std::size_t place) {
    if (row.is_emitted()) return "N = " + to_string(row.order);
    const std::string tolerance = "tolerance ";
    if (place % 3 != 0 || row.setting.compare(0, tolerance.size(), tolerance) != 0) return "";
    return typeset(row.setting.substr(tolerance.size()));
}

void add_row(Curve& curve, const ComparisonRow& row) {
    curve.marks.push_back(mark_of(row, curve.x.size()));
    curve.x.push_back(row.total_seconds());
    curve.y.push_back(largest_error(row));
    curve.x_low.push_back(row.seconds.low + row.construction_seconds);
    curve.x_high.push_back(row.seconds.high + row.construction_seconds);
}

} // namespace

Figure Figures::ladder(const OutputVerdict& output) const {
    const Rational claimed = output.order(output.claimed_order);
    const Compensated over(to_double(claimed));
    Curve errors{"max error", colour::red, Curve::Style::line_points, {}, {}};
    Curve hidden{"hidden by rounding", colour::grey, Curve::Style::points, {}, {}};
    for (const LadderRung& rung : output.ladder)
        over.add(usable(rung) ? errors : hidden, to_double(rung.eps), rung.max_error);
    const std::string power = power_of_eps(claimed), label_of_output = label(output.name);
    const std::size_t unit = label_of_output.find(',');
    Plot plot{"ladder_" + identifier_in_file(output.name),
              "ε",
              fmt::format("max |Δ{}| / {}{}", pretty(output.name), power,
                          unit == std::string::npos ? "" : label_of_output.substr(unit)),
              true,
              true,
              {errors}};
    if (output.found_order && output.constant > 0 && !errors.x.empty()) {
        // From a decade above the window of the slope down: further up it would only stretch the axis.
        const double from = output.slope_high_eps > 0 ? std::min(10 * output.slope_high_eps, errors.x.front())
                                                      : errors.x.front();
        const Rational found = output.order(*output.found_order);
        plot.curves.push_back(
            over.law(fmt::format("{} {}", short_number(output.constant), power_of_eps(found)), from,
                     errors.x.back(), output.constant, to_double(found)));
    }
    if (output.estimate && output.estimate->next_order > 0) {
        Curve estimated{"estimated", colour::orange, Curve::Style::line_points, {}, {}};
        for (const EstimatedRung& rung : output.estimate->ladder)
            over.add(estimated, to_double(rung.eps), rung.error);
        plot.curves.push_back(std::move(estimated));
    }
    if (!hidden.x.empty()) plot.curves.push_back(hidden);
    return draw(plot,
                fmt::format("{0}: max |Δ{0}| divided by {1}. Level towards small ε is the claimed order {2}; "
                            "a rise to the left is a lower one. Found: slope {3:.3f}, {4}",
                            pretty(output.name), power, to_string(claimed), output.slope,
                            to_string(output.verdict)));
}

Gallery Figures::ladders(const std::vector<OutputVerdict>& outputs) const {
    Gallery gallery;
    if (!drawn_) return gallery;
    for (const OutputVerdict& output : outputs)
        if (!output.ladder.empty()) gallery.figures.push_back(ladder(output));
    return gallery;
}

Figure Figures::work_of(const Comparison& comparison, Task task) const {
    std::vector<Curve> curves;
    std::size_t points = 0;
    for (const ComparisonRow& row : comparison.rows) {
        if (!is_drawn(row, task)) continue;
        points = row.points;
        auto curve =
            std::find_if(curves.begin(), curves.end(), [&](const Curve& c) { return c.label == row.method; });
        if (curve == curves.end()) {
            curves.push_back({row.method,
                              colour::hues[curves.size() % colour::hues.size()],
                              Curve::Style::line_points,
                              {},
                              {}});
            curve = curves.end() - 1;
        }
        add_row(*curve, row);
    }
    const Plot plot{fmt::format("work_{}", to_string(task)),
                    "run time with construction, s",
                    "max error, worst output",
                    true,
                    true,
                    curves,
                    "lower left is better"};
    return draw(
        plot,
        fmt::format("{}: {} point{}, ε = {:g}. Marks are orders N of the emitted code and tolerances of the "
                    "integrators; bars reach from the fastest to the slowest run",
                    task == Task::final ? "One point at the end" : "Dense output", points,
                    points == 1 ? "" : "s", to_double(comparison.by_eps.front().eps)));
}

Gallery Figures::work(const Comparison& comparison) const {
    if (!drawn_) return {};
    Gallery gallery;
    for (const Task task : {Task::final, Task::dense})
        if (std::any_of(comparison.rows.begin(), comparison.rows.end(),
                        [&](const ComparisonRow& row) { return is_drawn(row, task); }))
            gallery.figures.push_back(work_of(comparison, task));
    return gallery;
}

} // namespace resonform::report
