// SPDX-License-Identifier: GPL-3.0-or-later
// The derivatives of roots and functions, and the relation of a cosine with its sine.
//
//   sigma^k = P:  sigma' = sigma^(1-k)/k P'          f(u):  f(u)' = f'(u) u'
#include "algebra/ring/choose_relation.hpp"
#include "algebra/ring/ring.hpp"

#include <algorithm>

namespace resonform {

bool Ring::derivative_known(const Polynomial& p, GeneratorId id) const {
    for (GeneratorId v = 0; v < size(); ++v) {
        const std::vector<GeneratorId>& unknown = generator(v).unknown;
        if (std::find(unknown.begin(), unknown.end(), id) == unknown.end()) continue;
        for (const Term& t : p.terms())
            if (exponent(t.monomial, v) != 0) return false;
    }
    return true;
}

// f'(u) for the generator f(u); nullopt if the ring does not hold it.
std::optional<Polynomial> Ring::slope(GeneratorId function) const {
    const FunctionOf& of = generator(function).of;
    const auto found = [&](const auto& is_slope) -> std::optional<Polynomial> {
        for (GeneratorId id = 0; id < size(); ++id)
            if (generator(id).kind == GeneratorKind::function && is_slope(generator(id).of)) return gen(id);
        return std::nullopt;
    };
    const Polynomial& u = of.argument;
    switch (of.function) {
    case Function::exponential: return gen(function);
    case Function::sine: return found([&](const FunctionOf& f) { return f.sine == function; });
    case Function::cosine: return -gen(of.sine);
    case Function::logarithm: return inverse(u);
    case Function::arc_tangent: return inverse(one() + multiply(u, u));
    case Function::named: break;
    default: return of.slope;
    }
    return found([&](const FunctionOf& f) {
        return f.function == Function::named && f.symbol == of.symbol && f.derivative == of.derivative + 1 &&
               f.argument == u;
    });
}

// Fills in the derivatives of a root or a function; those of earlier generators are known.
void Ring::derive(GeneratorId id) {
    Generator& g = generators_[static_cast<std::size_t>(id)];
    const bool root = g.kind == GeneratorKind::root;
    if (!root && g.kind != GeneratorKind::function) return;
    const std::optional<Polynomial> outer =
        root ? Rational(1) / Rational(g.index) * gen(id, 1 - g.index) : slope(id);
    const Polynomial& inner = root ? g.radicand : g.of.argument;
    for (GeneratorId v = 0; v < size(); ++v) {
        const GeneratorKind kind = generator(v).kind;
        if (kind != GeneratorKind::slow && kind != GeneratorKind::parameter) continue;
        const bool known = derivative_known(inner, v);
        const Polynomial rate = known ? derivative(inner, v) : Polynomial();
        if (known && rate.empty()) continue;
        if (known && outer)
            g.derivatives.emplace_back(v, multiply(*outer, rate));
        else
            g.unknown.push_back(v);
    }
}

void Ring::relate_circle(GeneratorId cosine) {
    const GeneratorId sine = generator(cosine).of.sine;
    const Polynomial circle =
        reduce(Polynomial(monomial(sine, 2), 1) + Polynomial(monomial(cosine, 2), 1) - one());
    if (circle.empty()) return;
    std::optional<Relation> relation = solve_for_one_of(*this, relations_, circle, {sine, cosine});
    related_ = related_ && relation.has_value();
    if (relation) relations_.push_back(std::move(*relation));
}

} // namespace resonform
