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

std::string script(const Plot& plot) {
    std::string text = fmt::format(
        "set encoding utf8\nset terminal svg size 640,420 dynamic enhanced name \"{}\" "
        "font \"Helvetica,Arial,sans-serif,15\" background \"#ffffff\"\n"
        "set border 3 lc rgb \"#5a6068\"\nset tics nomirror out scale 0.6 textcolor rgb \"#33383e\"\n"
        "set grid lc rgb \"#e4e7eb\" lt 1 lw 0.8\n"
        "set key above horizontal left Left reverse samplen 2 textcolor rgb \"#33383e\"\n"
        "set lmargin 12\nset rmargin 3\n",
        plot.name);
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

std::string to_svg(const Plot& plot, const fs::path& scratch) {
    const fs::path file = scratch / fmt::format("{}.{}.gnuplot", plot.name, getpid());
    write_atomically(file, script(plot));
    std::string svg = run_gnuplot(file);
    svg.erase(0, svg.find("<svg")); // the prolog has no place inside a page
    // Marks are shared by id: without a prefix the plots of one page would share each other's.
    replace_all(svg, " id=\"", " id=\"" + plot.name + "-");
    replace_all(svg, " id='", " id='" + plot.name + "-");
    replace_all(svg, "'#gp", "'#" + plot.name + "-gp");
    replace_all(svg, "url(#", "url(#" + plot.name + "-");
    return svg;
}

} // namespace resonform
