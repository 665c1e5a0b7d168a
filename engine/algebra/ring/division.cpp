// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/division.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

namespace resonform {
namespace {

using Exponents = std::vector<int>;
using Ordered = std::map<Exponents, Rational>; // lexicographic: a monomial order for signed exponents

Ordered ordered(const Ring& ring, const Polynomial& p) {
    Ordered out;
    for (const Term& t : p.terms()) out.emplace(ring.exponents(t.monomial), t.coefficient);
    return out;
}

Exponents difference(const Exponents& a, const Exponents& b) {
    Exponents out(a.size());
    for (std::size_t v = 0; v < a.size(); ++v) out[v] = a[v] - b[v];
    return out;
}

// Degrees add under multiplication, so each exponent of p/q lies between these two.
struct Box {
    Exponents low, high;
    explicit Box(const Ordered& p) : low(p.begin()->first), high(low) {
        for (const auto& term : p) {
            for (std::size_t v = 0; v < low.size(); ++v) {
                low[v] = std::min(low[v], term.first[v]);
                high[v] = std::max(high[v], term.first[v]);
            }
        }
    }
    [[nodiscard]] bool contains(const Exponents& e) const {
        for (std::size_t v = 0; v < e.size(); ++v) {
            if (e[v] < low[v] || e[v] > high[v]) return false;
        }
        return true;
    }
};

} // namespace

std::optional<Polynomial> divide_exactly(const Ring& ring, const Polynomial& p, const Polynomial& q) {
    if (p.empty()) return Polynomial();
    Ordered rest = ordered(ring, p);
    const Ordered divisor = ordered(ring, q);
    Box box(rest);
    const Box of_divisor(divisor);
    box.low = difference(box.low, of_divisor.low);
    box.high = difference(box.high, of_divisor.high);

    const auto& lead = *divisor.rbegin();
    std::vector<Term> quotient;
    while (!rest.empty()) {
        const Exponents e = difference(rest.rbegin()->first, lead.first);
        if (!box.contains(e)) return std::nullopt; // the box is finite and e falls: this ends
        const Rational c = rest.rbegin()->second / lead.second;
        quotient.push_back({ring.monomial(e), c});
        for (const auto& term : divisor) {
            Exponents target = term.first;
            for (std::size_t v = 0; v < e.size(); ++v) target[v] += e[v];
            Rational& left = rest[target];
            left = left - c * term.second;
            if (cln::zerop(left)) rest.erase(target);
        }
    }
    return Polynomial::from_terms(std::move(quotient));
}

} // namespace resonform
