// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judging/emitted_forms.hpp"

#include "verify/evaluate/ensemble.hpp"
#include "verify/evaluate/program_defaults.hpp"

#include <numeric>
#include <type_traits>
#include <utility>

namespace resonform {

namespace {

template <class Real>
std::vector<Real> start_of(const EmittedProgram& code, const EmittedPoints<Real>& points) {
    std::vector<Real> start;
    for (const ProgramInput& input : code.program.start) start.push_back(points.start_of(input.canonical));
    return start;
}

template <class Real>
Evaluator<Real> evaluator(const EmittedProgram& code, const EmittedPoints<Real>& points) {
    return {code.library, points.eps, default_parameters<Real>(code.program, points.eps),
            start_of(code, points), points.end};
}

// For so many times, in their order.
template <class Real>
EmittedAnswers<Real> room(const EmittedProgram& code, EmittedForm form, std::size_t start,
                          std::size_t count) {
    EmittedAnswers<Real> answers{
        start, form, std::vector<std::size_t>(count), std::vector<unsigned char>(count),
        std::vector<std::vector<Real>>(code.program.outputs.size(), std::vector<Real>(count))};
    std::iota(answers.times.begin(), answers.times.end(), std::size_t(0));
    return answers;
}

// call(t, values) -> Status
template <class Real, class Call>
void ask_one_by_one(const EmittedPoints<Real>& points, EmittedAnswers<Real>& answers, const Call& call) {
    std::vector<Real> values(answers.values.size());
    for (std::size_t i = 0; i < points.times.size(); ++i) {
        answers.statuses[i] = static_cast<unsigned char>(call(points.times[i], values.data()));
        for (std::size_t k = 0; k < values.size(); ++k) answers.values[k][i] = values[k];
    }
}

// Sets the answers at the points of the grid that are judged.
void ask_grid(const EmittedProgram& code, const Evaluator<double>& emitted,
              const EmittedPoints<double>& points, EmittedAnswers<double>& answers) {
    EmittedAnswers<double> whole = room<double>(code, answers.form, answers.start, grid_points);
    emitted.grid(points.grid.t0, points.grid.dt, arrays_of(whole.values), whole.statuses);
    for (const auto& [point, place] : points.grid.places) {
        answers.times.push_back(point);
        answers.statuses.push_back(whole.statuses[place]);
        for (std::size_t k = 0; k < whole.values.size(); ++k)
            answers.values[k].push_back(whole.values[k][place]);
    }
}

void ask_final_points(const EmittedProgram& code, const EmittedPoints<double>& points,
                      EmittedAnswers<double>& answers) {
    const FinalPointLibrary library(code.library);
    const std::vector<double> parameters = default_parameters<double>(code.program, points.eps),
                              arguments = start_of(code, points);
    ask_one_by_one(points, answers, [&](double t, double* values) {
        return library.at_end(points.eps, parameters.data(), arguments.data(), t, values);
    });
}

void ask_members(const EmittedProgram& code, const EmittedPoints<double>& points,
                 EmittedAnswers<double>& answers) {
    const std::size_t count = points.times.size();
    std::vector<std::vector<double>> columns{std::vector<double>(count, points.eps)};
    for (const double value : default_parameters<double>(code.program, points.eps))
        columns.emplace_back(count, value);
    for (const double value : start_of(code, points)) columns.emplace_back(count, value);
    std::vector<const double*> arguments;
    for (const std::vector<double>& column : columns) arguments.push_back(column.data());
    EnsembleLibrary(code.library)
        .evaluate(arguments, count, points.times.data(), arrays_of(answers.values), answers.statuses.data(),
                  answers.form == EmittedForm::ensemble);
}

// What compiled code has in double alone.
void add_many(const EmittedProgram& code, const Evaluator<double>& emitted,
              const EmittedPoints<double>& points, std::size_t start,
              std::vector<EmittedAnswers<double>>& all) {
    const auto asked = [&](EmittedForm form, std::size_t count) -> EmittedAnswers<double>& {
        return all.emplace_back(room<double>(code, form, start, count));
    };
    const std::size_t count = points.times.size();
    if (code.program.has_tables()) {
        EmittedAnswers<double>& batch = asked(EmittedForm::batch, count);
        emitted.batch(points.times, arrays_of(batch.values), batch.statuses);
        if (!points.grid.places.empty()) ask_grid(code, emitted, points, asked(EmittedForm::grid, 0));
    }
    if (FinalPointLibrary::is_in(*code.library))
        ask_final_points(code, points, asked(EmittedForm::at_end, count));
    if (!EnsembleLibrary::is_in(*code.library)) return;
    for (const EmittedForm form : {EmittedForm::ensemble, EmittedForm::quick_ensemble})
        ask_members(code, points, asked(form, count));
}

} // namespace

const char* to_string(EmittedForm form) {
    switch (form) {
    case EmittedForm::call: return "one call";
    case EmittedForm::batch: return "batch";
    case EmittedForm::grid: return "grid";
    case EmittedForm::at_end: return "at_end";
    case EmittedForm::ensemble: return "ensemble";
    case EmittedForm::quick_ensemble: return "ensemble without full_phase";
    }
    return "";
}

template <class Real>
std::vector<EmittedAnswers<Real>> answers_of(const EmittedProgram& code, const EmittedPoints<Real>& points,
                                             std::size_t start) {
    const Evaluator<Real> emitted = evaluator(code, points);
    std::vector<EmittedAnswers<Real>> all{room<Real>(code, EmittedForm::call, start, points.times.size())};
    ask_one_by_one(points, all.front(), [&](Real t, Real* values) { return emitted.call(t, values); });
    if constexpr (std::is_same_v<Real, double>)
        if (code.library->object()) add_many(code, emitted, points, start, all);
    return all;
}

template <class Real> Status status_at_0(const EmittedProgram& code, const EmittedPoints<Real>& points) {
    std::vector<Real> values(code.program.outputs.size());
    return evaluator(code, points).call(Real(0), values.data());
}

template std::vector<EmittedAnswers<double>> answers_of(const EmittedProgram&, const EmittedPoints<double>&,
                                                        std::size_t);
template std::vector<EmittedAnswers<long double>> answers_of(const EmittedProgram&,
                                                             const EmittedPoints<long double>&, std::size_t);
template Status status_at_0(const EmittedProgram&, const EmittedPoints<double>&);
template Status status_at_0(const EmittedProgram&, const EmittedPoints<long double>&);

} // namespace resonform
