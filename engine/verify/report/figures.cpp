// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/report/figures.hpp"

#include "algebra/number/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace resonform::report {

namespace {

std::string identifier(const std::string& text) {
    std::string result;
    for (const char c : text)
        result += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : (c == '\'' ? 'p' : '_');
    return result;
}

std::size_t position(const ErrorCurves& curves, const std::string& output) {
    const auto at = std::find(curves.outputs.begin(), curves.outputs.end(), output);
    return static_cast<std::size_t>(at - curves.outputs.begin());
}

// constant * eps^order at the ends of a ladder.
Curve power_law(std::string text, std::string hue, const std::vector<double>& eps, double constant,
                double order) {
    Curve curve{std::move(text), std::move(hue), Curve::Style::dashed, {eps.front(), eps.back()}, {}};
    for (const double e : curve.x) curve.y.push_back(constant * std::pow(e, order));
    return curve;
}

// Of emitted code the form that is meant for the task, of an integrator all.
bool is_drawn(const ComparisonRow& row, Task task) {
    return row.task == task && row.failure.empty() && row.form != Form::scalar;
}

// How wrong a row is: its worst output.
double worst(const ComparisonRow& row) {
    return row.max_error.empty() ? 0 : *std::max_element(row.max_error.begin(), row.max_error.end());
}

} // namespace

Figures::Figures(const System& system, std::filesystem::path scratch, bool drawn)
    : system_(&system), scratch_(std::move(scratch)), drawn_(drawn) {}

Figure Figures::draw(const Plot& plot, std::string caption) const {
    return {plot.name, to_svg(plot, scratch_), std::move(caption)};
}

std::string Figures::label(const std::string& name) const {
    const Variable* variable = system_->variable(name);
    const std::string unit = variable == nullptr || variable->unit.empty() ? "" : ", " + variable->unit;
    return pretty(name) + unit;
}

std::vector<std::string> Figures::drift_outputs(const ErrorCurves& curves) const {
    std::vector<std::string> names;
    for (const std::string& name : curves.outputs) {
        const Variable* variable = system_->variable(name);
        if (variable != nullptr && variable->role == Role::drift) names.push_back(name);
    }
    return names;
}

Figure Figures::path(const MotionCurves& motion, const std::string& x, const std::string& y) const {
    const ErrorCurves& former = *motion.former;
    const std::size_t i = position(former, x), j = position(former, y);
    Plot plot{fmt::format("path_{}", identifier(fmt::format("{:g}", former.eps))),
              label(x),
              label(y),
              false,
              false,
              {{"direct integration", colour::grey, Curve::Style::line, former.direct[i], former.direct[j]},
               {"evaluator", colour::red, Curve::Style::dashed, former.emitted[i], former.emitted[j]}}};
    if (motion.mean)
        plot.curves.push_back({"without oscillation", colour::blue, Curve::Style::line,
                               motion.mean->emitted[position(*motion.mean, x)],
                               motion.mean->emitted[position(*motion.mean, y)]});
    return draw(plot, fmt::format("{} over {}, ε = {:g}", pretty(y), pretty(x), former.eps));
}

Figure Figures::former_constant(const ErrorCurves& curves, std::size_t output) const {
    const std::string& name = curves.outputs[output];
    std::vector<double> slow_time;
    for (const double t : curves.times) slow_time.push_back(curves.eps * t);
    const Plot plot{
        fmt::format("transgression_{}_{}", identifier(name), identifier(fmt::format("{:g}", curves.eps))),
        "εt",
        label(name),
        false,
        false,
        {{"direct integration", colour::grey, Curve::Style::line, slow_time, curves.direct[output]},
         {"evaluator", colour::red, Curve::Style::dashed, slow_time, curves.emitted[output]}}};
    return draw(plot, fmt::format("{} over εt, ε = {:g}", pretty(name), curves.eps));
}

Gallery Figures::transgression(const std::vector<MotionCurves>& motions) const {
    Gallery gallery;
    const ErrorCurves& first = *motions.front().former;
    for (std::size_t k = 0; k < first.outputs.size(); ++k)
        for (const MotionCurves& motion : motions)
            gallery.figures.push_back(former_constant(*motion.former, k));
    const std::vector<std::string> drift = drift_outputs(first);
    if (drift.size() == 2)
        for (const MotionCurves& motion : motions)
            gallery.figures.push_back(path(motion, drift[0], drift[1]));
    return gallery;
}

