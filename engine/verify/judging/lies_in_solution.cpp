// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/error.hpp"
#include "emit/program/build_program.hpp"
#include "solve/flow/named_parts.hpp"
#include "verify/judging/descent.hpp"
#include "verify/judging/emitted_judge.hpp"
#include "verify/judging/guarantee.hpp"
#include "verify/judging/lies.hpp"
#include "verify/judging/order_of_starts.hpp"
#include "verify/judging/trial.hpp"
#include "verify/run/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

namespace {

// judged: the outputs of which the ladder judges every term, and their claims. Where there is none, no part
// is lied about.
std::vector<NamedPart<Solution>> named_parts(const Solution& solution, const Claims& judged) {
    NamedParts<Solution> parts;
    if (judged.empty()) return {};
    parts.add_each(solution, &Solution::modes, numbered("phase rate"), &ModeSolution::phase_rate);
    parts.add_each(
        solution, &Solution::primitives, [&](std::size_t k) { return solution.primitives[k].name; },
        &Primitive::argument);
    for (std::size_t k = 0; k < solution.outputs.size(); ++k)
        if (judged.count(solution.outputs[k].name) > 0)
            parts.add(solution.outputs[k].name, solution.outputs[k].value,
                      [k](Solution& s) -> Series& { return s.outputs[k].value; });
    return parts.all();
}

// The polynomial with the other sign of its k-th term; of one that is real, also of the term's conjugate, so
// that it stays real: once for both, nullopt for the second.
std::optional<Polynomial> with_lie(const Ring& ring, const Polynomial& truth, std::size_t k) {
    const Polynomial term = Polynomial::from_terms({truth.terms()[k]});
    const Polynomial conjugate = ring.conjugate(term);
    if (conjugate == term || !(ring.conjugate(truth) == truth)) return truth - Rational(2) * term;
    for (std::size_t before = 0; before < k; ++before)
        if (truth.terms()[before].monomial == conjugate.terms().front().monomial) return std::nullopt;
    return truth - Rational(2) * (term + conjugate);
}

// The ladder, rung by rung, as verify goes down it.
class LadderOfLies {
public:
    LadderOfLies(std::shared_ptr<const FirstOrderSystem> system, const Scene& scene, VerifyOptions options)
        : system_(std::move(system)), scene_(scene), options_(std::move(options)) {
        options_.compiled = false;
        options_.progress = nullptr;
    }

    void learn(const Solution& honest) {
        Verification result;
        honest_ = descended(honest, result, roundings_, [](const Verdicts&) { return false; });
        for (const OutputVerdict& output : result.outputs)
            if (output.expected == Verdict::pass && output.claimed_order > scene_.order)
                judged_[output.name] = output.claimed_order;
    }
    // The outputs that are to pass and whose claim leaves no term of theirs out, as that of a mean motion
    // does.
    [[nodiscard]] const Claims& judged() const { return judged_; }
    // An output fails after a rung after which it honestly does not, or does not pass in the end though it
    // honestly does.
    [[nodiscard]] bool catches(const Solution& lie) const {
        Verification result;
        Descent::Roundings roundings = roundings_;
        const auto so_far = [&](const Verdicts& found) { return fails(found); };
        const Verdicts found = descended(lie, result, roundings, so_far);
        if (fails(found)) return true;
        for (std::size_t k = 0; k < found.back().size(); ++k)
            if (found.back()[k] != Verdict::pass && honest_.back()[k] == Verdict::pass) return true;
        return false;
    }

private:
    using Verdicts = std::vector<std::vector<Verdict>>; // of each output, after each rung

    [[nodiscard]] bool fails(const Verdicts& found) const {
        const std::vector<Verdict>&here = found.back(),
              &honestly = honest_[std::min(found.size(), honest_.size()) - 1];
        for (std::size_t k = 0; k < here.size(); ++k)
            if (here[k] == Verdict::fail && honestly[k] != Verdict::fail) return true;
        return false;
    }

