// SPDX-License-Identifier: GPL-3.0-or-later
// Emitted code in one real type at the points that it is judged at, and the exact solution there. The exact
// values are computed once, for however many answers of the code.
#pragma once

#include "verify/evaluate/evaluator.hpp"
#include "verify/judging/emitted_forms.hpp"
#include "verify/judging/emitted_points.hpp"
#include "verify/symbolic/table.hpp"

#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace resonform {

// Real: double, long double.
template <class Real> class EmittedJudge {
public:
    using Answers = std::vector<EmittedAnswers<Real>>;
    static constexpr double unlimited = std::numeric_limits<double>::infinity();

    // Computes the exact values; all must outlive it. Precondition: as check_emitted.
    EmittedJudge(const Program& program, std::shared_ptr<const EvaluatorLibrary> library,
                 std::shared_ptr<const SymbolicSolution> symbolic, const Scene& scene, bool is_flow,
                 const EmittedCheckOptions& options);

    // Of the code as it is now, at one start, in every form that the library has. May run beside itself.
    [[nodiscard]] Answers answers_at(std::size_t start) const {
        return answers_at(start, program_, library_);
    }
    // At its first time alone.
    [[nodiscard]] Answers first_answers_at(std::size_t start) const {
        return answers_of<Real>({program_, library_}, drawn_[start].at_first_time(), start);
    }
    // Of other code with the same outputs.
    [[nodiscard]] Answers answers_at(std::size_t start, const Program& program,
                                     const std::shared_ptr<const EvaluatorLibrary>& library) const {
        return answers_of<Real>({program, library}, drawn_[start], start);
    }
    [[nodiscard]] Answers answers() const; // at all
    [[nodiscard]] std::size_t starts() const { return drawn_.size(); }

    // These answers against the exact solution. It ends with a difference of more than `enough` ulp.
    [[nodiscard]] EmittedInType judged(const Answers& answers, double enough = unlimited);

    // Further starts, of which only the status at t = 0 is compared. They are drawn, and their exact statuses
    // found, when their number is asked for.
    [[nodiscard]] std::size_t further_starts();
    // Of the code as it is now.
    [[nodiscard]] Status status_at_start(std::size_t k) const {
        return status_at_0<Real>({program_, library_}, starts_[k].drawn);
    }
    // statuses: of some of them, by their numbers.
    [[nodiscard]] EmittedInType judged_starts(const std::vector<std::pair<std::size_t, Status>>& statuses,
                                              double enough = unlimited);

    // The largest difference between answers, a at the first times of b or all, in ulp of the output's scale,
    // where both are numbers; infinite where only one is, unless that is low_precision.
    struct Difference {
        double ulp = 0;
        std::size_t output = 0; // there
    };
    [[nodiscard]] Difference difference(const Answers& a, const Answers& b) const;

private:
    using Points = EmittedPoints<Real>;
    struct Start { // of which the status at t = 0 is compared
        Points drawn;
        SymbolicPoints asked;
        Status exact; // as far as the start says
    };

    [[nodiscard]] bool takes(const std::string& canonical) const;
    [[nodiscard]] SymbolicPoints asked_of(const Points& d) const;
    [[nodiscard]] double phase_blur(EmittedForm form) const;

    void begin();
    [[nodiscard]] bool has_seen_more_than(double ulp) const {
        return result_.has_seen() && !(result_.ulp <= ulp);
    }
    [[nodiscard]] EmittedInType end();
    [[nodiscard]] std::size_t compare(const EmittedAnswers<Real>& answers, double enough);
    void compare_start(const Start& start, Status emitted);
    [[nodiscard]] bool at_edge(Status status, const SymbolicPoint& exact, const SymbolicPoints& asked, Real t,
                               std::unique_ptr<SymbolicEvaluator>& beside) const;
    void disagree(Status emitted, Status exact, EmittedForm form, const Points& drawn, Real t);
    void record(double ulp, double phase_share, const std::string& output, EmittedForm form,
                const Points& drawn, Real t, const std::string& statuses);

    const Program& program_;
    std::shared_ptr<const EvaluatorLibrary> library_;
    std::shared_ptr<const SymbolicSolution> symbolic_;
    const Scene& scene_;
    bool is_flow_;
    EmittedCheckOptions options_;
    int most_modes_; // of a term, as factors
    std::vector<Points> drawn_;
    std::vector<SymbolicPoints> asked_;
    std::vector<std::vector<SymbolicPoint>> exact_; // [start][time]
    std::vector<Start> starts_;
    EmittedInType result_;
};

extern template class EmittedJudge<double>;
extern template class EmittedJudge<long double>;

} // namespace resonform
