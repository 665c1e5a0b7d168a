// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judging/emitted_check.hpp"

#include "verify/judging/emitted_judge.hpp"
#include "verify/run/parallel.hpp"
#include "verify/symbolic/ulp.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace resonform {

namespace {

template <class Real>
EmittedInType in_type(const Program& program, const std::shared_ptr<const EvaluatorLibrary>& library,
                      const std::shared_ptr<const SymbolicSolution>& symbolic, const Scene& scene,
                      bool is_flow, const EmittedCheckOptions& options) {
    EmittedJudge<Real> judge(program, library, symbolic, scene, is_flow, options);
    EmittedInType result = judge.judged(judge.answers());
    std::vector<std::pair<std::size_t, Status>> statuses(judge.further_starts());
    in_parallel(statuses.size(), [&](std::size_t k) { statuses[k] = {k, judge.status_at_start(k)}; });
    result.add(judge.judged_starts(statuses));
    return result;
}

std::string place_of(const EmittedInType& type) {
    std::vector<std::string> inputs;
    for (const auto& [name, value] : type.at) inputs.push_back(fmt::format("{} = {:.17g}", name, value));
    return fmt::format("{}", fmt::join(inputs, ", "));
}

std::string line_of(const EmittedInType& type) {
    std::string line = fmt::format("    {:<12}", type.type);
    if (!type.has_seen())
        return line + fmt::format("nothing compared: 0 of {} points answered with numbers\n", type.points);
    if (!type.statuses.empty())
        line += type.statuses;
    else
        line += fmt::format("{:.3g} ulp of {}", type.ulp, type.output);
    if (type.phase_share > 0)
        line += fmt::format(", {:.0f} % of the scale there for a phase that the slow flow moves",
                            100 * type.phase_share);
    return line + fmt::format(" ({} of {} points answered), {} at {}\n", type.compared, type.points,
                              type.form, place_of(type));
}

} // namespace

Verdict verdict_of(const std::vector<EmittedInType>& types, double threshold) {
    for (const EmittedInType& type : types)
        if (type.has_seen() && !(type.ulp <= threshold)) return Verdict::fail;
    for (const EmittedInType& type : types)
        if (static_cast<double>(type.compared) < compared_share * static_cast<double>(type.points))
            return Verdict::undecided;
    return Verdict::pass;
}

double EmittedCheck::worst() const {
    double most = std::numeric_limits<double>::quiet_NaN();
    for (const EmittedInType& type : types) most = std::fmax(most, type.ulp); // the first is no number
    return most;
}

EmittedCheck check_emitted(const Program& program, const std::shared_ptr<const EvaluatorLibrary>& library,
                           const Solution& solution, const Scene& scene, const EmittedCheckOptions& options) {
    const auto begin = std::chrono::steady_clock::now();
    EmittedCheck check;
    check.threshold = scene.verify.ulp;
    check.reason = scene.verify.ulp_reason;
    const auto symbolic = std::make_shared<const SymbolicSolution>(solution, scene);
    const bool is_flow = solution.flow != nullptr;
    check.types.push_back(in_type<double>(program, library, symbolic, scene, is_flow, in_double(options)));
    check.types.push_back(in_type<long double>(program, library, symbolic, scene, is_flow, options));
    check.verdict = verdict_of(check.types, check.threshold);
    if (options.progress)
        options.progress(
            fmt::format("emitted code held against the exact solution in {:.1f} s",
                        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()));
    return check;
}

std::string to_text(const EmittedCheck& check) {
    std::string text = fmt::format("  emitted = symbolic: {}, threshold {:g} ulp of the output's scale",
                                   to_string(check.verdict), check.threshold);
    if (check.threshold > default_ulp)
        text += check.reason.empty() ? ", widened without a reason" : ", widened: " + check.reason;
    text += "\n";
    for (const EmittedInType& type : check.types) text += line_of(type);
    return text;
}

} // namespace resonform
