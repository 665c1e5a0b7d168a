// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/signs/sign_prover.hpp"

#include "model/text/enclosure.hpp"
#include "model/text/named_function.hpp"

#include <algorithm>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::numeric;

constexpr int deepest_comparison = 4;
// Each comparison may lead to one with every declaration again: many are compared less deeply.
constexpr std::size_t few_declarations = 6;
constexpr int deepest_among_many = 2;

} // namespace

ProvedSign SignProver::sign(const ex& e) const {
    return sign(e, system_.positive.size() <= few_declarations ? deepest_comparison : deepest_among_many);
}

ProvedSign SignProver::of_symbol(const ex& e) const {
    if (e.is_equal(system_.eps)) return ProvedSign::positive;
    for (const Parameter& p : system_.parameters) {
        if (p.positive && e.is_equal(p.symbol)) return ProvedSign::positive;
    }
    for (const Variable& v : system_.variables) {
        if (v.positive && e.is_equal(v.jet.front())) return ProvedSign::positive;
    }
    return ProvedSign::unknown;
}

bool SignProver::real(const ex& e) const {
    if (is_constant(e) && sign_of_constant(e) != ConstantSign::unknown) return true;
    if (GiNaC::is_a<numeric>(e)) return GiNaC::ex_to<numeric>(e).is_real();
    if (GiNaC::is_a<GiNaC::symbol>(e) || GiNaC::is_a<GiNaC::constant>(e)) return true;
    if (GiNaC::is_a<GiNaC::power>(e)) {
        if (!GiNaC::is_a<numeric>(e.op(1))) return false;
        const numeric n = GiNaC::ex_to<numeric>(e.op(1));
        if (n.is_negative() && !nonzero(e.op(0))) return false;
        return n.is_integer() ? real(e.op(0)) : sign(e.op(0)) != ProvedSign::unknown;
    }
    if (is_named(e)) return real(e.op(0));
    if (GiNaC::is_a<GiNaC::function>(e)) {
        const std::string name = GiNaC::ex_to<GiNaC::function>(e).get_name();
        if (name == "log") return sign(e.op(0)) == ProvedSign::positive;
        if (name == "asin")
            return sign((1 - e.op(0) * e.op(0)).expand()) == ProvedSign::positive && real(e.op(0));
        if (name == "acos" || name == "tan") return false;
    }
    return std::all_of(e.begin(), e.end(), [this](const ex& part) { return real(part); });
}

ProvedSign SignProver::of_power(const ex& e, int comparisons) const {
    if (!GiNaC::is_a<numeric>(e.op(1))) return ProvedSign::unknown;
    const numeric n = GiNaC::ex_to<numeric>(e.op(1));
    if (!n.is_rational()) return ProvedSign::unknown;
    if (n.is_even()) {
        if (!real(e.op(0))) return ProvedSign::unknown;
        if (nonzero(e.op(0))) return ProvedSign::positive;
        return n.is_positive() ? ProvedSign::nonnegative : ProvedSign::unknown;
    }
    const ProvedSign base = sign(e.op(0), comparisons);
    return base == ProvedSign::nonnegative && !n.is_positive() ? ProvedSign::unknown : base;
}

ProvedSign SignProver::of_function(const ex& e) const {
    if (is_named(e)) {
        const NamedCall call = named_call(e);
        const NamedFunction* f = system_.function(call.name);
        return call.derivative == 0 && f != nullptr && f->positive ? ProvedSign::positive
                                                                   : ProvedSign::unknown;
    }
    const std::string name = GiNaC::ex_to<GiNaC::function>(e).get_name();
    if ((name == "exp" || name == "cosh") && real(e.op(0))) return ProvedSign::positive;
    // These have the sign of their argument.
    if (name == "sinh" || name == "tanh" || name == "atan") return sign(e.op(0));
    return ProvedSign::unknown;
}

