// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/stability/points.hpp"

#include "algebra/number/number.hpp"
#include "verify/evaluate/interpreter.hpp"
#include "verify/evaluate/scene_values.hpp"
#include "verify/integrate/tape.hpp"
#include "verify/judging/start_scaling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

namespace resonform {

namespace {

constexpr double default_eps = 0.01;
constexpr double corner_probability = 0.4;
constexpr int most_draws = 60, most_ways_out = 6;
constexpr double edge_decades = 6;
constexpr double parameter_decades = 1e12, largest_start = 1e3, smallest_start = 1e-12;
constexpr double largest_phase = 1e12;

// All inputs as one vector: eps, parameters, start.
using Inputs = std::vector<double>;
using Inside = std::function<bool(const SweepPoint&)>;

// Where start values rest at eps = 0: 0, or by [equilibrium].
class Rests {
public:
    Rests(const Program& program, const Scene& scene)
        : program_(program), system_(*scene.system), fixed_(parameter_values<double>(scene)) {
        std::vector<GiNaC::symbol> slow;
        for (const Variable& v : system_.variables) {
            if (v.role != Role::slow) continue;
            slow.push_back(GiNaC::ex_to<GiNaC::symbol>(v.jet.front()));
            const auto own =
                std::find_if(program.start.begin(), program.start.end(),
                             [&](const ProgramInput& input) { return input.canonical == v.name; });
            slow_.push_back(static_cast<std::size_t>(own - program.start.begin()));
        }
        std::vector<GiNaC::ex> values;
        for (std::size_t k = 0; k < program.start.size(); ++k)
            if (rests_elsewhere(system_, program.start[k].canonical)) {
                resting_.push_back(k);
                values.push_back(rest_of(system_, program.start[k].canonical, {}));
            }
        if (!resting_.empty()) tape_ = Tape::of(system_, slow, values);
    }

    // Of a point whose slow variables are known.
    [[nodiscard]] std::vector<double> at(const SweepPoint& point) const {
        const std::vector<double>& start = point.start;
        std::vector<double> rests(start.size(), 0.0);
        if (resting_.empty()) return rests;
        std::vector<double> slow, values(resting_.size());
        for (const std::size_t k : slow_) slow.push_back(k < start.size() ? start[k] : 0);
        const std::vector<double> parameters = with_parameters_of(point, program_, system_, fixed_);
        BoundTape<double>(*tape_, parameters, point.eps).evaluate(slow.data(), values.data());
        for (std::size_t k = 0; k < resting_.size(); ++k) rests[resting_[k]] = values[k];
        return rests;
    }

private:
    const Program& program_;
    const System& system_;
    std::vector<double> fixed_;
    std::vector<std::size_t> slow_, resting_; // places of start values
    std::optional<Tape> tape_;
};

// Start values are distances from where they rest.
SweepPoint unpack(const Program& program, const Rests& rests, const Inputs& inputs) {
    const auto parameters = inputs.begin() + 1,
               start = parameters + static_cast<long>(program.parameters.size());
    SweepPoint point{inputs.front(), {parameters, start}, {start, inputs.end()}, {start, inputs.end()}};
    const std::vector<double> rest = rests.at(point);
    for (std::size_t k = 0; k < rest.size(); ++k) point.start[k] += rest[k];
    return point;
}

Inputs defaults(const Program& program, const Rests& rests, double eps) {
    Inputs inputs{eps};
    std::vector<double> parameters = default_parameters<double>(program, eps);
    for (double& p : parameters)
        if (std::isnan(p)) p = 1; // the scene gives none
    std::vector<double> start = default_start<double>(program, eps, parameters);
    const std::vector<double> rest = rests.at({eps, parameters, start});
    for (std::size_t k = 0; k < rest.size(); ++k) start[k] -= rest[k];
    inputs.insert(inputs.end(), parameters.begin(), parameters.end());
    inputs.insert(inputs.end(), start.begin(), start.end());
    return inputs;
}

class Draws {
public:
    Draws(const Program& program, const Scene& scene, std::uint64_t seed, const Inside& inside)
        : program_(program), rests_(program, scene), inputs_(swept_inputs(program, *scene.system)),
          random_(seed), inside_(inside) {}

    [[nodiscard]] SweepPoint point(const Inputs& inputs) const { return unpack(program_, rests_, inputs); }
    [[nodiscard]] Inputs of_scene() const { return defaults(program_, rests_, default_eps); }

