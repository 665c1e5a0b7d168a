// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/division.hpp"

#include "algebra/ring/translation.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace resonform {
namespace {

// The lowest and the highest exponent of a generator.
std::pair<int, int> range(const Ring& ring, const Polynomial& p, GeneratorId id) {
    std::pair<int, int> result(ring.exponent(p.terms().front().monomial, id), 0);
    result.second = result.first;
    for (const Term& t : p.terms()) {
        result.first = std::min(result.first, ring.exponent(t.monomial, id));
        result.second = std::max(result.second, ring.exponent(t.monomial, id));
    }
    return result;
}

} // namespace

std::optional<Polynomial> divide_exactly(const Ring& ring, const Polynomial& p, const Polynomial& q) {
    if (p.empty()) return Polynomial();
    std::vector<GeneratorId> inside;
    Monomial above, below; // in all terms of p, and of q
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const auto [p_low, p_high] = range(ring, p, id);
        const auto [q_low, q_high] = range(ring, q, id);
        if (p_high - p_low < q_high - q_low) return std::nullopt;
        if (p_low < p_high) inside.push_back(id);
        above = above + ring.monomial(id, p_low);
        below = below + ring.monomial(id, q_low);
    }
    const Translation translation(ring, inside);
    const auto quotient =
        translation.packed(divided(p, above))->quotient_by(*translation.packed(divided(q, below)));
    if (!quotient) return std::nullopt;
    return content(p) / content(q) * divided(translation.unpacked(*quotient), below - above);
}

} // namespace resonform
