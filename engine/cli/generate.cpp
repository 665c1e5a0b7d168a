// SPDX-License-Identifier: GPL-3.0-or-later
// resonform generate SCENE [-o FILE]: the C++ header of a scene, and the savings by pruning.
#include "cli/command.hpp"
#include "cli/limits.hpp"
#include "cli/locations.hpp"
#include "cli/output.hpp"
#include "cli/pipeline.hpp"
#include "cli/watch.hpp"
#include "emit/display/json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace resonform {

namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Program::Count& count) {
    return {{"add", count.add},      {"multiply", count.multiply}, {"divide", count.divide},
            {"root", count.root},    {"sincos", count.sincos},     {"other", count.other},
            {"tables", count.tables}};
}

std::string to_text(const Program::Count& c) {
    return fmt::format("{} add, {} multiply, {} divide, {} root, {} sincos, {} other, {} tables", c.add,
                       c.multiply, c.divide, c.root, c.sincos, c.other, c.tables);
}

struct GenerateRequest {
    std::string scene, output, format;
    bool inline_runtime = false;
    DerivationLimits limits;
};

struct Generated {
    SceneLine line;
    Header header;
};

Generated generate(const GenerateRequest& request) {
    const Home home = find_home();
    return watched(request.limits, [&](Watch& watch) {
        SceneLine line = solve_scene(request.scene, home, watch);
        Header header = header_of(line, watch, request.inline_runtime);
        return Generated{std::move(line), std::move(header)};
    });
}

int run_generate(const GenerateRequest& request) {
    const auto [line, made] = generate(request);
    const auto& [program, header] = made;
    require_other_file(request.output, {line.scene.file, line.scene.system->file});
    if (!request.output.empty()) write_file(request.output, header);
    if (request.format == "json") {
        Json document{
            {"schema", "resonform.generation/1"},
            {"system", program.system},
            {"scene", program.scene},
            {"order", json_rational(program.weight(program.order))},
            {"truncation", json_rational(program.weight(program.truncation))},
            {"operations_before", to_json(program.before)},
            {"operations_after", to_json(program.after)},
            {"form", program.form()},
            {"operations_by_form",
             {{"tables", nullptr}, {"atoms", nullptr}, {"direct", program.operations_by_form.direct}}},
            {"bytes", header.size()}};
        if (const auto tables = program.operations_by_form.tables)
            document["operations_by_form"]["tables"] = *tables;
        if (const auto atoms = program.operations_by_form.atoms)
            document["operations_by_form"]["atoms"] = *atoms;
        if (request.output.empty())
            document["header"] = header;
        else
            document["file"] = request.output;
        put("{}", document_text(document));
        return done;
    }
    if (request.output.empty()) put("{}", header);
    say(fmt::format("{}/{}: order {}, truncation {} ({})", program.system, program.scene,
                    to_string(program.weight(program.order)), to_string(program.weight(program.truncation)),
                    line.count.reason));
    say(fmt::format("operations per call before pruning: {}", to_text(program.before)));
    say(fmt::format("operations per call after pruning:  {}", to_text(program.after)));
    return done;
}

} // namespace

void add_generate(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("generate", "the C++ header that evaluates a scene");
    const Text scene = add_required(*command, "SCENE", "", scene_help);
    const Text output =
        add_output(*command, "-o,--output", "FILE", "write the header here instead of to standard output");
    const auto inline_runtime = std::make_shared<bool>(false);
    command->add_flag("--inline-runtime", *inline_runtime,
                      "copy the runtime into the header: it includes nothing of ours");
    const FormatOption format(*command, {"text", "json"});
    const LimitOptions limits(*command);
    on_choice(*command, action, [=] {
        const std::string file = *output == "-" ? "" : *output; // "-" usually means standard output
        return run_generate({*scene, file, format.value(), *inline_runtime, limits.value()});
    });
}

} // namespace resonform
