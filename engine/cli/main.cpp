// SPDX-License-Identifier: GPL-3.0-or-later
// resonform COMMAND ...: reads the command line, runs one command, turns every failure into one
// message on stderr and an exit code (0 done, 1 a check failed, 2 bad input, 3 refused).
#include "algebra/number/error.hpp"
#include "cli/command.hpp"
#include "cli/command_line.hpp"
#include "cli/complaint.hpp"
#include "cli/output.hpp"

#include <exception>
#include <memory>
#include <string>
#include <utility>

namespace resonform {

namespace {

// The usage line shows required arguments before [OPTIONS], because --set takes all words behind it.
class Help : public CLI::Formatter {
public:
    std::string make_usage(const CLI::App* app, std::string name) const override {
        std::string text = CLI::Formatter::make_usage(app, std::move(name));
        const std::string options = " [OPTIONS]";
        const std::size_t at = text.find(options), end = text.find('\n');
        if (app->get_parent() == nullptr || at == std::string::npos || at > end) return text;
        return text.erase(at, options.size()).insert(end - options.size(), options);
    }
};

void add_commands(CLI::App& app, Action& action) {
    app.require_subcommand(0, 1);
    app.formatter(std::make_shared<Help>());
    app.set_version_flag("--version", "resonform " RESONFORM_VERSION);
    app.set_help_flag("-h,--help", "print this help and exit");
    for (const auto& add : {add_derive, add_generate, add_verify, add_certify, add_compare, add_stability,
                            add_sweep, add_regenerate, add_results, add_list, add_evaluate})
        add(app, action);
    app.footer("SYSTEM is a folder with system.toml, the path of that file, or a name in systems/.\n"
               "SCENE is the path of a scene file: systems/NAME/scenes/SCENE.toml.\n"
               "Exit codes: 0 done, 1 a check failed, 2 bad input, 3 refused.");
}

int run(int argc, char** argv) {
    CLI::App app("From a text file of a dynamical system to its normal form, its solution, and C++ "
                 "evaluators whose accuracy is measured.",
                 "resonform");
    Action action;
    add_commands(app, action);
    return run_command_line(app, action, argc, argv);
}

} // namespace

} // namespace resonform

int main(int argc, char** argv) {
    using namespace resonform;
    try {
        hold_streams();
        return run(argc, argv);
    } catch (...) {
        const Error error = error_of(std::current_exception());
        tell_error(error, asks_for_json(argc, argv));
        return static_cast<int>(error.kind());
    }
}
