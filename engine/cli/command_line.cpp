// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_line.hpp"

#include "algebra/number/error.hpp"
#include "cli/arguments.hpp"
#include "cli/output.hpp"
#include "model/text/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

namespace resonform {

namespace {

// As complaints name it: "--order" of an option with several names, "SCENE" of an argument without dashes.
std::string one_name(const CLI::Option& option) {
    return option.get_lnames().empty() ? option.get_name() : "--" + option.get_lnames().front();
}

// The subcommand that was chosen, else the app itself.
const CLI::App& chosen_in(const CLI::App& app) {
    const auto chosen = app.get_subcommands();
    return chosen.empty() ? app : *chosen.front();
}

std::string full_name(const CLI::App& app, const CLI::App& chosen) {
    return &app == &chosen ? app.get_name() : app.get_name() + " " + chosen.get_name();
}

std::string see_help(const CLI::App& app) {
    return fmt::format("see {} --help", full_name(app, chosen_in(app)));
}

// Refuses the word that CLI11 left in `remaining`, and names the nearest known one.
[[noreturn]] void unexpected_word(const CLI::App& app) {
    const CLI::App& chosen = chosen_in(app);
    const auto remaining = app.remaining(true);
    const std::string word = remaining.empty() ? "" : remaining.front();
    std::vector<std::string> known;
    std::string rule;
    if (&chosen == &app) {
        for (const CLI::App* command : app.get_subcommands(nullptr)) known.push_back(command->get_name());
        rule = fmt::format("the command must be one of {}", fmt::join(known, ", "));
    } else {
        for (const CLI::Option* option : chosen.get_options())
            if (!option->get_lnames().empty()) known.push_back("--" + option->get_lnames().front());
        rule = fmt::format("{} takes no such argument", chosen.get_name());
    }
    if (&chosen != &app && std::find(known.begin(), known.end(), word) != known.end())
        bad_input(Reason::command_line, {fmt::format("an option follows its command, {}", chosen.get_name()),
                                         word,
                                         fmt::format("write {} ... {}", full_name(app, chosen), word),
                                         {}});
    const std::string near = nearest(word, known);
    bad_input(Reason::command_line, {rule,
                                     remaining.empty() ? "" : as_found(word),
                                     near.empty() ? see_help(app) : fmt::format("did you mean {}?", near),
                                     {}});
}

// An option of several words takes all that follow, up to the next option: --set g=1 SYSTEM.
void refuse_swallowed(const CLI::App& app, const CLI::Option& missing) {
    const CLI::App& chosen = chosen_in(app);
    if (!missing.get_positional()) return;
    for (const CLI::Option* option : chosen.get_options())
        if (option->get_expected_max() > 1 && option->count() > 0)
            bad_argument(one_name(*option),
                         fmt::format("takes all words that follow it, and {} needs {}: {}", chosen.get_name(),
                                     missing.get_name(), missing.get_description()),
                         fmt::format("{} {}", option->get_name(), fmt::join(option->results(), " ")),
                         fmt::format("write {} {} {} ...", full_name(app, chosen), missing.get_name(),
                                     option->get_name()));
}

[[noreturn]] void missing_argument(const CLI::App& app) {
    const CLI::App& chosen = chosen_in(app);
    if (!app.remaining(true).empty()) unexpected_word(app);
    for (const CLI::Option* option : chosen.get_options())
        if (option->get_required() && option->count() == 0) {
            refuse_swallowed(app, *option);
            bad_argument(one_name(*option),
                         fmt::format("{} needs it, {}", chosen.get_name(), option->get_description()),
                         std::nullopt, see_help(app));
        }
    bad_input(Reason::command_line, {"a command must be given", "", see_help(app), {}});
}

[[noreturn]] void wrong_count(const CLI::App& app, const std::string& explanation) {
    for (const CLI::Option* option : chosen_in(app).get_options())
        if (option->count() > 1)
            bad_argument(one_name(*option), "must be given at most once",
                         fmt::format("{}", fmt::join(option->results(), ", ")), "leave out all but one");
    // "--order: 1 required INT missing"
    bad_argument(explanation.substr(0, explanation.find(':')), "must be followed by its value", std::nullopt,
                 see_help(app));
}

// An option takes the next word, whatever it is: --order --stage equations.
void refuse_option_as_value(const CLI::App& app) {
    const CLI::App& chosen = chosen_in(app);
    const auto names_option = [&](const std::string& word) {
        return word.substr(0, 1) == "-" &&
               chosen.get_option_no_throw(word.substr(0, word.find('='))) != nullptr;
    };
    for (const CLI::Option* option : chosen.get_options())
        for (const std::string& value : option->results())
            if (names_option(value))
                bad_argument(one_name(*option), "must be followed by its value", value + ", another option",
                             see_help(app));
}

// Refuses empty values: they would count as options that were not given.
void refuse_empty_values(const CLI::App& app) {
    for (const CLI::Option* option : chosen_in(app).get_options()) {
        if (option->get_positional() || option->get_required()) continue; // their readers complain
        for (const std::string& value : option->results())
            if (value.empty() && option->get_default_str().empty())
                bad_argument(one_name(*option), "must be followed by its value", value,
                             "give one, or leave the option out");
    }
}

// Returns what --help or --version prints, else "".
std::string read_command_line(CLI::App& app, int argc, char** argv) {
    try {
        app.parse(argc, argv);
        refuse_option_as_value(app);
        refuse_empty_values(app);
        return "";
    } catch (const CLI::Success& asked) { // --help, --version
        std::ostringstream text;
        app.exit(asked, text, text);
        return text.str();
    } catch (const CLI::ExtrasError&) {
        refuse_option_as_value(app);
        unexpected_word(app);
    } catch (const CLI::RequiredError&) {
        refuse_option_as_value(app);
        missing_argument(app);
    } catch (const CLI::ArgumentMismatch& mismatch) {
        wrong_count(app, mismatch.what());
    } catch (const CLI::ParseError&) {
        bad_input(Reason::command_line, {"the arguments must be those of the help",
                                         fmt::format("{}", fmt::join(argv + 1, argv + argc, " ")),
                                         see_help(app),
                                         {}});
    }
}

} // namespace

int run_command_line(CLI::App& app, const Action& action, int argc, char** argv) {
    const std::string help = read_command_line(app, argc, argv);
    print_result(help);
    if (help.empty() && !action)
        bad_input(Reason::command_line, {"a command must be given", "", see_help(app), {}});
    const int code = action ? action() : done;
    finish_results();
    return code;
}

} // namespace resonform
