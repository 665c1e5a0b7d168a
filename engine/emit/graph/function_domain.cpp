// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/graph/function_domain.hpp"

#include "algebra/number/functions.hpp"

namespace resonform {

std::optional<Polynomial> positive_for(const Ring& ring, const FunctionOf& of) {
    const Polynomial& u = of.argument;
    switch (row_of(of.function).argument) {
    case Argument::positive: return u;
    case Argument::within_one:
    case Argument::inside_one: return ring.one() - ring.multiply(u, u);
    case Argument::at_least_one: return u - ring.one();
    case Argument::any:
    case Argument::not_a_pole: break;
    }
    return std::nullopt;
}

} // namespace resonform
