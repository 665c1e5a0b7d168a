// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/scene_trial.hpp"

#include "certify/certificate.hpp"
#include "emit/program/build_program.hpp"
#include "fuzz/planted_change.hpp"
#include "fuzz/random_scene.hpp"
#include "model/files/read_scene.hpp"
#include "solve/time_scale.hpp"
#include "support/program.hpp"
#include "verify/evaluate/interpreter.hpp"
#include "verify/judging/emitted_points.hpp"
#include "verify/judging/ladder.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>

namespace resonform::test {

namespace {

namespace fs = std::filesystem;

constexpr int most_attempts = 40, most_changes = 100;
constexpr std::uint64_t stream_of_changes = 999'983; // beyond all attempts
constexpr int certificate_every = 5;                 // scenes: the change is in the normal form
constexpr std::size_t starts_of_effect = 500;        // with 20 times each: 10^4 points
constexpr std::uint64_t seed_of_effect = 2;

struct Derived {
    Scene scene;
    Solution solution;
    std::shared_ptr<const FirstOrderSystem> system;
    Verification verification;
};

class SceneTrial {
public:
    SceneTrial(std::uint64_t seed, const TrialOptions& options)
        : options_(options), changes_(seed, stream_of_changes) {
        result_.seed = seed;
        verify_.cache = options.folder;
        verify_.compiled = false; // the ladder; compiled code is checked besides
        verify_.emitted_starts = options.starts;
    }

    SceneResult run() {
        std::optional<Derived> derived;
        for (int attempt = 0; !derived && attempt < most_attempts && result_.wrong.empty(); ++attempt)
            derived = attempted(attempt);
        if (!derived) {
            if (result_.wrong.empty()) result_.wrong = "every attempt is refused";
            return result_;
        }
        if (result_.wrong.empty()) result_.wrong = judged(*derived);
        if (!result_.wrong.empty()) return result_;
        if (result_.seed % certificate_every == 0)
            plant_before_solving(*derived);
        else
            plant_in_code(*derived);
        return result_;
    }

private:
    std::optional<Derived> attempted(int attempt);
    std::string judged(Derived& derived);
    void plant_before_solving(const Derived& derived);
    void plant_in_code(const Derived& derived);
    bool has_effect(const Derived& derived, const Program& program, const Program& lie);
    bool seems_to_have_effect(const Derived& derived, const Program& program, const Program& lie);
    struct Answer {
        Status status = Status::ok;
        std::vector<double> values, scales;
    };
    const std::vector<Answer>& truth(const Derived& derived, const Program& program);
    [[nodiscard]] EmittedCheck checked(const Derived& derived, const Program& program, std::size_t starts,
                                       std::uint64_t seed) const;

