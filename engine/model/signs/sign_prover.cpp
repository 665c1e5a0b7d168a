// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/signs/sign_prover.hpp"

#include "model/text/enclosure.hpp"
#include "model/text/function_call.hpp"
#include "model/text/named_function.hpp"

#include <algorithm>
#include <optional>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::numeric;

SignSet of_constant(const ex& e) {
    if (e.is_zero()) return SignSet::of(0);
    const ConstantSign sign = sign_of_constant(e);
    return sign == ConstantSign::unknown ? SignSet::all()
                                         : SignSet::of(sign == ConstantSign::positive ? 1 : -1);
}

SignSet flagged(bool positive, bool nonzero) {
    return positive ? SignSet::of(1) : SignSet{true, !nonzero, true};
}

} // namespace

SignSet SignProver::signs(const ex& e) const {
    const auto asked = signs_.find(e);
    return asked != signs_.end() ? asked->second : signs_.emplace(e, find_signs(e)).first->second;
}

SignSet SignProver::find_signs(const ex& e) const {
    SignSet signs = is_constant(e) ? of_constant(e) : declared(e);
    const auto narrow = [&](const auto& method) {
        if (signs.is_known()) return;
        const SignSet both = signs & method();
        if (!both.empty()) signs = both; // else the domain is empty
    };
    narrow([&] { return by_structure(e); });
    if (!is_constant(e)) narrow([&] { return real(e) ? in_atoms(e) : SignSet::all(); });
    return signs;
}

bool SignProver::nonzero(const ex& e) const {
    if (GiNaC::is_a<GiNaC::mul>(e))
        return std::all_of(e.begin(), e.end(), [this](const ex& part) { return nonzero(part); });
    if (GiNaC::is_a<GiNaC::power>(e)) return GiNaC::is_a<numeric>(e.op(1)) && nonzero(e.op(0));
    return !signs(e).zero;
}

bool SignProver::real(const ex& e) const {
    if (is_constant(e) && sign_of_constant(e) != ConstantSign::unknown) return true;
    if (GiNaC::is_a<numeric>(e)) return GiNaC::ex_to<numeric>(e).is_real();
    if (GiNaC::is_a<GiNaC::symbol>(e) || GiNaC::is_a<GiNaC::constant>(e)) return true;
    if (GiNaC::is_a<GiNaC::power>(e)) {
        if (!GiNaC::is_a<numeric>(e.op(1))) return false;
        const numeric n = GiNaC::ex_to<numeric>(e.op(1));
        if (n.is_negative() && !nonzero(e.op(0))) return false;
        return n.is_integer() ? real(e.op(0)) : !signs(e.op(0)).negative;
    }
    if (is_named(e)) return real(e.op(0));
    if (const std::optional<Function> f = function_of(e)) {
        const ex asked = asked_of(e.op(0), *f);
        if (!asked.is_equal(1) && !signs(asked).is_positive()) return false;
        return asked.is_equal(e.op(0)) || real(e.op(0));
    }
    return std::all_of(e.begin(), e.end(), [this](const ex& part) { return real(part); });
}

// The signs that the system file declares.
SignSet SignProver::declared(const ex& e) const {
    const auto is_declared = [&](const ex& other) {
        return std::any_of(system_.positive.begin(), system_.positive.end(),
                           [&](const Declaration& d) { return other.is_equal(d.value); });
    };
    if (is_declared(e)) return SignSet::of(1);
    if (is_declared(-e)) return SignSet::of(-1);
    if (is_named(e)) {
        const NamedFunction* f = system_.function(named_call(e).name);
        return flagged(f != nullptr && f->positive && named_call(e).derivative == 0,
                       f != nullptr && f->nonzero && named_call(e).derivative == 0);
    }
    if (e.is_equal(system_.eps)) return SignSet::of(1);
    for (const Parameter& p : system_.parameters)
        if (e.is_equal(p.symbol)) return flagged(p.positive, p.nonzero);
    for (const Variable& v : system_.variables)
        if (e.is_equal(v.jet.front())) return flagged(v.positive, v.nonzero);
    return SignSet::all();
}

SignSet SignProver::by_structure(const ex& e) const {
    if (GiNaC::is_a<GiNaC::power>(e)) return of_power(e);
    if (GiNaC::is_a<GiNaC::function>(e) && !is_named(e)) return of_function(e);
    if (GiNaC::is_a<GiNaC::add>(e)) return of_sum(e);
    if (!GiNaC::is_a<GiNaC::mul>(e)) return SignSet::all();
    SignSet product = SignSet::of(1);
    for (const ex& part : e) product = product * signs(part);
    return product;
}

SignSet SignProver::of_power(const ex& e) const {
    if (!e.op(1).info(GiNaC::info_flags::rational)) return SignSet::all();
    const numeric n = GiNaC::ex_to<numeric>(e.op(1));
    const SignSet base = signs(e.op(0));
    if (base.zero && n.is_negative()) return SignSet::all();
    if (n.is_even()) return real(e.op(0)) ? base.square() : SignSet::all();
    return n.is_integer() || !base.negative ? base : SignSet::all();
}

SignSet SignProver::of_function(const ex& e) const {
    const std::optional<Function> f = function_of(e);
    if (f && row_of(*f).keeps_sign) return signs(e.op(0));
    if (f == Function::logarithm) return signs(e.op(0)).is_positive() ? signs(e.op(0) - 1) : SignSet::all();
    if (f != Function::exponential && f != Function::hyperbolic_cosine) return SignSet::all();
    return real(e.op(0)) ? SignSet::of(1) : SignSet::all();
}

// The constants in a sum count as one addend: sqrt(a) - 1 + pi.
SignSet SignProver::of_sum(const ex& e) const {
    ex constants = 0;
    SignSet sum = SignSet::of(0);
    for (const ex& part : e) {
        if (is_constant(part))
            constants += part;
        else
            sum = sum + signs(part);
        if (sum == SignSet::all()) return sum;
    }
    return sum + of_constant(constants);
}

bool provably_positive(const ex& e, const System& system) {
    return SignProver(system).signs(e).is_positive();
}

bool provably_nonzero(const ex& e, const System& system) { return SignProver(system).nonzero(e); }

} // namespace resonform
