// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/integrate/cvode.hpp"

#include "verify/integrate/step_budget.hpp"
#include "verify/integrate/sundials.hpp"

#include <cvode/cvode.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <memory>
#include <type_traits>

namespace resonform {

namespace {

class CvodeSolver : public SundialsSolver {
public:
    CvodeSolver(Method method, Sundials& owner)
        : memory_(CVodeCreate(method == Method::cvode_adams ? CV_ADAMS : CV_BDF, owner.context())) {
        void* memory = memory_.get();
        CVodeSetErrHandlerFn(memory, Sundials::keep_message, &owner);
        CVodeInit(memory, Sundials::rates, 0.0, owner.state());
        CVodeSVtolerances(memory, owner.tolerance(), owner.absolute_tolerances()); // copied
        CVodeSetUserData(memory, &owner);
        CVodeSetMaxNumSteps(memory, static_cast<long>(4 * rival_budget.most));
        if (method == Method::cvode_adams) {
            iteration_.reset(SUNNonlinSol_FixedPoint(owner.state(), 0, owner.context()));
            CVodeSetNonlinearSolver(memory, iteration_.get());
            return;
        }
        const Sundials::Newton newton = owner.newton();
        CVodeSetLinearSolver(memory, newton.solver, newton.matrix);
        if (owner.has_jacobian()) CVodeSetJacFn(memory, Sundials::jacobian);
    }

    void restart(N_Vector start) override { CVodeReInit(memory_.get(), 0.0, start); }
    int step(double end, N_Vector state, double& reached) override {
        return CVode(memory_.get(), end, state, &reached, CV_ONE_STEP);
    }
    void value_at(double t, N_Vector value) override { CVodeGetDky(memory_.get(), t, 0, value); }
    [[nodiscard]] double last_step() const override {
        double h = 0;
        CVodeGetLastStep(memory_.get(), &h);
        return h;
    }
    [[nodiscard]] std::size_t steps() const override {
        return counted([this](long* n) { CVodeGetNumSteps(memory_.get(), n); });
    }
    [[nodiscard]] std::size_t evaluations() const override {
        return counted([this](long* n) { CVodeGetNumRhsEvals(memory_.get(), n); });
    }

private:
    struct FreeMemory {
        void operator()(void* m) const { CVodeFree(&m); }
    };
    std::unique_ptr<std::remove_pointer_t<SUNNonlinearSolver>, int (*)(SUNNonlinearSolver)> iteration_{
        nullptr, SUNNonlinSolFree};
    std::unique_ptr<void, FreeMemory> memory_;
};

} // namespace

std::unique_ptr<Integrator> make_cvode(Method method, RightHandSide rates, const Start& start) {
    auto made = std::make_unique<Sundials>(rates, start);
    made->set_solver(std::make_unique<CvodeSolver>(method, *made));
    return made;
}

} // namespace resonform