    const TrialOptions& options_;
    VerifyOptions verify_;
    Draw changes_;
    SceneResult result_;
    std::vector<Answer> truth_; // at the points at which changes must have an effect
};

std::vector<EmittedPoints<double>> points_of_effect(const Derived& d) {
    return emitted_points<double>(d.scene, starts_of_effect, 20, seed_of_effect);
}

Interpreter<double> interpreter(const std::shared_ptr<const Interpretation>& shared,
                                const EmittedPoints<double>& at) {
    std::vector<double> start;
    for (const ProgramInput& input : shared->program->start) start.push_back(at.start_of(input.canonical));
    return {shared, at.eps, {}, start, at.end};
}

void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

// nullopt: the engine refuses it, with the reason.
std::optional<Derived> SceneTrial::attempted(int attempt) {
    const WrittenScene written = random_scene(result_.seed, attempt);
    const fs::path system = options_.folder / "random", file = system / "scenes" / "s.toml";
    fs::create_directories(file.parent_path());
    write(system / "system.toml", written.system);
    write(file, written.scene);
    result_.roles = written.roles;
    result_.order = written.order;
    Derived d;
    options_.enter(fmt::format("order {}, {}: derivation", written.order, written.roles));
    try {
        d.scene = read_scene(file, options_.folder);
        d.solution = solution_of(d.scene);
        check_time_scale(d.solution, d.scene);
        d.system = d.solution.normalization->normal_form.field->first_order;
        const Certificate certificate =
            certify(d.solution.normalization->normal_form, d.solution.normalization->map);
        if (!certificate.holds) result_.wrong = "certificate: " + certificate.complaint;
        options_.enter(fmt::format("order {}, {}: verification", written.order, written.roles));
        d.verification = verify(d.system, d.scene, d.solution, verify_);
        if (d.verification.emitted.verdict != Verdict::undecided) return d;
        result_.reason = "hardly a point of emitted = symbolic lies in the domain";
    } catch (const Error& error) {
        result_.reason = error.what();
        if (error.kind() != ErrorKind::refused) result_.wrong = error.what();
    }
    ++result_.refused;
    return std::nullopt;
}

// What is wrong with the scene itself, "" if nothing is. A ladder that is undecided is expected to be.
std::string SceneTrial::judged(Derived& d) {
    if (options_.compiled)
        d.verification.emitted =
            checked(d, build_program(d.solution, d.scene), options_.starts, EmittedCheckOptions().seed);
    const EmittedCheck& emitted = d.verification.emitted;
    for (const EmittedInType& type : emitted.types) result_.points += type.points;
    result_.ulp = emitted.types.front().ulp;
    result_.ulp_extended = emitted.types.back().ulp;
    result_.ladder = "pass";
    for (OutputVerdict& output : d.verification.outputs) {
        if (output.verdict == Verdict::fail) return "ladder of " + output.name + ": " + output.reason;
        if (output.verdict == Verdict::undecided) result_.ladder = "undecided: " + output.reason;
        output.expected = output.verdict;
    }
    return d.verification.as_expected() ? "" : to_text(emitted);
}

void SceneTrial::plant_before_solving(const Derived& d) {
    const auto planted = plant_in_normal_form(*d.solution.normalization, changes_);
    if (!planted) {
        result_.wrong = "no coefficient to change";
        return;
    }
    result_.change = planted->what;
    const Certificate certificate = certify(planted->lie.normal_form, planted->lie.map);
    if (certificate.holds)
        result_.wrong = "uncaught by the certificate: " + planted->what;
    else
        result_.caught_by = "certificate";
}

EmittedCheck SceneTrial::checked(const Derived& d, const Program& program, std::size_t starts,
                                 std::uint64_t seed) const {
    VerifyOptions how = verify_;
    how.compiled = options_.compiled;
    const auto shared = std::make_shared<const Program>(program);
    return check_emitted(program, library_of(shared, how, "dl"), d.solution, d.scene,
                         {options_.folder, {}, starts, 20, seed});
}

// The truth at the 10^4 points, in double, with what it adds up: of the scale that counts, at most as much.
const std::vector<SceneTrial::Answer>& SceneTrial::truth(const Derived& d, const Program& program) {
    if (!truth_.empty()) return truth_;
    const auto shared = std::make_shared<const Interpretation>(std::make_shared<const Program>(program));
    for (const auto& points : points_of_effect(d)) {
        const Interpreter<double> at = interpreter(shared, points);
        for (const double t : points.times) {
            Answer answer;
            answer.status = at.call(t, answer.values);
            if (answer.status == Status::ok) answer.status = at.scale(t, answer.scales);
            truth_.push_back(std::move(answer));
        }
    }
    return truth_;
}

// Whether a lie moves an output by more than twice the threshold, or a status.
bool SceneTrial::seems_to_have_effect(const Derived& d, const Program& program, const Program& lie) {
    const double allowed = 2 * d.scene.verify.ulp * std::numeric_limits<double>::epsilon();
    const auto shared = std::make_shared<const Interpretation>(std::make_shared<const Program>(lie));
    auto right = truth(d, program).begin();
    std::vector<double> values;
    for (const auto& points : points_of_effect(d)) {
        const Interpreter<double> at = interpreter(shared, points);
        for (const double t : points.times) {
            const Answer& answer = *right++;
            if (at.call(t, values) != answer.status) return true;
            if (answer.status != Status::ok) continue;
            for (std::size_t k = 0; k < values.size(); ++k)
                if (!(std::abs(values[k] - answer.values[k]) <= allowed * answer.scales[k])) return true;
        }
    }
    return false;
}

// At 10^4 points. What seems to have one is asked again, against 50 digits and in the scale that counts.
bool SceneTrial::has_effect(const Derived& d, const Program& program, const Program& lie) {
    if (!seems_to_have_effect(d, program, lie)) return false;
    options_.enter(
        fmt::format("order {}, {}: {}, 10^4 points", result_.order, result_.roles, result_.change));
    const EmittedCheck effect = checked(d, lie, starts_of_effect, seed_of_effect);
    if (effect.worst() > 2 * effect.threshold) result_.reason = to_text(effect);
    return effect.worst() > 2 * effect.threshold;
}

void SceneTrial::plant_in_code(const Derived& d) {
    const Program program = build_program(d.solution, d.scene);
    for (int k = 0; k < most_changes; ++k) {
        const auto planted = plant_in_program(program, changes_);
        if (!planted) continue;
        options_.enter(fmt::format("order {}, {}: {}", result_.order, result_.roles, planted->what));
        result_.change = planted->what;
        Verification lied = d.verification;
        lied.emitted = checked(d, planted->lie, options_.starts, EmittedCheckOptions().seed);
        if (!lied.as_expected()) {
            result_.caught_by = "emitted = symbolic";
            return;
        }
        if (has_effect(d, program, planted->lie)) {
            result_.wrong = "uncaught: " + planted->what + "\n" + result_.reason;
            return;
        }
        ++result_.without_effect;
    }
    result_.wrong = "no change has an effect";
}

} // namespace

SceneResult try_scene(std::uint64_t seed, const TrialOptions& options) {
    const auto begin = std::chrono::steady_clock::now();
    SceneResult result = SceneTrial(seed, options).run();
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

} // namespace resonform::test
