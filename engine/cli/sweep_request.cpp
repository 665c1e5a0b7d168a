// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep_request.hpp"

#include "cli/arguments.hpp"
#include "cli/output.hpp"
#include "verify/sweep/hdf5.hpp"
#include "verify/sweep/size.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace resonform {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t most_jobs = 1024, most_shards = 1'000'000;
constexpr const char *first_seed = "1", *usual_tolerance = "1e-6";

bool is_suffix(const fs::path& suffix) { return suffix == ".npy" || suffix == ".csv" || suffix == ".h5"; }

SweepFiles files_of(const fs::path& stem, const fs::path& output) {
    const auto beside = [&](const char* suffix) { return fs::path(stem) += suffix; };
    return {stem, output, beside(".json"), beside(".parts")};
}

} // namespace

void require_form(const char* option, const fs::path& output) {
    if (output.extension() != ".h5") return;
    if (const std::string why = why_no_hdf5(); !why.empty())
        bad_argument(option, "HDF5 cannot be written here", why, "write .npy or .csv");
}

fs::path with_suffix(const SweepFiles& files, const std::string& suffix) {
    return fs::path(files.stem) += suffix;
}

SweepOptions::SweepOptions(CLI::App& command)
    : command_(&command),
      scene_(add_text(command, "SCENE", "", std::string(scene_help) + "; not with --gather")),
      over_(std::make_shared<std::vector<std::string>>()),
      sample_(add_text(command, "--sample", "N", "N random points in place of a grid")),
      seed_(
          add_text(command, "--seed", "NUMBER", "of the sample: the same seed, the same points", first_seed)),
      what_(add_text(command, "--what", fmt::format("{}", fmt::join(sweep_kinds(), "|")),
                     "the outputs, or of each: its error and order against direct integration, up to which "
                     "time its estimated error is below the tolerance, its worst ulp against 50 digits",
                     sweep_kinds().front())),
      tolerance_(add_text(command, "--tolerance", "NUMBER", "of the validity", usual_tolerance)),
      times_(add_text(command, "--t", "T1,T2,...",
                      "times, separated by commas; default: the end of the scene's interval")),
      output_(add_output(command, "--output", "FILE",
                         "F.npy, F.h5 or F.csv; F.json and the blocks, F.parts/, stand beside it")),
      map_(add_output(command, "--map", "FILE", "F.svg: the first output over one or two axes, by gnuplot")),
      jobs_(add_text(command, "--jobs", "NUMBER",
                     "threads; default: one for each processor, of resonform_mpi one")),
      shard_(add_text(command, "--shard", "I/N",
                      "compute only every N-th block, from the I-th on, and gather nothing")),
      gather_(add_output(command, "--gather", "F",
                         "write the output of the blocks in F.parts/, and nothing else")),
      format_(command, {"text", "json"}), limits_(command) {
    command
        .add_option(
            "--over", *over_,
            "eps, a parameter or a start value, and where it goes: LO:HI:N, log(LO:HI:N) or V1,V2,...; "
            "several make a grid, the first is the slowest")
        ->type_name("NAME=VALUES")
        ->allow_extra_args(false);
}

std::vector<double> SweepOptions::times() const {
    if (times_->empty()) return {};
    std::vector<double> times = read_times(*times_);
    for (const double t : times)
        if (!std::isfinite(t) || t < 0)
            bad_argument("--t", "times must be >= 0 and finite", *times_, "give for example --t 0,1/3,10.5");
    return times;
}

std::optional<SweepSample> SweepOptions::sample() const {
    if (sample_->empty()) {
        if (command_->get_option("--seed")->count() > 0)
            bad_argument("--seed", "must be given with --sample, whose points it draws", *seed_,
                         "leave it out: a grid has no seed");
        return std::nullopt;
    }
    return SweepSample{read_integer("--sample", *sample_, 1, most_values, 10000),
                       read_integer("--seed", *seed_, 0, std::numeric_limits<std::uint64_t>::max(), 1)};
}