// (2 - tau)*tau may be held as -(-2 + tau)*tau, and (2 - tau)^(-1) as -(-2 + tau)^(-1): a number, a sum and
// an odd power of a sum may be the negative of something positive.
ProvedSign SignProver::of_product(const ex& e, int comparisons) const {
    ProvedSign weakest = ProvedSign::positive;
    bool negative = false;
    for (const ex& part : e) {
        ProvedSign s = sign(part, comparisons);
        if (s == ProvedSign::unknown) {
            s = of_negative(part, comparisons);
            negative = !negative;
        }
        if (s == ProvedSign::unknown) return ProvedSign::unknown;
        weakest = std::min(weakest, s);
    }
    return negative ? ProvedSign::unknown : weakest;
}

// The sign of -part.
ProvedSign SignProver::of_negative(const ex& part, int comparisons) const {
    if (is_constant(part)) // of log(1 - pi) neither sign is known: a product with -1 asks here again
        return sign_of_constant(part) == ConstantSign::negative ? ProvedSign::positive : ProvedSign::unknown;
    if (GiNaC::is_a<GiNaC::add>(part)) return sign((-part).expand(), comparisons);
    if (!GiNaC::is_a<GiNaC::power>(part) || !GiNaC::is_a<GiNaC::add>(part.op(0)) ||
        !part.op(1).info(GiNaC::info_flags::odd))
        return ProvedSign::unknown;
    const ProvedSign base = sign((-part.op(0)).expand(), comparisons);
    const bool inverted = part.op(1).info(GiNaC::info_flags::negative);
    return base == ProvedSign::nonnegative && inverted ? ProvedSign::unknown : base;
}

ProvedSign SignProver::by_structure(const ex& e, int comparisons) const {
    if (GiNaC::is_a<numeric>(e)) {
        const numeric n = GiNaC::ex_to<numeric>(e);
        if (!n.is_real() || n.is_negative()) return ProvedSign::unknown;
        return n.is_zero() ? ProvedSign::nonnegative : ProvedSign::positive;
    }
    if (e.is_equal(GiNaC::Pi)) return ProvedSign::positive;
    if (GiNaC::is_a<GiNaC::symbol>(e)) return of_symbol(e);
    if (GiNaC::is_a<GiNaC::power>(e)) return of_power(e, comparisons);
    if (GiNaC::is_a<GiNaC::function>(e)) return of_function(e);
    if (GiNaC::is_a<GiNaC::mul>(e)) return of_product(e, comparisons);
    if (!GiNaC::is_a<GiNaC::add>(e)) return ProvedSign::unknown;
    return of_sum(e, comparisons);
}

bool SignProver::declared_positive(const ex& e) const {
    return std::any_of(system_.positive.begin(), system_.positive.end(),
                       [&](const Declaration& declared) { return e.is_equal(declared.value); });
}

ProvedSign SignProver::sign(const ex& e, int comparisons) const {
    Known<ProvedSign>& known = signs_[comparisons];
    const auto asked = known.find(e);
    if (asked != known.end()) return asked->second;
    return known.emplace(e, find_sign(e, comparisons)).first->second;
}

ProvedSign SignProver::find_sign(const ex& e, int comparisons) const {
    if (declared_positive(e)) return ProvedSign::positive;
    if (is_constant(e)) {
        const ConstantSign decided = sign_of_constant(e);
        if (decided != ConstantSign::unknown)
            return decided == ConstantSign::positive ? ProvedSign::positive : ProvedSign::unknown;
    }
    ProvedSign s = by_structure(e, comparisons);
    if (s != ProvedSign::positive) s = std::max(s, by_one_atom(e));
    if (s == ProvedSign::unknown) s = by_declaration(e, comparisons);
    if (s == ProvedSign::unknown) s = by_pairs(e, comparisons);
    return s == ProvedSign::positive ? s : std::max(s, by_discriminant(e, comparisons));
}

} // namespace resonform
