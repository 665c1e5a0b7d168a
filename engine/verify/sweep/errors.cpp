// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/sweep/errors.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/number.hpp"
#include "model/system/scene_file.hpp"
#include "model/system/start_names.hpp"
#include "verify/evaluate/interpreter.hpp"
#include "verify/evaluate/scene_values.hpp"
#include "verify/judging/descent.hpp"
#include "verify/judging/judge.hpp"
#include "verify/judging/start_scaling.hpp"
#include "verify/run/cache.hpp"

#include <cln/real.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace resonform {

namespace {

constexpr std::array<int, 3> parts_of_eps{2, 4, 8}; // the rungs below the point's own
constexpr double most_digits = 6;

GiNaC::numeric numeric(const Rational& x) { return GiNaC::numeric(cln::cl_N(x)); }

// In the digits that are clear of the rounding of the integration, at most six; 0 where none are.
double known_part(const LadderRung& rung) {
    if (!usable(rung)) return 0;
    const double noise = std::max(rung.reference_error, rung.floor);
    const double digits = noise > 0 ? std::floor(std::log10(rung.max_error / noise)) : most_digits;
    const int shown = static_cast<int>(std::clamp(digits, 1.0, most_digits));
    return std::stod(fmt::format("{:.{}e}", rung.max_error, shown - 1));
}

// A point verified as a scene of its own.
class VerifiedPoint {
public:
    VerifiedPoint(std::shared_ptr<const FirstOrderSystem> system, Scene scene, const Solution& solution)
        : scene_(std::move(scene)), trial_(std::move(system), scene_, solution, interpreted()),
          descent_(trial_, scene_, solution, result_), complaint_(start_scaling_complaint(scene_)) {}

    // All that is read off the scene.
    void plan() {
        const Rational eps = scene_.verify.eps.front();
        own_ = descent_.planned({eps});
        if (own_.empty()) return;
        std::vector<Rational> lower;
        for (const int part : parts_of_eps) lower.push_back(eps / Rational(part));
        try {
            lower_ = descent_.planned(lower);
        } catch (const Error&) { // the point's own error is told nevertheless
            lower_.clear();
        }
    }

    // Numbers alone.
    void measure() {
        descent_.measure(own_);
        try {
            descent_.measure(lower_);
        } catch (const Error&) {
            lower_.clear();
        }
        weigh_defects(result_);
    }

    // Both are NaN where there is none. Returns the status of the formula.
    Status tell(double* error, double* order) const {
        if (own_.empty()) return Status::outside_interval;
        Status status = Status::ok;
        for (std::size_t k = 0; k < result_.outputs.size(); ++k) {
            const OutputVerdict& output = result_.outputs[k];
            const LadderRung& rung = output.ladder.front();
            if (std::isfinite(rung.max_error))
                error[k] = known_part(rung);
            else
                status = rung.refused;
            const bool limit = output.found_order && std::isfinite(output.slope) && complaint_.empty();
            if (limit) order[k] = to_double(output.order(*output.found_order));
        }
        return status;
    }

    [[nodiscard]] std::optional<double> end() const {
        if (own_.empty()) return std::nullopt;
        return own_.front().at.interval;
    }

private:
    static VerifyOptions interpreted() {
        VerifyOptions options;
        options.compiled = false;
        return options;
    }

    Scene scene_;
    Trial trial_;
    Verification result_;
    Descent descent_;
    std::string complaint_;
    std::vector<PlannedRung> own_, lower_;
};

} // namespace

std::string equations_text(const Program& program, const Scene& scene) {
    std::string text = read_bytes(scene.system->file).value_or("") + scene.verify.interval_text;
    for (const std::string& note : program.notes) text += "\n" + note;
    for (const StartValue& start : scene.start) text += "\n" + start.name + " = " + start.text;
    for (const double value : parameter_values<double>(scene)) text += fmt::format("\n{:.15g}", value);
    return text;
}