// 0 of what has none.
double SweepOptions::tolerance(SweepKind what) const {
    if (what == SweepKind::validity) {
        const double number = read_limit("--tolerance", *tolerance_);
        if (std::isfinite(number)) return number;
        bad_argument("--tolerance", "must be a decimal number or a fraction > 0", *tolerance_,
                     "give for example --tolerance 1e-6");
    }
    if (command_->get_option("--tolerance")->count() > 0)
        bad_argument("--tolerance", "must be given with --what validity, whose tolerance it is", *tolerance_,
                     "leave it out");
    return 0;
}

SweepShare SweepOptions::share() const {
    SweepShare share;
    share.progress = show_progress;
    share.jobs = jobs_->empty() ? 0 : read_integer("--jobs", *jobs_, 1, most_jobs, 4);
    if (shard_->empty()) return share;
    const auto bad_shard = [&] {
        bad_argument("--shard", fmt::format("must be I/N with 1 <= I <= N <= {}", most_shards), *shard_,
                     "give for example --shard 1/4");
    };
    const std::size_t slash = shard_->find('/');
    const auto read = [&](std::size_t begin, std::size_t end, std::uint64_t& number) {
        const char* const last = shard_->data() + end;
        const auto [stop, error] = std::from_chars(shard_->data() + begin, last, number);
        if (error != std::errc() || stop != last) bad_shard();
    };
    if (slash == std::string::npos) bad_shard();
    read(0, slash, share.part);
    read(slash + 1, shard_->size(), share.parts);
    if (share.part < 1 || share.part > share.parts || share.parts > most_shards) bad_shard();
    return share;
}

SweepFiles SweepOptions::files_of_output() const {
    if (output_->empty())
        bad_argument("--output", "sweep needs it, the file to be written", std::nullopt,
                     "give for example --output sweep.npy");
    const fs::path output = *output_;
    if (!is_suffix(output.extension()) || output.stem().empty())
        bad_argument("--output", "must end in .npy, .h5 or .csv", *output_,
                     "give for example --output sweep.npy");
    require_form("--output", output);
    return files_of(fs::path(output).replace_extension(), output);
}

SweepFiles SweepOptions::files_to_gather() const {
    const fs::path given = *gather_;
    return is_suffix(given.extension()) ? files_of(fs::path(given).replace_extension(), given)
                                        : files_of(given, "");
}

void SweepOptions::require_alone() const {
    for (const CLI::Option* option : command_->get_options())
        if (option->count() > 0 && option->get_name() != "--gather" && option->get_name() != "--format")
            bad_argument("--gather", "reads what is swept from F.parts/, and takes no other option",
                         option->get_name(), "leave it out");
}

SweepRequest SweepOptions::value() const {
    SweepRequest request;
    request.format = format_.value();
    request.limits = limits_.value();
    if (!gather_->empty()) {
        require_alone();
        request.files = files_to_gather();
        return request;
    }
    if (scene_->empty())
        bad_argument("SCENE", std::string("sweep needs it, ") + scene_help, std::nullopt,
                     "see resonform sweep --help");
    if (over_->empty())
        bad_argument("--over", "sweep needs it, once for each axis", std::nullopt,
                     "give for example --over 'eps=log(1e-3:1e-1:100)'");
    const std::vector<std::string> kinds = sweep_kinds();
    const auto kind = std::find(kinds.begin(), kinds.end(), read_choice("--what", *what_, kinds));
    request.what = static_cast<SweepKind>(kind - kinds.begin());
    request.tolerance = tolerance(request.what);
    request.scene = *scene_;
    request.over = *over_;
    request.sample = sample();
    request.times = times();
    if (request.what != SweepKind::values && !request.times.empty())
        bad_argument("--t", fmt::format("must not be given with --what {}, which finds the times", *what_),
                     *times_, "leave it out");
    request.files = files_of_output();
    request.share = share();
    request.map = *map_;
    if (!request.map.empty() && request.map.extension() != ".svg")
        bad_argument("--map", "must end in .svg", *map_, "give for example --map sweep.svg");
    if (!request.map.empty() && request.share.parts > 1)
        bad_argument("--map", "is of a whole sweep, and must not be given with --shard", *map_,
                     "leave it out");
    return request;
}

} // namespace resonform
