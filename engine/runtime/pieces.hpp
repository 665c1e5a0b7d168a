// SPDX-License-Identifier: MIT
// Functions of slow time that are smooth on each of several intervals. Integrals over them are cut where one
// interval ends and the next begins.
#ifndef RESONFORM_RUNTIME_PIECES
#define RESONFORM_RUNTIME_PIECES

#include "runtime/math.hpp"

#include <cstddef>
#include <utility>

namespace resonform {

// A function, and the times at which its pieces end.
template <class Function, class Edges> struct InPieces {
    Function function;
    Edges edges;

    template <class... Arguments> auto operator()(const Arguments&... x) const { return function(x...); }
};
template <class Function, class Edges> InPieces<Function, Edges> in_pieces(Function function, Edges edges) {
    return {std::move(function), std::move(edges)};
}

// `function` in the pieces of `like`.
template <class Like, class Function> auto in_same_pieces(const Like& like, Function function) {
    if constexpr (requires { like.edges; })
        return in_pieces(std::move(function), like.edges);
    else
        return function;
}

// The first time in (left, end) at which a piece of f ends, else `end`. What is nearer to either than
// rounding is no time of its own.
template <class Function, class Number>
Number end_of_piece([[maybe_unused]] const Function& f, [[maybe_unused]] const Number& left,
                    const Number& end) {
    if constexpr (requires { f.edges; }) {
        const Number rounding = end * Number(0x1p-40);
        Number first = end;
        for (const auto& known : f.edges)
            if (const Number edge(known); left + rounding < edge && edge + rounding < first) first = edge;
        return first;
    }
    return end;
}

// The times T at which at_0 + (at_1 - at_0) T passes a breakpoint of a spline go to edges[next], ...; -1 for
// one that is never passed.
template <class Spline, class Number, class Edges>
void add_edges(const Spline& spline, const Number& at_0, const Number& at_1, Edges& edges,
               std::size_t& next) {
    const Number rate = at_1 - at_0;
    for (std::size_t k = 0; k <= spline.pieces; ++k) {
        const Number T = (Number(spline.breakpoints[k]) - at_0) / rate;
        edges[next++] = math::finite(T) ? T : Number(-1);
    }
}

} // namespace resonform

#endif
