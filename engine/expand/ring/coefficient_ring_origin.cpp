// SPDX-License-Identifier: GPL-3.0-or-later
// Expressions at the origin, where the fast variables and eps are zero.
#include "expand/ring/coefficient_ring.hpp"

#include "algebra/number/error.hpp"
#include "model/exact/question.hpp"
#include "model/text/canonical.hpp"
#include "model/text/function_call.hpp"
#include "model/text/regular.hpp"

#include <algorithm>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::is_a;

bool has_log_of_zero(const ex& e, const GiNaC::exmap& zero) {
    return std::any_of(e.preorder_begin(), e.preorder_end(), [&](const ex& part) {
        if (function_of(part) != Function::logarithm) return false;
        const auto argument =
            where_regular([&] { return part.op(0).subs(zero, GiNaC::subs_options::no_pattern).normal(); });
        return argument && argument->is_zero();
    });
}

} // namespace

void CoefficientRing::refuse_pole(const ex& e, const Place& place) {
    bad_input({"nothing is divided by an expression that is zero at the origin", spell(e),
               "remove the singularity, or expand about another point", place});
}

ex CoefficientRing::at_origin(const ex& e, const Place& place) const {
    const auto value = where_regular([&] { return e.subs(zero_, GiNaC::subs_options::no_pattern).normal(); });
    if (!value) {
        if (has_log_of_zero(e, zero_))
            bad_input({"log has no value at zero, where the fast variables and eps are", spell(e),
                       "remove the singularity, or expand about another point", place});
        refuse_pole(e, place);
    }
    return simplified(*value, place);
}

Zero CoefficientRing::vanishes(const ex& e, const Place& place) const {
    const Zero zero = resonform::vanishes(e, *system_);
    if (zero != Zero::unknown) return zero;
    const CoefficientRing own = ring_of(e, place);
    return own.ring()->is_zero(own.convert(e, place));
}

CoefficientRing CoefficientRing::ring_of(const ex& e, const Place& place) const {
    CoefficientRing own(system_);
    own.collect(e, place);
    own.freeze();
    return own;
}

// For terms that cancel only by relations of roots: (1 - w)^(3/2) - (1 - w)^(1/2) + w*(1 - w)^(1/2) + k is k.
ex CoefficientRing::simplified(const ex& e, const Place& place) const {
    if (!holds_functions_or_roots(e)) return e;
    try {
        if (vanishes(e, place) == Zero::yes) return 0;
        const ex above = e.numer().expand();
        if (!is_a<GiNaC::add>(above)) return e;
        const CoefficientRing own = ring_of(e, place);
        const Polynomial p = own.convert(e, place);
        return p.size() < above.nops() ? own.expression(p) : e;
    } catch (const Error&) { // no ring: refused where it is needed
        return e;
    }
}

bool CoefficientRing::has_weight(const ex& e) const {
    return std::any_of(zero_.begin(), zero_.end(), [&](const auto& entry) { return e.has(entry.first); }) ||
           std::any_of(moving_.begin(), moving_.end(), [&](const ex& symbol) { return e.has(symbol); });
}

bool CoefficientRing::is_finite(const ex& e) const {
    GiNaC::exmap small{{system_->eps, 0}};
    std::vector<ex> finite;
    for (const Variable& v : system_->variables)
        for (const GiNaC::symbol& symbol : v.jet) {
            if (v.role != Role::fast) continue;
            if (v.weight > 0)
                small[symbol] = 0;
            else
                finite.push_back(symbol);
        }
    const auto holds_one = [&](const ex& part) {
        return std::any_of(finite.begin(), finite.end(), [&](const ex& symbol) { return part.has(symbol); });
    };
    if (!holds_one(e)) return false;
    const auto there = where_regular([&] { return e.subs(small, GiNaC::subs_options::no_pattern).normal(); });
    return !there || holds_one(*there); // a pole is refused elsewhere
}

} // namespace resonform
