// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judging/trial.hpp"

#include "algebra/number/error.hpp"
#include "emit/program/build_program.hpp"
#include "model/files/interval_length.hpp"
#include "model/system/scene_file.hpp"
#include "verify/estimate/times.hpp"
#include "verify/evaluate/interpreter.hpp"
#include "verify/evaluate/scene_values.hpp"
#include "verify/integrate/integrate.hpp"
#include "verify/integrate/tape.hpp"
#include "verify/judging/conditions.hpp"
#include "verify/run/cache.hpp"
#include "verify/run/real.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <future>
#include <type_traits>

namespace resonform {

namespace {

constexpr double reference_tolerance = 1e-32; // of a step, in double-double
constexpr double check_tolerance = 1e-29;     // of the second, coarser run
constexpr int check_order = 30;
constexpr std::size_t check_points = 1000;
constexpr double scout_tolerance = 1e-15;    // steps of a double run: about six in a period
constexpr double implicit_tolerance = 1e-28; // likewise, of implicit steps
constexpr double implicit_check_tolerance = 1e-25;
constexpr double implicit_scout_tolerance = 1e-13; // a third as many steps as explicit ones, or more
constexpr std::size_t scouts_per_implicit_step = 3;
constexpr std::size_t points_per_step = 8;
constexpr std::size_t least_points = 2000, most_points = 200'000;

std::vector<Float128> required_values(const Scene& scene) {
    std::vector<std::string> missing;
    for (const Parameter& p : scene.system->parameters)
        if (scene.fix.count(p.name) == 0) missing.push_back(p.name);
    if (!missing.empty()) not_fixed(scene, "verification needs a value for every parameter", missing);
    return parameter_values<Float128>(scene);
}

// The state does not come from the formula: the scene gives it, or it is slow or an angle (0 if not given).
bool is_given(const System& system, const Scene& scene, const State& state) {
    const Role role = system.variables[state.variable].role;
    return role == Role::slow || role == Role::angle || scene.start_of(state.name) != nullptr;
}

std::string pack(const Reference& reference) {
    std::string bytes;
    const auto put = [&bytes](double x) { bytes.append(reinterpret_cast<const char*>(&x), sizeof x); };
    for (const double e : reference.error) put(e);
    for (const auto& row : reference.values)
        for (const DoubleDouble& v : row)
            for (const double part : v.x) put(part);
    return bytes;
}

bool unpack(const std::string& bytes, std::size_t outputs, std::size_t points, Reference& reference) {
    if (bytes.size() != outputs * (1 + 2 * points) * sizeof(double)) return false;
    const char* at = bytes.data();
    const auto take = [&at](double& x) {
        std::memcpy(&x, at, sizeof x);
        at += sizeof x;
    };
    reference.error.assign(outputs, 0.0);
    for (double& e : reference.error) take(e);
    reference.values.assign(outputs, std::vector<DoubleDouble>(points));
    for (auto& row : reference.values)
        for (DoubleDouble& v : row)
            for (double& part : v.x) take(part);
    return true;
}

// A little beyond, so that rounding does not put the last time outside the evaluator's tables.
Float128 end_of(const TrialPoint& at) { return at.eps_value * Float128(at.interval) * Float128(1 + 0x1p-40); }

Place place_of_interval(const Scene& scene) {
    if (scene.verify.interval_source) return place_of(*scene.verify.interval_source);
    return {scene.file.string(), 0, 0, "verify.interval", ""};
}

} // namespace

void Trial::refuse_interval(const TrialPoint& at, const std::string& failure) const {
    refuse(Reason::integration,
           {"direct integration reaches the end of the interval",
            fmt::format("interval = {:g} at eps = {}: {}", at.interval, to_string(at.eps), failure),
            "shorten verify.interval or " + without(at.eps), interval_place_});
}

std::string Trial::without(const Rational& eps) const {
    if (eps_from_ == EpsFrom::command_line) return "take a larger --eps";
    return fmt::format("leave eps = {} out of the ladder", to_string(eps));
}

Trial::Trial(std::shared_ptr<const FirstOrderSystem> system, const Scene& scene, const Solution& solution,
             const VerifyOptions& options, EpsFrom eps_from)
    : system_(std::move(system)), scene_(scene), options_(options), eps_from_(eps_from),
      program_(std::make_shared<const Program>(build_program(solution, scene, {true, true}))),
      tape_(Tape::rates(*system_)), start_tape_(Tape::constants(*system_->system, {scene.verify.interval})),
      parameters_(required_values(scene)), domain_(*system_, scene),
      interval_place_(place_of_interval(scene)), field_(solution.normalization->normal_form.field),
      projects_(solution.flow && solution.flow->is_projected()),
      grows_(grows_at_start(*field_, scene,
                            scene.verify.eps.empty() ? Rational(1) / 100 : scene.verify.eps.front())) {
    for (const Rational& eps : scene.verify.eps) domain_.require(eps);
    std::vector<GiNaC::ex> expressions{scene.verify.interval};
    for (std::size_t i = 0; i < system_->states.size(); ++i) {
        const State& state = system_->states[i];
        if (!is_given(*system_->system, scene, state)) continue;
        const StartValue* start = scene.start_of(state.name);
        given_.push_back(i);
        expressions.push_back(start == nullptr ? GiNaC::ex(0) : start->value);
    }
    start_tape_ = Tape::constants(*system_->system, expressions);
    for (const ProgramOutput& output : program_->outputs)
        output_states_.push_back(
            static_cast<std::size_t>(&system_->state(output.name) - system_->states.data()));
    library_ = library_of(program_, options_, "l");
    interpreted_ = EvaluatorLibrary::interpreted(program_);
}

template <class Real>
Evaluator<Real> Trial::evaluator(const TrialPoint& at, const GivenArguments& given) const {
    const Real eps = convert<Real>(at.eps_value);
    const ProgramArguments<Real> arguments =
        program_arguments<Real>(*program_, eps, given, &interpreted_->interpretation()->numbers);
    const bool compiled = std::is_same_v<Real, long double>;
    return Evaluator<Real>(compiled ? library_ : interpreted_, eps, arguments.parameters, arguments.start,
                           convert<Real>(at.slow_time_end));
}

template Evaluator<long double> Trial::evaluator(const TrialPoint&, const GivenArguments&) const;
template Evaluator<Float128> Trial::evaluator(const TrialPoint&, const GivenArguments&) const;

TrialPoint Trial::point(const Rational& eps) const {
    domain_.require(eps);
    TrialPoint at;
    at.eps = eps;
    at.eps_value = from_rational<Float128>(eps);
    at.parameters = parameters_;
    (void)bounded_interval_length(scene_, eps);
    const std::vector<Float128> given = evaluate_constants(start_tape_, at.parameters, at.eps_value);
    at.interval = to_double_value(given[0]);
    at.interval = std::min(at.interval, judged_interval(*field_, scene_, eps));
    at.slow_time_end = end_of(at);
    return started(std::move(at), {});
}

TrialPoint Trial::started(TrialPoint at, const GivenArguments& start) const {
    at.start.assign(system_->states.size(), Float128(0));
    const std::vector<Float128> given = evaluate_constants(start_tape_, at.parameters, at.eps_value);
    const std::vector<Float128> state = state_at_start(at, start);
    for (std::size_t k = 0; k < state.size(); ++k)
        at.start[static_cast<std::size_t>(&system_->state(program_->state[k].name) -
                                          system_->states.data())] = state[k];
    for (std::size_t k = 0; k < given_.size(); ++k) {
        const State& of = system_->states[given_[k]];
        if (comes_from_formula(of)) continue;
        const auto changed = start.find(of.name);
        at.start[given_[k]] = changed == start.end() ? given[k + 1] : Float128(changed->second);
    }
    return at;
}

TrialPoint Trial::whole(TrialPoint at) const {
    at.interval = interval_length(scene_, at.eps);
    at.slow_time_end = end_of(at);
    return at;
}

// On the manifold onto which a start is projected every variable has its place, slow ones among them.
bool Trial::comes_from_formula(const State& state) const {
    return projects_ && system_->system->variables[state.variable].role != Role::angle;
}

std::vector<Conditions::Moved> Trial::moved(const TrialPoint& at) const {
    std::vector<Conditions::Moved> list;
    const std::vector<Float128> given = evaluate_constants(start_tape_, at.parameters, at.eps_value);
    for (std::size_t k = 0; k < given_.size(); ++k)
        if (const State& state = system_->states[given_[k]]; comes_from_formula(state))
            list.push_back({state.name, to_double_value(given[k + 1]), to_double_value(at.start[given_[k]])});
    for (std::size_t i = 0; scene_.at_zero && i < at.start.size(); ++i)
        if (system_->states[i].name == scene_.at_zero->state)
            list.push_back({scene_.at_zero->state, std::nullopt, to_double_value(at.start[i])});
    return list;
}

// The state at the start by the formula, for start values that the scene does not give.
std::vector<Float128> Trial::state_at_start(const TrialPoint& at, const GivenArguments& given) const {
    std::vector<Float128> state(program_->state.size());
    if (state.empty()) return state;
    TrialPoint beginning = at; // tables of the whole interval may be costly, and t = 0 needs none
    beginning.slow_time_end = std::min(at.slow_time_end, at.eps_value);
    const Evaluator<Float128> formula = evaluator<Float128>(beginning, given);
    if (const Status status = formula.state(Float128(0), state.data()); !answers(status))
        refuse(Reason::integration,
               {"the formula answers at t = 0",
                fmt::format("{} at eps = {}", told(status, formula.why(status)), to_string(at.eps)),
                "change the start values or " + without(at.eps),
                {interval_place_.file, 0, 0, "start", ""}});
    return state;
}

// A Taylor series where that reaches the end, in fewer than `most` steps of a run in double; implicit steps
// where only they do, because rates far above those of the solution make the steps of a series short.
Trial::Route Trial::route(const TrialPoint& at, std::size_t most) const {
    const std::vector<double> parameters = convert_all<double>(at.parameters);
    const std::vector<double> start = convert_all<double>(at.start);
    const double eps = to_double_value(at.eps_value);
    const auto taylor =
        integrate_taylor<double>(tape_, parameters, eps, start, {at.interval}, scout_tolerance, 0, most);
    if (!taylor.too_far) {
        if (!taylor.failure.empty()) refuse_interval(at, taylor.failure);
        return {false, taylor.steps};
    }
    const auto stiff =
        integrate_implicit<double>(tape_, parameters, eps, start, {at.interval}, implicit_scout_tolerance);
    if (stiff.too_far) return {false, std::nullopt};
    if (!stiff.failure.empty()) refuse_interval(at, stiff.failure);
    return {true, scouts_per_implicit_step * stiff.steps};
}

std::optional<std::size_t> Trial::steps(const TrialPoint& at, std::size_t most) const {
    return route(at, most).steps;
}

std::size_t Trial::resolving_points(std::size_t steps) {
    return std::clamp(points_per_step * steps + 1, least_points, most_points);
}

std::string Trial::cache_key(const TrialPoint& at, const std::vector<double>& times, bool implicit) const {
    std::string text = implicit ? fmt::format("implicit reference 1, tolerances {} {}, times",
                                              implicit_tolerance, implicit_check_tolerance)
                                : fmt::format("reference 2, tolerances {} {} order {}, times",
                                              reference_tolerance, check_tolerance, check_order);
    for (const double t : times) text += fmt::format(" {:a}", t);
    text += '\n';
    const auto put = [&text](const Float128& x) {
        for (const double part : to_parts(x)) text += fmt::format("{:a} ", part);
    };
    put(at.eps_value);
    for (const Float128& x : at.parameters) put(x);
    for (const Float128& x : at.start) put(x);
    for (const std::size_t s : output_states_) text += fmt::format("output {} ", s);
    return content_hash(text + "\n" + tape_.text());
}

Integration<DoubleDouble> Trial::integrated(const TrialPoint& at, const std::vector<double>& times,
                                            bool implicit, bool fine) const {
    const std::vector<DoubleDouble> parameters = convert_all<DoubleDouble>(at.parameters);
    const std::vector<DoubleDouble> start = convert_all<DoubleDouble>(at.start);
    const std::vector<DoubleDouble> wanted(times.begin(), times.end());
    const auto eps = convert<DoubleDouble>(at.eps_value);
    if (implicit)
        return integrate_implicit(tape_, parameters, eps, start, wanted,
                                  fine ? implicit_tolerance : implicit_check_tolerance);
    return integrate_taylor(tape_, parameters, eps, start, wanted,
                            fine ? reference_tolerance : check_tolerance, fine ? 0 : check_order);
}

Reference Trial::reference(const TrialPoint& at, std::vector<double> times) const {
    Reference result;
    result.times = std::move(times);
    const std::size_t points = result.times.size();
    const auto kept = [&](bool implicit) {
        return options_.cache / (cache_key(at, result.times, implicit) + ".reference");
    };
    const auto is_known = [&](bool implicit) {
        if (options_.cache.empty()) return false;
        const auto bytes = load_checked(kept(implicit));
        return bytes && unpack(*bytes, output_states_.size(), points, result);
    };
    if (is_known(false)) return result;
    const bool implicit = route(at, most_ladder_steps).implicit;
    if (implicit && is_known(true)) return result;

    if (options_.progress)
        options_.progress(fmt::format("integrating directly at eps = {}", to_string(at.eps)));
    const std::size_t stride = std::max<std::size_t>(1, points / check_points);
    std::vector<double> some;
    for (std::size_t i = 0; i < points; i += stride) some.push_back(result.times[i]);
    auto coarse = std::async(std::launch::async, [&] { return integrated(at, some, implicit, false); });
    const Integration<DoubleDouble> fine = integrated(at, result.times, implicit, true), check = coarse.get();
    if (!fine.failure.empty()) refuse_interval(at, fine.failure);
    for (const std::size_t s : output_states_) {
        double error = 0;
        for (std::size_t i = 0; i < some.size(); ++i)
            error = std::max(error, std::abs(to_double_value(
                                        DoubleDouble(fine.values[s][i * stride] - check.values[s][i]))));
        result.error.push_back(error);
        result.values.push_back(fine.values[s]);
    }
    if (options_.cache.empty()) return result;
    try {
        store_checked(kept(implicit), pack(result));
    } catch (const Error& error) { // a full disk is no reason to throw the integration away
        if (options_.progress)
            options_.progress(fmt::format("the integration is not kept: {}", error.diagnostic().value));
    }
    return result;
}

} // namespace resonform
