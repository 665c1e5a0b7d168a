// SPDX-License-Identifier: GPL-3.0-or-later
// The line of rooms, walked once for all commands:
//   system.toml -> first-order system -> graded field -> normal form, certified -> solution -> program
#pragma once

#include "certify/certificate.hpp"
#include "cli/locations.hpp"
#include "cli/output.hpp"
#include "cli/watch.hpp"
#include "emit/program/program.hpp"
#include "model/files/settings.hpp"
#include "model/system/scene_file.hpp"
#include "normalize/styles/normalize.hpp"
#include "solve/solution.hpp"
#include "solve/truncation.hpp"
#include "verify/estimate/next_weight.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace resonform {

struct Expanded {
    std::shared_ptr<const FirstOrderSystem> first_order;
    std::shared_ptr<const GradedField> field;
};
// The changes that the command line makes to a system file.
struct SystemChanges {
    std::vector<Setting> settings; // --set: numbers in place of parameters
    std::optional<Style> style;    // --style
    int digits = 0;                // --digits
};
// SYSTEM of the command line, found by find_system.
System changed_system(const std::filesystem::path& file, const SystemChanges& changes, const Home& home);
Expanded expand_system(std::shared_ptr<const System> system, Watch& watch);

// Normal form and map through a weight with their certificate, which may fail to hold: `certify` shows it,
// all others call normalize_certified. Steps of half a second or more are reported on standard error.
std::shared_ptr<const Normalization> normalize_with_certificate(const Expanded& expanded, int through,
                                                                Watch& watch);
// Errors (check_failed): the certificate does not hold. The first has coefficients in a graph.
GraphNormalization normalize_in_graph_certified(const Expanded& expanded, int through, Watch& watch);
std::shared_ptr<const Normalization> normalize_certified(const Expanded& expanded, int through, Watch& watch);

// Solves a certified normal form; the watch is told of each step.
Solution solve_under(Watch& watch, std::shared_ptr<const Normalization> normalization,
                     const SolveOptions& options);

struct SceneLine {
    Scene scene;
    Expanded expanded;
    TruncationCount count;
    Solution solution;
};
// Options of verify, compare or stability with this cache and with progress on standard error.
template <class Options> Options with_progress(const CacheFolder& cache) {
    Options options;
    options.cache = cache.path();
    options.progress = show_progress;
    return options;
}

// The solution of a system through an order, with normal form and map through a weight.
Solution solve_system(std::shared_ptr<const System> system, int order, int truncation, Watch& watch);
// The same for an estimator of errors. It must not outlive the watch.
Derive deriving_under(Watch& watch);

// SCENE of the command line; errors: those of find_scene and read_scene.
Scene read_scene_of(const std::string& argument, const Home& home);
// The same for commands that compute numbers. Errors: also a function that only emitted code can call.
Scene read_scene_with_values(const std::string& argument, const Home& home);
// Parameters stay symbols where this can be done: the values of [fix] are put in before the derivation only
// if it is refused with symbols (sin(al), a divisor or a sign that is not proved, a resonance of fixed
// frequencies), and the scene of the line has them put in then.
// Errors: those of every room on the way, with the values put in.
SceneLine solve_scene(Scene scene, Watch& watch);
SceneLine solve_scene(const std::string& argument, const Home& home, Watch& watch);
// The same for commands that compute numbers, with a watch of its own, that ends with the derivation.
SceneLine solve_scene(const std::string& argument, const Home& home, const DerivationLimits& limits);
Program program_of(const SceneLine& line, Watch& watch);

// The header of a scene, with error estimates if it asks for them.
struct Header {
    Program program;
    std::string text;
};
Header header_of(const SceneLine& line, Watch& watch, bool inline_runtime = false);

} // namespace resonform
