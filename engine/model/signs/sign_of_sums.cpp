// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/signs/sign_prover.hpp"

#include "model/signs/one_atom.hpp"
#include "model/signs/pairs_of_terms.hpp"
#include "model/signs/root_split.hpp"
#include "model/text/bounds.hpp"
#include "model/text/enclosure.hpp"
#include "model/text/growth.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::numeric;

constexpr std::size_t largest_divided = 10; // operands of a sum
constexpr double most_terms = 20000;        // of what is expanded

} // namespace

bool is_comparable(const ex& e) { return of_expression(e).terms <= most_terms; }

// What is constant in it counts as one addend: sqrt(a) - 1 + pi.
ProvedSign SignProver::of_sum(const ex& e, int comparisons) const {
    ex constants = 0;
    if (!is_constant(e))
        for (const ex& part : e)
            if (is_constant(part)) constants += part;
    ProvedSign strongest = constants.is_zero() ? ProvedSign::unknown : sign(constants, comparisons);
    bool known = constants.is_zero() || strongest != ProvedSign::unknown;
    for (const ex& part : e) {
        if (!constants.is_zero() && is_constant(part)) continue;
        const ProvedSign s = known ? sign(part, comparisons) : ProvedSign::unknown;
        known = s != ProvedSign::unknown;
        if (!known) break;
        strongest = std::max(strongest, s);
    }
    if (known) return strongest;
    const ProvedSign whole = std::max(by_root(e, comparisons), by_bounds(e, comparisons));
    return whole == ProvedSign::unknown ? by_independent_part(e, comparisons) : whole;
}

// sqrt(b^2 + 1) - b + tau^2: without the addends that are not negative and have no symbol in common with
// those whose sign is unknown.
ProvedSign SignProver::by_independent_part(const ex& e, int comparisons) const {
    if (comparisons == 0 || e.nops() > largest_compared) return ProvedSign::unknown;
    ex rest = 0;
    GiNaC::exset open; // symbols
    std::vector<std::pair<ex, ProvedSign>> closed;
    for (const ex& part : e) {
        const ProvedSign s = is_constant(part) ? ProvedSign::unknown : sign(part, comparisons - 1);
        if (s != ProvedSign::unknown) {
            closed.emplace_back(part, s);
            continue;
        }
        rest += part;
        std::copy_if(part.preorder_begin(), part.preorder_end(), std::inserter(open, open.end()),
                     [](const ex& inner) { return GiNaC::is_a<GiNaC::symbol>(inner); });
    }
    ProvedSign left_out = ProvedSign::unknown;
    for (const auto& [part, s] : closed) {
        const bool shares = std::any_of(part.preorder_begin(), part.preorder_end(),
                                        [&](const ex& inner) { return open.count(inner) > 0; });
        if (shares)
            rest += part;
        else
            left_out = std::max(left_out, s);
    }
    const ProvedSign s = left_out == ProvedSign::unknown ? left_out : sign(rest, comparisons - 1);
    return s == ProvedSign::unknown ? s : std::max(s, left_out);
}

// sqrt(b^2) is b or -b, where the sign of b is known.
ex SignProver::without_squares(const ex& e, int comparisons) const {
    if (GiNaC::is_a<GiNaC::power>(e) && !e.op(1).info(GiNaC::info_flags::integer) &&
        GiNaC::is_a<GiNaC::power>(e.op(0)) && e.op(0).op(1).info(GiNaC::info_flags::even)) {
        const ex base = e.op(0).op(0), exponent = e.op(0).op(1) * e.op(1);
        for (const ex& root : {base, (-base).expand()})
            if (sign(root, comparisons) == ProvedSign::positive) return GiNaC::pow(root, exponent);
        return e;
    }
    if (!GiNaC::is_a<GiNaC::add>(e) && !GiNaC::is_a<GiNaC::mul>(e)) return e;
    const bool sum = GiNaC::is_a<GiNaC::add>(e);
    ex result = sum ? 0 : 1;
    for (const ex& part : e)
        result =
            sum ? result + without_squares(part, comparisons) : result * without_squares(part, comparisons);
    return result;
}

