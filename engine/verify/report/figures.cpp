// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/report/figures.hpp"

#include "algebra/number/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace resonform::report {

namespace {

std::size_t position(const ErrorCurves& curves, const std::string& output) {
    const auto at = std::find(curves.outputs.begin(), curves.outputs.end(), output);
    return static_cast<std::size_t>(at - curves.outputs.begin());
}

} // namespace

std::string identifier_in_file(const std::string& text) {
    std::string result;
    for (const char c : text)
        result += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : (c == '\'' ? 'p' : '_');
    return result;
}

Figures::Figures(const System& system, std::filesystem::path scratch, bool drawn, PublishedFigures published)
    : system_(&system), scratch_(std::move(scratch)), drawn_(drawn), published_(std::move(published)) {}

Figure Figures::draw(const Plot& plot, std::string caption) const {
    return {plot.name, to_svg(plot, scratch_), std::move(caption), to_csv(plot)};
}

std::string Figures::label(const std::string& name) const {
    const Variable* variable = system_->variable(name);
    const std::string unit = variable == nullptr || variable->unit.empty() ? "" : ", " + variable->unit;
    return pretty(name) + unit;
}

std::string Figures::unit_of_time() const {
    const auto has_unit = [](const auto& named) { return !named.unit.empty(); };
    const bool any = std::any_of(system_->parameters.begin(), system_->parameters.end(), has_unit) ||
                     std::any_of(system_->variables.begin(), system_->variables.end(), has_unit);
    return any ? "s" : "";
}

std::string Figures::time_label(const std::string& time) const {
    const std::string unit = unit_of_time();
    return unit.empty() ? time : time + ", " + unit;
}

std::string Figures::published(const std::string& what, double eps) const {
    const auto numbers = published_.find(what);
    if (numbers == published_.end()) return "";
    for (std::size_t i = 0; i < numbers->second.size(); ++i)
        if (eps == to_double(parse_rational(drawn_eps[i])))
            return fmt::format("; compare figure {} of the source", numbers->second[i]);
    return "";
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
    Plot plot{fmt::format("path_{}", identifier_in_file(fmt::format("{:g}", former.eps))),
              label(x),
              label(y),
              false,
              false,
              {{"direct integration", colour::pale, Curve::Style::wide, former.direct[i], former.direct[j]},
               {"evaluator", colour::red, Curve::Style::line, former.emitted[i], former.emitted[j]}}};
    if (motion.mean)
        plot.curves.push_back({"without oscillation", colour::blue, Curve::Style::line,
                               motion.mean->emitted[position(*motion.mean, x)],
                               motion.mean->emitted[position(*motion.mean, y)]});
    return draw(plot, fmt::format("{} over {}, ε = {:g}{}", pretty(y), pretty(x), former.eps,
                                  published(fmt::format("{}({})", y, x), former.eps)));
}

Figure Figures::former_constant(const ErrorCurves& curves, std::size_t output) const {
    const std::string& name = curves.outputs[output];
    std::vector<double> slow_time;
    for (const double t : curves.times) slow_time.push_back(curves.eps * t);
    const Plot plot{
        fmt::format("transgression_{}_{}", identifier_in_file(name),
                    identifier_in_file(fmt::format("{:g}", curves.eps))),
        time_label("εt"),
        label(name),
        false,
        false,
        {{"direct integration", colour::pale, Curve::Style::wide, slow_time, curves.direct[output]},
         {"evaluator", colour::red, Curve::Style::line, slow_time, curves.emitted[output]}}};
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

Figure Figures::motion_of(const ErrorCurves& curves, std::size_t output) const {
    const std::string& name = curves.outputs[output];
    const Plot plot{
        fmt::format("motion_{}_{}", identifier_in_file(name),
                    identifier_in_file(fmt::format("{:g}", curves.eps))),
        time_label("t"),
        label(name),
        false,
        false,
        {{"direct integration", colour::pale, Curve::Style::wide, curves.times, curves.direct[output]},
         {"evaluator", colour::red, Curve::Style::line, curves.times, curves.emitted[output]}},
        "",
        "Δ" + label(name),
        {{"difference", colour::blue, Curve::Style::line, curves.times, curves.error[output]}}};
    return draw(plot,
                fmt::format("{0} over t, ε = {1:g}; below it Δ{0}, direct integration minus evaluator{2}",
                            pretty(name), curves.eps, published(name, curves.eps)));
}

Gallery Figures::motion(const std::vector<MotionCurves>& motions) const {
    Gallery gallery;
    for (std::size_t k = 0; k < motions.front().full.outputs.size(); ++k)
        for (const MotionCurves& motion : motions) gallery.figures.push_back(motion_of(motion.full, k));
    return gallery;
}

} // namespace resonform::report
