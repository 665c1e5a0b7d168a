// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/integrate/cvode.hpp"

#include <cvode/cvode.h>
#include <fmt/format.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <type_traits>

namespace resonform {

namespace {

constexpr long most_cvode_steps = 50'000'000;

struct Problem {
    RightHandSide rates;
    std::string message; // the last error message of the library
};

int right_hand_side(realtype, N_Vector u, N_Vector rate, void* data) {
    const RightHandSide& f = static_cast<Problem*>(data)->rates;
    f.call(f.context, N_VGetArrayPointer(u), N_VGetArrayPointer(rate));
    const double* r = N_VGetArrayPointer(rate);
    return std::all_of(r, r + N_VGetLength(rate), [](double x) { return std::isfinite(x); }) ? 0 : 1;
}

void keep_message(int code, const char*, const char*, char* text, void* data) {
    if (code < 0) static_cast<Problem*>(data)->message = text;
}

// Owns what the library allocates; members are destroyed bottom up, the context last.
class Solver {
public:
    Solver(Method method, Problem& problem, const std::vector<double>& start, double tolerance)
        : size_(static_cast<sunindextype>(start.size())) {
        SUNContext raw = nullptr;
        SUNContext_Create(nullptr, &raw);
        context_.reset(raw);
        state_ = vector(start);
        std::vector<double> absolute(start);
        for (double& a : absolute) a = tolerance * (a == 0 ? 1.0 : std::abs(a));
        dense_ = vector(absolute);
        memory_.reset(CVodeCreate(method == Method::cvode_adams ? CV_ADAMS : CV_BDF, raw));
        CVodeSetErrHandlerFn(memory_.get(), keep_message, &problem);
        CVodeInit(memory_.get(), right_hand_side, 0.0, state_.get());
        CVodeSVtolerances(memory_.get(), tolerance, dense_.get()); // copied
        CVodeSetUserData(memory_.get(), &problem);
        CVodeSetMaxNumSteps(memory_.get(), most_cvode_steps);
        if (method == Method::cvode_adams) {
            iteration_.reset(SUNNonlinSol_FixedPoint(state_.get(), 0, raw));
            CVodeSetNonlinearSolver(memory_.get(), iteration_.get());
        } else {
            matrix_.reset(SUNDenseMatrix(size_, size_, raw));
            linear_.reset(SUNLinSol_Dense(state_.get(), matrix_.get(), raw));
            CVodeSetLinearSolver(memory_.get(), linear_.get(), matrix_.get());
        }
    }

    // Back to t = 0.
    void restart(const std::vector<double>& start) {
        std::copy(start.begin(), start.end(), N_VGetArrayPointer(state_.get()));
        CVodeReInit(memory_.get(), 0.0, state_.get());
    }
    // One internal step towards `end`; the time reached, or a failure code below 0.
    int step(double end, double& reached) {
        return CVode(memory_.get(), end, state_.get(), &reached, CV_ONE_STEP);
    }
    // The interpolant at a time inside the last step.
    const double* value_at(double t) {
        CVodeGetDky(memory_.get(), t, 0, dense_.get());
        return N_VGetArrayPointer(dense_.get());
    }
    [[nodiscard]] double last_step() const {
        double h = 0;
        CVodeGetLastStep(memory_.get(), &h);
        return h;
    }
    [[nodiscard]] std::size_t steps() const {
        long n = 0;
        CVodeGetNumSteps(memory_.get(), &n);
        return static_cast<std::size_t>(n);
    }
    [[nodiscard]] std::size_t evaluations() const {
        long n = 0;
        CVodeGetNumRhsEvals(memory_.get(), &n);
        return static_cast<std::size_t>(n);
    }

private:
    struct FreeContext {
        void operator()(SUNContext c) const { SUNContext_Free(&c); }
    };
    struct FreeMemory {
        void operator()(void* m) const { CVodeFree(&m); }
    };
    using Vector = std::unique_ptr<std::remove_pointer_t<N_Vector>, void (*)(N_Vector)>;
    Vector vector(const std::vector<double>& values) {
        Vector v(N_VNew_Serial(size_, context_.get()), N_VDestroy);
        std::copy(values.begin(), values.end(), N_VGetArrayPointer(v.get()));
        return v;
    }

    sunindextype size_;
    std::unique_ptr<std::remove_pointer_t<SUNContext>, FreeContext> context_;
    Vector state_{nullptr, N_VDestroy}, dense_{nullptr, N_VDestroy};
    std::unique_ptr<std::remove_pointer_t<SUNNonlinearSolver>, int (*)(SUNNonlinearSolver)> iteration_{
        nullptr, SUNNonlinSolFree};
    std::unique_ptr<std::remove_pointer_t<SUNMatrix>, void (*)(SUNMatrix)> matrix_{nullptr, SUNMatDestroy};
    std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, int (*)(SUNLinearSolver)> linear_{nullptr,
                                                                                              SUNLinSolFree};
    std::unique_ptr<void, FreeMemory> memory_;
};

class Cvode : public Integrator {
public:
    Cvode(Method method, RightHandSide rates, const Start& start)
        : start_(start), problem_{rates, ""}, solver_(method, problem_, start.state, start.tolerance) {}

    Run run(const std::vector<double>& times, std::vector<std::vector<double>>& values) override {
        Run run;
        std::size_t next = 0;
        const auto store = [&](const double* state) {
            for (std::size_t k = 0; k < start_.wanted.size(); ++k) values[k][next] = state[start_.wanted[k]];
            ++next;
        };
        solver_.restart(start_.state);
        while (next < times.size() && times[next] <= 0) store(start_.state.data());
        while (next < times.size()) {
            double reached = 0;
            const int code = solver_.step(times.back(), reached);
            if (code < 0) {
                run.failure =
                    problem_.message.empty() ? fmt::format("CVode returned {}", code) : problem_.message;
                break;
            }
            // The library goes on with steps that no longer move the time, and only warns.
            if (solver_.last_step() <= 4e-16 * reached) {
                run.failure = fmt::format("the step vanishes near t = {:.6g}", reached);
                break;
            }
            while (next < times.size() && times[next] <= reached) store(solver_.value_at(times[next]));
        }
        run.steps = solver_.steps();
        run.evaluations = solver_.evaluations();
        return run;
    }

private:
    Start start_;
    Problem problem_;
    Solver solver_;
};

} // namespace

std::unique_ptr<Integrator> make_cvode(Method method, RightHandSide rates, const Start& start) {
    return std::make_unique<Cvode>(method, rates, start);
}

} // namespace resonform
