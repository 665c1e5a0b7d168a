// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/stability_points.hpp"

#include "emit/identifier.hpp"
#include "verify/interpreter.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace resonform {

namespace {

constexpr double default_eps = 0.01;
constexpr double corner_probability = 0.4;

struct Range {
    double low, high; // of the magnitude
    bool both_signs;
};

Range range(InputKind kind) {
    switch (kind) {
    case InputKind::eps: return {smallest_eps, largest_eps, false};
    case InputKind::positive: return {1e-12, 1e12, false};
    case InputKind::real: return {1e-12, 1e12, true};
    case InputKind::amplitude: return {1e-12, 1e3, true};
    case InputKind::slow: return {1e-150, 1e150, true};
    case InputKind::phase: return {1e-3, 1e14, true};
    }
    return {1, 1, false};
}

// All inputs as one vector: eps, parameters, start.
using Inputs = std::vector<double>;

SweepPoint unpack(const Program& program, const Inputs& inputs) {
    const auto parameters = inputs.begin() + 1,
               start = parameters + static_cast<long>(program.parameters.size());
    return {inputs.front(), {parameters, start}, {start, inputs.end()}};
}

Inputs defaults(const Program& program) {
    Inputs inputs{default_eps};
    std::vector<double> parameters = default_parameters<double>(program, default_eps);
    for (double& p : parameters)
        if (std::isnan(p)) p = 1; // the scene gives none
    const std::vector<double> start = default_start<double>(program, default_eps, parameters);
    inputs.insert(inputs.end(), parameters.begin(), parameters.end());
    inputs.insert(inputs.end(), start.begin(), start.end());
    return inputs;
}

class Dice {
public:
    explicit Dice(std::uint64_t seed) : random_(seed) {}

    double value(InputKind kind) {
        if (uniform() < corner_probability) {
            const std::vector<double> list = corners(kind);
            return list[std::min(list.size() - 1,
                                 static_cast<std::size_t>(uniform() * static_cast<double>(list.size())))];
        }
        const Range r = range(kind);
        const double size = r.low * std::pow(r.high / r.low, uniform());
        return r.both_signs && uniform() < 0.5 ? -size : size;
    }
    double uniform() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

private:
    std::mt19937_64 random_;
};

} // namespace

std::vector<double> corners(InputKind kind) {
    const Range r = range(kind);
    switch (kind) {
    case InputKind::eps: return {r.low, 1e-6, 1e-3, 0.1, r.high};
    case InputKind::positive: return {r.low, 1, r.high};
    case InputKind::real:
    case InputKind::amplitude: return {-r.high, -1, r.low, 1, r.high};
    case InputKind::slow: return {0, -r.high, -1, -r.low, r.low, 1, r.high};
    case InputKind::phase: return {0, -r.high, 1, r.high};
    }
    return {};
}

namespace {

InputKind start_kind(const ProgramInput& input, const Program& program, const System& system) {
    for (const ProgramOutput& slow : program.slow)
        if (input.name == identifier(slow.name + "_0")) return InputKind::slow;
    for (const Variable& variable : system.variables) {
        if (input.name == identifier(system.constant_name("phase", variable.name))) return InputKind::phase;
        if (input.name == identifier(system.constant_name("amplitude", variable.name)))
            return InputKind::amplitude;
    }
    return InputKind::real;
}

} // namespace

std::vector<InputKind> input_kinds(const Program& program, const System& system) {
    std::vector<InputKind> kinds{InputKind::eps};
    for (const ProgramInput& input : program.parameters) {
        const auto named = [&](const Parameter& p) { return input.meaning == "parameter " + p.name; };
        const auto found = std::find_if(system.parameters.begin(), system.parameters.end(), named);
        const bool positive = found != system.parameters.end() && found->positive;
        kinds.push_back(positive ? InputKind::positive : InputKind::real);
    }
    for (const ProgramInput& input : program.start) kinds.push_back(start_kind(input, program, system));
    return kinds;
}

std::vector<SweepPoint> sweep_points(const Program& program, const System& system, std::size_t random_points,
                                     std::uint64_t seed) {
    const std::vector<InputKind> kinds = input_kinds(program, system);
    const Inputs base = defaults(program);
    std::vector<SweepPoint> points{unpack(program, base)};
    for (std::size_t i = 0; i < kinds.size(); ++i)
        for (const double first : corners(kinds[i])) {
            Inputs inputs = base;
            inputs[i] = first;
            points.push_back(unpack(program, inputs));
        }
    Dice dice(seed);
    for (std::size_t n = 0; n < random_points; ++n) {
        Inputs inputs = base;
        for (std::size_t i = 0; i < kinds.size(); ++i) inputs[i] = dice.value(kinds[i]);
        points.push_back(unpack(program, inputs));
    }
    return points;
}

} // namespace resonform
