// SPDX-License-Identifier: GPL-3.0-or-later
// One scene made ready to be tried against direct integration: its equations as a tape, its emitted
// code compiled, and for each eps the start of the integration and the integration itself.
#pragma once

#include "verify/evaluate/evaluator.hpp"
#include "verify/evaluate/program_defaults.hpp"
#include "verify/integrate/integrate.hpp"
#include "verify/judging/conditions.hpp"
#include "verify/judging/domain.hpp"
#include "verify/judging/options.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace resonform {

// The numbers of one run. slow_time_end is a little beyond eps*interval, so that rounding does not put
// the last time outside the evaluator's tables.
struct TrialPoint {
    Rational eps;
    double interval = 0;
    Float128 eps_value = 0, slow_time_end = 0;
    std::vector<Float128> parameters; // all of the system: for the integration
    std::vector<Float128> start;      // all states at t = 0
};

// Direct integration in double-double at given times, by Taylor series or, where these do not reach the end
// and implicit steps do, by those; of the outputs only.
struct Reference {
    std::vector<double> times;
    std::vector<std::vector<DoubleDouble>> values; // [output][point]
    std::vector<double> error;                     // of each output: a second run, coarser, differs by this
};

// Where an eps comes from, so that a message can tell where to leave it out.
enum class EpsFrom { ladder, command_line };

class Trial {
public:
    // The scene must outlive it. Errors: bad_input, a parameter without a value, a motion that leaves the
    // declared domain; those of Tape and EvaluatorLibrary.
    Trial(std::shared_ptr<const FirstOrderSystem> system, const Scene& scene, const Solution& solution,
          const VerifyOptions& options, EpsFrom eps_from = EpsFrom::ladder);

    [[nodiscard]] const std::shared_ptr<const Program>& program() const { return program_; }
    [[nodiscard]] const Tape& tape() const { return tape_; }
    [[nodiscard]] const FirstOrderSystem& system() const { return *system_; }
    [[nodiscard]] const std::vector<std::size_t>& output_states() const { return output_states_; }

    // The start is the formula itself at t = 0, all weights of the map kept; where the scene gives
    // physical start values and they are not projected, it is those. The interval is the judged one
    // (times.hpp). Errors: refused, the evaluator answers no start; those of bounded_interval_length.
    [[nodiscard]] TrialPoint point(const Rational& eps) const;
    // The same point with another start: of the scene's start values those that are given.
    [[nodiscard]] TrialPoint started(TrialPoint at, const GivenArguments& given) const;
    // The same point with the whole interval of the scene.
    [[nodiscard]] TrialPoint whole(TrialPoint at) const;
    // Given start values that a projection replaces, and one that is left out, with the formula's.
    [[nodiscard]] std::vector<Conditions::Moved> moved(const TrialPoint& at) const;

    // Whether a status comes with numbers to judge: beside modes that grow low_precision does, as they end
    // soon.
    [[nodiscard]] bool answers(Status status) const {
        return status == Status::ok || (grows_ && status == Status::low_precision);
    }

    // How many steps a run in double takes, about six in each period of the fastest motion, or what stands
    // for them where implicit steps are taken; nullopt: more than `most`, and the implicit ones are too many,
    // too. Errors: refused, the solution leaves the domain.
    [[nodiscard]] std::optional<std::size_t> steps(const TrialPoint& at, std::size_t most) const;

    // The number of sample times that resolve a run of so many steps (40 or more in each period), <= 200,000.
    static std::size_t resolving_points(std::size_t steps);

    // Cached. times: ascending, not negative. Errors: refused, the solution leaves the domain.
    [[nodiscard]] Reference reference(const TrialPoint& at, std::vector<double> times) const;

    // Real: long double, the emitted code; Float128, the same program interpreted, which takes the compiler
    // no time and is as fast, for arithmetic is all of it.
    template <class Real>
    [[nodiscard]] Evaluator<Real> evaluator(const TrialPoint& at, const GivenArguments& given = {}) const;

private:
    struct Route {
        bool implicit;
        std::optional<std::size_t> steps; // as steps()
    };
    [[nodiscard]] Route route(const TrialPoint& at, std::size_t most) const;
    // All states; fine: the reference itself, or the run that is compared with it.
    [[nodiscard]] Integration<DoubleDouble> integrated(const TrialPoint& at, const std::vector<double>& times,
                                                       bool implicit, bool fine) const;
    [[nodiscard]] bool comes_from_formula(const State& state) const;
    [[nodiscard]] std::vector<Float128> state_at_start(const TrialPoint& at,
                                                       const GivenArguments& given) const;
    [[nodiscard]] std::string without(const Rational& eps) const;
    [[noreturn]] void refuse_interval(const TrialPoint& at, const std::string& failure) const;
    [[nodiscard]] std::string cache_key(const TrialPoint& at, const std::vector<double>& times,
                                        bool implicit) const;

    std::shared_ptr<const FirstOrderSystem> system_;
    const Scene& scene_;
    VerifyOptions options_;
    EpsFrom eps_from_;
    std::shared_ptr<const Program> program_;
    std::shared_ptr<const EvaluatorLibrary> library_, interpreted_;
    Tape tape_, start_tape_; // start_tape_: the interval, then the given start values
    std::vector<Float128> parameters_;
    DeclaredDomain domain_;
    Place interval_place_;
    std::shared_ptr<const GradedField> field_;
    bool projects_, grows_;
    std::vector<std::size_t> given_; // states with a given start value
    std::vector<std::size_t> output_states_;
};

} // namespace resonform
