// SPDX-License-Identifier: GPL-3.0-or-later
// The command line: one subcommand per file, registered here; main turns failures into exit codes.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace resonform {

enum ExitCode : int {
    done = 0,
    check_failed = 1, // a verdict other than expected, a certificate that does not hold, a stale file
    bad_input_code = 2,
    refused_code = 3,
};

// The action of the chosen subcommand; it returns the exit code.
using Action = std::function<int()>;

// An option as the user typed it, alive as long as the action that uses it. `values` is what the help
// shows behind its name: "NUMBER".
using Text = std::shared_ptr<std::string>;
Text add_text(CLI::App& command, const std::string& name, const std::string& values, const std::string& help,
              const std::string& default_text = {});
Text add_required(CLI::App& command, const std::string& name, const std::string& values,
                  const std::string& help);
// A file or folder to be written; empty: not asked for. Errors (bad_input): given, but empty.
Text add_output(CLI::App& command, const std::string& name, const std::string& values,
                const std::string& help);

// --set NAME=VALUE...: as often as wanted, several after one --set.
using Texts = std::shared_ptr<std::vector<std::string>>;
Texts add_settings(CLI::App& command);

// --style, "" by default: that of the system file.
Text add_style(CLI::App& command);

// --digits, "" by default: exact coefficients.
Text add_digits(CLI::App& command);

// --format, the first of `known` by default; value() checks it.
class FormatOption {
public:
    FormatOption(CLI::App& command, std::vector<std::string> known);
    [[nodiscard]] std::string value() const;

private:
    std::vector<std::string> known_;
    Text text_;
};

constexpr const char* system_help = "a folder with system.toml, that file, or a name in systems/";
constexpr const char* scene_help = "the path of a scene file";
constexpr const char* order_values = "1..99";

// Makes `run` the action if the command is chosen.
template <class Run> void on_choice(CLI::App& command, Action& action, const Run& run) {
    command.callback([&action, run] { action = run; });
}

void add_derive(CLI::App& app, Action& action);
void add_generate(CLI::App& app, Action& action);
void add_verify(CLI::App& app, Action& action);
void add_certify(CLI::App& app, Action& action);
void add_compare(CLI::App& app, Action& action);
void add_stability(CLI::App& app, Action& action);
void add_sweep(CLI::App& app, Action& action);
void add_regenerate(CLI::App& app, Action& action);
void add_results(CLI::App& app, Action& action);
void add_list(CLI::App& app, Action& action);
void add_evaluate(CLI::App& app, Action& action);

} // namespace resonform
