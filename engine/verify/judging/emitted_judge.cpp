// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judging/emitted_judge.hpp"

#include "model/system/start_names.hpp"
#include "verify/evaluate/ensemble.hpp"
#include "verify/run/parallel.hpp"
#include "verify/symbolic/ulp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace resonform {

namespace {

constexpr int little_room = 70; // powers of e: of squares and amplitudes
// Times as many starts, of which the status at t = 0 is compared; the rules are the same in all types, and
// to construct is dear in the longer ones.
template <class Real> constexpr std::size_t starts_only = 5;
template <> constexpr std::size_t starts_only<double> = 40;
constexpr double shortened = 1e-3; // of the interval: their tables would take most of the time

template <class Real> constexpr const char* type_name = "double";
template <> constexpr const char* type_name<long double> = "long double";

double share(const Wide& part, const Wide& whole) {
    return whole > 0 ? static_cast<double>(Wide(part / whole)) : 0;
}

// The most modes that a term of an output has as factors: of weight 0 they may be more than weights are kept.
int most_modes(const SymbolicSolution& symbolic) {
    std::set<GeneratorId> modes;
    for (const SymbolicVariable& v : symbolic.variables())
        if (v.kind == SymbolicVariable::Kind::mode) modes.insert({v.id, v.conjugate});
    int most = 0;
    for (const SymbolicOutput& output : symbolic.outputs())
        for (const SymbolicTerm& term : output.sum) {
            int count = 0;
            for (const auto& [id, power] : term.powers) count += modes.count(id) > 0 ? power : 0;
            most = std::max(most, count);
        }
    return most;
}

// No answer is wrong there: the form knows no end of an interval.
bool is_open(EmittedForm form, const SymbolicPoint& exact) {
    return is_final_point(form) && exact.status == Status::outside_interval;
}

bool agree(Status emitted, Status exact) {
    return emitted == exact || (emitted == Status::low_precision && exact == Status::ok);
}

} // namespace

template <class Real>
EmittedJudge<Real>::EmittedJudge(const Program& program, std::shared_ptr<const EvaluatorLibrary> library,
                                 std::shared_ptr<const SymbolicSolution> symbolic, const Scene& scene,
                                 bool is_flow, const EmittedCheckOptions& options)
    : program_(program), library_(std::move(library)), symbolic_(std::move(symbolic)), scene_(scene),
      is_flow_(is_flow), options_(options),
      most_modes_(std::max(program_.truncation, most_modes(*symbolic_))),
      drawn_(emitted_points<Real>(scene, options.starts, options.times, options.seed)) {
    for (const Points& d : drawn_) asked_.push_back(asked_of(d));
    if (options_.progress)
        options_.progress(fmt::format("emitted code in {} against the exact solution: {} starts, {} times "
                                      "of each",
                                      type_name<Real>, options_.starts, options_.times));
    exact_ = symbolic_values(symbolic_, asked_, options_.cache, options_.progress);
}

template <class Real> bool EmittedJudge<Real>::takes(const std::string& canonical) const {
    return std::any_of(program_.start.begin(), program_.start.end(),
                       [&](const ProgramInput& input) { return input.canonical == canonical; });
}

template <class Real> SymbolicPoints EmittedJudge<Real>::asked_of(const Points& d) const {
    SymbolicPoints points{{Wide(d.eps), {}, {}, Wide(d.end), {}}, {d.times.begin(), d.times.end()}};
    for (const auto& [point, i] : d.grid.places)
        points.times.push_back(Wide(d.grid.t0) + static_cast<long>(i) * Wide(d.grid.dt));
    for (const auto& [name, value] : d.start) {
        points.inputs.start.emplace(name, Wide(value));
        if (!takes(name)) points.inputs.untaken.insert(name);
    }
    return points;
}

template <class Real> typename EmittedJudge<Real>::Answers EmittedJudge<Real>::answers() const {
    Answers all;
    for (std::size_t j = 0; j < drawn_.size(); ++j)
        for (EmittedAnswers<Real>& answers : answers_at(j)) all.push_back(std::move(answers));
    return all;
}

