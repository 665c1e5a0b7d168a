// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/report/plot.hpp"

#include "algebra/number/error.hpp"
#include "verify/report/compact_svg.hpp"
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

// A gnuplot string. Names have the whole of "_rest" as an index.
std::string in_gnuplot(const std::string& text) {
    std::string result = "\"";
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"' || c == '\\') result += '\\';
        result += c;
        if (c != '_' || i + 1 == text.size() || text[i + 1] == '{') continue;
        std::size_t end = i + 1;
        while (end < text.size() && text[end] != ' ' && text[end] != ',' && text[end] != '_' &&
               text[end] != '|')
            ++end;
        result += "{" + text.substr(i + 1, end - i - 1) + "}";
        i = end - 1;
    }
    return result + "\"";
}

// x, y, the ends of the bar; the marks follow in a block of their own, for those that there are.
std::string data_block(const Plot& plot, const Curve& curve, const std::string& name) {
    std::string block = fmt::format("${} << EOD\n", name), marks = fmt::format("${}marks << EOD\n", name);
    for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) {
        if (!drawable(plot, curve.x[i], curve.y[i])) continue;
        block += fmt::format("{:.9g} {:.9g}", curve.x[i], curve.y[i]);
        if (!curve.x_low.empty()) block += fmt::format(" {:.9g} {:.9g}", curve.x_low[i], curve.x_high[i]);
        block += '\n';
        if (!curve.marks.empty() && !curve.marks[i].empty())
            marks += fmt::format("{:.9g} {:.9g} {}\n", curve.x[i], curve.y[i], in_gnuplot(curve.marks[i]));
    }
    return block + "EOD\n" + (curve.marks.empty() ? "" : marks + "EOD\n");
}

std::string style_of(const Curve& curve) {
    switch (curve.style) {
    case Curve::Style::line: return "with lines lw 1.6";
    case Curve::Style::wide: return "with lines lw 5";
    case Curve::Style::dashed: return "with lines lw 1.4 dt (8,6)";
    case Curve::Style::points: return "with points pt 7 ps 0.55";
    case Curve::Style::crosses: return "with points pt 2 ps 0.5 lw 1.2";
    case Curve::Style::line_points: return "with linespoints lw 1.4 pt 7 ps 0.45";
    }
    return "with lines";
}

// The power of ten of the largest value: 2e-8 -> -8. 0 where it needs no power.
int power_of_ten_of(const std::vector<Curve>& curves) {
    double largest = 0;
    for (const Curve& curve : curves)
        for (const double y : curve.y)
            if (std::isfinite(y)) largest = std::max(largest, std::abs(y));
    if (largest == 0 || (largest >= 0.01 && largest < 1000)) return 0;
    return static_cast<int>(std::floor(std::log10(largest)));
}

// "Δx, m" in units of 10^-8: "Δx, 10^{-8} m".
std::string with_power(const std::string& label, int power) {
    if (power == 0) return label;
    const std::size_t comma = std::min(label.find(','), label.size());
    return fmt::format("{}, 10^{{{}}}{}", label.substr(0, comma), power,
                       label.substr(std::min(comma + 1, label.size())));
}

// "plot $data0 using ..., ...\n": each curve with its bars and marks.
std::string plot_command(const std::vector<Curve>& curves, const std::string& prefix, int power = 0) {
    const std::string y = power == 0 ? "2" : fmt::format("($2/1e{})", power);
    std::string command;
    const auto add = [&](const std::string& part) { command += (command.empty() ? "plot " : ", ") + part; };
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const Curve& curve = curves[i];
        const std::string data = fmt::format("${}{}", prefix, i);
        add(fmt::format("{} using 1:{} {} lc rgb \"{}\" {}", data, y, style_of(curve), curve.colour,
                        curve.label.empty() ? "notitle" : "title " + in_gnuplot(curve.label)));
        if (!curve.x_low.empty())
            add(fmt::format("{} using 1:2:3:4 with xerrorbars lw 1 ps 0 lc rgb \"{}\" notitle", data,
                            curve.colour));
        const auto is_word = [](const std::string& mark) { return !mark.empty(); };
        if (std::any_of(curve.marks.begin(), curve.marks.end(), is_word)) // gnuplot warns of none
            add(fmt::format(
                "{}marks using 1:2:3 with labels left offset 0.5,0.4 font \",11\" tc rgb \"{}\" notitle",
                data, curve.colour));
    }
    return command + "\n";
}

std::string axis(const std::string& letter, const std::string& label, bool logarithmic) {
    std::string text =
        fmt::format("set {}label {}{}\n", letter, in_gnuplot(label), letter == "y" ? " offset 1.2" : "");
    if (logarithmic)
        text += fmt::format("set logscale {0} 10\nset format {0} \"10^{{%T}}\"\nset m{0}tics 1\n", letter);
    else
        text += fmt::format("set format {} \"%h\"\n", letter);
    return text;
}

struct Sheet {
    int width = 600, height = 420, left = 12, right = 3; // margins in letters
    int name_width = -2;                                 // of the legend, in letters more than its names
};

