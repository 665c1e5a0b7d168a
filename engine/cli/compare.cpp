// SPDX-License-Identifier: GPL-3.0-or-later
// resonform compare SCENE: error against run time, beside direct integrators.
#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/limits.hpp"
#include "cli/locations.hpp"
#include "cli/output.hpp"
#include "cli/pipeline.hpp"
#include "cli/watch.hpp"
#include "verify/comparison/comparison.hpp"
#include "verify/comparison/timing.hpp"
#include "verify/report/json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>

namespace resonform {

namespace {

constexpr int highest_order = 63;
constexpr std::uint64_t fewest_points = 2, most_points = 10'000'000, most_members = 10'000'000,
                        most_repetitions = 1000;

class CompareCommand {
public:
    explicit CompareCommand(CLI::App& command)
        : command_(&command), scene_(add_required(command, "SCENE", "", scene_help)),
          eps_(add_text(command, "--eps", "E1,E2,...", "values of eps, such as 0.01,1/1000; default: 0.001")),
          orders_(add_text(command, "--orders", "N1,N2,...",
                           "orders at which the scene is derived and emitted; default: that of the scene")),
          tasks_(add_text(command, "--tasks", fmt::format("{}", fmt::join(task_names(), ",")),
                          "what is timed", "final,dense")),
          points_(add_text(command, "--points", "P1,P2,...", "of dense and grid", "1000000")),
          members_(add_text(command, "--members", "NUMBER", "of ensemble", "10000")),
          repetitions_(add_text(command, "--repetitions", "NUMBER",
                                "of each timing; default: 3 to 15, until a fifth of a second is spent")),
          format_(command, {"text", "json", "csv"}), limits_(command) {}

    [[nodiscard]] int run() const {
        const std::string format = format_.value();
        CompareOptions asked = options();
        const Home home = find_home();
        Scene scene = read_scene_with_values(*scene_, home);
        if (!orders_->empty())
            asked.orders = read_orders("--orders", *orders_, scene.system->eps_root, highest_order);
        set_order(scene, asked.orders);
        std::optional<SceneLine> line;
        asked.derivation_seconds = seconds_of(1, [&] {
            line = watched(limits_.value(), [&](Watch& watch) { return solve_scene(scene, watch); });
        });
        const CacheFolder cache(home);
        asked.cache = cache.path();
        asked.progress = show_progress;
        const Comparison comparison = compare(line->expanded.first_order, line->scene, line->solution, asked);
        if (format == "json")
            put("{}", document_text(to_json(comparison)));
        else
            put("{}", format == "csv" ? to_csv(comparison) : to_text(comparison));
        return done;
    }

private:
    [[nodiscard]] CompareOptions options() const {
        CompareOptions options;
        if (!eps_->empty()) options.eps = read_eps_list(*eps_);
        options.tasks = tasks();
        options.points.clear();
        for (const std::uint64_t points :
             read_integers("--points", *points_, fewest_points, most_points, 1000))
            options.points.push_back(points);
        options.members = read_integer("--members", *members_, 1, most_members, 10000);
        if (!repetitions_->empty())
            options.repetitions =
                static_cast<int>(read_integer("--repetitions", *repetitions_, 1, most_repetitions, 7));
        require_used("--points", {Task::dense, Task::grid}, options.tasks);
        require_used("--members", {Task::ensemble}, options.tasks);
        return options;
    }

    [[nodiscard]] std::vector<Task> tasks() const {
        std::vector<Task> tasks;
        for (const std::string& name : read_choices("--tasks", *tasks_, task_names()))
            tasks.push_back(task_of(name));
        std::sort(tasks.begin(), tasks.end());
        return tasks;
    }

    // An option that no task heeds would be dropped silently.
    void require_used(const std::string& option, const std::vector<Task>& by,
                      const std::vector<Task>& tasks) const {
        if (command_->get_option(option)->count() == 0) return;
        for (const Task task : by)
            if (std::find(tasks.begin(), tasks.end(), task) != tasks.end()) return;
        bad_argument(option, fmt::format("must be given with --tasks {}", to_string(by.front())),
                     command_->get_option(option)->as<std::string>(), "leave it out, or add the task");
    }

    // The scene is derived for the highest order.
    static void set_order(Scene& scene, const std::vector<int>& orders) {
        if (orders.empty()) return;
        scene.order = orders.back();
        if (scene.truncation && scene.order > *scene.truncation)
            bad_argument("--orders",
                         fmt::format("orders must not exceed the truncation = {} that the scene gives",
                                     to_string(scene.system->weight(*scene.truncation))),
                         to_string(scene.system->weight(scene.order)), "leave it out");
    }

    CLI::App* command_;
    Text scene_, eps_, orders_, tasks_, points_, members_, repetitions_;
    FormatOption format_;
    LimitOptions limits_;
};

} // namespace

void add_compare(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("compare", "error against run time, beside direct integrators");
    const CompareCommand compare(*command);
    on_choice(*command, action, [=] { return compare.run(); });
}

} // namespace resonform
