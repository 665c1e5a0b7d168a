// SPDX-License-Identifier: GPL-3.0-or-later
// resonform evaluate SCENE --eps E --t T1,T2,... [--errors]: numbers without writing a program.
#include "algebra/number/number.hpp"
#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/limits.hpp"
#include "cli/locations.hpp"
#include "cli/output.hpp"
#include "cli/pipeline.hpp"
#include "cli/watch.hpp"
#include "emit/display/json.hpp"
#include "model/files/interval_length.hpp"
#include "model/system/scene_file.hpp"
#include "verify/estimate/error_estimator.hpp"
#include "verify/evaluate/interpretation.hpp"
#include "verify/evaluate/interpreter.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <set>

namespace resonform {

namespace {

using Json = nlohmann::ordered_json;

struct Values {
    double eps = 0;
    std::vector<double> t;
    std::vector<std::vector<double>> points; // [point][output]
    std::vector<Status> status;
    std::vector<std::string> why;                           // "" where nothing is behind the status
    std::optional<std::vector<std::vector<double>>> errors; // [output][point], estimated; NaN: none
};

struct EvaluateRequest {
    std::string scene, eps, times;
    bool errors;
    DerivationLimits limits;
    std::string format;
};

void require_values(const Program& program, const Scene& scene) {
    if (program.parameters.empty()) return; // those that [fix] gives are folded in
    std::vector<std::string> missing;
    for (const ProgramInput& parameter : program.parameters) missing.push_back(parameter.name);
    not_fixed(scene, "evaluation needs a value for every parameter that the outputs depend on", missing);
}

// A time such as 1/eps may round to just beyond the interval that the scene asks for.
double slow_time_end(const Program& program, double eps) {
    return default_slow_time_end<double>(program, eps, {}) * (1 + 4 * std::numeric_limits<double>::epsilon());
}

Values evaluate_program(const std::shared_ptr<const Program>& program, double eps, std::vector<double> t) {
    const Interpreter<double> evaluator(program, eps, {}, {}, slow_time_end(*program, eps));
    Values values{eps, std::move(t), {}, {}, {}, {}};
    for (const double time : values.t) {
        std::vector<double> outputs(program->outputs.size());
        values.status.push_back(evaluator.call(time, outputs));
        values.why.emplace_back(evaluator.why(values.status.back()));
        values.points.push_back(std::move(outputs));
    }
    return values;
}

// |map + flow| of each output; what has none is said on standard error, once.
std::vector<std::vector<double>> estimated_errors(const ErrorEstimator& estimator, double eps, double end,
                                                  const std::vector<double>& t) {
    const ErrorParts parts = estimator.parts<long double>(eps, end, t);
    std::vector<std::vector<double>> errors(parts.map.size());
    for (std::size_t k = 0; k < errors.size(); ++k) {
        const ErrorEstimator::Output& output = estimator.outputs()[k];
        if (output.next_order == 0)
            say(fmt::format("resonform: no estimated error of {}: {}", output.name, output.reason));
        for (std::size_t i = 0; i < t.size(); ++i)
            errors[k].push_back(output.next_order > 0 ? std::abs(parts.map[k][i] + parts.flow[k][i])
                                                      : std::numeric_limits<double>::quiet_NaN());
    }
    return errors;
}

void print_json(const Program& program, const Values& values) {
    Json outputs = Json::object(), status = Json::array(), why = Json::array();
    for (std::size_t k = 0; k < program.outputs.size(); ++k) {
        Json column = Json::array();
        for (std::size_t i = 0; i < values.t.size(); ++i)
            column.push_back(has_numbers(values.status[i]) ? Json(values.points[i][k]) : Json(nullptr));
        outputs[program.outputs[k].name] = std::move(column);
    }
    for (const Status s : values.status) status.push_back(to_string(s));
    for (const std::string& w : values.why) why.push_back(w.empty() ? Json(nullptr) : Json(w));
    Json document{{"schema", "resonform.values/1"},
                  {"system", program.system},
                  {"scene", program.scene},
                  {"eps", values.eps},
                  {"t", values.t},
                  {"outputs", outputs},
                  {"status", status},
                  {"why", why}};
    for (std::size_t k = 0; values.errors && k < program.outputs.size(); ++k)
        document["error_estimate"][program.outputs[k].name] = json_numbers((*values.errors)[k]);
    put("{}", document_text(document));
}

// "low_precision: chi_2 (z2 of y)", each once.
void say_causes(const Program& program, const Values& values) {
    std::set<std::string> causes;
    for (std::size_t i = 0; i < values.t.size(); ++i) {
        const std::string& why = values.why[i];
        if (why.empty()) continue;
        const auto phase =
            std::find_if(program.phases.begin(), program.phases.end(),
                         [&](const ProgramPhase& p) { return p.name == why && !p.of.empty(); });
        const std::string of = phase == program.phases.end() ? "" : " (" + phase->of + ")";
        causes.insert(fmt::format("resonform: {}: {}{}", to_string(values.status[i]), why, of));
    }
    for (const std::string& cause : causes) say(cause);
}

void print_csv(const Program& program, const Values& values) {
    put("t");
    for (const ProgramOutput& output : program.outputs) put(",{}", output.name);
    put(",status");
    for (const ProgramOutput& output : program.outputs)
        if (values.errors) put(",error_{}", output.name);
    put("\n");
    for (std::size_t i = 0; i < values.t.size(); ++i) {
        put("{:.17g}", values.t[i]);
        for (const double value : values.points[i])
            put(",{}", has_numbers(values.status[i]) ? fmt::format("{:.17g}", value) : "");
        put(",{}", to_string(values.status[i]));
        for (std::size_t k = 0; values.errors && k < program.outputs.size(); ++k) {
            const double error = (*values.errors)[k][i];
            put(",{}", std::isfinite(error) ? fmt::format("{:.3g}", error) : "");
        }
        put("\n");
    }
    say_causes(program, values);
}

int run_evaluate(const EvaluateRequest& request) {
    const Rational asked = read_eps(request.eps);
    const double eps = to_double(asked);
    std::vector<double> t = read_times(request.times);
    const Home home = find_home();
    std::optional<ErrorEstimator> estimator;
    const auto program = watched(request.limits, [&](Watch& watch) {
        const SceneLine line = solve_scene(read_scene_with_values(request.scene, home), watch);
        auto built = std::make_shared<const Program>(program_of(line, watch));
        require_values(*built, line.scene);
        (void)bounded_interval_length(line.scene, asked);
        if (request.errors) estimator.emplace(line.scene, line.solution, deriving_under(watch));
        return built;
    });
    Values values = evaluate_program(program, eps, std::move(t));
    if (estimator) values.errors = estimated_errors(*estimator, eps, slow_time_end(*program, eps), values.t);
    if (request.format == "json")
        print_json(*program, values);
    else
        print_csv(*program, values);
    return done;
}

} // namespace

void add_evaluate(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("evaluate", "the outputs of a scene at given times");
    const Text scene = add_required(*command, "SCENE", "", scene_help);
    const Text eps = add_required(*command, "--eps", "NUMBER",
                                  "the small parameter, 1e-12 ... 0.5, such as 0.01 or 1/100");
    const Text times = add_required(*command, "--t", "T1,T2,...", "times, separated by commas");
    const auto errors = std::make_shared<bool>(false);
    command->add_flag("--errors", *errors,
                      "estimate the error of each output, too, from the next weight of the normal form");
    const FormatOption format(*command, {"csv", "json"});
    const LimitOptions limits(*command);
    on_choice(*command, action, [=] {
        return run_evaluate({*scene, *eps, *times, *errors, limits.value(), format.value()});
    });
}

} // namespace resonform
