// SPDX-License-Identifier: GPL-3.0-or-later
// resonform evaluate SCENE --eps E --t T1,T2,...: numbers without writing a program.
#include "algebra/number/number.hpp"
#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/limits.hpp"
#include "cli/locations.hpp"
#include "cli/output.hpp"
#include "cli/pipeline.hpp"
#include "cli/watch.hpp"
#include "model/files/interval_length.hpp"
#include "model/system/scene_file.hpp"
#include "verify/evaluate/interpreter.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <set>

namespace resonform {

namespace {

using Json = nlohmann::ordered_json;

struct Values {
    double eps = 0;
    std::vector<double> t;
    std::vector<std::vector<double>> points; // [point][output]
    std::vector<Status> status;
    std::vector<std::string> why; // "" where nothing is behind the status
};

void require_values(const Program& program, const Scene& scene) {
    if (program.parameters.empty()) return; // those that [fix] gives are folded in
    std::vector<std::string> missing;
    for (const ProgramInput& parameter : program.parameters) missing.push_back(parameter.name);
    not_fixed(scene, "evaluation needs a value for every parameter that the outputs depend on", missing);
}

Values evaluate_program(const std::shared_ptr<const Program>& program, double eps, std::vector<double> t) {
    // A time such as 1/eps may round to just beyond the interval that the scene asks for.
    const double end =
        default_slow_time_end<double>(*program, eps, {}) * (1 + 4 * std::numeric_limits<double>::epsilon());
    const Interpreter<double> evaluator(program, eps, {}, {}, end);
    Values values{eps, std::move(t), {}, {}, {}};
    for (const double time : values.t) {
        std::vector<double> outputs(program->outputs.size());
        values.status.push_back(evaluator.call(time, outputs));
        values.why.emplace_back(evaluator.why(values.status.back()));
        values.points.push_back(std::move(outputs));
    }
    return values;
}

bool has_numbers(Status status) { return status == Status::ok || status == Status::low_precision; }

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
    const Json document{{"schema", "resonform.values/1"},
                        {"system", program.system},
                        {"scene", program.scene},
                        {"eps", values.eps},
                        {"t", values.t},
                        {"outputs", outputs},
                        {"status", status},
                        {"why", why}};
    put("{}", document_text(document));
}

void print_csv(const Program& program, const Values& values) {
    put("t");
    for (const ProgramOutput& output : program.outputs) put(",{}", output.name);
    put(",status\n");
    for (std::size_t i = 0; i < values.t.size(); ++i) {
        put("{:.17g}", values.t[i]);
        for (const double value : values.points[i])
            put(",{}", has_numbers(values.status[i]) ? fmt::format("{:.17g}", value) : "");
        put(",{}\n", to_string(values.status[i]));
    }
    std::set<std::string> causes;
    for (std::size_t i = 0; i < values.t.size(); ++i)
        if (!values.why[i].empty())
            causes.insert(fmt::format("resonform: {}: {}", to_string(values.status[i]), values.why[i]));
    for (const std::string& cause : causes) say(cause);
}

int run_evaluate(const std::string& scene, const std::string& eps_text, const std::string& times,
                 const DerivationLimits& limits, const std::string& format) {
    const Rational asked = read_eps(eps_text);
    const double eps = to_double(asked);
    std::vector<double> t = read_times(times);
    const Home home = find_home();
    const auto program = watched(limits, [&](Watch& watch) {
        const SceneLine line = solve_scene(scene, home, watch);
        auto built = std::make_shared<const Program>(program_of(line, watch));
        require_values(*built, line.scene);
        (void)bounded_interval_length(line.scene, asked);
        return built;
    });
    const Values values = evaluate_program(program, eps, std::move(t));
    if (format == "json")
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
    const FormatOption format(*command, {"csv", "json"});
    const LimitOptions limits(*command);
    on_choice(*command, action,
              [=] { return run_evaluate(*scene, *eps, *times, limits.value(), format.value()); });
}

} // namespace resonform
