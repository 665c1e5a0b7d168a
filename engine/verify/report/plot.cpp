// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/report/plot.hpp"

#include "algebra/number/error.hpp"
#include "verify/run/cache.hpp"
#include "verify/run/child.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace resonform {

namespace fs = std::filesystem;

namespace {

bool drawable(const Plot& plot, double x, double y) {
    return std::isfinite(x) && std::isfinite(y) && (!plot.log_x || x > 0) && (!plot.log_y || y > 0);
}

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result + "\"";
}

std::string data_block(const Plot& plot, std::size_t index) {
    const Curve& curve = plot.curves[index];
    std::string block = fmt::format("$data{} << EOD\n", index);
    for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i)
        if (drawable(plot, curve.x[i], curve.y[i]))
            block += fmt::format("{:.9g} {:.9g}\n", curve.x[i], curve.y[i]);
    return block + "EOD\n";
}

std::string style_of(const Curve& curve) {
    switch (curve.style) {
    case Curve::Style::line: return "with lines lw 1.6";
    case Curve::Style::dashed: return "with lines lw 1.4 dt (8,6)";
    case Curve::Style::points: return "with points pt 7 ps 0.55";
    case Curve::Style::line_points: return "with linespoints lw 1.4 pt 7 ps 0.45";
    }
    return "with lines";
}

std::string axis(const std::string& letter, const std::string& label, bool logarithmic) {
    std::string text =
        fmt::format("set {}label {}{}\n", letter, quoted(label), letter == "y" ? " offset 1.2" : "");
    if (logarithmic)
        text += fmt::format("set logscale {0} 10\nset format {0} \"10^{{%T}}\"\n", letter);
    else
        text += fmt::format("set format {} \"%h\"\n", letter);
    return text;
}

// What all figures have in common.
std::string head_of_script(const std::string& name, int right_margin) {
    return fmt::format(
        "set encoding utf8\nset terminal svg size 640,420 dynamic enhanced name \"{}\" "
        "font \"Helvetica,Arial,sans-serif,15\" background \"#ffffff\"\n"
        "set border 3 lc rgb \"#5a6068\"\nset tics nomirror out scale 0.6 textcolor rgb \"#33383e\"\n"
        "set grid lc rgb \"#e4e7eb\" lt 1 lw 0.8\n"
        "set key above horizontal left Left reverse samplen 2 textcolor rgb \"#33383e\"\n"
        "set lmargin 12\nset rmargin {}\n",
        name, right_margin);
}

std::string script(const Plot& plot) {
    std::string text = head_of_script(plot.name, 3);
    text += axis("x", plot.x_label, plot.log_x) + axis("y", plot.y_label, plot.log_y);
    std::string draw;
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        const Curve& curve = plot.curves[i];
        text += data_block(plot, i);
        draw += fmt::format("{}$data{} using 1:2 {} lc rgb \"{}\" {}", draw.empty() ? "plot " : ", ", i,
                            style_of(curve), curve.colour,
                            curve.label.empty() ? "notitle" : "title " + quoted(curve.label));
    }
    return text + draw + "\n";
}

// The edges of cells: halfway between neighbours, in the logarithm on a logarithmic axis.
std::vector<double> edges(const std::vector<double>& centres, bool logarithmic) {
    const auto halfway = [&](double a, double b) {
        return logarithmic ? std::sqrt(a) * std::sqrt(b) : a + (b - a) / 2;
    };
    std::vector<double> all;
    for (std::size_t i = 0; i + 1 < centres.size(); ++i) all.push_back(halfway(centres[i], centres[i + 1]));
    const auto beyond = [&](double edge, double centre) {
        return logarithmic ? centre / edge * centre : centre + (centre - edge);
    };
    const double first = beyond(all.front(), centres.front()), last = beyond(all.back(), centres.back());
    all.insert(all.begin(), first);
    all.push_back(last);
    return all;
}

std::string script(const HeatMap& map) {
    std::string text = head_of_script(map.name, 14);
    text += axis("x", map.x_label, map.log_x) + axis("y", map.y_label, map.log_y);
    const std::vector<double> x = edges(map.x, map.log_x), y = edges(map.y, map.log_y);
    text += fmt::format("set title {}\nset palette defined (0 \"#1f3f7a\", 1 \"#3f8fb5\", 2 \"#f2f0d8\", 3 "
                        "\"#d98a3d\", 4 \"#8a2a1f\")\nset style fill solid 1 noborder\nunset grid\n",
                        quoted(map.title));
    text += fmt::format("set xrange [{:.9g}:{:.9g}]\nset yrange [{:.9g}:{:.9g}]\n$cells << EOD\n",
                        std::min(x.front(), x.back()), std::max(x.front(), x.back()),
                        std::min(y.front(), y.back()), std::max(y.front(), y.back()));
    for (std::size_t i = 0; i < map.x.size(); ++i)
        for (std::size_t j = 0; j < map.y.size(); ++j)
            if (const double z = map.z[i * map.y.size() + j]; std::isfinite(z))
                text += fmt::format("{:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g}\n", map.x[i], map.y[j],
                                    x[i], x[i + 1], y[j], y[j + 1], z);
    return text + "EOD\nplot $cells using 1:2:3:4:5:6:7 with boxxyerror lc palette notitle\n";
}

constexpr double longest_question = 10, longest_drawing = 60; // seconds

[[noreturn]] void cannot_plot(const std::string& reason) {
    bad_input({"the plots of a report are drawn by gnuplot",
               reason,
               "install the Debian package gnuplot-nox, check the gnuplot in PATH, or leave the report out",
               {}});
}

std::string run_gnuplot(const fs::path& script_file) {
    const Finished gnuplot =
        run_child("gnuplot " + shell_quoted(script_file), {script_file}, longest_drawing);
    std::error_code ignored;
    fs::remove(script_file, ignored);
    if (gnuplot.late) cannot_plot(fmt::format("no plot within {} s", longest_drawing));
    if (gnuplot.output.find("</svg>") == std::string::npos) cannot_plot("gnuplot printed no plot");
    return gnuplot.output;
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
}

} // namespace

std::string why_no_plots() {
    const Finished asked = run_child("gnuplot -e 'set terminal svg' >/dev/null 2>&1", {}, longest_question);
    if (asked.late) return fmt::format("gnuplot does not answer within {} s", longest_question);
    return asked.status == 0 ? "" : "gnuplot cannot be run";
}

namespace {

std::string drawn(const std::string& name, const std::string& script, const fs::path& scratch) {
    const fs::path file = scratch / fmt::format("{}.{}.gnuplot", name, getpid());
    write_atomically(file, script);
    std::string svg = run_gnuplot(file);
    svg.erase(0, svg.find("<svg")); // the prolog has no place inside a page
    // Marks are shared by id: without a prefix the plots of one page would share each other's.
    replace_all(svg, " id=\"", " id=\"" + name + "-");
    replace_all(svg, " id='", " id='" + name + "-");
    replace_all(svg, "'#gp", "'#" + name + "-gp");
    replace_all(svg, "url(#", "url(#" + name + "-");
    return svg;
}

} // namespace

std::string to_svg(const Plot& plot, const fs::path& scratch) {
    return drawn(plot.name, script(plot), scratch);
}

std::string to_svg(const HeatMap& map, const fs::path& scratch) {
    return drawn(map.name, script(map), scratch);
}

} // namespace resonform