// a + b r with r >= 0 has the sign of a where a^2 > b^2 r^2, else that of b: sqrt(tau^2 + r) - tau.
ProvedSign SignProver::by_root(const ex& e, int comparisons) const {
    if (comparisons == 0 || e.nops() > largest_compared || !is_comparable(e)) return ProvedSign::unknown;
    if (const ex plain = without_squares(e, comparisons - 1); !plain.is_equal(e))
        return sign(plain, comparisons - 1);
    const auto split = split_by_root(e.expand());
    if (!split || sign(split->radicand, comparisons - 1) == ProvedSign::unknown || !real(e))
        return ProvedSign::unknown;
    const auto norm = split->norm(largest_compared);
    if (!norm) return ProvedSign::unknown;
    const ProvedSign a = sign(split->a, comparisons - 1), b = sign(split->b, comparisons - 1);
    if (a != ProvedSign::unknown && b != ProvedSign::unknown)
        return b == ProvedSign::positive && nonzero(split->radicand) ? b : a;
    if (a != ProvedSign::unknown) return sign(*norm, comparisons - 1);
    return b == ProvedSign::unknown ? b : sign((-*norm).expand(), comparisons - 1);
}

// By all that is known of a single symbol or function: x^2 - x - 1 where x - 2 is declared.
ProvedSign SignProver::by_one_atom(const ex& e) const {
    const bool simple = !GiNaC::is_a<GiNaC::add>(e) && system_.positive.empty(); // its structure tells all
    if (simple || GiNaC::is_a<GiNaC::function>(e)) return ProvedSign::unknown;
    const auto signs = signs_of_one_atom(e, system_);
    if (!signs || signs->negative || !real(e)) return ProvedSign::unknown;
    return signs->zero ? ProvedSign::nonnegative : ProvedSign::positive;
}

// 2 + cos(tau), 3/2 + xi^2 - tanh(tau)
ProvedSign SignProver::by_bounds(const ex& e, int comparisons) const {
    const auto is_function = [](const ex& part) { return GiNaC::is_a<GiNaC::function>(part); };
    if (std::none_of(e.preorder_begin(), e.preorder_end(), is_function) || !real(e))
        return ProvedSign::unknown;
    const Bounds bounds = bounds_of(e, [&](const ex& part) {
        return !GiNaC::is_a<GiNaC::add>(part) && sign(part, comparisons) != ProvedSign::unknown;
    });
    if (!bounds.low || bounds.low->is_negative()) return ProvedSign::unknown;
    return bounds.low->is_zero() ? ProvedSign::nonnegative : ProvedSign::positive;
}

// m + c - c*cos(u)^2, x^2 - x*y + y^2: not negative, and positive if it is so without a little of a positive
// term.
ProvedSign SignProver::by_pairs(const ex& e, int comparisons) const {
    if (comparisons == 0 || !GiNaC::is_a<GiNaC::add>(e) || !is_comparable(e)) return ProvedSign::unknown;
    const ex sum = e.expand(); // which terms there are is not left to the form of e
    if (!GiNaC::is_a<GiNaC::add>(sum) || sum.nops() > largest_compared) return ProvedSign::unknown;
    const auto nonnegative = [&](const ex& all) {
        return nonnegative_by_pairs(
            all, [&](const ex& part) { return sign(part, 0) == ProvedSign::positive; },
            [&](const ex& part) { return real(part); });
    };
    if (!nonnegative(sum)) return ProvedSign::unknown;
    const numeric little(1, 1024); // as much of a positive term may be missing
    for (const ex& term : sum)
        if (sign(term, 0) == ProvedSign::positive && nonnegative(sum - little * term))
            return ProvedSign::positive;
    return ProvedSign::nonnegative;
}

