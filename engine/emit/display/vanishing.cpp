// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/display/vanishing.hpp"

#include "emit/display/spelling.hpp"
#include "model/signs/sign_prover.hpp"

#include <algorithm>

namespace resonform {

bool Vanishing::nowhere(const Polynomial& p) {
    for (const auto& [polynomial, answer] : known_)
        if (polynomial == p) return answer;
    const bool answer = provably_nonzero(field_.coefficients->expression(p).expand(), field_.system());
    known_.emplace_back(p, answer);
    return answer;
}

std::vector<Polynomial> Vanishing::factors(const Polynomial& p) {
    if (nowhere(p)) return {};
    const Ring& ring = *field_.ring;
    std::vector<Polynomial> result;
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const Generator& g = ring.generator(id);
        const bool divisor = g.kind == GeneratorKind::root && g.index == 1;
        if (divisor && ring.lowest_exponent(p, id) > 0 && !nowhere(g.radicand)) result.push_back(g.radicand);
    }
    Polynomial rest = primitive_part(ring, p);
    if (!nowhere(rest)) result.push_back(std::move(rest));
    return result;
}

DisplaySum display_without_sign(const Ring& ring, const Polynomial& p) {
    DisplaySum sum = display(ring, p);
    const auto begins_with_minus = [&] { return spell(sum, text_spelling()).front() == '-'; };
    if (begins_with_minus() && cln::minusp(sum.terms.front().coefficient)) sum = -sum;
    if (!begins_with_minus() || sum.terms.size() != 1 || !is_bare_sum(sum.terms.front())) return sum;
    DisplaySum& inside = sum.terms.front().factors.front().arguments.front(); // of -c + 1, held as (-c + 1)
    inside = -inside;
    return sum;
}

} // namespace resonform
