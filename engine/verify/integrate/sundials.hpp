// SPDX-License-Identifier: GPL-3.0-or-later
// What solvers of SUNDIALS have in common: vectors, tolerances, dense Newton matrices, steps one by one with
// the library's interpolation between them.
#pragma once

#include "verify/integrate/integrator.hpp"

#include <nvector/nvector_serial.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>

#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace resonform {

// The library's own object: CVODE or ARKODE. Codes below 0 are failures.
class SundialsSolver {
public:
    SundialsSolver() = default;
    virtual ~SundialsSolver() = default;
    SundialsSolver(const SundialsSolver&) = delete;
    SundialsSolver& operator=(const SundialsSolver&) = delete;

    virtual void restart(N_Vector start) = 0;                          // at t = 0
    virtual int step(double end, N_Vector state, double& reached) = 0; // one internal step towards end
    virtual void value_at(double t, N_Vector value) = 0;               // within the last step
    [[nodiscard]] virtual double last_step() const = 0;
    [[nodiscard]] virtual std::size_t steps() const = 0;
    [[nodiscard]] virtual std::size_t evaluations() const = 0;
};

class Sundials : public Integrator {
public:
    Sundials(RightHandSide rates, const Start& start);
    Run run(const std::vector<double>& times, std::vector<std::vector<double>>& values) final;

    // What solvers are made of: callbacks take this object as their data.
    static int rates(double t, N_Vector state, N_Vector rate, void* self);
    static int jacobian(double t, N_Vector state, N_Vector rate, SUNMatrix matrix, void* self, N_Vector,
                        N_Vector, N_Vector);
    static void keep_message(int code, const char*, const char*, char* text, void* self);
    [[nodiscard]] SUNContext context() const { return context_.get(); }
    [[nodiscard]] N_Vector state() const { return state_.get(); }
    // tolerance times the size of each start value, 1 where that is zero
    [[nodiscard]] N_Vector absolute_tolerances() const { return absolute_.get(); }
    [[nodiscard]] double tolerance() const { return start_.tolerance; }
    [[nodiscard]] bool has_jacobian() const { return rates_.jacobian != nullptr; }
    // A dense matrix and its solver, made when they are first wanted.
    struct Newton {
        SUNLinearSolver solver;
        SUNMatrix matrix;
    };
    [[nodiscard]] Newton newton();

    // Precondition of run(): it is there.
    void set_solver(std::unique_ptr<SundialsSolver> solver) { solver_ = std::move(solver); }

private:
    struct FreeContext {
        void operator()(SUNContext c) const { SUNContext_Free(&c); }
    };
    using Vector = std::unique_ptr<std::remove_pointer_t<N_Vector>, void (*)(N_Vector)>;
    Vector vector(const std::vector<double>& values) const;

    RightHandSide rates_;
    Start start_;
    std::string message_; // the last error message of the library
    // Destroyed bottom up, the context last.
    std::unique_ptr<std::remove_pointer_t<SUNContext>, FreeContext> context_;
    Vector state_{nullptr, N_VDestroy}, dense_{nullptr, N_VDestroy}, absolute_{nullptr, N_VDestroy};
    std::unique_ptr<std::remove_pointer_t<SUNMatrix>, void (*)(SUNMatrix)> matrix_{nullptr, SUNMatDestroy};
    std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, int (*)(SUNLinearSolver)> linear_{nullptr,
                                                                                              SUNLinSolFree};
    std::unique_ptr<SundialsSolver> solver_;
};

// A counter of the library as a number.
template <class Get> std::size_t counted(const Get& get) {
    long n = 0;
    get(&n);
    return static_cast<std::size_t>(n);
}

} // namespace resonform
