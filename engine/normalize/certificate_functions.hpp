// SPDX-License-Identifier: GPL-3.0-or-later
// Time derivatives of functions along the normal form by the chain rule, f(u)' = f'(u) u'. Which generator is
// which function of what is read from the ring, its derivatives are not.
#pragma once

#include "algebra/error.hpp"
#include "algebra/ring.hpp"

#include <optional>

namespace resonform {

template <class Value> struct Moving { Value value, rate; };

// The generator of f'(u) for a sine or a function that is known by its name.
inline std::optional<GeneratorId> slope_generator(const Ring& ring, GeneratorId function) {
    const FunctionOf& of = ring.generator(function).of;
    for (GeneratorId id = 0; id < ring.size(); ++id) {
        const Generator& g = ring.generator(id);
        if (g.kind != GeneratorKind::function) continue;
        const bool cosine = of.function == Function::sine && g.of.sine == function;
        const bool next = of.function == Function::named && g.of.symbol == of.symbol &&
                          g.of.derivative == of.derivative + 1 && g.of.argument == of.argument;
        if (cosine || next) return id;
    }
    return std::nullopt;
}

// The last derivative of a named function has no rate: no result may hold it.
inline void require_known_rate(const Ring& ring, GeneratorId id) {
    const Generator& g = ring.generator(id);
    if (g.kind == GeneratorKind::function && g.of.function == Function::named && !slope_generator(ring, id))
        refuse({"a normal form holds no higher derivatives than its weights can bring",
                g.name,
                "ask for a lower order",
                {}});
}

// nullopt: the last derivative.
template <class Algebra, class Value = typename Algebra::Value>
std::optional<Value> function_rate(const Algebra& algebra, const Ring& ring, GeneratorId id,
                                   const Moving<Value>& argument) {
    const FunctionOf& of = ring.generator(id).of;
    const auto times = [&](const Value& slope) { return algebra.multiply(slope, argument.rate); };
    const Value& u = argument.value;
    switch (of.function) {
    case Function::exponential: return times(algebra.generator(id, 1));
    case Function::cosine: return times(algebra.multiply(algebra.number(-1), algebra.generator(of.sine, 1)));
    case Function::logarithm: return times(algebra.inverse_power(u, 1));
    case Function::arc_tangent:
        return times(algebra.inverse_power(algebra.add(algebra.number(1), algebra.multiply(u, u)), 1));
    case Function::sine:
    case Function::named: break;
    }
    const std::optional<GeneratorId> slope = slope_generator(ring, id);
    return slope ? std::optional(times(algebra.generator(*slope, 1))) : std::nullopt;
}

} // namespace resonform
