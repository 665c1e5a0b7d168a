// SPDX-License-Identifier: GPL-3.0-or-later
// What the user wants of a system, from scenes/*.toml (model/files/read_scene.hpp); everything else is left
// out.
#pragma once

#include "algebra/number/number.hpp"
#include "model/system/system_file.hpp"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace resonform {

enum class Verdict { pass, fail, undecided };
const char* to_string(Verdict verdict);

// How emitted code computes many points.
enum class EmitForm { automatic, tables, atoms, direct };

// What becomes of modes that grow at eps = 0: they are followed, as long as they leave digits; or the start
// is moved along the fibres onto the manifold on which there are none.
enum class Growing { status, project };

struct StartValue {
    std::string name; // "xi", "C_delta", "psi", "psi'"
    GiNaC::ex value;  // in parameters and eps
    std::string text;
    SourceText source;
};

// "amplitude.z2" = 0 under [start]: this mode is 0 at all times, and one physical value of the fast variables
// is not given but follows from that.
struct ModeAtZero {
    std::string mode;  // as `derive` names it
    std::string state; // that is not given: "y'"
    Place place;
};

// Below the smallest, the effects of eps are lost in double precision; above the largest, eps is not small.
constexpr double smallest_eps = 1e-12, largest_eps = 0.5;
constexpr const char* eps_rule = "eps lies in 1e-12 <= eps <= 0.5";

// The error that emitted code may have against the exact solution if a scene says nothing else.
constexpr double default_ulp = 16, largest_ulp = 1e6;

struct VerifyPlan {
    GiNaC::ex interval; // in eps and parameters; default eps^-time_scale
    std::string interval_text = "1/eps";
    std::optional<SourceText> interval_source; // absent: by default
    std::vector<Rational> eps;                 // descending; default 0.2 0.1 0.05 0.02 0.01 ... 1e-4
    bool eps_given = false;                    // false: the judge may extend the ladder downwards
    std::map<std::string, int> claim;          // those given; held as weights are
    std::map<std::string, Verdict> expect;
    double ulp = default_ulp; // emitted code's largest error, in units of the last place of an output's scale
    std::string ulp_reason;   // why it is more than the default
    // Numbers that the source gives to figures of a report, at its values of eps: of an output ("psi") that
    // of its difference from direct integration, of a path ("y(x)") its own.
    std::map<std::string, std::vector<int>> figures;
};

// The values of eps that a report draws motions at.
constexpr std::array<const char*, 2> drawn_eps{"0.1", "0.01"};

// The sign of a value as far as it is known, with [fix] put in and eps = 0.1.
enum class Estimate {
    unknown,   // parameters are left, or rounding hides the sign
    unbounded, // no parameter is left, but it is not finite in double precision
    negative,
    zero,
    positive,
};

struct Scene {
    std::string name; // file stem
    std::string title;
    std::filesystem::path file;
    std::shared_ptr<const System> system;
    // Held as weights are, in units of 1/eps_root of the system.
    int order = 3;                 // N
    std::optional<int> time_scale; // p; exactly one of the two; default: 1/eps
    std::optional<int> truncation; // M
    std::vector<std::string> outputs;
    bool oscillating = true;
    bool transients = true; // modes that decay at eps = 0; where nothing oscillates they are left out, too
    Growing growing = Growing::status;
    bool error_estimate = false; // in the emitted code
    EmitForm form = EmitForm::automatic;
    std::map<std::string, GiNaC::ex> fix; // parameter -> exact value: 5/4, sqrt(2)
    std::vector<StartValue> start;        // in the order of the file
    std::optional<ModeAtZero> at_zero;
    Place fix_place, start_place; // of the tables, else of the file: for missing entries
    // Of the values, else of the file.
    Place order_place, time_scale_place, form_place, transients_place;
    VerifyPlan verify;

    // p; of a scene that gives its truncation that of 1/eps.
    [[nodiscard]] int slow_power() const { return time_scale ? *time_scale : system->eps_root; }
    // Whether it is among the outputs.
    [[nodiscard]] bool wants(const std::string& output) const;
    // Start value by canonical name ("amplitude.psi", "phase.psi", "constant.x", "xi", "psi", "psi'").
    [[nodiscard]] const StartValue* start_of(const std::string& canonical) const;
    // What start values and intervals may contain: parameters, eps, cancelled parameters that are fixed, and
    // the functions of the system.
    [[nodiscard]] Scope constants() const;
    // An expression with the values of [fix] put in; GiNaC throws if a denominator becomes zero.
    [[nodiscard]] GiNaC::ex fixed(const GiNaC::ex& value) const;
    [[nodiscard]] Estimate estimate(const GiNaC::ex& value) const;
    // For an unbounded value that is not real: "-eps is negative at eps = 0.1". Else empty.
    [[nodiscard]] std::string why_unreal(const GiNaC::ex& value) const;
};

// Errors: values of parameters are missing under [fix]; the rule says who needs them.
[[noreturn]] void not_fixed(const Scene& scene, const std::string& rule,
                            const std::vector<std::string>& missing);

} // namespace resonform