// What all figures have in common.
std::string head_of_script(const std::string& name, const Sheet& sheet) {
    return fmt::format(
        "set encoding utf8\nset terminal svg size {},{} dynamic enhanced name \"{}\" "
        "font \"Helvetica,Arial,sans-serif,15\" background \"#ffffff\"\n"
        "set border 3 lc rgb \"#5a6068\"\nset tics nomirror out scale 0.6 textcolor rgb \"#33383e\"\n"
        "set grid lc rgb \"#e4e7eb\" lt 1 lw 0.8\n"
        "set key above horizontal left Left reverse samplen 1.6 width {} font \",13\" textcolor rgb "
        "\"#33383e\"\n"
        "set lmargin {}\nset rmargin {}\nset errorbars small\n",
        sheet.width, sheet.height, name, sheet.name_width, sheet.left, sheet.right);
}

// gnuplot warns of a curve without a point.
void drop_empty(const Plot& plot, std::vector<Curve>& curves) {
    curves.erase(std::remove_if(curves.begin(), curves.end(),
                                [&](const Curve& curve) {
                                    for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i)
                                        if (drawable(plot, curve.x[i], curve.y[i])) return false;
                                    return true;
                                }),
                 curves.end());
}

// The curves over each other, or in two panels.
std::string script(Plot plot) {
    drop_empty(plot, plot.curves);
    drop_empty(plot, plot.below);
    const bool two = !plot.below.empty();
    const Sheet sheet = plot.small ? Sheet{400, 300, 9, 3, 1} : Sheet{600, two ? 540 : 420};
    std::string text = head_of_script(plot.name, sheet);
    text += axis("x", plot.x_label, plot.log_x) + axis("y", plot.y_label, plot.log_y);
    if (!plot.note.empty())
        text += fmt::format("set label 1 {} at graph 0.02,0.05 left font \",13\" tc rgb \"#5a6068\"\n",
                            in_gnuplot(plot.note));
    for (std::size_t i = 0; i < plot.curves.size(); ++i)
        text += data_block(plot, plot.curves[i], fmt::format("data{}", i));
    for (std::size_t i = 0; i < plot.below.size(); ++i)
        text += data_block(plot, plot.below[i], fmt::format("below{}", i));
    if (!two) return text + plot_command(plot.curves, "data");
    text += "set multiplot\nset tmargin at screen 0.90\nset bmargin at screen 0.44\nunset xlabel\nset format "
            "x \"\"\n";
    text += plot_command(plot.curves, "data");
    const int power = power_of_ten_of(plot.below);
    text += "set tmargin at screen 0.40\nset bmargin at screen 0.13\nunset key\nunset label 1\nset ytics "
            "autofreq\n";
    text += axis("x", plot.x_label, plot.log_x) + axis("y", with_power(plot.below_label, power), false);
    return text + plot_command(plot.below, "below", power) + "unset multiplot\n";
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
    std::string text = head_of_script(map.name, {600, 420, 12, 14});
    text += axis("x", map.x_label, map.log_x) + axis("y", map.y_label, map.log_y);
    const std::vector<double> x = edges(map.x, map.log_x), y = edges(map.y, map.log_y);
    text += fmt::format("set title {}\nset palette defined (0 \"#1f3f7a\", 1 \"#3f8fb5\", 2 \"#f2f0d8\", 3 "
                        "\"#d98a3d\", 4 \"#8a2a1f\")\nset style fill solid 1 noborder\nunset grid\n",
                        in_gnuplot(map.title));
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
    return compact_svg(std::move(svg));
}

} // namespace

std::string to_svg(const Plot& plot, const fs::path& scratch) {
    return drawn(plot.name, script(plot), scratch);
}

std::string to_svg(const HeatMap& map, const fs::path& scratch) {
    return drawn(map.name, script(map), scratch);
}

std::string to_csv(const Plot& plot) {
    const auto cell = [](std::string text) {
        replace_all(text, "\"", "\"\"");
        return "\"" + text + "\"";
    };
    std::vector<const Curve*> all;
    for (const Curve& curve : plot.curves) all.push_back(&curve);
    for (const Curve& curve : plot.below) all.push_back(&curve);
    const bool marks = std::any_of(all.begin(), all.end(), [](const Curve* c) { return !c->marks.empty(); });
    const bool bars = std::any_of(all.begin(), all.end(), [](const Curve* c) { return !c->x_low.empty(); });
    std::string csv = fmt::format("quantity,curve,{},value{}{}\n", cell(plot.x_label), marks ? ",mark" : "",
                                  bars ? ",low,high" : "");
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Curve& c = *all[k];
        const std::string begin =
            cell(k < plot.curves.size() ? plot.y_label : plot.below_label) + "," + cell(c.label);
        for (std::size_t i = 0; i < std::min(c.x.size(), c.y.size()); ++i) {
            csv += fmt::format("{},{:.9g},{:.9g}", begin, c.x[i], c.y[i]);
            if (marks) csv += "," + (c.marks.empty() ? "" : cell(c.marks[i]));
            if (bars) csv += c.x_low.empty() ? ",," : fmt::format(",{:.9g},{:.9g}", c.x_low[i], c.x_high[i]);
            csv += '\n';
        }
    }
    return csv;
}

} // namespace resonform