    template <class Enough>
    Verdicts descended(const Solution& solution, Verification& result, Descent::Roundings& roundings,
                       const Enough& enough) const {
        const Trial trial(system_, scene_, solution, options_);
        Descent descent(trial, scene_, solution, result);
        descent.know(roundings);
        Verdicts found;
        const auto note = [&] {
            weigh_defects(result);
            found.emplace_back();
            for (const OutputVerdict& output : result.outputs) found.back().push_back(output.verdict);
            return enough(found);
        };
        bool ends = false;
        for (const Rational& eps : scene_.verify.eps) {
            descent.along({eps});
            if ((ends = note())) break;
        }
        if (!ends && !scene_.verify.eps_given) {
            descent.further();
            note();
        }
        roundings = descent.roundings();
        return found;
    }

    std::shared_ptr<const FirstOrderSystem> system_;
    const Scene& scene_;
    VerifyOptions options_;
    Verdicts honest_;
    Descent::Roundings roundings_; // of the honest solution
    Claims judged_;
};

// How far interpreted code with a lie is from that without.
class EffectOfLies {
public:
    EffectOfLies(const Scene& scene, const Solution& solution, const VerifyOptions& options)
        : scene_(scene), honest_(solution, scene),
          judge_(*honest_.program, honest_.library, std::make_shared<const SymbolicSolution>(solution, scene),
                 scene, false, {options.cache, {}, options.emitted_starts}),
          order_(judge_.starts()) {
        for (std::size_t j = 0; j < judge_.starts(); ++j) answers_.push_back(judge_.answers_at(j));
    }

    // The largest; of one that is more than `enough`, up to where it is.
    void measure(const Solution& solution, Lie& lie, double enough) {
        const Interpreted lying(solution, scene_);
        Judge::Difference most;
        const auto is_enough = [&](std::size_t j, const Judge::Answers& answers) {
            const Judge::Difference here = judge_.difference(answers, answers_[j]);
            if (here.ulp > most.ulp) most = here;
            return most.ulp > enough;
        };
        order_.ends([](std::size_t) { return true; }, side_by_side(),
                    [&](std::size_t j) { return judge_.answers_at(j, *lying.program, lying.library); },
                    is_enough);
        lie.effect_ulp = most.ulp;
        lie.output = honest_.program->outputs[most.output].name;
    }

private:
    using Judge = EmittedJudge<double>;
    struct Interpreted {
        Interpreted(const Solution& solution, const Scene& scene)
            : program(std::make_shared<const Program>(build_program(solution, scene, {true, false, false}))),
              library(EvaluatorLibrary::interpreted(program)) {}
        std::shared_ptr<const Program> program;
        std::shared_ptr<const EvaluatorLibrary> library;
    };

    const Scene& scene_;
    Interpreted honest_;
    Judge judge_;
    OrderOfStarts order_;
    std::vector<Judge::Answers> answers_; // of each start
};

// Sets the effect, and whether the ladder sees it.
void try_lie(const Solution& lying, EffectOfLies& effect, const LadderOfLies& ladder, double enough,
             Lie& lie) {
    try {
        effect.measure(lying, lie, enough);
        const bool is_clear = lie.effect_ulp > enough;
        if (is_clear && ladder.catches(lying))
            lie.caught_by = "ladder";
        else if (is_clear)
            effect.measure(lying, lie, EmittedJudge<double>::unlimited);
    } catch (const Error&) { // there is no start, or no program: verify would end with it
        lie.caught_by = "ladder";
    }
}

} // namespace

void lies_in_solution(const std::shared_ptr<const FirstOrderSystem>& system, const Scene& scene,
                      const Solution& solution, const VerifyOptions& options, Lies& lies) {
    EffectOfLies effect(scene, solution, options);
    LadderOfLies ladder(system, scene, options);
    ladder.learn(solution);
    for (const NamedPart<Solution>& part : named_parts(solution, ladder.judged()))
        for (std::size_t term = 0; term < part.truth.size(); ++term) {
            const std::optional<Polynomial> p = with_lie(*solution.ring, part.truth, term);
            if (!p) continue;
            Solution lying = solution;
            part.put(lying, *p);
            Lie lie{"", fmt::format("solution, {}, term {}", part.name, term + 1), "sign"};
            try_lie(lying, effect, ladder, lies.clear_of_threshold(), lie);
            lies.all.push_back(std::move(lie));
        }
}

} // namespace resonform
