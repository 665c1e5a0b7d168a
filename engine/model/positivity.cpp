// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/positivity.hpp"

#include "model/bounds.hpp"
#include "model/constant_sign.hpp"
#include "model/named_function.hpp"
#include "model/pairs_of_terms.hpp"

#include <algorithm>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::numeric;

// Ordered, so that the weakest of several is their minimum.
enum class Sign { unknown, nonnegative, positive };

// Comparing with declared expressions divides polynomials; no honest one is larger than this.
constexpr std::size_t largest_compared = 60;
constexpr std::size_t largest_divided = 10;
constexpr int deepest_comparison = 4;
// Each comparison may lead to one with every declaration again: many are compared less deeply.
constexpr std::size_t few_declarations = 6;
constexpr int deepest_among_many = 2;

class Prover {
public:
    explicit Prover(const System& system) : system_(system) {}

    Sign sign(const ex& e) const {
        return sign(e, system_.positive.size() <= few_declarations ? deepest_comparison : deepest_among_many);
    }
    bool nonzero(const ex& e) const;
    bool real(const ex& e) const;

private:
    Sign sign(const ex& e, int comparisons) const;
    bool declared_positive(const ex& e) const;
    Sign of_symbol(const ex& e) const;
    Sign of_power(const ex& e, int comparisons) const;
    Sign of_function(const ex& e) const;
    Sign of_sum(const ex& e, int comparisons) const;
    Sign of_product(const ex& e, int comparisons) const;
    Sign of_negative(const ex& part, int comparisons) const;
    Sign by_structure(const ex& e, int comparisons) const;
    Sign by_declaration(const ex& e, int comparisons) const;
    Sign by_division(const ex& e, const ex& declared, int comparisons) const;
    Sign by_squares(const ex& e, int comparisons) const;
    Sign by_bounds(const ex& e, int comparisons) const;
    Sign by_pairs(const ex& e, int comparisons) const;
    bool declared_nonzero(const ex& symbol) const;

    const System& system_;
};

Sign Prover::of_symbol(const ex& e) const {
    if (e.is_equal(system_.eps)) return Sign::positive;
    for (const Parameter& p : system_.parameters) {
        if (p.positive && e.is_equal(p.symbol)) return Sign::positive;
    }
    for (const Variable& v : system_.variables) {
        if (v.positive && e.is_equal(v.jet.front())) return Sign::positive;
    }
    return Sign::unknown;
}

bool Prover::declared_nonzero(const ex& symbol) const {
    for (const Parameter& p : system_.parameters) {
        if (p.nonzero && symbol.is_equal(p.symbol)) return true;
    }
    for (const Variable& v : system_.variables) {
        if (v.nonzero && symbol.is_equal(v.jet.front())) return true;
    }
    return of_symbol(symbol) == Sign::positive || declared_positive(symbol);
}

// A real expression: no root of what may be negative, no logarithm of what may not be positive.
bool Prover::real(const ex& e) const {
    if (is_constant(e) && sign_of_constant(e) != ConstantSign::unknown) return true;
    if (GiNaC::is_a<numeric>(e)) return GiNaC::ex_to<numeric>(e).is_real();
    if (GiNaC::is_a<GiNaC::symbol>(e) || GiNaC::is_a<GiNaC::constant>(e)) return true;
    if (GiNaC::is_a<GiNaC::power>(e)) {
        if (!GiNaC::is_a<numeric>(e.op(1))) return false;
        const numeric n = GiNaC::ex_to<numeric>(e.op(1));
        if (n.is_negative() && !nonzero(e.op(0))) return false;
        return n.is_integer() ? real(e.op(0)) : sign(e.op(0)) != Sign::unknown;
    }
    if (is_named(e)) return real(e.op(0));
    if (GiNaC::is_a<GiNaC::function>(e)) {
        const std::string name = GiNaC::ex_to<GiNaC::function>(e).get_name();
        if (name == "log") return sign(e.op(0)) == Sign::positive;
        if (name == "asin") return sign((1 - e.op(0) * e.op(0)).expand()) == Sign::positive && real(e.op(0));
        if (name == "acos" || name == "tan") return false;
    }
    return std::all_of(e.begin(), e.end(), [this](const ex& part) { return real(part); });
}

Sign Prover::of_power(const ex& e, int comparisons) const {
    if (!GiNaC::is_a<numeric>(e.op(1))) return Sign::unknown;
    const numeric n = GiNaC::ex_to<numeric>(e.op(1));
    if (!n.is_rational()) return Sign::unknown;
    if (n.is_even()) {
        if (!real(e.op(0))) return Sign::unknown;
        if (nonzero(e.op(0))) return Sign::positive;
        return n.is_positive() ? Sign::nonnegative : Sign::unknown;
    }
    const Sign base = sign(e.op(0), comparisons);
    return base == Sign::nonnegative && !n.is_positive() ? Sign::unknown : base;
}

