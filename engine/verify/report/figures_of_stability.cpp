// SPDX-License-Identifier: GPL-3.0-or-later
// The worst errors of the stability sweep over each of its inputs.
#include "algebra/number/number.hpp"
#include "verify/report/figures.hpp"
#include "verify/report/page.hpp"
#include "verify/stability/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace resonform::report {

namespace {

constexpr double lowest_ulp = 0.1; // smaller errors are drawn at this height
constexpr double row_of_statuses =
    0.5; // the crosses of each status lie at this share of the height above them
constexpr double middle_of_decade = 3;

std::string size_of(const SweptInput& input) {
    const std::string name = pretty(input.name) + (input.rests ? " − rest" : "");
    const std::string size = input.negative || input.rests ? "|" + name + "|" : name;
    return input.weight == 0 ? size : size + " / " + power_of_eps(input.weight);
}

// Where a decade is drawn; 0 has a place to the left of all others.
class Places {
public:
    explicit Places(const std::vector<Decade>& decades) {
        for (const Decade& d : decades)
            if (d.exponent) {
                at_zero_ = d.from() / (10 / middle_of_decade);
                break;
            }
    }
    [[nodiscard]] double operator()(const Decade& d) const {
        return d.exponent ? middle_of_decade * d.from() : at_zero_;
    }

private:
    double at_zero_ = 1;
};

Curve errors_of(const std::vector<Decade>& decades, std::size_t output, const std::string& name) {
    const Places place(decades);
    Curve curve{name, colour::hues[output % colour::hues.size()], Curve::Style::line_points, {}, {}};
    for (const Decade& d : decades) {
        if (d.ulp.empty()) continue;
        curve.x.push_back(place(d));
        curve.y.push_back(std::max(lowest_ulp, d.ulp[output]));
        curve.marks.emplace_back(d.exponent || output > 0 ? "" : "0");
    }
    return curve;
}

Curve threshold_of(const std::vector<Decade>& decades, double threshold) {
    const Places place(decades);
    Curve curve{"", colour::grey, Curve::Style::dashed, {}, {}};
    for (const Decade& d : decades) {
        curve.x.push_back(place(d));
        curve.y.push_back(threshold);
    }
    return curve;
}

Curve answered_by(const std::string& status, const std::vector<Decade>& decades, double row) {
    const Places place(decades);
    Curve curve{"", colour::grey, Curve::Style::crosses, {}, {}};
    for (const Decade& d : decades) {
        if (d.refused_by.count(status) == 0) continue;
        curve.x.push_back(place(d));
        curve.y.push_back(row);
    }
    return curve;
}

} // namespace

Figure Figures::stability_over(const Stability& s, const InputByDecade& own) const {
    Plot plot{"stability_" + identifier_in_file(own.input.name),
              own.input.name == "t" ? time_label("t") : size_of(own.input),
              "ulp",
              true,
              true,
              {}};
    plot.small = true;
    for (std::size_t k = 0; k < s.histogram.size(); ++k)
        plot.curves.push_back(errors_of(own.decades, k, pretty(s.histogram[k].first)));
    plot.curves.push_back(threshold_of(own.decades, s.threshold));
    double row = lowest_ulp;
    for (const auto& [status, count] : s.refused_by)
        plot.curves.push_back(answered_by(status, own.decades, row *= row_of_statuses));
    return draw(plot, fmt::format("Worst errors over {}, by decades", pretty(own.input.name)));
}

Gallery Figures::stability(const Stability& s) const {
    Gallery gallery{{}, true};
    if (!drawn_) return gallery;
    for (const InputByDecade& own : s.by_decade)
        if (!own.decades.empty()) gallery.figures.push_back(stability_over(s, own));
    return gallery;
}

} // namespace resonform::report
