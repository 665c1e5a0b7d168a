// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judging/domain.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/number.hpp"
#include "model/files/interval_length.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/regular.hpp"

#include <cln/real.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace resonform {

namespace {

constexpr int samples = 256; // of the interval: a condition that fails between two of them is not seen
constexpr int halvings = 60;

std::string line_of(const std::string& file, int line) { return fmt::format("{}:{}", file, line); }

} // namespace

DeclaredDomain::DeclaredDomain(const FirstOrderSystem& system, const Scene& scene)
    : system_(*system.system), scene_(scene), interval_text_(scene.verify.interval_text) {
    place_.file = scene.file.string();
    place_.key = "verify.interval";
    if (scene.verify.interval_source) place_ = place_of(*scene.verify.interval_source);
    GiNaC::exmap motion;
    GiNaC::lst unknown;
    for (const State& state : system.states) {
        if (system_.variables[state.variable].role != Role::slow) continue;
        const bool constant = std::none_of(system.states.begin(), system.states.end(),
                                           [&](const State& s) { return state.rate.has(s.symbol); });
        if (!constant) {
            unknown.append(state.symbol);
            continue;
        }
        const StartValue* start = scene.start_of(state.name);
        const GiNaC::ex begin = start == nullptr ? GiNaC::ex(0) : start->value;
        motions_.push_back({state.name, scene.fixed(begin + state.rate * time_)});
        motion[state.symbol] = motions_.back().value;
    }
    const auto add = [&](const GiNaC::ex& value, const std::string& text, const std::string& where) {
        for (const GiNaC::ex& symbol : unknown)
            if (value.has(symbol)) return;
        Condition condition{scene.fixed(value.subs(motion)), text, where, {}};
        for (std::size_t k = 0; k < motions_.size(); ++k)
            if (value.has(system.state(motions_[k].name).symbol)) condition.slow.push_back(k);
        conditions_.push_back(std::move(condition));
    };
    for (const Declaration& declared : system_.positive)
        add(declared.value, excerpt(declared.text) + " > 0",
            line_of(declared.source.file, declared.source.line));
    for (const SlowMotion& slow : motions_) {
        const Variable& v = *system_.variable(slow.name);
        const GiNaC::ex x = v.jet.front();
        const std::string where = line_of(v.place.file, v.place.line);
        if (v.positive) add(x, v.name + " > 0", where);
        // It keeps the sign that it starts with.
        if (v.nonzero && !v.positive) add(x * slow.value.subs(time_ == 0), v.name + " is not zero", where);
    }
}

// NaN, which counts as outside, where the value is no number.
double DeclaredDomain::number(const GiNaC::ex& value, const Rational& eps, double t) const {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const auto found = where_regular([&] {
        const GiNaC::lst point{system_.eps == system_.small_at(eps),
                               time_ == GiNaC::numeric(cln::cl_N(exact_rational(t)))};
        const GiNaC::ex e = system_.with_data(value.subs(point)).evalf();
        const bool real = GiNaC::is_a<GiNaC::numeric>(e) && GiNaC::ex_to<GiNaC::numeric>(e).is_real();
        return real ? GiNaC::ex_to<GiNaC::numeric>(e).to_double() : none;
    });
    return found.value_or(none);
}

void DeclaredDomain::require(const Rational& eps) const {
    const double end = std::min(interval_length(scene_, eps), longest_interval);
    for (const Condition& condition : conditions_)
        for (int i = 0; i <= samples; ++i) {
            double outside = end * i / samples;
            if (number(condition.value, eps, outside) > 0) continue;
            double inside = i == 0 ? 0 : end * (i - 1) / samples;
            for (int n = 0; n < halvings && i > 0; ++n) {
                const double middle = (inside + outside) / 2;
                (number(condition.value, eps, middle) > 0 ? inside : outside) = middle;
            }
            complain(condition, eps, outside);
        }
}

void DeclaredDomain::complain(const Condition& condition, const Rational& eps, double t) const {
    std::vector<std::string> values;
    for (const std::size_t k : condition.slow)
        values.push_back(fmt::format("{} = {:.6g}", motions_[k].name, number(motions_[k].value, eps, t)));
    bad_input({"the motion stays in the declared domain over the whole interval of verification",
               fmt::format("interval = {}, but at t = {:.6g} (eps = {}) {} leaves {}, declared in {}",
                           interval_text_, t, to_string(eps), fmt::join(values, ", "), condition.text,
                           condition.where),
               fmt::format("end the interval before eps*t = {:.6g}, or start elsewhere", to_double(eps) * t),
               place_});
}

} // namespace resonform
