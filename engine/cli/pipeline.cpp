// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/pipeline.hpp"

#include "cli/output.hpp"

#include <fmt/format.h>

#include <chrono>

namespace resonform {

namespace {

// Tells how long each step of a computation took, if that was long enough to wonder.
class Laps {
public:
    void done(const std::string& step) {
        constexpr double told = 0.5; // seconds
        const Clock::time_point now = Clock::now();
        const double seconds = std::chrono::duration<double>(now - begin_).count();
        if (seconds >= told) show_progress(fmt::format("{}, {:.1f} s", step, seconds));
        begin_ = now;
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point begin_ = Clock::now();
};

Expanded expand_shared(std::shared_ptr<const System> system) {
    Expanded expanded;
    expanded.first_order = std::make_shared<const FirstOrderSystem>(solve_for_highest(std::move(system)));
    expanded.field = std::make_shared<const GradedField>(expand(expanded.first_order));
    return expanded;
}

} // namespace

Expanded expand_system(const std::filesystem::path& file) {
    return expand_shared(std::make_shared<const System>(read_system(file)));
}

std::shared_ptr<const Normalization> normalize_with_certificate(const Expanded& expanded, int through) {
    Laps laps;
    const NormalizeOptions options{[&laps](int weight, std::size_t terms) {
        laps.done(fmt::format("weight {}: {} terms", weight, terms));
    }};
    auto normalization =
        std::make_shared<Normalization>(normalize_poincare(expanded.field, through, options));
    normalization->certificate = certify(normalization->normal_form, normalization->map);
    laps.done("certificate");
    return normalization;
}

std::shared_ptr<const Normalization> normalize_certified(const Expanded& expanded, int through) {
    auto normalization = normalize_with_certificate(expanded, through);
    if (!normalization->certificate.holds)
        throw CertificateFailed(fmt::format("the certificate of the normal form does not hold: {}",
                                            normalization->certificate.complaint));
    return normalization;
}

SceneLine solve_scene(const std::string& argument, const Home& home) {
    SceneLine line;
    line.scene = read_scene(find_scene(argument, home), home.systems());
    line.expanded = expand_shared(line.scene.system);
    line.count = count_truncation(*line.expanded.field, line.scene);
    line.solution = solve(normalize_certified(line.expanded, line.count.truncation),
                          {line.scene.order, line.count.truncation});
    check_time_scale(line.solution, line.scene);
    return line;
}

} // namespace resonform
