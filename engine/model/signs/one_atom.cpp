// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/signs/one_atom.hpp"

#include "model/text/growth.hpp"
#include "model/text/named_function.hpp"
#include "model/text/regular.hpp"

#include <algorithm>
#include <string>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

constexpr int highest_power = 24; // of the atom in what is asked, and in one condition

Rational exact_coefficient(const ex& e) { return cln::the<cln::cl_RA>(ex_to<numeric>(e).to_cl_N()); }

std::string name_of_function(const ex& e) { return ex_to<GiNaC::function>(e).get_name(); }

// An expression whose only atom it is, by the number t: sin(u) = 2 t/(1 + t^2), cos(u) = (1 - t^2)/(1 + t^2);
// exp(u/3) = t^2 where exp(u/6) is t; any other atom is t itself.
class Atom {
public:
    // nullopt: e has several, or none, or what is no rational function of them.
    static std::optional<Atom> of(const ex& e) {
        Atom atom;
        if (!atom.read(e) || atom.met_.empty()) return std::nullopt;
        atom.settle();
        return atom;
    }

    // The atom and whatever belongs to it: sin(u), cos(u).
    [[nodiscard]] const ex& kind() const { return met_.front(); }

    // Of the same sign as e wherever e has a value.
    [[nodiscard]] std::optional<UnivariatePolynomial> polynomial(const ex& e) const {
        const Atom own = of(e).value_or(Atom{});
        for (const ex& met : own.met_)
            if (by_t_.find(met) == by_t_.end()) return std::nullopt;
        if (own.met_.empty() || of_expression(e).degree > highest_power) return std::nullopt;
        const ex fraction = e.subs(by_t_, GiNaC::subs_options::no_pattern).normal().numer_denom();
        const ex p = (fraction.op(0) * fraction.op(1)).expand();
        if (!p.is_polynomial(t_) || p.degree(t_) > highest_power) return std::nullopt;
        UnivariatePolynomial result;
        for (int k = 0; k <= p.degree(t_); ++k) {
            const ex c = p.coeff(t_, k);
            if (!c.info(GiNaC::info_flags::rational)) return std::nullopt;
            result.push_back(exact_coefficient(c));
        }
        return result;
    }

    // t = infinity is sin(u) = 0, cos(u) = -1.
    [[nodiscard]] bool is_wave() const { return is_wave(kind()); }
    [[nodiscard]] std::optional<int> sign_at_infinity(const ex& e) const {
        GiNaC::exmap there;
        there[GiNaC::sin(kind().op(0))] = 0;
        there[GiNaC::cos(kind().op(0))] = -1;
        const auto value = where_regular([&] { return e.subs(there, GiNaC::subs_options::no_pattern); });
        if (!value || !value->info(GiNaC::info_flags::rational)) return std::nullopt;
        return ex_to<numeric>(*value).csgn();
    }

private:
    static bool is_exponential(const ex& e) {
        return is_a<GiNaC::function>(e) && !is_named(e) && name_of_function(e) == "exp";
    }
    static bool is_wave(const ex& e) {
        if (!is_a<GiNaC::function>(e) || is_named(e)) return false;
        return name_of_function(e) == "sin" || name_of_function(e) == "cos";
    }

    // false: no rational function of one atom.
    bool read(const ex& e) {
        if (is_a<numeric>(e)) return e.info(GiNaC::info_flags::rational);
        if (is_a<GiNaC::symbol>(e) || is_a<GiNaC::function>(e)) return meet(e);
        if (is_a<GiNaC::power>(e)) return e.op(1).info(GiNaC::info_flags::integer) && read(e.op(0));
        if (!is_a<GiNaC::add>(e) && !is_a<GiNaC::mul>(e)) return false;
        return std::all_of(e.begin(), e.end(), [this](const ex& part) { return read(part); });
    }

    bool meet(const ex& e) {
        if (std::any_of(met_.begin(), met_.end(), [&](const ex& other) { return other.is_equal(e); }))
            return true;
        const bool fits = met_.empty() || (is_wave() && is_wave(e) && e.op(0).is_equal(kind().op(0))) ||
                          (is_exponential(kind()) && is_exponential(e) &&
                           (e.op(0) / kind().op(0)).normal().info(GiNaC::info_flags::rational));
        if (fits) met_.push_back(e);
        return fits;
    }

    void settle() {
        if (is_wave()) {
            const ex square = 1 + t_ * t_;
            by_t_[GiNaC::sin(kind().op(0))] = 2 * t_ / square;
            by_t_[GiNaC::cos(kind().op(0))] = (1 - t_ * t_) / square;
            met_ = {GiNaC::sin(kind().op(0))};
            return;
        }
        numeric denominator = 1;
        const auto multiple = [&](const ex& e) {
            return is_exponential(e) ? ex_to<numeric>((e.op(0) / kind().op(0)).normal()) : numeric(1);
        };
        for (const ex& e : met_) denominator = GiNaC::lcm(denominator, multiple(e).denom());
        for (const ex& e : met_) by_t_[e] = GiNaC::pow(t_, multiple(e) * denominator);
    }

    GiNaC::symbol t_{"t"};
    std::vector<ex> met_;
    GiNaC::exmap by_t_;
};

// What is known of a function or symbol t by itself.
std::vector<SignCondition> known_range(const ex& atom, const System& system) {
    const SignCondition positive{{0, 1}, true}, nonzero{{0, 0, 1}, true};
    const auto between = [](const Rational& low, const Rational& high) {
        return std::vector<SignCondition>{{{-low, 1}, true}, {{high, -1}, true}};
    };
    const auto declared = [&](const auto& named) {
        return named.positive  ? std::vector{positive}
               : named.nonzero ? std::vector{nonzero}
                               : std::vector<SignCondition>{};
    };
    if (is_a<GiNaC::symbol>(atom)) {
        if (atom.is_equal(system.eps)) return {positive};
        for (const Parameter& p : system.parameters)
            if (atom.is_equal(p.symbol)) return declared(p);
        for (const Variable& v : system.variables)
            if (atom.is_equal(v.jet.front())) return declared(v);
        return {};
    }
    if (is_named(atom)) {
        const NamedFunction* f = system.function(named_call(atom).name);
        if (f == nullptr || named_call(atom).derivative != 0) return {};
        return declared(*f);
    }
    const std::string name = name_of_function(atom);
    const Rational half_pi = Rational(11) / 7; // a little more
    if (name == "exp") return {positive};
    if (name == "cosh") return {{{-1, 1}, false}};
    if (name == "tanh") return between(-1, 1);
    if (name == "atan" || name == "asin") return between(-half_pi, half_pi);
    return {};
}

} // namespace

std::optional<SignSet> signs_of_one_atom(const ex& e, const System& system) {
    const auto atom = Atom::of(e);
    if (!atom) return std::nullopt;
    const auto asked = atom->polynomial(e);
    if (!asked) return std::nullopt;
    std::vector<SignCondition> conditions = known_range(atom->kind(), system);
    for (const Declaration& declared : system.positive)
        if (auto p = atom->polynomial(declared.value)) conditions.push_back({*std::move(p), true});
    SignSet signs = signs_where(*asked, conditions);
    if (atom->is_wave()) {
        const auto last = atom->sign_at_infinity(e);
        if (!last) return std::nullopt;
        signs.insert(*last);
    }
    return signs.empty() ? std::nullopt : std::optional(signs);
}

} // namespace resonform
