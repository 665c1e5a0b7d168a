// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/signs/sign_prover.hpp"

#include "model/signs/one_atom.hpp"
#include "model/signs/root_split.hpp"
#include "model/text/enclosure.hpp"
#include "model/text/named_function.hpp"

#include <algorithm>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::numeric;

} // namespace

bool SignProver::declared_nonzero(const ex& symbol) const {
    for (const Parameter& p : system_.parameters) {
        if (p.nonzero && symbol.is_equal(p.symbol)) return true;
    }
    for (const Variable& v : system_.variables) {
        if (v.nonzero && symbol.is_equal(v.jet.front())) return true;
    }
    return of_symbol(symbol) == ProvedSign::positive || declared_positive(symbol) || has_no_zero(symbol);
}

bool SignProver::nonzero(const ex& e) const {
    const auto asked = nonzero_.find(e);
    if (asked != nonzero_.end()) return asked->second;
    return nonzero_.emplace(e, find_nonzero(e)).first->second;
}

bool SignProver::find_nonzero(const ex& e) const {
    if (is_constant(e)) return sign_of_constant(e) != ConstantSign::unknown;
    if (GiNaC::is_a<GiNaC::symbol>(e)) return declared_nonzero(e);
    if (GiNaC::is_a<GiNaC::mul>(e)) {
        return std::all_of(e.begin(), e.end(), [this](const ex& part) { return nonzero(part); });
    }
    if (GiNaC::is_a<GiNaC::power>(e)) return GiNaC::is_a<numeric>(e.op(1)) && nonzero(e.op(0));
    if (is_named(e)) {
        const NamedFunction* f = system_.function(named_call(e).name);
        return named_call(e).derivative == 0 && f != nullptr && f->nonzero;
    }
    return sign(e) == ProvedSign::positive || sign((-e).expand()) == ProvedSign::positive || has_no_zero(e);
}

// Though it may have either sign: tau where tau^2 - 2 is declared, x^2 - y - sqrt(y).
bool SignProver::has_no_zero(const ex& e) const {
    if (e.nops() > largest_compared || !is_comparable(e)) return false;
    const auto signs = signs_of_one_atom(e, system_);
    if ((signs && !signs->zero && real(e)) || is_excluded(e)) return true;
    const auto split = split_by_root(e.expand());
    if (!split) return false;
    const auto norm = split->norm(largest_compared); // e (a - b r)
    return norm && nonzero(*norm);
}

// Would its zeros contradict a declaration?
bool SignProver::is_excluded(const ex& e) const {
    const ex expanded = e.expand();
    return expanded.info(GiNaC::info_flags::rational_polynomial) &&
           std::any_of(system_.positive.begin(), system_.positive.end(), [&](const Declaration& declared) {
               return is_excluded_by(declared.value.expand(), expanded);
           });
}

// declared = quotient e + rest, where the rest is not positive: tau with tau^2 - k.
bool SignProver::is_excluded_by(const ex& declared, const ex& e) const {
    if (!declared.info(GiNaC::info_flags::rational_polynomial)) return false;
    const auto excluded = [&](const ex& symbol) {
        if (e.degree(symbol) == 0 || declared.degree(symbol) < e.degree(symbol) ||
            !GiNaC::is_a<numeric>(e.lcoeff(symbol)))
            return false;
        const ex rest = GiNaC::rem(declared, e, symbol).expand();
        return rest.nops() <= largest_compared && sign((-rest).expand(), 1) != ProvedSign::unknown;
    };
    for (const Parameter& p : system_.parameters)
        if (excluded(p.symbol)) return true;
    return std::any_of(system_.variables.begin(), system_.variables.end(),
                       [&](const Variable& v) { return excluded(v.jet.front()); });
}

} // namespace resonform
