// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judging/emitted_check.hpp"

#include "model/system/start_names.hpp"
#include "verify/evaluate/interpreter.hpp"
#include "verify/judging/emitted_points.hpp"
#include "verify/symbolic/table.hpp"
#include "verify/symbolic/ulp.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace resonform {

namespace {

constexpr int little_room = 70;         // powers of e: of squares and amplitudes
constexpr std::size_t starts_only = 10; // times as many starts, of which the status at t = 0 is compared

template <class Real> constexpr const char* type_name = "double";
template <> constexpr const char* type_name<long double> = "long double";

template <class Real> class Check {
public:
    using Points = EmittedPoints<Real>;

    Check(const Program& program, std::shared_ptr<const EvaluatorLibrary> library,
          std::shared_ptr<const SymbolicSolution> symbolic, const Scene& scene, bool is_flow,
          const EmittedCheckOptions& options)
        : program_(program), library_(std::move(library)), symbolic_(std::move(symbolic)), scene_(scene),
          is_flow_(is_flow), options_(options) {
        result_.type = type_name<Real>;
    }

    EmittedInType run() {
        const auto drawn = emitted_points<Real>(scene_, options_.starts, options_.times, options_.seed);
        std::vector<SymbolicPoints> asked;
        for (const Points& d : drawn) asked.push_back(asked_of(d));
        if (options_.progress)
            options_.progress(
                fmt::format("emitted code in {} against the exact solution: {} starts, {} times "
                            "of each",
                            type_name<Real>, options_.starts, options_.times));
        const auto exact = symbolic_values(symbolic_, asked, options_.cache, options_.progress);
        for (std::size_t j = 0; j < drawn.size(); ++j) compare(drawn[j], asked[j], exact[j]);
        for (const Points& d :
             emitted_points<Real>(scene_, starts_only * options_.starts, 0, options_.seed + 1))
            compare_start(d);
        if (!result_.has_seen()) result_.ulp = std::numeric_limits<double>::quiet_NaN();
        return std::move(result_);
    }

private:
    [[nodiscard]] bool takes(const std::string& canonical) const {
        return std::any_of(program_.start.begin(), program_.start.end(),
                           [&](const ProgramInput& input) { return input.canonical == canonical; });
    }

    [[nodiscard]] SymbolicPoints asked_of(const Points& d) const {
        SymbolicPoints points{{Wide(d.eps), {}, {}, Wide(d.end), {}}, {d.times.begin(), d.times.end()}};
        for (const auto& [name, value] : d.start) {
            points.inputs.start.emplace(name, Wide(value));
            if (!takes(name)) points.inputs.untaken.insert(name);
        }
        return points;
    }

    [[nodiscard]] Evaluator<Real> emitted_at(const Points& drawn) const {
        std::vector<Real> start;
        for (const ProgramInput& input : program_.start) start.push_back(drawn.start_of(input.canonical));
        return {library_, drawn.eps, default_parameters<Real>(program_, drawn.eps), start, drawn.end};
    }

    // Whether the map leads back to its start is asked at t = 0 only, and few starts fail: of many, the
    // status there. Where the exact start says another one, the whole exact solution is asked.
    void compare_start(const Points& drawn) {
        const SymbolicPoints asked = asked_of(drawn);
        std::vector<Real> values(program_.outputs.size());
        const Status status = emitted_at(drawn).call(Real(0), values.data());
        const auto agrees = [&](Status exact) {
            return status == exact || (status == Status::low_precision && exact == Status::ok);
        };
        if (agrees(symbolic_->start().at(asked.inputs).status)) return;
        std::unique_ptr<SymbolicEvaluator> beside;
        const SymbolicPoint exact = SymbolicEvaluator(symbolic_, asked.inputs, Wide(0))(Wide(0));
        if (!agrees(exact.status) && !at_edge(status, exact, asked, Real(0), beside))
            disagree(status, exact.status, drawn, Real(0));
    }

    void disagree(Status emitted, Status exact, const Points& drawn, Real t) {
        record(std::numeric_limits<double>::infinity(), 0, "", drawn, t,
               fmt::format("emitted {}, symbolic {}", to_string(emitted), to_string(exact)));
    }

    // Statuses and values of an evaluator, all times of a start at once or one by one.
    struct Answers {
        std::vector<unsigned char> statuses;
        std::vector<std::vector<Real>> values; // [output][time]
        [[nodiscard]] Status status(std::size_t i) const { return static_cast<Status>(statuses[i]); }
    };

    [[nodiscard]] Answers one_by_one(const Evaluator<Real>& emitted, const Points& drawn) const {
        Answers answers = room_for(drawn);
        std::vector<Real> values(program_.outputs.size());
        for (std::size_t i = 0; i < drawn.times.size(); ++i) {
            answers.statuses[i] = static_cast<unsigned char>(emitted.call(drawn.times[i], values.data()));
            for (std::size_t k = 0; k < values.size(); ++k) answers.values[k][i] = values[k];
        }
        return answers;
    }

    [[nodiscard]] Answers at_once(const Evaluator<Real>& emitted, const Points& drawn) const {
        Answers answers = room_for(drawn);
        std::vector<Real*> rows;
        for (std::vector<Real>& row : answers.values) rows.push_back(row.data());
        emitted.batch({drawn.times.begin(), drawn.times.end()}, rows, answers.statuses);
        return answers;
    }

    [[nodiscard]] Answers room_for(const Points& drawn) const {
        const std::size_t count = drawn.times.size();
        return {std::vector<unsigned char>(count),
                std::vector<std::vector<Real>>(program_.outputs.size(), std::vector<Real>(count))};
    }

    void compare(const Points& drawn, const SymbolicPoints& asked, const std::vector<SymbolicPoint>& exact) {
        const Evaluator<Real> emitted = emitted_at(drawn);
        std::unique_ptr<SymbolicEvaluator> beside; // for times beside those asked for
        result_.points += drawn.times.size();
        result_.compared += compare(one_by_one(emitted, drawn), drawn, asked, exact, beside);
        if (std::is_same_v<Real, double> && !program_.rows.empty()) // from tables
            compare(at_once(emitted, drawn), drawn, asked, exact, beside);
    }

    // How many values are compared.
    std::size_t compare(const Answers& answers, const Points& drawn, const SymbolicPoints& asked,
                        const std::vector<SymbolicPoint>& exact, std::unique_ptr<SymbolicEvaluator>& beside) {
        std::size_t compared = 0;
        for (std::size_t i = 0; i < drawn.times.size(); ++i) {
            const Real t = drawn.times[i];
            const Status status = answers.status(i);
            if (status != exact[i].status &&
                !(status == Status::low_precision && exact[i].status == Status::ok)) {
                if (!at_edge(status, exact[i], asked, t, beside)) disagree(status, exact[i].status, drawn, t);
                continue;
            }
            if (exact[i].status != Status::ok || status == Status::low_precision) continue;
            ++compared;
            for (std::size_t k = 0; k < answers.values.size(); ++k)
                record(in_ulp<Real>(answers.values[k][i], exact[i].values[k], exact[i].scales[k]),
                       share(exact[i].phase_parts[k], exact[i].scales[k]), program_.outputs[k].name, drawn, t,
                       "");
        }
        return compared;
    }

    static double share(const Wide& part, const Wide& whole) {
        return whole > 0 ? static_cast<double>(Wide(part / whole)) : 0;
    }

    // The symbolic status changes to the emitted one within 4 ulp of t, a value is beyond the range of Real,
    // or a phase beyond what Real knows of it.
    bool at_edge(Status status, const SymbolicPoint& exact, const SymbolicPoints& asked, Real t,
                 std::unique_ptr<SymbolicEvaluator>& beside) const {
        if (status == Status::overflow)
            for (const Wide& value : exact.values)
                if (abs(value) > Wide(std::numeric_limits<Real>::max())) return true;
        if (!beside)
            beside = std::make_unique<SymbolicEvaluator>(symbolic_, asked.inputs, asked.inputs.slow_time_end);
        if (status == Status::overflow) // a power of a mode may be, though no value is
            for (const Wide& chi : beside->exponents(Wide(t)))
                if (program_.truncation * chi > log(Wide(std::numeric_limits<Real>::max())) - little_room)
                    return true;
        if (status == Status::outside_interval && exact.status == Status::ok &&
            beside->loses_phase(Wide(t), asked.inputs.slow_time_end / asked.inputs.eps,
                                phase_resolution<Real>(is_flow_)))
            return true;
        const auto times = times_at_edge(t);
        return std::any_of(times.begin(), times.end(),
                           [&](const Wide& time) { return (*beside)(time).status == status; });
    }

    void record(double ulp, double phase_share, const std::string& output, const Points& drawn, Real t,
                const std::string& statuses) {
        const bool first = result_.at.empty();
        if (!first && !(ulp > result_.ulp)) return;
        result_.ulp = ulp;
        result_.phase_share = phase_share;
        result_.output = output;
        result_.statuses = statuses;
        result_.at = {{"eps", static_cast<double>(drawn.eps)}};
        for (const auto& [name, value] : drawn.start)
            result_.at.emplace_back(user_start(name, *scene_.system), static_cast<double>(value));
        result_.at.emplace_back("t", static_cast<double>(t));
    }

    const Program& program_;
    std::shared_ptr<const EvaluatorLibrary> library_;
    std::shared_ptr<const SymbolicSolution> symbolic_;
    const Scene& scene_;
    bool is_flow_;
    const EmittedCheckOptions& options_;
    EmittedInType result_;
};

Verdict verdict_of(const EmittedCheck& check) {
    for (const EmittedInType& type : check.types)
        if (type.has_seen() && !(type.ulp <= check.threshold)) return Verdict::fail;
    for (const EmittedInType& type : check.types)
        if (static_cast<double>(type.compared) < compared_share * static_cast<double>(type.points))
            return Verdict::undecided;
    return Verdict::pass;
}

std::string place_of(const EmittedInType& type) {
    std::vector<std::string> inputs;
    for (const auto& [name, value] : type.at) inputs.push_back(fmt::format("{} = {:.17g}", name, value));
    return fmt::format("{}", fmt::join(inputs, ", "));
}

std::string line_of(const EmittedInType& type) {
    std::string line = fmt::format("    {:<12}", type.type);
    if (!type.has_seen())
        return line + fmt::format("nothing compared: 0 of {} points answered with numbers\n", type.points);
    if (!type.statuses.empty())
        line += type.statuses;
    else
        line += fmt::format("{:.3g} ulp of {}", type.ulp, type.output);
    if (type.phase_share > 0)
        line += fmt::format(", {:.0f} % of the scale there for a phase that the slow flow moves",
                            100 * type.phase_share);
    return line +
           fmt::format(" ({} of {} points answered), at {}\n", type.compared, type.points, place_of(type));
}

} // namespace

