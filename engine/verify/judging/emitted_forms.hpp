// SPDX-License-Identifier: GPL-3.0-or-later
// The forms in which emitted code answers, each asked at the same points: call by call, many points at once,
// a grid, one final point, members of an ensemble.
#pragma once

#include "emit/program/program.hpp"
#include "verify/evaluate/evaluator.hpp"
#include "verify/judging/emitted_points.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace resonform {

// quick_ensemble: full_phase = false.
enum class EmittedForm { call, batch, grid, at_end, ensemble, quick_ensemble };

// "at_end"
const char* to_string(EmittedForm form);

// Nothing is constructed, and the interval ends with the point.
constexpr bool is_final_point(EmittedForm form) { return form >= EmittedForm::at_end; }

// Statuses and values at times of one start.
template <class Real> struct EmittedAnswers {
    std::size_t start;
    EmittedForm form;
    std::vector<std::size_t> times; // the numbers of their points
    std::vector<unsigned char> statuses;
    std::vector<std::vector<Real>> values; // [output][time]
    [[nodiscard]] Status status(std::size_t i) const { return static_cast<Status>(statuses[i]); }
};

// The emitted code of a program.
struct EmittedProgram {
    const Program& program;
    const std::shared_ptr<const EvaluatorLibrary>& library;
};

// In each form that the library has in this type. Many points that are many calls, as without tables, are not
// asked for again. Real: double, long double.
template <class Real>
std::vector<EmittedAnswers<Real>> answers_of(const EmittedProgram& code, const EmittedPoints<Real>& points,
                                             std::size_t start);

// Of one call there.
template <class Real> Status status_at_0(const EmittedProgram& code, const EmittedPoints<Real>& points);

} // namespace resonform
