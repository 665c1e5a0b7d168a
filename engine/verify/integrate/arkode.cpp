// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/integrate/cvode.hpp"
#include "verify/integrate/step_budget.hpp"
#include "verify/integrate/sundials.hpp"

#include <arkode/arkode_arkstep.h>

#include <memory>

namespace resonform {

namespace {

constexpr int explicit_order = 8, implicit_order = 5; // the highest there are

class ArkodeSolver : public SundialsSolver {
public:
    ArkodeSolver(Method method, Sundials& owner)
        : explicit_(method == Method::arkode_explicit ? Sundials::rates : nullptr),
          implicit_(method == Method::arkode_explicit ? nullptr : Sundials::rates),
          memory_(ARKStepCreate(explicit_, implicit_, 0.0, owner.state(), owner.context())) {
        void* memory = memory_.get();
        ARKStepSetErrHandlerFn(memory, Sundials::keep_message, &owner);
        ARKStepSVtolerances(memory, owner.tolerance(), owner.absolute_tolerances()); // copied
        ARKStepSetUserData(memory, &owner);
        ARKStepSetMaxNumSteps(memory, static_cast<long>(4 * rival_budget.most));
        ARKStepSetOrder(memory, implicit_ == nullptr ? explicit_order : implicit_order);
        if (implicit_ == nullptr) return;
        // Hermite's takes rates, which are large next to what decays fast.
        ARKStepSetInterpolantType(memory, ARK_INTERP_LAGRANGE);
        const Sundials::Newton newton = owner.newton();
        ARKStepSetLinearSolver(memory, newton.solver, newton.matrix);
        if (owner.has_jacobian()) ARKStepSetJacFn(memory, Sundials::jacobian);
    }

    void restart(N_Vector start) override { ARKStepReInit(memory_.get(), explicit_, implicit_, 0.0, start); }
    int step(double end, N_Vector state, double& reached) override {
        return ARKStepEvolve(memory_.get(), end, state, &reached, ARK_ONE_STEP);
    }
    void value_at(double t, N_Vector value) override { ARKStepGetDky(memory_.get(), t, 0, value); }
    [[nodiscard]] double last_step() const override {
        double h = 0;
        ARKStepGetLastStep(memory_.get(), &h);
        return h;
    }
    [[nodiscard]] std::size_t steps() const override {
        return counted([this](long* n) { ARKStepGetNumSteps(memory_.get(), n); });
    }
    [[nodiscard]] std::size_t evaluations() const override {
        long of_explicit = 0, of_implicit = 0;
        ARKStepGetNumRhsEvals(memory_.get(), &of_explicit, &of_implicit);
        return static_cast<std::size_t>(of_explicit + of_implicit);
    }

private:
    struct FreeMemory {
        void operator()(void* m) const { ARKStepFree(&m); }
    };
    ARKRhsFn explicit_, implicit_;
    std::unique_ptr<void, FreeMemory> memory_;
};

} // namespace

std::unique_ptr<Integrator> make_arkode(Method method, RightHandSide rates, const Start& start) {
    auto made = std::make_unique<Sundials>(rates, start);
    made->set_solver(std::make_unique<ArkodeSolver>(method, *made));
    return made;
}

} // namespace resonform