Sign Prover::of_function(const ex& e) const {
    if (is_named(e)) {
        const NamedCall call = named_call(e);
        const NamedFunction* f = system_.function(call.name);
        return call.derivative == 0 && f != nullptr && f->positive ? Sign::positive : Sign::unknown;
    }
    const std::string name = GiNaC::ex_to<GiNaC::function>(e).get_name();
    if ((name == "exp" || name == "cosh") && real(e.op(0))) return Sign::positive;
    // These have the sign of their argument.
    if (name == "sinh" || name == "tanh" || name == "atan") return sign(e.op(0));
    return Sign::unknown;
}

// (2 - tau)*tau may be held as -(-2 + tau)*tau, and (2 - tau)^(-1) as -(-2 + tau)^(-1): a number, a sum and
// an odd power of a sum may be the negative of something positive.
Sign Prover::of_product(const ex& e, int comparisons) const {
    Sign weakest = Sign::positive;
    bool negative = false;
    for (const ex& part : e) {
        Sign s = sign(part, comparisons);
        if (s == Sign::unknown) {
            s = of_negative(part, comparisons);
            negative = !negative;
        }
        if (s == Sign::unknown) return Sign::unknown;
        weakest = std::min(weakest, s);
    }
    return negative ? Sign::unknown : weakest;
}

// The sign of -part.
Sign Prover::of_negative(const ex& part, int comparisons) const {
    if (GiNaC::is_a<GiNaC::add>(part) || is_constant(part)) return sign((-part).expand(), comparisons);
    if (!GiNaC::is_a<GiNaC::power>(part) || !GiNaC::is_a<GiNaC::add>(part.op(0)) ||
        !part.op(1).info(GiNaC::info_flags::odd))
        return Sign::unknown;
    const Sign base = sign((-part.op(0)).expand(), comparisons);
    const bool inverted = part.op(1).info(GiNaC::info_flags::negative);
    return base == Sign::nonnegative && inverted ? Sign::unknown : base;
}

Sign Prover::by_structure(const ex& e, int comparisons) const {
    if (GiNaC::is_a<numeric>(e)) {
        const numeric n = GiNaC::ex_to<numeric>(e);
        if (!n.is_real() || n.is_negative()) return Sign::unknown;
        return n.is_zero() ? Sign::nonnegative : Sign::positive;
    }
    if (e.is_equal(GiNaC::Pi)) return Sign::positive;
    if (GiNaC::is_a<GiNaC::symbol>(e)) return of_symbol(e);
    if (GiNaC::is_a<GiNaC::power>(e)) return of_power(e, comparisons);
    if (GiNaC::is_a<GiNaC::function>(e)) return of_function(e);
    if (GiNaC::is_a<GiNaC::mul>(e)) return of_product(e, comparisons);
    if (!GiNaC::is_a<GiNaC::add>(e)) return Sign::unknown;
    return of_sum(e, comparisons);
}

// What is constant in it counts as one addend: sqrt(a) - 1 + pi.
Sign Prover::of_sum(const ex& e, int comparisons) const {
    ex constants = 0;
    if (!is_constant(e))
        for (const ex& part : e)
            if (is_constant(part)) constants += part;
    Sign strongest = constants.is_zero() ? Sign::unknown : sign(constants, comparisons);
    bool known = constants.is_zero() || strongest != Sign::unknown;
    for (const ex& part : e) {
        if (!constants.is_zero() && is_constant(part)) continue;
        const Sign s = known ? sign(part, comparisons) : Sign::unknown;
        known = s != Sign::unknown;
        if (!known) break;
        strongest = std::max(strongest, s);
    }
    return known ? strongest : std::max(by_squares(e, comparisons), by_bounds(e, comparisons));
}

// a - b for positive a and b has the sign of a^2 - b^2: sqrt(tau^2 + r) - tau.
Sign Prover::by_squares(const ex& e, int comparisons) const {
    if (e.nops() != 2 || comparisons == 0) return Sign::unknown;
    for (const std::size_t k : {0U, 1U}) {
        const ex a = e.op(k), b = -e.op(1 - k);
        const bool root = std::any_of(a.preorder_begin(), a.preorder_end(), [](const ex& part) {
            return GiNaC::is_a<GiNaC::power>(part) && !part.op(1).info(GiNaC::info_flags::integer);
        });
        if (root && sign(a, comparisons) == Sign::positive && sign(b, comparisons) != Sign::unknown)
            return sign((a * a - b * b).expand(), comparisons - 1);
    }
    return Sign::unknown;
}

// 2 + cos(tau), 3/2 + xi^2 - tanh(tau)
Sign Prover::by_bounds(const ex& e, int comparisons) const {
    const auto is_function = [](const ex& part) { return GiNaC::is_a<GiNaC::function>(part); };
    if (std::none_of(e.preorder_begin(), e.preorder_end(), is_function) || !real(e)) return Sign::unknown;
    const Bounds bounds = bounds_of(e, [&](const ex& part) {
        return !GiNaC::is_a<GiNaC::add>(part) && sign(part, comparisons) != Sign::unknown;
    });
    if (!bounds.low || bounds.low->is_negative()) return Sign::unknown;
    return bounds.low->is_zero() ? Sign::nonnegative : Sign::positive;
}