template <class Real> void EmittedJudge<Real>::begin() {
    result_ = {};
    result_.type = type_name<Real>;
}

template <class Real> EmittedInType EmittedJudge<Real>::end() {
    if (!result_.has_seen()) result_.ulp = std::numeric_limits<double>::quiet_NaN();
    return result_;
}

template <class Real> EmittedInType EmittedJudge<Real>::judged(const Answers& answers, double enough) {
    begin();
    for (std::size_t j = 0; j < answers.size() && !has_seen_more_than(enough); ++j) {
        const std::size_t compared = compare(answers[j], enough);
        if (j > 0 && answers[j].start == answers[j - 1].start) continue; // the same points again
        result_.points += answers[j].statuses.size();
        result_.compared += compared;
    }
    return end();
}

template <class Real> std::size_t EmittedJudge<Real>::further_starts() {
    if (!starts_.empty()) return starts_.size();
    for (Points& d :
         emitted_points<Real>(scene_, starts_only<Real> * options_.starts, 0, options_.seed + 1)) {
        d.end *= Real(shortened);
        const SymbolicPoints asked = asked_of(d);
        starts_.push_back({d, asked, Status::ok});
    }
    in_parallel(starts_.size(), [&](std::size_t k) {
        starts_[k].exact = symbolic_->start().at(starts_[k].asked.inputs).status;
    });
    return starts_.size();
}

template <class Real>
EmittedInType EmittedJudge<Real>::judged_starts(const std::vector<std::pair<std::size_t, Status>>& statuses,
                                                double enough) {
    begin();
    for (const auto& [k, status] : statuses) {
        if (has_seen_more_than(enough)) break;
        compare_start(starts_[k], status);
    }
    return end();
}

template <class Real>
typename EmittedJudge<Real>::Difference EmittedJudge<Real>::difference(const Answers& a,
                                                                       const Answers& b) const {
    Difference most;
    const auto see = [&](double ulp, std::size_t output) {
        if (ulp > most.ulp) most = {ulp, output};
    };
    for (std::size_t j = 0; j < a.size(); ++j) {
        const double blur = 2 * phase_blur(a[j].form); // of the one and the other
        for (std::size_t i = 0; i < a[j].statuses.size(); ++i) {
            const SymbolicPoint& exact = exact_[a[j].start][a[j].times[i]];
            if (!is_open(a[j].form, exact) && has_numbers(a[j].status(i)) != has_numbers(b[j].status(i)))
                see(std::numeric_limits<double>::infinity(), most.output);
            if (exact.status != Status::ok || a[j].status(i) != Status::ok || b[j].status(i) != Status::ok)
                continue;
            for (std::size_t k = 0; k < a[j].values.size(); ++k)
                if (a[j].values[k][i] != b[j].values[k][i])
                    see(in_ulp<Real>(a[j].values[k][i], Wide(b[j].values[k][i]), exact.scales[k]) - blur, k);
        }
    }
    return most;
}

// Whether the map leads back to its start is asked at t = 0 only, and few starts fail: of many, the
// status there. Where the exact start says another one, the whole exact solution is asked.
template <class Real> void EmittedJudge<Real>::compare_start(const Start& start, Status status) {
    if (agree(status, start.exact)) return;
    std::unique_ptr<SymbolicEvaluator> beside;
    const SymbolicPoint exact = SymbolicEvaluator(symbolic_, start.asked.inputs, Wide(0))(Wide(0));
    if (!agree(status, exact.status) && !at_edge(status, exact, start.asked, Real(0), beside))
        disagree(status, exact.status, EmittedForm::call, start.drawn, Real(0));
}

// What an error of phases that a form is allowed may make of an output, in ulp of its scale.
template <class Real> double EmittedJudge<Real>::phase_blur(EmittedForm form) const {
    if (form != EmittedForm::quick_ensemble) return 0;
    return most_modes_ * quick_phase_error / static_cast<double>(std::numeric_limits<Real>::epsilon());
}

