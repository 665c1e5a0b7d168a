// SPDX-License-Identifier: GPL-3.0-or-later
// resonform sweep SCENE --over NAME=LO:HI:N ... --output F.npy: a scene over a grid or a sample of its
// arguments, in blocks that outlive a kill.
#include "algebra/number/error.hpp"
#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/limits.hpp"
#include "cli/locations.hpp"
#include "cli/output.hpp"
#include "cli/pipeline.hpp"
#include "cli/sweep_request.hpp"
#include "cli/sweep_team.hpp"
#include "cli/watch.hpp"
#include "emit/cpp/cpp.hpp"
#include "emit/program/build_program.hpp"
#include "verify/run/cache.hpp"
#include "verify/sweep/arguments.hpp"
#include "verify/sweep/compute.hpp"
#include "verify/sweep/errors.hpp"
#include "verify/sweep/map.hpp"
#include "verify/sweep/result.hpp"
#include "verify/sweep/size.hpp"
#include "verify/sweep/stability.hpp"
#include "verify/sweep/subject.hpp"
#include "verify/sweep/validity.hpp"
#include "verify/sweep/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <thread>
#include <utility>

namespace resonform {

namespace {

// Everything that is written and read back by the names that follow from --output.
struct Sweep {
    SweepFiles files;
    Json description; // subject_json
    SweepSubject subject;
    SweepGrid grid;
    SweepSize size;
};

Sweep sweep_of(SweepFiles files, SweepSubject subject, SweepGrid grid) {
    Json description = subject_json(subject, grid);
    const SweepSize size =
        size_of_sweep(grid.points(), subject.rows(), subject.columns(), cost_of_point(subject.what));
    return {std::move(files), std::move(description), std::move(subject), std::move(grid), size};
}

std::string counted(std::uint64_t n, const std::string& thing) {
    return fmt::format("{} {}{}", n, thing, n == 1 ? "" : "s");
}

std::string told(const Sweep& sweep, const SweepTotals& totals, bool written) {
    std::string text = fmt::format("sweep of {}/{}\n\n", sweep.subject.system, sweep.subject.scene);
    text += fmt::format("points   {}, {} each\n", sweep.grid.points(),
                        counted(sweep.subject.rows() * sweep.subject.outputs.size(), "number"));
    text += fmt::format("done     {}\n", totals.done);
    for (const auto& [status, count] : totals.statuses)
        text += fmt::format("         {} {}\n", count, to_string(static_cast<Status>(status)));
    if (written)
        text += fmt::format("\nwritten: {}, {}\n", sweep.files.output.string(), sweep.files.json.string());
    return text;
}

// Writes F.json and prints the totals; writes the output, too, once all blocks are there.
SweepTotals finish(const Sweep& sweep, const SweepFolder& folder, bool whole, const std::string& format) {
    SweepTotals totals = whole
                             ? write_result(sweep.files.output, folder, sweep.subject, sweep.grid, sweep.size)
                             : read_blocks(folder, sweep.size, [](std::uint64_t, const SweepBlock&) {});
    const std::string document =
        document_text(sweep_json(sweep.description, sweep.subject, sweep.grid, totals));
    write_file(sweep.files.json, document);
    if (whole && totals.blocks < sweep.size.blocks()) return totals;
    put("{}", format == "json" ? document : told(sweep, totals, whole));
    return totals;
}

SweepSubject subject_asked(const SweepRequest& request, const SceneLine& line, const Program& program) {
    std::string code = emit_library(program, "e");
    // what the formula leaves out counts as well
    if (request.what == SweepKind::verify || request.what == SweepKind::validity)
        code += equations_text(program, line.scene);
    return {request.what,
            request.tolerance,
            program.system,
            program.scene,
            content_hash(code),
            request.over,
            request.sample,
            request.times,
            line.scene.verify.interval_text,
            line.scene.outputs,
            request.files.output.extension().string()};
}

// What is derived of the scene.
struct Derived {
    SceneLine line;
    std::shared_ptr<const Program> program;
    std::shared_ptr<const ErrorEstimator> estimator; // of validity
};

Derived derive(const SweepRequest& request, Scene scene, const SweepGrid& grid) {
    std::vector<std::string> given;
    for (const Axis& axis : grid.axes()) given.push_back(axis.name());
    return watched(request.limits, [&](Watch& watch) {
        Derived derived;
        derived.line = solve_scene(std::move(scene), watch);
        const auto& [fixed, expanded, count, solution] = derived.line;
        derived.program = std::make_shared<const Program>(build_program(solution, fixed));
        if (request.what == SweepKind::validity)
            derived.estimator =
                std::make_shared<const ErrorEstimator>(fixed, solution, deriving_under(watch), given);
        return derived;
    });
}

void say_what_has_no_estimate(const ErrorEstimator& estimator) {
    for (const ErrorEstimator::Output& output : estimator.outputs())
        if (output.next_order == 0)
            say(fmt::format("resonform: no estimated error of {}: {}", output.name, output.reason));
}

ComputePoints computation(const SweepRequest& request, const Derived& derived, const SweepGrid& grid,
                          const CacheFolder& cache) {
    const auto& [scene, expanded, count, solution] = derived.line;
    return of_argument(
        "--over", [&, &scene = scene, &expanded = expanded, &solution = solution]() -> ComputePoints {
            switch (request.what) {
            case SweepKind::values: break;
            case SweepKind::verify:
                return SweepErrors(derived.program, scene, solution, expanded.first_order, grid);
            case SweepKind::validity:
                say_what_has_no_estimate(*derived.estimator);
                return SweepValidity(derived.program, scene, grid, derived.estimator, request.tolerance);
            case SweepKind::stability:
                return SweepStability(derived.program, scene, solution, grid,
                                      EvaluatorLibrary::build(*derived.program, cache.path(), show_progress));
            }
            return SweepValues(derived.program, scene, grid, request.times, cache.path(), show_progress);
        });
}

// resonform links no MPI: each rank would compute all of it.
void refuse_mpirun() {
    const char* ranks =
        std::getenv("OMPI_COMM_WORLD_SIZE"); // NOLINT(concurrency-mt-unsafe): nobody sets it here
    if (ranks == nullptr || std::string_view(ranks) == "1") return;
    bad_input(Reason::command_line, {"a sweep by the ranks of mpirun needs the program that is made for it",
                                     fmt::format("resonform on {} ranks", ranks),
                                     "write mpirun -n 4 resonform_mpi sweep ...",
                                     {}});
}

// What std::thread says may be 0.
std::uint64_t cores() { return std::max(1U, std::thread::hardware_concurrency()); }

// Every rank has the blocks of a shard of its own.
SweepShare share_of(SweepShare share, const SweepTeam& team) {
    share.part += share.parts * team.rank;
    share.parts *= team.size;
    if (share.jobs == 0) share.jobs = team.of_mpi ? 1 : cores();
    if (!team.leads()) share.progress = nullptr;
    return share;
}

int run_sweep(const SweepRequest& request, const SweepTeam& team) {
    SweepGrid grid = of_argument("--over", [&] { return SweepGrid(request.over, request.sample); });
    const Home home = find_home();
    Scene scene = read_scene_with_values(request.scene, home);
    of_argument("--over", [&] {
        require_axes(grid, scene);
        const std::size_t rows = std::max(request.times.size(), quantities(request.what).size());
        return bounded_product({grid.points(), std::max<std::uint64_t>(1, rows), scene.outputs.size()});
    });
    require_place_for(request.files.output);
    require_place_for(request.files.json);
    if (!request.map.empty() && team.leads()) {
        of_argument("--map", [&] { require_map(grid); });
        require_place_for(request.map);
    }
    const Derived derived = derive(request, std::move(scene), grid);
    const Sweep sweep =
        sweep_of(request.files, subject_asked(request, derived.line, *derived.program), std::move(grid));
    const CacheFolder cache(home);
    const ComputePoints compute = computation(request, derived, sweep.grid, cache);
    const SweepFolder folder(sweep.files.parts, sweep.description);
    team.prepared();
    const bool whole = request.share.parts == 1;
    compute_blocks(folder, sweep.size, compute, share_of(request.share, team));
    if (const int code = team.computed(); code != done || !team.leads()) return code;
    if (whole && !request.map.empty())
        write_file(request.map, of_argument("--map", [&] {
                       return sweep_map(folder, sweep.subject, sweep.grid, sweep.size, cache.path());
                   }));
    finish(sweep, folder, whole, request.format);
    return done;
}

int run_gather(const SweepRequest& request) {
    const Json description = SweepFolder::read_subject(request.files.parts);
    SweepSubject subject = subject_of(description);
    SweepGrid grid(subject.over, subject.sample);
    SweepFiles files = request.files;
    if (files.output.empty()) files.output = with_suffix(files, subject.suffix);
    require_form("--gather", files.output);
    require_place_for(files.output);
    require_place_for(files.json);
    const Sweep sweep = sweep_of(std::move(files), std::move(subject), std::move(grid));
    const SweepFolder folder(sweep.files.parts, sweep.description);
    const SweepTotals totals = finish(sweep, folder, true, request.format);
    if (totals.blocks < sweep.size.blocks())
        bad_argument("--gather", "all blocks of the sweep must be there",
                     fmt::format("{} of {}; block {} is the first that is missing", totals.blocks,
                                 sweep.size.blocks(), totals.first_missing),
                     "run the shards that are missing: each computes what is not there");
    return done;
}

} // namespace

void add_sweep_of(CLI::App& app, Action& action, const SweepTeam& team) {
    CLI::App* command = app.add_subcommand("sweep", "the outputs of a scene over a grid of its arguments");
    const SweepOptions options(*command);
    on_choice(*command, action, [=] {
        if (!team.of_mpi) refuse_mpirun();
        const SweepRequest request = options.value();
        return request.scene.empty() ? run_gather(request) : run_sweep(request, team);
    });
}

void add_sweep(CLI::App& app, Action& action) { add_sweep_of(app, action, SweepTeam()); }

} // namespace resonform