    Inputs one_corner() {
        const std::size_t round = corners_ / (2 * inputs_.size());
        const std::size_t i = corners_ / 2 % inputs_.size(), which = 2 * round + corners_ % 2;
        ++corners_;
        const double value = corner(inputs_[i], default_eps, which % corners(inputs_[i]).size());
        if (i == 0) return defaults(program_, rests_, value);
        Inputs inputs = of_scene();
        inputs[i] = value;
        return inputs;
    }

    Inputs all() {
        Inputs inputs(inputs_.size());
        for (std::size_t i = 0; i < inputs_.size(); ++i)
            inputs[i] = uniform() < corner_probability
                            ? corner(inputs_[i], inputs.front(), below(usual_corners(inputs_[i])))
                            : anywhere(inputs_[i], inputs.front());
        return inputs;
    }

    // All drawn, then one of them moved close to where the domain ends, if there is a way out.
    Inputs near_edge() {
        Inputs within = all();
        if (inputs_.size() == 1 || !inside_(point(within))) return within;
        for (int n = 0; n < most_ways_out; ++n) {
            const std::size_t i = 1 + below(inputs_.size() - 1);
            Inputs beyond = within;
            beyond[i] = anywhere(inputs_[i], within.front());
            if (inside_(point(beyond))) continue;
            const double begin = within[i], way = edge(within, i, beyond[i]) - begin;
            within[i] = begin + way * (1 - std::pow(10, -edge_decades * uniform()));
            break;
        }
        return within;
    }

private:
    // The last value of an input inside on the way to one outside.
    double edge(Inputs at, std::size_t i, double outside) const {
        double last = at[i];
        for (int halvings = 0; halvings < std::numeric_limits<double>::digits; ++halvings) {
            at[i] = last + (outside - last) / 2;
            (inside_(point(at)) ? last : outside) = at[i];
        }
        return last;
    }
    double uniform() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
    std::size_t below(std::size_t n) {
        return std::min(n - 1, static_cast<std::size_t>(uniform() * static_cast<double>(n)));
    }
    double signed_value(const SweptInput& input, double eps, double size) {
        const bool turned = input.negative && uniform() < 0.5;
        return (turned ? -1 : 1) * size * std::pow(eps, to_double(input.weight));
    }
    struct Sizes {
        double from, to;
    };
    static std::vector<Sizes> corners(const SweptInput& input) {
        const double middle = std::sqrt(input.low) * std::sqrt(input.high);
        std::vector<Sizes> sizes{{input.high, input.high}, {input.low, input.low}, {middle, middle}};
        if (input.zero) sizes.push_back({0, 0});
        if (input.extreme > 0) sizes.push_back({input.extreme, input.extreme});
        if (input.subnormal > 0) sizes.push_back({input.subnormal, input.subnormal});
        if (input.judged > 0) {
            sizes.push_back({input.high, input.judged});
            sizes.push_back({input.judged, input.extreme});
        }
        return sizes;
    }
    // Without those that are drawn: beside a parameter of 1e-12 the exact solution would lose its digits.
    static std::size_t usual_corners(const SweptInput& input) {
        return corners(input).size() - (input.judged > 0 ? 2 : 0);
    }
    double corner(const SweptInput& input, double eps, std::size_t which) {
        return anywhere(input, corners(input)[which], eps);
    }
    double anywhere(const SweptInput& input, double eps) {
        return anywhere(input, {input.low, input.high}, eps);
    }
    double anywhere(const SweptInput& input, const Sizes& sizes, double eps) {
        if (sizes.to == 0) return 0;
        const bool one = sizes.from == sizes.to;
        return signed_value(input, eps,
                            one ? sizes.to : sizes.from * std::pow(sizes.to / sizes.from, uniform()));
    }