// How many values are compared.
template <class Real>
std::size_t EmittedJudge<Real>::compare(const EmittedAnswers<Real>& answers, double enough) {
    const Points& drawn = drawn_[answers.start];
    const SymbolicPoints& asked = asked_[answers.start];
    const double blur = phase_blur(answers.form);
    std::unique_ptr<SymbolicEvaluator> beside; // for times beside those asked for
    std::size_t compared = 0;
    for (std::size_t i = 0; i < answers.times.size(); ++i) {
        if (has_seen_more_than(enough)) break;
        const Real t = static_cast<Real>(asked.times[answers.times[i]]);
        const SymbolicPoint& exact = exact_[answers.start][answers.times[i]];
        const Status status = answers.status(i);
        if (!agree(status, exact.status)) {
            if (!is_open(answers.form, exact) && !at_edge(status, exact, asked, t, beside))
                disagree(status, exact.status, answers.form, drawn, t);
            continue;
        }
        if (exact.status != Status::ok || status == Status::low_precision) continue;
        ++compared;
        for (std::size_t k = 0; k < answers.values.size(); ++k) {
            const double ulp = in_ulp<Real>(answers.values[k][i], exact.values[k], exact.scales[k]);
            record(std::fmax(0, ulp - blur), share(exact.phase_parts[k], exact.scales[k]),
                   program_.outputs[k].name, answers.form, drawn, t, "");
        }
    }
    return compared;
}

// The symbolic status changes to the emitted one within 4 ulp of t, a value is beyond the range of Real,
// or a phase beyond what Real knows of it.
template <class Real>
bool EmittedJudge<Real>::at_edge(Status status, const SymbolicPoint& exact, const SymbolicPoints& asked,
                                 Real t, std::unique_ptr<SymbolicEvaluator>& beside) const {
    if (status == Status::overflow)
        for (const Wide& value : exact.values)
            if (abs(value) > Wide(std::numeric_limits<Real>::max())) return true;
    if (!beside)
        beside = std::make_unique<SymbolicEvaluator>(symbolic_, asked.inputs, asked.inputs.slow_time_end);
    if (status == Status::overflow) { // a power of a mode may be, though no value is
        for (const Wide& chi : beside->exponents(Wide(t)))
            if (most_modes_ * chi > log(Wide(std::numeric_limits<Real>::max())) - little_room) return true;
    }
    if (status == Status::outside_interval && exact.status == Status::ok &&
        beside->loses_phase(Wide(t), asked.inputs.slow_time_end / asked.inputs.eps,
                            phase_resolution<Real>(is_flow_)))
        return true;
    const auto times = times_at_edge(t);
    return std::any_of(times.begin(), times.end(),
                       [&](const Wide& time) { return (*beside)(time).status == status; });
}

template <class Real>
void EmittedJudge<Real>::disagree(Status emitted, Status exact, EmittedForm form, const Points& drawn,
                                  Real t) {
    record(std::numeric_limits<double>::infinity(), 0, "", form, drawn, t,
           fmt::format("emitted {}, symbolic {}", to_string(emitted), to_string(exact)));
}

template <class Real>
void EmittedJudge<Real>::record(double ulp, double phase_share, const std::string& output, EmittedForm form,
                                const Points& drawn, Real t, const std::string& statuses) {
    if (result_.has_seen() && !(ulp > result_.ulp)) return;
    result_.ulp = ulp;
    result_.phase_share = phase_share;
    result_.output = output;
    result_.form = to_string(form);
    result_.statuses = statuses;
    result_.at = {{"eps", static_cast<double>(drawn.eps)}};
    for (const auto& [name, value] : drawn.start)
        result_.at.emplace_back(user_start(name, *scene_.system), static_cast<double>(value));
    result_.at.emplace_back("t", static_cast<double>(t));
}

template class EmittedJudge<double>;
template class EmittedJudge<long double>;

} // namespace resonform
