// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/pipeline.hpp"

#include <fmt/format.h>

namespace resonform {

namespace {

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
    auto normalization = std::make_shared<Normalization>(normalize_poincare(expanded.field, through));
    normalization->certificate = certify(normalization->normal_form, normalization->map);
    return normalization;
}

std::shared_ptr<const Normalization> normalize_certified(const Expanded& expanded, int through) {
    auto normalization = normalize_with_certificate(expanded, through);
    if (!normalization->certificate.holds)
        throw CertificateFailed(fmt::format("the certificate of the normal form does not hold: {}",
                                            normalization->certificate.complaint));
    return normalization;
}

SceneLine solve_scene(const std::filesystem::path& file, const Home& home) {
    SceneLine line;
    line.scene = read_scene(file, home.systems());
    line.expanded = expand_shared(line.scene.system);
    line.count = count_truncation(*line.expanded.field, line.scene);
    line.solution = solve(normalize_certified(line.expanded, line.count.truncation),
                          {line.scene.order, line.count.truncation});
    return line;
}

} // namespace resonform