    const Program& program_;
    Rests rests_;
    std::vector<SweptInput> inputs_;
    std::mt19937_64 random_;
    std::size_t corners_ = 0; // drawn so far
    const Inside& inside_;
};

SweptInput of_parameter(const ProgramInput& input, const System& system) {
    const auto named = [&](const Parameter& p) { return input.meaning == "parameter " + p.name; };
    const auto found = std::find_if(system.parameters.begin(), system.parameters.end(), named);
    const bool positive = found != system.parameters.end() && found->positive;
    return {input.name, 1 / parameter_decades, parameter_decades, !positive};
}

SweptInput of_start(const ProgramInput& input, const System& system) {
    const Variable* variable = system.variable(input.canonical);
    const bool slow = variable != nullptr && variable->role == Role::slow;
    const bool phase = input.canonical.compare(0, 6, "phase.") == 0;
    return {input.name,
            smallest_start,
            phase ? largest_phase : largest_start,
            !(slow && variable->positive),
            !(slow && (variable->positive || variable->nonzero)),
            system.weight(start_weight(system, input.canonical)),
            rests_elsewhere(system, input.canonical),
            slow    ? extreme_slow
            : phase ? extreme_phase
                    : 0,
            slow ? judged_slow : 0,
            slow ? subnormal_slow : 0};
}

} // namespace

std::vector<SweptInput> swept_inputs(const Program& program, const System& system) {
    std::vector<SweptInput> inputs{{"eps", smallest_eps, largest_eps}};
    for (const ProgramInput& input : program.parameters) inputs.push_back(of_parameter(input, system));
    for (const ProgramInput& input : program.start) inputs.push_back(of_start(input, system));
    return inputs;
}

double decades(const SweptInput& input) {
    return input.high > input.low ? std::log10(input.high / input.low) : 0;
}

std::vector<SweptInput> reachable_inputs(const Program& program, const Scene& scene, const Inside& inside) {
    const Rests rests(program, scene);
    const Inputs of_scene = defaults(program, rests, default_eps);
    const double step = std::sqrt(10.0);
    std::vector<SweptInput> inputs = swept_inputs(program, *scene.system);
    for (std::size_t i = 1; i < inputs.size(); ++i) {
        SweptInput& input = inputs[i];
        const auto reaches = [&](double size) {
            Inputs at = of_scene;
            at[i] = size * std::pow(default_eps, to_double(input.weight));
            if (inside(unpack(program, rests, at))) return true;
            at[i] = -at[i];
            return input.negative && inside(unpack(program, rests, at));
        };
        while (input.low < input.high && !reaches(input.low)) input.low *= step;
        while (input.low < input.high && !reaches(input.high)) input.high /= step;
    }
    return inputs;
}

bool is_far_beyond(const SweepPoint& point, const std::vector<SweptInput>& inputs) {
    const std::vector<double> values = as_swept(point, inputs);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double size = std::abs(values[i]);
        const double judged = inputs[i].judged > 0 ? inputs[i].judged : 10 * inputs[i].high;
        if (inputs[i].extreme > 0 && size > judged) return true;
        if (inputs[i].subnormal > 0 && size != 0 && size < std::numeric_limits<double>::min()) return true;
    }
    return false;
}

std::vector<SweptInput> nothing_swept(std::vector<SweptInput> inputs) {
    for (SweptInput& input : inputs) {
        input.low = std::numeric_limits<double>::infinity();
        input.high = 0;
        input.negative = input.zero = false;
    }
    return inputs;
}

std::vector<double> as_swept(const SweepPoint& point, const std::vector<SweptInput>& inputs) {
    Inputs values{point.eps};
    values.insert(values.end(), point.parameters.begin(), point.parameters.end());
    values.insert(values.end(), point.distance.begin(), point.distance.end());
    for (std::size_t i = 0; i < values.size(); ++i)
        if (inputs[i].weight != 0) values[i] /= std::pow(point.eps, to_double(inputs[i].weight));
    return values;
}

void add(const SweepPoint& point, std::vector<SweptInput>& swept) {
    const std::vector<double> values = as_swept(point, swept);
    for (std::size_t i = 0; i < values.size(); ++i) {
        SweptInput& input = swept[i];
        if (values[i] == 0) {
            input.zero = true;
            continue;
        }
        const double size = std::abs(values[i]);
        input.low = std::min(input.low, size);
        input.high = std::max(input.high, size);
        if (values[i] < 0) input.negative = true;
    }
}

std::vector<SweepPoint> sweep_points(const Program& program, const Scene& scene, std::size_t count,
                                     std::uint64_t seed, const Inside& inside) {
    Draws draws(program, scene, seed, inside);
    std::vector<SweepPoint> points;
    while (points.size() < count) {
        if (points.empty()) {
            points.push_back(draws.point(draws.of_scene()));
            continue;
        }
        const bool corner = points.size() % 2 == 1, edge = points.size() % 4 == 2;
        SweepPoint drawn;
        for (int n = 0; n < most_draws; ++n) {
            drawn = draws.point(corner ? draws.one_corner() : edge ? draws.near_edge() : draws.all());
            if (inside(drawn) && std::find(points.begin(), points.end(), drawn) == points.end()) break;
        }
        points.push_back(std::move(drawn));
    }
    return points;
}

} // namespace resonform
