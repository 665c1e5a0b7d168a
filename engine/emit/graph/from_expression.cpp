// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/graph/from_expression.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/number.hpp"
#include "model/text/canonical.hpp"
#include "model/text/enclosure.hpp"
#include "model/text/function_call.hpp"
#include "model/text/named_function.hpp"

#include <algorithm>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace resonform {

namespace {

std::string to_text(const GiNaC::ex& e) {
    std::ostringstream text;
    text << e;
    return text.str();
}

class Translation {
public:
    Translation(Graph& graph, const std::map<std::string, Graph::Node>& names, const Place& place,
                const NamedNode& named)
        : graph_(graph), names_(names), place_(place), named_(named) {}

    Graph::Node operator()(const GiNaC::ex& e) const {
        if (GiNaC::is_a<GiNaC::numeric>(e)) return number(GiNaC::ex_to<GiNaC::numeric>(e));
        if (GiNaC::is_a<GiNaC::symbol>(e)) return symbol(GiNaC::ex_to<GiNaC::symbol>(e).get_name());
        if (GiNaC::is_a<GiNaC::add>(e)) return graph_.add(nodes(e));
        if (GiNaC::is_a<GiNaC::mul>(e)) return graph_.multiply(nodes(e));
        if (GiNaC::is_a<GiNaC::power>(e)) return power(e);
        if (e.is_equal(GiNaC::Pi)) // every real type has its own digits of it
            return graph_.function(Graph::Op::atan2, {graph_.rational(0), graph_.rational(-1)});
        return function(e);
    }

private:
    Graph::Node number(const GiNaC::numeric& value) const {
        if (!value.is_rational()) refuse_function(value);
        return graph_.rational(parse_rational(to_text(value)));
    }

    Graph::Node symbol(const std::string& name) const {
        const auto found = names_.find(name);
        if (found == names_.end()) throw std::logic_error("from_expression: no node for " + name);
        return found->second;
    }

    std::vector<Graph::Node> nodes(const GiNaC::ex& e) const {
        std::vector<Graph::Node> nodes;
        for (const GiNaC::ex& operand : operands(e)) nodes.push_back((*this)(operand));
        return nodes;
    }

    Graph::Node power(const GiNaC::ex& e) const {
        const GiNaC::ex exponent = e.op(1);
        if (!GiNaC::is_a<GiNaC::numeric>(exponent) || !GiNaC::ex_to<GiNaC::numeric>(exponent).is_rational())
            refuse_function(e);
        const auto value = GiNaC::ex_to<GiNaC::numeric>(exponent);
        const Graph::Node root = graph_.root((*this)(e.op(0)), value.denom().to_int());
        return graph_.power(root, value.numer().to_int());
    }

    Graph::Node function(const GiNaC::ex& e) const {
        if (is_named(e)) return named(e);
        const std::optional<Function> f = function_of(e);
        if (!f) refuse_function(e);
        const bool of_runtime = *f == Function::sine || *f == Function::cosine ||
                                *f == Function::exponential || *f == Function::logarithm ||
                                *f == Function::tangent || *f == Function::inverse_hyperbolic_sine;
        if (!of_runtime && is_constant(e)) return graph_.rational(value_of(e)); // atan(1/3)
        return function_node(graph_, *f, (*this)(e.op(0)));
    }

    Graph::Node named(const GiNaC::ex& e) const {
        if (!named_) refuse_function(e);
        const NamedCall call = named_call(e);
        return named_(call.name, call.derivative, (*this)(call.argument));
    }

    // Its value to more digits than any real type has.
    [[nodiscard]] Rational value_of(const GiNaC::ex& e) const {
        constexpr int bits = 400;
        const std::optional<RealBall> value = enclose(e, {}, bits);
        if (!value) refuse_function(e);
        return middle(*value);
    }

    [[noreturn]] void refuse_function(const GiNaC::ex& e) const {
        refuse({"a value in emitted code is made of elementary functions and rational powers", to_text(e),
                "write it with these, or as a number", place_});
    }

    Graph& graph_;
    const std::map<std::string, Graph::Node>& names_;
    const Place& place_;
    const NamedNode& named_;
};

} // namespace

// Operands stand in braces, where they are made from left to right.
Graph::Node function_node(Graph& graph, Function f, Graph::Node x) {
    using Op = Graph::Op;
    const auto of = [&](Op op) { return graph.function(op, {x}); };
    const auto inverse = [&](Graph::Node n) { return graph.power(n, -1); };
    const auto cosh = [&] {
        const Graph::Node up = of(Op::exp);
        return graph.multiply({graph.rational(Rational(1) / 2), graph.add({up, inverse(up)})});
    };
    const auto root_beside_one = [&] { // sqrt((1 + x)(1 - x))
        const Graph::Node one = graph.rational(1);
        return graph.root(graph.multiply({graph.add({one, x}), graph.add({one, graph.negate(x)})}), 2);
    };
    switch (f) {
    case Function::sine: return of(Op::sin);
    case Function::cosine: return of(Op::cos);
    case Function::exponential: return of(Op::exp);
    case Function::logarithm: return of(Op::log);
    case Function::tangent: return graph.multiply({of(Op::sin), inverse(of(Op::cos))});
    case Function::hyperbolic_sine: return of(Op::sinh);
    case Function::hyperbolic_cosine: return cosh();
    case Function::hyperbolic_tangent: return graph.multiply({of(Op::sinh), inverse(cosh())});
    case Function::arc_sine: return graph.function(Op::atan2, {x, root_beside_one()});
    case Function::arc_cosine: return graph.function(Op::atan2, {root_beside_one(), x});
    case Function::arc_tangent: return graph.function(Op::atan2, {x, graph.rational(1)});
    case Function::inverse_hyperbolic_sine: return of(Op::asinh);
    case Function::inverse_hyperbolic_cosine: { // asinh(sqrt((x + 1)(x - 1)))
        const Graph::Node one = graph.rational(1), minus_one = graph.rational(-1);
        return graph.function(
            Op::asinh, {graph.root(graph.multiply({graph.add({x, one}), graph.add({x, minus_one})}), 2)});
    }
    case Function::inverse_hyperbolic_tangent:
        return graph.function(Op::asinh, {graph.multiply({x, inverse(root_beside_one())})});
    case Function::error_function: return of(Op::erf);
    case Function::named: break;
    }
    throw std::logic_error("function_node: a function without a value");
}

Graph::Node from_expression(Graph& graph, const GiNaC::ex& e, const std::map<std::string, Graph::Node>& names,
                            const Place& place, const NamedNode& named) {
    return Translation(graph, names, place, named)(e);
}

} // namespace resonform