SweepErrors::SweepErrors(std::shared_ptr<const Program> program, const Scene& scene, const Solution& solution,
                         std::shared_ptr<const FirstOrderSystem> system, const SweepGrid& grid)
    : program_(std::move(program)), formula_(std::make_shared<const Interpretation>(program_)), scene_(scene),
      solution_(solution), system_(std::move(system)), grid_(grid),
      place_(places_of_axes(grid, *program_, scene)), algebra_(std::make_shared<std::mutex>()) {
    std::vector<std::string> missing;
    const std::vector<Axis>& axes = grid.axes();
    for (const Parameter& p : scene.system->parameters)
        if (scene.fix.count(p.name) == 0 &&
            std::none_of(axes.begin(), axes.end(), [&](const Axis& axis) { return axis.name() == p.name; }))
            missing.push_back(p.name);
    if (!missing.empty()) not_fixed(scene, "verification needs a value for every parameter", missing);
    (void)Tape::rates(*system_);
}

// Of the formula, with the end of its interval.
Status SweepErrors::status_at_start(const GivenArguments& given, double& end) const {
    const long double eps = given.at("eps");
    const NodeNumbers* known = &formula_->numbers;
    auto arguments = program_arguments<long double>(*program_, eps, given, known);
    const auto interval = default_slow_time_end<long double>(*program_, eps, arguments.parameters, known);
    end = static_cast<double>(interval / eps);
    const Interpreter<long double> formula(formula_, eps, std::move(arguments.parameters),
                                           std::move(arguments.start), std::min(interval, eps));
    std::vector<long double> values;
    return formula.call(0, values);
}

// The arguments are doubles, which are exact numbers.
Scene SweepErrors::scene_at(const GivenArguments& given) const {
    Scene scene = scene_;
    const Rational eps = exact_rational(given.at("eps"));
    scene.verify.eps = {eps};
    scene.verify.eps_given = true;
    for (const auto& [name, number] : given) {
        if (name == "eps") continue;
        const GiNaC::numeric value = numeric(exact_rational(number));
        const auto is_it = [&, &canonical = name](const StartValue& s) {
            return canonical_start(s.name, *scene.system) == canonical;
        };
        const auto start = std::find_if(scene.start.begin(), scene.start.end(), is_it);
        const bool is_parameter =
            std::any_of(program_->parameters.begin(), program_->parameters.end(),
                        [&, &parameter = name](const ProgramInput& p) { return p.name == parameter; });
        if (is_parameter) {
            scene.fix[name] = value;
            continue;
        }
        const bool rests = rests_elsewhere(*scene.system, name);
        const int weight = rests ? 0 : start_weight(*scene.system, name);
        const GiNaC::ex down = GiNaC::pow(scene.system->eps / scene.system->small_at(eps), weight);
        if (start == scene.start.end())
            scene.start.push_back({name, value * down, "", {}});
        else
            start->value = value * down;
    }
    return scene;
}

Status SweepErrors::compute(std::uint64_t i, double* numbers) const {
    const std::size_t outputs = program_->outputs.size(), columns = 1 + outputs;
    std::fill_n(numbers, 2 * columns, std::numeric_limits<double>::quiet_NaN());
    const GivenArguments given = arguments_at(grid_, i, *program_, place_);
    Status status = status_at_start(given, numbers[0]);
    numbers[columns] = numbers[0];
    if (status != Status::ok && status != Status::low_precision) return status;
    const auto locked = [this](const auto& work) {
        const std::lock_guard lock(*algebra_);
        work();
    };
    std::unique_ptr<VerifiedPoint> point;
    try {
        locked([&] {
            point = std::make_unique<VerifiedPoint>(system_, scene_at(given), solution_);
            point->plan();
        });
        if (const std::optional<double> end = point->end(); end) numbers[0] = numbers[columns] = *end;
        point->measure();
        if (const Status later = point->tell(numbers + 1, numbers + columns + 1); later != Status::ok)
            status = later;
    } catch (const Error&) {
        status = Status::outside_domain;
    }
    locked([&] { point.reset(); });
    return status;
}

void SweepErrors::operator()(std::uint64_t first, std::uint64_t count, double* numbers,
                             unsigned char* status) const {
    const std::size_t of_point = 2 * (1 + program_->outputs.size());
    for (std::uint64_t i = 0; i < count; ++i) {
        const auto answer = static_cast<unsigned char>(compute(first + i, numbers + i * of_point));
        std::fill_n(status + 2 * i, 2, answer);
    }
}

} // namespace resonform