// m + c - c*cos(u)^2, x^2 - x*y + y^2: not negative, and positive if it is so without a little of a positive
// term.
Sign Prover::by_pairs(const ex& e, int comparisons) const {
    if (comparisons == 0 || !GiNaC::is_a<GiNaC::add>(e)) return Sign::unknown;
    const ex sum = e.expand(); // which terms there are is not left to the form of e
    if (!GiNaC::is_a<GiNaC::add>(sum) || sum.nops() > largest_compared) return Sign::unknown;
    const auto nonnegative = [&](const ex& all) {
        return nonnegative_by_pairs(
            all, [&](const ex& part) { return sign(part, 0) == Sign::positive; },
            [&](const ex& part) { return real(part); });
    };
    if (!nonnegative(sum)) return Sign::unknown;
    const numeric little(1, 1024); // as much of a positive term may be missing
    for (const ex& term : sum)
        if (sign(term, 0) == Sign::positive && nonnegative(sum - little * term)) return Sign::positive;
    return Sign::nonnegative;
}

// With d > 0 declared: e = q d has the sign of q; e = d + rest is positive if the rest is >= 0.
Sign Prover::by_declaration(const ex& e, int comparisons) const {
    if (comparisons == 0 || !GiNaC::is_a<GiNaC::add>(e)) return Sign::unknown;
    const ex expanded = e.expand();
    if (expanded.nops() > largest_compared) return Sign::unknown;
    for (const Declaration& declared : system_.positive) {
        const ex d = declared.value.expand();
        const ex rest = (expanded - d).expand();
        if (rest.is_zero()) return Sign::positive;
        const bool simpler = !GiNaC::is_a<GiNaC::add>(rest) || rest.nops() <= expanded.nops();
        if (simpler && sign(rest, comparisons - 1) != Sign::unknown) return Sign::positive;
        ex quotient;
        if (GiNaC::is_a<numeric>(d) || !expanded.info(GiNaC::info_flags::rational_polynomial) ||
            !d.info(GiNaC::info_flags::rational_polynomial) || !GiNaC::divide(expanded, d, quotient)) {
            continue;
        }
        const Sign s = sign(quotient, comparisons - 1);
        if (s != Sign::unknown) return s;
    }
    for (const Declaration& declared : system_.positive) {
        const Sign s = by_division(expanded, declared.value.expand(), comparisons - 2);
        if (s != Sign::unknown) return s;
    }
    return Sign::unknown;
}

// e = quotient d + rest, divided with respect to one symbol: 13 + 12*mu - 12*mu^2 = 12*mu (1 - mu) + 13.
Sign Prover::by_division(const ex& e, const ex& declared, int comparisons) const {
    if (comparisons < 0 || e.nops() > largest_divided || !e.info(GiNaC::info_flags::rational_polynomial) ||
        !declared.info(GiNaC::info_flags::rational_polynomial))
        return Sign::unknown;
    const auto divided_by = [&](const ex& symbol) {
        if (declared.degree(symbol) == 0 || e.degree(symbol) < declared.degree(symbol) ||
            !GiNaC::is_a<numeric>(declared.lcoeff(symbol)))
            return Sign::unknown;
        const ex quotient = GiNaC::quo(e, declared, symbol).expand();
        const ex rest = GiNaC::rem(e, declared, symbol).expand();
        const Sign s = sign(quotient, comparisons);
        const Sign t = s == Sign::unknown ? s : sign(rest, comparisons);
        return t == Sign::unknown ? t : std::max(s, t);
    };
    for (const Parameter& p : system_.parameters)
        if (const Sign s = divided_by(p.symbol); s != Sign::unknown) return s;
    for (const Variable& v : system_.variables)
        if (const Sign s = divided_by(v.jet.front()); s != Sign::unknown) return s;
    return Sign::unknown;
}

bool Prover::declared_positive(const ex& e) const {
    return std::any_of(system_.positive.begin(), system_.positive.end(),
                       [&](const Declaration& declared) { return e.is_equal(declared.value); });
}

Sign Prover::sign(const ex& e, int comparisons) const {
    if (declared_positive(e)) return Sign::positive;
    if (is_constant(e)) {
        const ConstantSign decided = sign_of_constant(e);
        if (decided != ConstantSign::unknown)
            return decided == ConstantSign::positive ? Sign::positive : Sign::unknown;
    }
    Sign s = by_structure(e, comparisons);
    if (s == Sign::unknown) s = by_declaration(e, comparisons);
    return s == Sign::unknown ? by_pairs(e, comparisons) : s;
}

bool Prover::nonzero(const ex& e) const {
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
    return sign(e) == Sign::positive || sign((-e).expand()) == Sign::positive;
}

} // namespace

bool provably_positive(const ex& e, const System& system) { return Prover(system).sign(e) == Sign::positive; }

bool provably_nonzero(const ex& e, const System& system) { return Prover(system).nonzero(e); }

} // namespace resonform
