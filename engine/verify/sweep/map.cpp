// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/sweep/map.hpp"

#include "algebra/number/error.hpp"
#include "verify/report/page.hpp"
#include "verify/report/plot.hpp"
#include "verify/sweep/result.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace resonform {

namespace {

constexpr std::uint64_t most_drawn = 200; // of an axis

// Those of several values.
std::vector<std::size_t> long_axes(const SweepGrid& grid) {
    std::vector<std::size_t> axes;
    for (std::size_t a = 0; a < grid.axes().size(); ++a)
        if (grid.axes()[a].count() > 1) axes.push_back(a);
    return axes;
}

[[noreturn]] void no_map(const std::string& rule, const std::string& found, const std::string& hint) {
    bad_input(Reason::command_line, {rule, found, hint, {}});
}

// Places along an axis.
std::vector<std::uint64_t> picked(std::uint64_t count) {
    const std::uint64_t drawn = std::min(count, most_drawn);
    std::vector<std::uint64_t> places;
    for (std::uint64_t i = 0; i < drawn; ++i)
        places.push_back(drawn == 1 ? 0 : i * (count - 1) / (drawn - 1));
    return places;
}

// One axis as it is drawn.
struct Drawn {
    const Axis* axis;
    std::vector<std::uint64_t> places;
    std::vector<double> values;
    [[nodiscard]] bool logarithmic() const { return axis->spacing() == Spacing::logarithmic; }
};

Drawn drawn(const SweepGrid& grid, std::size_t a) {
    Drawn axis{&grid.axes()[a], picked(grid.axes()[a].count()), {}};
    for (const std::uint64_t i : axis.places) axis.values.push_back(grid.values(a)[i]);
    return axis;
}

// Of an error; of none that is seen there is nothing to draw.
double log_of_error(double error) {
    return error > 0 ? std::log10(error) : std::numeric_limits<double>::quiet_NaN();
}

// The numbers of all points that are drawn, the first axis slowest.
std::vector<double> numbers(const SweepFolder& folder, const SweepSize& size, const SweepSubject& subject,
                            const std::vector<Drawn>& axes) {
    const std::uint64_t row_of_point = subject.what == SweepKind::values ? size.rows - 1 : 0;
    std::vector<std::uint64_t> wanted;
    for (const std::uint64_t i : axes.front().places) {
        if (axes.size() == 1) wanted.push_back(i);
        for (std::size_t j = 0; axes.size() > 1 && j < axes[1].places.size(); ++j)
            wanted.push_back(i * axes[1].axis->count() + axes[1].places[j]);
    }
    std::vector<double> found;
    read_blocks(folder, size, [&](std::uint64_t b, const SweepBlock& block) {
        const std::uint64_t end = size.first(b) + size.count(b);
        for (; found.size() < wanted.size() && wanted[found.size()] < end;) {
            const std::uint64_t row = (wanted[found.size()] - size.first(b)) * size.rows + row_of_point;
            const double number = block.numbers[row * size.columns + 1];
            found.push_back(subject.what == SweepKind::verify ? log_of_error(number) : number);
        }
    });
    return found;
}

// As in the other figures; gnuplot takes what is behind _ for a subscript of one letter.
std::string label(const std::string& name) {
    std::string text;
    for (const char c : report::pretty(name)) text += c == '_' ? std::string("\\_") : std::string(1, c);
    return text;
}

std::string quantity(const SweepSubject& subject) {
    const std::string output = label(subject.outputs.front());
    if (subject.what == SweepKind::validity)
        return fmt::format("time up to which the estimated error of {} is below {:g}", output,
                           subject.tolerance);
    if (subject.what == SweepKind::verify)
        return fmt::format("log10 of the largest error of {} on t <= {}", output, subject.interval);
    if (subject.what == SweepKind::stability)
        return fmt::format("largest rounding error of {} on t <= {} in ulp", output, subject.interval);
    return fmt::format("{} at t = {}", output,
                       subject.times.empty() ? subject.interval : fmt::format("{:g}", subject.times.back()));
}

} // namespace

void require_map(const SweepGrid& grid) {
    const std::vector<std::size_t> axes = long_axes(grid);
    if (grid.sample() || axes.empty() || axes.size() > 2)
        no_map("a map must be of one or two axes of a grid with several values",
               grid.sample() ? "a sample" : fmt::format("{} of them", axes.size()),
               "leave out --map, or give the other axes one value each");
    for (const std::size_t a : axes) {
        const std::vector<double>& values = grid.values(a);
        if (std::adjacent_find(values.begin(), values.end(), std::greater_equal<>()) != values.end() &&
            std::adjacent_find(values.begin(), values.end(), std::less_equal<>()) != values.end())
            no_map("the values of an axis of a map must rise or fall", grid.axes()[a].name(), "sort them");
    }
    if (const std::string why = why_no_plots(); !why.empty())
        no_map("maps are drawn by gnuplot", why,
               "install the Debian package gnuplot-nox, or leave out --map");
}

std::string sweep_map(const SweepFolder& folder, const SweepSubject& subject, const SweepGrid& grid,
                      const SweepSize& size, const std::filesystem::path& scratch) {
    std::vector<Drawn> axes;
    for (const std::size_t a : long_axes(grid)) axes.push_back(drawn(grid, a));
    const std::vector<double> z = numbers(folder, size, subject, axes);
    if (std::none_of(z.begin(), z.end(), [](double number) { return std::isfinite(number); }))
        no_map("a map must have a number to show",
               fmt::format("none at the {} points that are drawn{}", z.size(),
                           subject.what == SweepKind::verify ? ", or an error of 0" : ""),
               "leave out --map: what is computed is kept, and the statuses say why");
    const Drawn& x = axes.front();
    std::string svg;
    if (axes.size() == 1) {
        Plot plot{"sweep", label(x.axis->name()), quantity(subject), x.logarithmic(), false, {}};
        plot.curves.push_back({"", colour::blue, Curve::Style::line, x.values, z});
        svg = to_svg(plot, scratch);
    } else {
        svg = to_svg(HeatMap{"sweep", label(x.axis->name()), label(axes[1].axis->name()), quantity(subject),
                             x.logarithmic(), axes[1].logarithmic(), x.values, axes[1].values, z},
                     scratch);
    }
    return "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n" + svg;
}

} // namespace resonform
