// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/program/from_expression.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/number.hpp"
#include "model/text/enclosure.hpp"

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
        if (GiNaC::is_a<GiNaC::add>(e)) return graph_.add(operands(e));
        if (GiNaC::is_a<GiNaC::mul>(e)) return graph_.multiply(operands(e));
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

    // A spelling that does not depend on the order of terms.
    std::string key(const GiNaC::ex& e) const {
        if (e.nops() == 0) return to_text(e);
        std::vector<std::string> parts;
        for (std::size_t i = 0; i < e.nops(); ++i) parts.push_back(key(e.op(i)));
        const bool commutes = GiNaC::is_a<GiNaC::add>(e) || GiNaC::is_a<GiNaC::mul>(e);
        if (commutes) std::sort(parts.begin(), parts.end());
        std::string result = GiNaC::is_a<GiNaC::function>(e) ? GiNaC::ex_to<GiNaC::function>(e).get_name()
                             : GiNaC::is_a<GiNaC::add>(e)    ? "+"
                             : GiNaC::is_a<GiNaC::mul>(e)    ? "*"
                                                             : "^";
        for (const std::string& part : parts) result += "(" + part + ")";
        return result;
    }

    std::vector<Graph::Node> operands(const GiNaC::ex& e) const {
        std::vector<std::pair<std::string, GiNaC::ex>> sorted;
        for (std::size_t i = 0; i < e.nops(); ++i) sorted.emplace_back(key(e.op(i)), e.op(i));
        std::sort(sorted.begin(), sorted.end(),
                  [](const auto& a, const auto& b) { return a.first < b.first; });
        std::vector<Graph::Node> nodes;
        nodes.reserve(sorted.size());
        for (const auto& operand : sorted) nodes.push_back((*this)(operand.second));
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
        using Op = Graph::Op;
        static const std::map<std::string, Op> known{
            {"sin", Op::sin}, {"cos", Op::cos}, {"exp", Op::exp}, {"log", Op::log}, {"asinh", Op::asinh}};
        if (!GiNaC::is_a<GiNaC::function>(e)) refuse_function(e);
        const std::string name = GiNaC::ex_to<GiNaC::function>(e).get_name();
        if (name == "tan") {
            const Graph::Node x = (*this)(e.op(0));
            return graph_.multiply(
                {graph_.function(Op::sin, {x}), graph_.power(graph_.function(Op::cos, {x}), -1)});
        }
        const auto found = known.find(name);
        if (found == known.end()) return graph_.rational(value_of(e));
        return graph_.function(found->second, {(*this)(e.op(0))});
    }

    // A function that emitted code does not have, of a number, as in atan(1/3): its value to more digits than
    // any real type has.
    [[nodiscard]] Rational value_of(const GiNaC::ex& e) const {
        constexpr int bits = 400;
        const std::optional<RealBall> value = enclose(e, {}, bits);
        if (!value) refuse_function(e);
        return middle(*value);
    }

    [[noreturn]] void refuse_function(const GiNaC::ex& e) const {
        refuse({"a value in emitted code uses pi, sin, cos, tan, exp, log, sqrt and rational powers, and any "
                "function of numbers",
                to_text(e), "write it with these, or as a number", place_});
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
