// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/enclosure.hpp"

#include <cstdlib>

namespace resonform {

RealBall enclose(Function f, const RealBall& x, std::int64_t bits) {
    RealBall result;
    row_of(f).enclose(result.get(), x.get(), bits);
    return result;
}

ComplexBall enclose(const Ring& ring, const Polynomial& p, const BallOf& value_of, std::int64_t bits) {
    RealBall re, im, factor;
    for (const Term& t : p.terms()) {
        RealBall product(t.coefficient, bits);
        for (GeneratorId id = 1; id < ring.size(); ++id) {
            const int exponent = ring.exponent(t.monomial, id);
            if (exponent == 0) continue;
            arb_pow_ui(factor.get(), value_of(id).get(), static_cast<ulong>(std::abs(exponent)), bits);
            if (exponent > 0)
                arb_mul(product.get(), product.get(), factor.get(), bits);
            else
                arb_div(product.get(), product.get(), factor.get(), bits);
        }
        RealBall& part = ring.exponent(t.monomial, Ring::imaginary_unit) == 1 ? im : re;
        arb_add(part.get(), part.get(), product.get(), bits);
    }
    return {re, im};
}

std::optional<RealBall> enclose(const Ring& ring, const Generator& g, const BallOf& value_of,
                                std::int64_t bits) {
    RealBall result;
    if (g.kind == GeneratorKind::parameter && g.name == "pi") { // no user has that name
        arb_const_pi(result.get(), bits);
        return result;
    }
    if (g.kind == GeneratorKind::function && g.of.function != Function::named)
        return enclose(g.of.function, enclose(ring, g.of.argument, value_of, bits).re(), bits);
    if (g.kind != GeneratorKind::root) return std::nullopt;
    const RealBall radicand = enclose(ring, g.radicand, value_of, bits).re();
    if (g.index > 1 && !radicand.is_positive()) return std::nullopt;
    arb_root_ui(result.get(), radicand.get(), static_cast<ulong>(g.index), bits);
    return result;
}

} // namespace resonform
