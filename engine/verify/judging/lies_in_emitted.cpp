// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp/lies.hpp"
#include "emit/program/build_program.hpp"
#include "verify/judging/emitted_check.hpp"
#include "verify/judging/emitted_judge.hpp"
#include "verify/judging/emitted_points.hpp"
#include "verify/judging/lies.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

namespace resonform {

namespace {

constexpr std::size_t longest_term = 80;
constexpr std::size_t told_after = 500; // lies

using Judge = EmittedJudge<double>;

std::string place_name(const CppLies::Place& place) {
    const bool is_long = place.coefficient.size() > longest_term;
    return fmt::format("{}: {}{}", place.function, place.coefficient.substr(0, longest_term),
                       is_long ? "..." : "");
}

// The code of a scene with all its lies, and the points at which it is asked.
class PlantedCode {
public:
    PlantedCode(const Scene& scene, const Solution& solution, const VerifyOptions& options)
        : program_(build_program(solution, scene, {true, false, true})),
          library_(EvaluatorLibrary::build(program_, options.cache, options.progress, "d", &planted_)),
          symbolic_(std::make_shared<const SymbolicSolution>(solution, scene)), scene_(scene),
          tell_(reinterpret_cast<Tell>(library_->object()->symbol("rf_lie"))),
          check_(program_, library_, symbolic_, scene, solution.flow != nullptr,
                 in_double({options.cache, options.progress, options.emitted_starts})),
          honest_(check_.answers()) {}

    [[nodiscard]] const std::vector<CppLies::Place>& places() const { return planted_.places(); }
    [[nodiscard]] bool honest_passes() { return passes(honest_); }

    // place: from 1; kind: that of rf_lie.
    Lie tried(std::size_t place, int kind) {
        Lie lie{"", place_name(places()[place - 1]), kind == 1 ? "sign" : "2^-20"};
        tell_(static_cast<int>(place), kind);
        const Judge::Answers answers = check_.answers();
        if (!passes(answers)) lie.caught_by = "emitted = exact";
        tell_(0, 0);
        const Judge::Difference effect = check_.difference(answers, honest_);
        lie.effect_ulp = effect.ulp;
        lie.output = program_.outputs[effect.output].name;
        return lie;
    }

private:
    using Tell = void (*)(int place, int kind);

    [[nodiscard]] bool passes(const Judge::Answers& answers) {
        const double threshold = scene_.verify.ulp;
        return verdict_of({check_.judged(answers, threshold)}, threshold) == Verdict::pass;
    }

    CppLies planted_;
    Program program_;
    std::shared_ptr<const EvaluatorLibrary> library_;
    std::shared_ptr<const SymbolicSolution> symbolic_;
    const Scene& scene_;
    Tell tell_;
    Judge check_;
    Judge::Answers honest_;
};

} // namespace

void lies_in_emitted(const Scene& scene, const Solution& solution, const VerifyOptions& options, Lies& lies) {
    PlantedCode code(scene, solution, options);
    lies.honest_fails = !code.honest_passes();
    const std::size_t count = code.places().size();
    for (std::size_t place = 1; place <= count; ++place) {
        for (const int kind : {1, 2}) lies.all.push_back(code.tried(place, kind));
        if (options.progress && place % told_after == 0)
            options.progress(fmt::format("lies in emitted code: {} of {} places", place, count));
    }
}

} // namespace resonform
