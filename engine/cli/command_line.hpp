// SPDX-License-Identifier: GPL-3.0-or-later
// Reads argv with CLI11 and rewords its complaints.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace resonform {

// Runs the callback of the chosen subcommand. Returns what --help or --version prints, else "".
// Errors (bad_input): an unknown word, an option without its value or given twice, a missing argument.
std::string read_command_line(CLI::App& app, int argc, char** argv);

} // namespace resonform