Gallery Figures::motion(const std::vector<MotionCurves>& motions) const {
    Gallery gallery;
    for (std::size_t k = 0; k < motions.front().full.outputs.size(); ++k)
        for (const MotionCurves& motion : motions) {
            const std::string& name = motion.full.outputs[k];
            const Plot plot{
                fmt::format("motion_{}_{}", identifier(name),
                            identifier(fmt::format("{:g}", motion.full.eps))),
                "t",
                label(name),
                false,
                false,
                {{"", colour::red, Curve::Style::line, motion.full.times, motion.full.emitted[k]}}};
            gallery.figures.push_back(
                draw(plot, fmt::format("{} over t, ε = {:g}", pretty(name), motion.full.eps)));
        }
    return gallery;
}

Gallery Figures::errors(const std::vector<MotionCurves>& motions) const {
    Gallery gallery;
    for (std::size_t k = 0; k < motions.front().full.outputs.size(); ++k)
        for (const MotionCurves& motion : motions) {
            const std::string& name = motion.full.outputs[k];
            const Plot plot{
                fmt::format("error_{}_{}", identifier(name),
                            identifier(fmt::format("{:g}", motion.full.eps))),
                "t",
                "Δ" + label(name),
                false,
                false,
                {{"", colour::blue, Curve::Style::line, motion.full.times, motion.full.error[k]}}};
            gallery.figures.push_back(
                draw(plot, fmt::format("Δ{}: direct integration minus formula, ε = {:g}", pretty(name),
                                       motion.full.eps)));
        }
    return gallery;
}

Figure Figures::ladder(const OutputVerdict& output) const {
    Curve errors{"max error", colour::red, Curve::Style::line_points, {}, {}};
    Curve floor{"error of the reference", colour::grey, Curve::Style::points, {}, {}};
    for (const LadderRung& rung : output.ladder) {
        const double eps = to_double(rung.eps);
        errors.x.push_back(eps);
        errors.y.push_back(rung.max_error);
        floor.x.push_back(eps);
        floor.y.push_back(rung.reference_error);
    }
    Plot plot{
        "ladder_" + identifier(output.name), "ε", "max |Δ" + pretty(output.name) + "|", true, true, {errors}};
    const Rational claimed = output.order(output.claimed_order);
    const double claim = to_double(claimed);
    if (output.found_order && output.constant > 0) {
        const Rational found = output.order(*output.found_order);
        plot.curves.push_back(power_law("slope " + to_string(found), colour::blue, errors.x, output.constant,
                                        to_double(found)));
        if (claimed != found) // through the largest eps, so that the two part downwards
            plot.curves.push_back(power_law(fmt::format("slope {} (claimed)", to_string(claimed)),
                                            colour::grey, errors.x,
                                            errors.y.front() / std::pow(errors.x.front(), claim), claim));
    }
    if (output.estimate && output.estimate->next_order > 0) {
        Curve estimated{"estimated", colour::orange, Curve::Style::line_points, {}, {}};
        for (const EstimatedRung& rung : output.estimate->ladder) {
            estimated.x.push_back(to_double(rung.eps));
            estimated.y.push_back(rung.error);
        }
        plot.curves.push_back(std::move(estimated));
    }
    plot.curves.push_back(floor);
    return draw(plot, fmt::format("{}: claimed O(ε^{}), found slope {:.3f}, {}", pretty(output.name),
                                  to_string(claimed), output.slope, to_string(output.verdict)));
}

Gallery Figures::ladders(const std::vector<OutputVerdict>& outputs) const {
    Gallery gallery;
    if (!drawn_) return gallery;
    for (const OutputVerdict& output : outputs)
        if (!output.ladder.empty()) gallery.figures.push_back(ladder(output));
    return gallery;
}

Figure Figures::work_of(const Comparison& comparison, Task task) const {
    const std::vector<std::string> hues = {colour::red, colour::blue, colour::green, colour::orange,
                                           colour::violet};
    std::vector<Curve> curves;
    std::size_t points = 0;
    for (const ComparisonRow& row : comparison.rows) {
        if (!is_drawn(row, task)) continue;
        points = row.points;
        auto curve =
            std::find_if(curves.begin(), curves.end(), [&](const Curve& c) { return c.label == row.method; });
        if (curve == curves.end()) {
            curves.push_back(
                {row.method, hues[curves.size() % hues.size()], Curve::Style::line_points, {}, {}});
            curve = curves.end() - 1;
        }
        curve->x.push_back(row.total_seconds());
        curve->y.push_back(worst(row));
    }
    const Plot plot{fmt::format("work_{}", to_string(task)),
                    "seconds, construction included",
                    "max error, worst output",
                    true,
                    true,
                    curves};
    return draw(plot, fmt::format("{}: {} point{}, ε = {:g}",
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
