// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/cpp/lies.hpp"
#include "emit/program/build_program.hpp"
#include "verify/judging/emitted_check.hpp"
#include "verify/judging/emitted_judge.hpp"
#include "verify/judging/emitted_points.hpp"
#include "verify/judging/lies.hpp"
#include "verify/judging/order_of_starts.hpp"
#include "verify/run/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

namespace resonform {

namespace {

constexpr std::size_t longest_term = 80;
constexpr std::size_t told_after = 500; // lies
constexpr std::size_t starts_at_a_time = 64;
// As lie_kinds has them.
constexpr int other_sign = 1, a_little_more = 2;
constexpr unsigned char listening = 3, heard = 4;
// Of the emitted class: asked once for each construction, whatever the time, and by statuses alone.
constexpr std::string_view conditions_of_start = "start_conditions";

using Judge = EmittedJudge<double>;

std::string place_name(const CppLies::Place& place) {
    const bool is_long = place.coefficient.size() > longest_term;
    return fmt::format("{}: {}{}", place.function, place.coefficient.substr(0, longest_term),
                       is_long ? "..." : "");
}

// By number of a start: for each place whether the code asks for the coefficient there. A lie that is not
// asked for changes nothing.
using AskedFor = std::vector<std::vector<bool>>;

// The code of a scene with all its lies, and the points at which it is asked.
class PlantedCode {
public:
    PlantedCode(const Scene& scene, const Solution& solution, const VerifyOptions& options)
        : program_(build_program(solution, scene, {true, false, true})),
          library_(EvaluatorLibrary::build(program_, options.cache, options.progress, "dfe", &planted_)),
          symbolic_(std::make_shared<const SymbolicSolution>(solution, scene)), threshold_(scene.verify.ulp),
          told_(reinterpret_cast<unsigned char* (*)()>(library_->object()->symbol("rf_lies"))()),
          check_(program_, library_, symbolic_, scene, solution.flow != nullptr,
                 in_double({options.cache, options.progress, options.emitted_starts})),
          order_(check_.starts()), order_of_further_(check_.further_starts()) {
        listen();
    }

    [[nodiscard]] const std::vector<CppLies::Place>& places() const { return planted_.places(); }
    [[nodiscard]] bool honest_passes() const { return honest_passes_; }

    // place: from 1; kind: as lie_kinds has it.
    Lie tried(std::size_t place, int kind) {
        Lie lie{"", place_name(places()[place - 1]), kind == other_sign ? "sign" : "2^-20"};
        told_[place] = static_cast<unsigned char>(kind);
        if (is_caught_at_points(place, lie) || is_caught_at_start(place)) lie.caught_by = "emitted = exact";
        told_[place] = 0;
        return lie;
    }

private:
    using Statuses = std::vector<std::pair<std::size_t, Status>>;

    [[nodiscard]] Verdict verdict(const EmittedInType& found) const {
        return verdict_of({found}, threshold_);
    }

    // Records what the honest code answers at each start, and which coefficients it reads on the way.
    void listen() {
        EmittedInType all;
        for (std::size_t j = 0; j < check_.starts(); ++j) {
            asked_.push_back(asked_during([&] { honest_.push_back(check_.answers_at(j)); }));
            honestly_.push_back(check_.judged(honest_.back()));
            all.add(honestly_.back());
        }
        for (std::size_t k = 0; k < check_.further_starts(); ++k)
            asked_of_further_.push_back(asked_during([&] { status_.push_back(check_.status_at_start(k)); }));
        Statuses statuses;
        for (std::size_t k = 0; k < status_.size(); ++k) statuses.emplace_back(k, status_[k]);
        all.add(check_.judged_starts(statuses));
        honest_passes_ = verdict(all) == Verdict::pass;
    }

    template <class Ask> [[nodiscard]] std::vector<bool> asked_during(const Ask& ask) {
        const std::size_t count = places().size();
        std::fill(told_ + 1, told_ + count + 1, listening);
        ask();
        std::vector<bool> asked{false};
        for (std::size_t place = 1; place <= count; ++place) asked.push_back(told_[place] == heard);
        std::fill(told_ + 1, told_ + count + 1, 0);
        return asked;
    }

    // Sets the effect: the largest, of a lie that is caught up to where it is.
    [[nodiscard]] bool is_caught_at_points(std::size_t place, Lie& lie) {
        EmittedInType all;
        Judge::Difference effect;
        const auto is_caught = [&](std::size_t j, const Judge::Answers& answers) {
            const EmittedInType found = check_.judged(answers, threshold_);
            all.add(found);
            const Judge::Difference here = check_.difference(answers, honest_[j]);
            if (here.ulp > effect.ulp) effect = here;
            return verdict(found) == Verdict::fail;
        };
        const bool once = places()[place - 1].function == conditions_of_start;
        const bool caught = order_.ends(
            [&](std::size_t j) { return asked_[j][place]; }, side_by_side(),
            [&](std::size_t j) { return once ? check_.first_answers_at(j) : check_.answers_at(j); },
            is_caught);
        lie.effect_ulp = effect.ulp;
        lie.output = program_.outputs[effect.output].name;
        for (std::size_t j = 0; j < asked_.size(); ++j)
            if (!asked_[j][place]) all.add(honestly_[j]);
        return caught || verdict(all) != Verdict::pass;
    }

    [[nodiscard]] bool is_caught_at_start(std::size_t place) {
        const auto is_caught = [&](std::size_t k, Status status) {
            return status != status_[k] &&
                   verdict(check_.judged_starts({{k, status}}, threshold_)) == Verdict::fail;
        };
        return order_of_further_.ends([&](std::size_t k) { return asked_of_further_[k][place]; },
                                      starts_at_a_time,
                                      [&](std::size_t k) { return check_.status_at_start(k); }, is_caught);
    }

    CppLies planted_;
    Program program_;
    std::shared_ptr<const EvaluatorLibrary> library_;
    std::shared_ptr<const SymbolicSolution> symbolic_;
    double threshold_;
    unsigned char* told_;
    Judge check_;
    OrderOfStarts order_, order_of_further_;
    AskedFor asked_, asked_of_further_;
    std::vector<Judge::Answers> honest_; // of each start
    std::vector<EmittedInType> honestly_;
    std::vector<Status> status_; // of each further start
    bool honest_passes_ = false;
};

} // namespace

void lies_in_emitted(const Scene& scene, const Solution& solution, const VerifyOptions& options, Lies& lies) {
    PlantedCode code(scene, solution, options);
    lies.honest_fails = !code.honest_passes();
    const std::size_t count = code.places().size();
    for (std::size_t place = 1; place <= count; ++place) {
        for (const int kind : {other_sign, a_little_more}) lies.all.push_back(code.tried(place, kind));
        if (options.progress && place % told_after == 0)
            options.progress(fmt::format("lies in emitted code: {} of {} places", place, count));
    }
}

} // namespace resonform