double EmittedCheck::worst() const {
    double most = std::numeric_limits<double>::quiet_NaN();
    for (const EmittedInType& type : types) most = std::fmax(most, type.ulp); // the first is no number
    return most;
}

EmittedCheck check_emitted(const Program& program, const std::shared_ptr<const EvaluatorLibrary>& library,
                           const Solution& solution, const Scene& scene, const EmittedCheckOptions& options) {
    const auto begin = std::chrono::steady_clock::now();
    EmittedCheck check;
    check.threshold = scene.verify.ulp;
    check.reason = scene.verify.ulp_reason;
    const auto symbolic = std::make_shared<const SymbolicSolution>(solution, scene);
    const bool is_flow = solution.flow != nullptr;
    check.types.push_back(Check<double>(program, library, symbolic, scene, is_flow, options).run());
    check.types.push_back(Check<long double>(program, library, symbolic, scene, is_flow, options).run());
    check.verdict = verdict_of(check);
    if (options.progress)
        options.progress(
            fmt::format("emitted code held against the exact solution in {:.1f} s",
                        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()));
    return check;
}

std::string to_text(const EmittedCheck& check) {
    std::string text = fmt::format("  emitted = symbolic: {}, threshold {:g} ulp of the output's scale",
                                   to_string(check.verdict), check.threshold);
    if (check.threshold > default_ulp)
        text += check.reason.empty() ? ", widened without a reason" : ", widened: " + check.reason;
    text += "\n";
    for (const EmittedInType& type : check.types) text += line_of(type);
    return text;
}

} // namespace resonform