// a x^2 + b x + c with a > 0 has the sign of 4 a c - b^2, where that is not negative: 1 + (s - 1 - k)^2 when
// it is multiplied out.
ProvedSign SignProver::by_discriminant(const ex& e, int comparisons) const {
    if (comparisons < 2 || !GiNaC::is_a<GiNaC::add>(e) || !is_comparable(e)) return ProvedSign::unknown;
    const ex sum = e.expand();
    if (sum.nops() > largest_compared) return ProvedSign::unknown;
    const auto of_quadratic = [&](const ex& x) {
        if (!sum.is_polynomial(x) || sum.degree(x) != 2) return ProvedSign::unknown;
        const ex a = sum.coeff(x, 2), b = sum.coeff(x, 1), c = sum.coeff(x, 0);
        if (sign(a, comparisons - 2) != ProvedSign::positive || !real(b)) return ProvedSign::unknown;
        return sign((4 * a * c - b * b).expand(), comparisons - 2);
    };
    for (const Parameter& p : system_.parameters)
        if (const ProvedSign s = of_quadratic(p.symbol); s != ProvedSign::unknown) return s;
    for (const Variable& v : system_.variables)
        if (const ProvedSign s = of_quadratic(v.jet.front()); s != ProvedSign::unknown) return s;
    return ProvedSign::unknown;
}

// With d > 0 declared: e = q d has the sign of q; e = d + rest is positive if the rest is >= 0.
ProvedSign SignProver::by_declaration(const ex& e, int comparisons) const {
    if (comparisons == 0 || !GiNaC::is_a<GiNaC::add>(e) || !is_comparable(e)) return ProvedSign::unknown;
    const ex expanded = e.expand();
    if (expanded.nops() > largest_compared) return ProvedSign::unknown;
    for (const Declaration& declared : system_.positive) {
        const ex d = declared.value.expand();
        const ex rest = (expanded - d).expand();
        if (rest.is_zero()) return ProvedSign::positive;
        const bool simpler = !GiNaC::is_a<GiNaC::add>(rest) || rest.nops() <= expanded.nops();
        if (simpler && sign(rest, comparisons - 1) != ProvedSign::unknown) return ProvedSign::positive;
        GiNaC::exmap functions; // and roots: symbols stand for them
        const ex dividend = expanded.to_polynomial(functions), divisor = d.to_polynomial(functions);
        ex quotient;
        if (GiNaC::is_a<numeric>(d) || !dividend.info(GiNaC::info_flags::rational_polynomial) ||
            !divisor.info(GiNaC::info_flags::rational_polynomial) ||
            !GiNaC::divide(dividend, divisor, quotient)) {
            continue;
        }
        const ProvedSign s = sign(quotient.subs(functions, GiNaC::subs_options::no_pattern), comparisons - 1);
        if (s != ProvedSign::unknown) return s;
    }
    for (const Declaration& declared : system_.positive) {
        const ProvedSign s = by_division(expanded, declared.value.expand(), comparisons - 2);
        if (s != ProvedSign::unknown) return s;
    }
    return ProvedSign::unknown;
}

// e = quotient d + rest, divided with respect to one symbol: 13 + 12*mu - 12*mu^2 = 12*mu (1 - mu) + 13.
ProvedSign SignProver::by_division(const ex& e, const ex& declared, int comparisons) const {
    if (comparisons < 0 || e.nops() > largest_divided || !e.info(GiNaC::info_flags::rational_polynomial) ||
        !declared.info(GiNaC::info_flags::rational_polynomial))
        return ProvedSign::unknown;
    const auto divided_by = [&](const ex& symbol) {
        if (declared.degree(symbol) == 0 || e.degree(symbol) < declared.degree(symbol) ||
            !GiNaC::is_a<numeric>(declared.lcoeff(symbol)))
            return ProvedSign::unknown;
        const ex quotient = GiNaC::quo(e, declared, symbol).expand();
        const ex rest = GiNaC::rem(e, declared, symbol).expand();
        const ProvedSign s = sign(quotient, comparisons);
        const ProvedSign t = s == ProvedSign::unknown ? s : sign(rest, comparisons);
        return t == ProvedSign::unknown ? t : std::max(s, t);
    };
    for (const Parameter& p : system_.parameters)
        if (const ProvedSign s = divided_by(p.symbol); s != ProvedSign::unknown) return s;
    for (const Variable& v : system_.variables)
        if (const ProvedSign s = divided_by(v.jet.front()); s != ProvedSign::unknown) return s;
    return ProvedSign::unknown;
}

} // namespace resonform
