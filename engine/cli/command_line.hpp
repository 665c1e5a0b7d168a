// SPDX-License-Identifier: GPL-3.0-or-later
// Reads argv with CLI11, rewords its complaints, and runs the command.
#pragma once

#include "cli/command.hpp"

namespace resonform {

// Prints what --help or --version asks for, or runs `action`, which the chosen subcommand sets while argv is
// read; the exit code. Errors (bad_input): no command, an unknown word, an option without its value or given
// twice, a missing argument.
int run_command_line(CLI::App& app, const Action& action, int argc, char** argv);

} // namespace resonform
