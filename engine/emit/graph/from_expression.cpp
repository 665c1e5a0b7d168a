// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/graph/from_expression.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/number.hpp"
#include "model/text/canonical.hpp"
#include "model/text/enclosure.hpp"
#include "model/text/function_call.hpp"

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
    Translation(Graph& graph, const std::map<std::string, Graph::Node>& names, const Place& place)
        : graph_(graph), names_(names), place_(place) {}

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

    // By the functions that the runtime has, without loss of digits.
    Graph::Node function(const GiNaC::ex& e) const {
        using Op = Graph::Op;
        const std::optional<Function> f = function_of(e);
        if (!f) refuse_function(e);
        const auto of = [&](Op op) { return graph_.function(op, {(*this)(e.op(0))}); };
        switch (*f) {
        case Function::sine: return of(Op::sin);
        case Function::cosine: return of(Op::cos);
        case Function::exponential: return of(Op::exp);
        case Function::logarithm: return of(Op::log);
        case Function::inverse_hyperbolic_sine: return of(Op::asinh);
        case Function::tangent: return graph_.multiply({of(Op::sin), inverse(of(Op::cos))});
        default: break;
        }
        if (is_constant(e)) return graph_.rational(value_of(e)); // atan(1/3)
        // Operands stand in braces, where they are made from left to right.
        const Graph::Node x = (*this)(e.op(0)), one = graph_.rational(1);
        const auto cosh = [&] {
            const Graph::Node up = of(Op::exp);
            return graph_.multiply({graph_.rational(Rational(1) / 2), graph_.add({up, inverse(up)})});
        };
        const auto root_beside_one = [&] { // sqrt((1 + x)(1 - x))
            return graph_.root(graph_.multiply({graph_.add({one, x}), graph_.add({one, graph_.negate(x)})}),
                               2);
        };
        switch (*f) {
        case Function::hyperbolic_sine: return of(Op::sinh);
        case Function::hyperbolic_cosine: return cosh();
        case Function::hyperbolic_tangent: return graph_.multiply({of(Op::sinh), inverse(cosh())});
        case Function::arc_sine: return graph_.function(Op::atan2, {x, root_beside_one()});
        case Function::arc_tangent: return graph_.function(Op::atan2, {x, one});
        case Function::inverse_hyperbolic_cosine: // asinh(sqrt((x + 1)(x - 1)))
            return graph_.function(
                Op::asinh,
                {graph_.root(graph_.multiply({graph_.add({x, one}), graph_.add({x, graph_.rational(-1)})}),
                             2)});
        case Function::inverse_hyperbolic_tangent:
            return graph_.function(Op::asinh, {graph_.multiply({x, inverse(root_beside_one())})});
        case Function::error_function: return of(Op::erf);
        default: refuse_function(e);
        }
    }

    Graph::Node inverse(Graph::Node n) const { return graph_.power(n, -1); }

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
};

} // namespace

Graph::Node from_expression(Graph& graph, const GiNaC::ex& e, const std::map<std::string, Graph::Node>& names,
                            const Place& place) {
    return Translation(graph, names, place)(e);
}

} // namespace resonform
