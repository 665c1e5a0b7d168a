// SPDX-License-Identifier: GPL-3.0-or-later
// resonform COMMAND ...: reads the command line, runs one command, turns every failure into one
// message on stderr and an exit code (0 done, 1 a check failed, 2 bad input, 3 refused).
#include "cli/arguments.hpp"
#include "cli/command.hpp"
#include "cli/pipeline.hpp"
#include "model/expression.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iostream>
#include <new>

namespace resonform {

namespace {

void add_commands(CLI::App& app, Action& action) {
    app.require_subcommand(0, 1); // none: help
    app.set_version_flag("--version", "resonform " RESONFORM_VERSION);
    app.set_help_flag("-h,--help", "print this help and exit");
    for (const auto& add : {add_derive, add_generate, add_verify, add_certify, add_compare, add_stability,
                            add_regenerate, add_list, add_evaluate})
        add(app, action);
    app.footer("SYSTEM is a folder with system.toml, the path of that file, or a name in systems/.\n"
               "SCENE is the path of a scene file: systems/NAME/scenes/SCENE.toml.\n"
               "Exit codes: 0 done, 1 a check failed, 2 bad input, 3 refused.");
}

// CLI11 leaves an unknown word in `remaining`: say which it was and what is nearest.
[[noreturn]] void unexpected_word(const CLI::App& app) {
    const auto chosen = app.get_subcommands();
    const std::string word = app.remaining(true).empty() ? "" : app.remaining(true).front();
    std::vector<std::string> known;
    if (chosen.empty()) {
        for (const CLI::App* command : app.get_subcommands(nullptr)) known.push_back(command->get_name());
    } else {
        for (const CLI::Option* option : chosen.front()->get_options())
            if (!option->get_lnames().empty()) known.push_back("--" + option->get_lnames().front());
    }
    const std::string near = nearest(word, known);
    const std::string owner = chosen.empty() ? "resonform" : "resonform " + chosen.front()->get_name();
    bad_argument(owner,
                 chosen.empty() ? fmt::format("a command is one of {}", fmt::join(known, ", "))
                                : fmt::format("{} takes no such argument", owner),
                 word,
                 near.empty() ? fmt::format("see {} --help", owner) : fmt::format("did you mean {}?", near));
}

int run(int argc, char** argv) {
    CLI::App app("From a text file of a dynamical system to its normal form, its solution, and C++ "
                 "evaluators of proved accuracy.",
                 "resonform");
    Action action;
    add_commands(app, action);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& success) {
        return app.exit(success); // --help, --version
    } catch (const CLI::ExtrasError&) {
        unexpected_word(app);
    } catch (const CLI::ParseError& error) {
        bad_argument("command line", error.what(), fmt::format("{}", fmt::join(argv + 1, argv + argc, " ")),
                     "see resonform --help");
    }
    if (!action) {
        bad_argument("command line", "a command is needed", "", "see resonform --help");
    }
    const int code = action();
    std::cout.flush();
    if (!std::cout)
        bad_argument("standard output", "the results must be writable", "",
                     "free space, or redirect them elsewhere");
    return code;
}

int complain(const char* message, int code) {
    fmt::print(stderr, "resonform: {}\n", message);
    return code;
}

} // namespace

} // namespace resonform

int main(int argc, char** argv) {
    using namespace resonform;
    try {
        return run(argc, argv);
    } catch (const Error& error) {
        return complain(error.what(), static_cast<int>(error.kind()));
    } catch (const CertificateFailed& failure) {
        return complain(failure.what(), check_failed);
    } catch (const std::bad_alloc&) {
        return complain("the memory is exhausted; ask for a lower order", refused_code);
    } catch (const std::exception& unforeseen) {
        return complain(
            fmt::format("refused, by a fault of the engine that its authors would like to know: {}",
                        unforeseen.what())
                .c_str(),
            refused_code);
    }
}
