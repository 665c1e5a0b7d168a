// SPDX-License-Identifier: GPL-3.0-or-later
// Plots as SVG, drawn by gnuplot.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace resonform {

// The few colours of all figures.
namespace colour {
inline const std::string red = "#c0392b", blue = "#1f5fa8", grey = "#8a8f98", green = "#2e7d4f",
                         orange = "#c77d0a", violet = "#7a4a9e", teal = "#0b7f8a", brown = "#7b4b2a",
                         pale = "#c9d6e6";
// Of curves that are told apart by nothing else.
inline const std::vector<std::string> hues = {red, blue, green, orange, violet, teal, brown};
} // namespace colour

struct Curve {
    // wide: a pale band for others to lie upon
    enum class Style { line, wide, dashed, points, line_points, crosses };
    std::string label; // empty: not in the legend
    std::string colour;
    Style style = Style::line;
    std::vector<double> x, y; // points that are not finite (or not positive on a log axis) are left out
    std::vector<std::string> marks = {};         // a word beside each point, or none at all
    std::vector<double> x_low = {}, x_high = {}; // a bar through each point, or none at all
};

struct Plot {
    std::string name; // letters, digits and _: the prefix of its ids, so that many fit one page
    std::string x_label, y_label;
    bool log_x = false, log_y = false;
    std::vector<Curve> curves;
    std::string note = {}; // in the lower left corner
    // A second, lower panel over the same x, where there are curves; its y is linear.
    std::string below_label = {};
    std::vector<Curve> below = {};
    bool small = false; // one of many: smaller, with letters as large
};

// A colour for each cell: z[i*y.size() + j] at x[i], y[j], both ascending or descending; cells without a
// finite value are left out.
struct HeatMap {
    std::string name; // as of a Plot
    std::string x_label, y_label, title;
    bool log_x = false, log_y = false;
    std::vector<double> x, y, z;
};

// "" if gnuplot is there, and draws SVG.
std::string why_no_plots();

// An <svg> element without width and height: it fills its container. `scratch` is a folder for the
// script of gnuplot, made if absent. Errors (bad_input): gnuplot cannot be run, or takes a minute.
std::string to_svg(const Plot& plot, const std::filesystem::path& scratch);
std::string to_svg(const HeatMap& map, const std::filesystem::path& scratch);

// Its numbers, a line a point: what is drawn, the curve, x and y; where there are any, marks and bars.
std::string to_csv(const Plot& plot);

} // namespace resonform
