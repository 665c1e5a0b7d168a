// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/integrate/sundials.hpp"

#include "verify/integrate/step_budget.hpp"

#include <fmt/format.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <cmath>

namespace resonform {

Sundials::Sundials(RightHandSide rates, const Start& start) : rates_(rates), start_(start) {
    SUNContext raw = nullptr;
    SUNContext_Create(nullptr, &raw);
    context_.reset(raw);
    state_ = vector(start.state);
    dense_ = vector(start.state);
    std::vector<double> absolute(start.state);
    for (double& a : absolute) a = start.tolerance * (a == 0 ? 1.0 : std::abs(a));
    absolute_ = vector(absolute);
}

Sundials::Vector Sundials::vector(const std::vector<double>& values) const {
    Vector v(N_VNew_Serial(static_cast<sunindextype>(values.size()), context_.get()), N_VDestroy);
    std::copy(values.begin(), values.end(), N_VGetArrayPointer(v.get()));
    return v;
}

Sundials::Newton Sundials::newton() {
    if (!linear_) {
        const auto size = static_cast<sunindextype>(start_.state.size());
        matrix_.reset(SUNDenseMatrix(size, size, context_.get()));
        linear_.reset(SUNLinSol_Dense(state_.get(), matrix_.get(), context_.get()));
    }
    return {linear_.get(), matrix_.get()};
}

int Sundials::rates(double, N_Vector state, N_Vector rate, void* self) {
    const RightHandSide& f = static_cast<Sundials*>(self)->rates_;
    f.call(f.context, N_VGetArrayPointer(state), N_VGetArrayPointer(rate));
    const double* r = N_VGetArrayPointer(rate);
    return std::all_of(r, r + N_VGetLength(rate), [](double x) { return std::isfinite(x); }) ? 0 : 1;
}

int Sundials::jacobian(double, N_Vector state, N_Vector, SUNMatrix matrix, void* self, N_Vector, N_Vector,
                       N_Vector) {
    const RightHandSide& f = static_cast<Sundials*>(self)->rates_;
    double* entries = SM_DATA_D(matrix); // columns one after the other
    f.jacobian(f.context, N_VGetArrayPointer(state), entries);
    return std::all_of(entries, entries + SM_LDATA_D(matrix), [](double x) { return std::isfinite(x); }) ? 0
                                                                                                         : 1;
}

void Sundials::keep_message(int code, const char*, const char*, char* text, void* self) {
    if (code < 0) static_cast<Sundials*>(self)->message_ = text;
}

Run Sundials::run(const std::vector<double>& times, std::vector<std::vector<double>>& values) {
    Run run;
    std::size_t next = 0;
    const auto store = [&](const double* state) {
        for (std::size_t k = 0; k < start_.wanted.size(); ++k) values[k][next] = state[start_.wanted[k]];
        ++next;
    };
    std::copy(start_.state.begin(), start_.state.end(), N_VGetArrayPointer(state_.get()));
    solver_->restart(state_.get());
    while (next < times.size() && times[next] <= 0) store(start_.state.data());
    for (std::size_t step = 1; next < times.size(); ++step) {
        double reached = 0;
        const int code = solver_->step(times.back(), state_.get(), reached);
        if (code < 0) {
            run.failure = message_.empty() ? fmt::format("the library returned {}", code) : message_;
            break;
        }
        // The library goes on with steps that no longer move the time, and only warns.
        if (solver_->last_step() <= 4e-16 * reached) {
            run.failure = fmt::format("the step vanishes near t = {:.6g}", reached);
            break;
        }
        for (; next < times.size() && times[next] <= reached; store(N_VGetArrayPointer(dense_.get())))
            solver_->value_at(times[next], dense_.get());
        if (next < times.size() && rival_budget.is_spent(step, reached, times.back())) {
            run.failure = fmt::format("more than {} steps", rival_budget.most);
            break;
        }
    }
    run.steps = solver_->steps();
    run.evaluations = solver_->evaluations();
    return run;
}

} // namespace resonform
