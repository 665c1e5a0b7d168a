// SPDX-License-Identifier: GPL-3.0-or-later
#include "emit/graph/graph.hpp"

#include "algebra/number/error.hpp"

#include <algorithm>
#include <optional>

namespace resonform {

namespace {

// Bytes, not digits: programs of long maps have hundreds of thousands of entries.
std::string spelling(const Graph::Entry& e) {
    std::string key;
    const auto append = [&](int n) { key.append(reinterpret_cast<const char*>(&n), sizeof n); };
    append(static_cast<int>(e.op));
    append(e.exponent);
    if (e.op == Graph::Op::rational) key += to_string(e.value);
    if (e.op == Graph::Op::symbol) key += e.name;
    if (e.op == Graph::Op::callable) key += e.name + ' ';
    if (e.op == Graph::Op::spline) key += e.data->name + ' ';
    for (const Graph::Node n : e.operands) append(n);
    return key;
}

// n = rest * cos(angle)
struct WithCosine {
    Graph::Node rest, angle;
};

std::optional<WithCosine> cosine_in(Graph& graph, Graph::Node n) {
    const auto is_cosine = [&](Graph::Node factor) { return graph.at(factor).op == Graph::Op::cos; };
    if (is_cosine(n)) return WithCosine{graph.rational(1), graph.at(n).operands.front()};
    if (graph.at(n).op != Graph::Op::multiply) return std::nullopt;
    std::vector<Graph::Node> factors = graph.at(n).operands;
    const auto found = std::find_if(factors.begin(), factors.end(), is_cosine);
    if (found == factors.end()) return std::nullopt;
    const Graph::Node angle = graph.at(*found).operands.front();
    factors.erase(found);
    return WithCosine{graph.multiply(factors), angle};
}

// c A - c A cos(u)   ->   2 c A sin(u/2)^2, of which no digit is lost where u is small.
void join_cosines(Graph& graph, std::map<Graph::Node, Rational>& terms) {
    std::vector<Graph::Node> nodes;
    for (const auto& [node, coefficient] : terms) nodes.push_back(node);
    for (const Graph::Node node : nodes) {
        const auto cosine = cosine_in(graph, node);
        if (!cosine) continue;
        const auto beside = terms.find(cosine->rest);
        const Rational coefficient = terms[node];
        if (beside == terms.end() || coefficient == 0 || beside->second != -coefficient) continue;
        beside->second = terms[node] = 0;
        const Graph::Node half = graph.multiply({graph.rational(Rational(1) / 2), cosine->angle});
        const Graph::Node sine = graph.function(Graph::Op::sin, {half});
        Rational& joined =
            terms.try_emplace(graph.multiply({cosine->rest, graph.power(sine, 2)}), 0).first->second;
        joined = joined - 2 * coefficient;
    }
}

int floor_divide(int a, int b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

} // namespace

Graph::Node Graph::intern(Entry entry) {
    const auto [position, fresh] = index_.try_emplace(spelling(entry), static_cast<Node>(entries_.size()));
    if (fresh) entries_.push_back(std::move(entry));
    return position->second;
}

bool Graph::is_rational(Node n, const Rational& value) const {
    return at(n).op == Op::rational && at(n).value == value;
}

Graph::Node Graph::rational(const Rational& value) {
    Entry e;
    e.value = value;
    return intern(std::move(e));
}

Graph::Node Graph::symbol(const std::string& name) {
    Entry e;
    e.op = Op::symbol;
    e.name = name;
    return intern(std::move(e));
}

// n = coefficient * rest; rest of a number is 1.
std::pair<Rational, Graph::Node> Graph::split_coefficient(Node n) {
    const Entry e = at(n);
    if (e.op == Op::rational) return {e.value, rational(1)};
    if (e.op != Op::multiply || at(e.operands.front()).op != Op::rational) return {Rational(1), n};
    const Rational coefficient = at(e.operands.front()).value;
    std::vector<Node> rest(e.operands.begin() + 1, e.operands.end());
    if (rest.size() == 1) return {coefficient, rest.front()};
    Entry product;
    product.op = Op::multiply;
    product.operands = std::move(rest);
    return {coefficient, intern(std::move(product))};
}

Graph::Node Graph::add(std::vector<Node> operands) {
    std::map<Node, Rational> terms;
    while (!operands.empty()) {
        const Node n = operands.back();
        operands.pop_back();
        if (at(n).op == Op::add && whole_.count(n) == 0) {
            operands.insert(operands.end(), at(n).operands.begin(), at(n).operands.end());
            continue;
        }
        const auto [coefficient, rest] = split_coefficient(n);
        Rational& sum = terms.try_emplace(rest, 0).first->second;
        sum = sum + coefficient;
    }
    join_cosines(*this, terms);
    Entry e;
    e.op = Op::add;
    for (const auto& [rest, coefficient] : terms)
        if (coefficient != 0) e.operands.push_back(multiply({rational(coefficient), rest}));
    if (e.operands.empty()) return rational(0);
    if (e.operands.size() == 1) return e.operands.front();
    std::sort(e.operands.begin(), e.operands.end());
    return intern(std::move(e));
}

// Whether it is a double, or the negative of one: a difference of two that are close is exact.
bool Graph::is_exact_term(Node n) const {
    const Entry& e = at(n);
    if (e.op == Op::symbol) return true;
    if (e.op == Op::multiply)
        return e.operands.size() == 2 && is_rational(e.operands[0], -1) && is_exact_term(e.operands[1]);
    return e.op == Op::rational && cln::integer_length(cln::numerator(e.value)) <= 53 &&
           cln::logcount(cln::denominator(e.value)) == 1;
}

// Data and functions of the user are known to the digits of the type only.
bool Graph::can_be_doubled(Node n) const {
    const Entry& e = at(n);
    return e.op != Op::spline && e.op != Op::callable &&
           std::all_of(e.operands.begin(), e.operands.end(), [this](Node x) { return can_be_doubled(x); });
}

Graph::Node Graph::difference(Node sum) {
    const std::vector<Node> terms = at(sum).operands;
    if (at(sum).op != Op::add) return sum;
    if (!can_be_doubled(sum) ||
        std::all_of(terms.begin(), terms.end(), [this](Node term) { return is_exact_term(term); })) {
        whole_.insert(sum);
        return sum;
    }
    Entry e;
    e.op = Op::doubled;
    e.operands = {sum};
    return intern(std::move(e));
}

void Graph::collect(Node n, int exponent, Factors& factors, Rational& coefficient) {
    const Entry& e = at(n);
    switch (e.op) {
    case Op::rational:
        if (e.value == 0 && exponent < 0)
            refuse(Reason::singular, {"a division by zero cannot be emitted",
                                      "0",
                                      "change the values under [fix] or [start]",
                                      {}});
        coefficient = coefficient * cln::expt(e.value, exponent);
        return;
    case Op::multiply:
        for (const Node operand : e.operands) collect(operand, exponent, factors, coefficient);
        return;
    case Op::power: collect(e.operands.front(), exponent * e.exponent, factors, coefficient); return;
    default: factors[n] += exponent;
    }
}

// root^e with 0 <= e < index; whole powers of the radicand take the rest.
void Graph::reduce_roots(Factors& factors, Rational& coefficient) {
    for (bool changed = true; changed;) {
        changed = false;
        for (auto& [base, exponent] : factors) {
            if (at(base).op != Op::root) continue;
            const int whole = floor_divide(exponent, at(base).exponent);
            if (whole == 0) continue;
            exponent -= whole * at(base).exponent;
            collect(at(base).operands.front(), whole, factors, coefficient);
            changed = true;
            break;
        }
    }
}

Graph::Node Graph::intern_power(Node base, int exponent) {
    if (exponent == 1) return base;
    Entry e;
    e.op = Op::power;
    e.exponent = exponent;
    e.operands = {base};
    return intern(std::move(e));
}

Graph::Node Graph::product(const Factors& factors, const Rational& coefficient) {
    if (coefficient == 0) return rational(0);
    Entry e;
    e.op = Op::multiply;
    for (const auto& [base, exponent] : factors)
        if (exponent != 0) e.operands.push_back(intern_power(base, exponent));
    std::sort(e.operands.begin(), e.operands.end());
    if (e.operands.empty()) return rational(coefficient);
    if (coefficient != 1) e.operands.insert(e.operands.begin(), rational(coefficient));
    if (e.operands.size() == 1) return e.operands.front();
    return intern(std::move(e));
}

Graph::Node Graph::multiply(const std::vector<Node>& operands) {
    Factors factors;
    Rational coefficient = 1;
    for (const Node n : operands) collect(n, 1, factors, coefficient);
    reduce_roots(factors, coefficient);
    return product(factors, coefficient);
}

Graph::Node Graph::power(Node base, int exponent) {
    Factors factors;
    Rational coefficient = 1;
    if (exponent != 0) collect(base, exponent, factors, coefficient);
    reduce_roots(factors, coefficient);
    return product(factors, coefficient);
}

Graph::Node Graph::root(Node base, int k) {
    if (k == 1) return base;
    if (at(base).op == Op::rational) {
        const Rational value = at(base).value;
        if (value < 0)
            refuse(Reason::singular, {"the root of a negative number is not real",
                                      to_string(value),
                                      "change the values under [fix] or [start]",
                                      {}});
        Rational exact;
        if (exact_root(value, k, exact)) return rational(exact);
    }
    if (k % 2 == 0 && k > 2) return root(root(base, k / 2), 2);
    Entry e;
    e.op = Op::root;
    e.exponent = k;
    e.operands = {base};
    return intern(std::move(e));
}

// u of 1 + u. That sum is rounded, and log(1 + u) loses all digits where u is small.
std::optional<Graph::Node> Graph::beside_one(Node n) {
    if (at(n).op != Op::add) return std::nullopt;
    std::vector<Node> rest = at(n).operands;
    const auto one = std::find_if(rest.begin(), rest.end(), [&](Node term) { return is_rational(term, 1); });
    if (one == rest.end()) return std::nullopt;
    rest.erase(one);
    return add(std::move(rest));
}

Graph::Node Graph::function(Op op, std::vector<Node> operands) {
    const Node x = operands.front();
    const bool odd = op == Op::sin || op == Op::asinh || op == Op::sinh || op == Op::erf || op == Op::expm1 ||
                     op == Op::log1p;
    if (is_rational(x, 0) && odd) return x;
    if (is_rational(x, 0) && (op == Op::cos || op == Op::exp)) return rational(1);
    if (is_rational(x, 1) && op == Op::log) return rational(0);
    if (op == Op::log)
        if (const std::optional<Node> rest = beside_one(x)) return function(Op::log1p, {*rest});
    Entry e;
    e.op = op;
    e.operands = std::move(operands);
    return intern(std::move(e));
}

Graph::Node Graph::spline(DataPointer data, int derivative, Node x) {
    if (derivative > data->degree) return rational(0);
    Entry e;
    e.op = Op::spline;
    e.exponent = derivative;
    e.data = std::move(data);
    e.operands = {x};
    return intern(std::move(e));
}

Graph::Node Graph::callable(const std::string& name, int derivative, Node x) {
    Entry e;
    e.op = Op::callable;
    e.name = name;
    e.exponent = derivative;
    e.operands = {x};
    return intern(std::move(e));
}

const char* function_name(Graph::Op op) {
    switch (op) {
    case Graph::Op::sin: return "sin";
    case Graph::Op::cos: return "cos";
    case Graph::Op::log: return "log";
    case Graph::Op::log1p: return "log1p";
    case Graph::Op::exp: return "exp";
    case Graph::Op::expm1: return "expm1";
    case Graph::Op::asinh: return "asinh";
    case Graph::Op::sinh: return "sinh";
    case Graph::Op::erf: return "erf";
    case Graph::Op::atan2: return "atan2";
    default: return "hypot";
    }
}

} // namespace resonform
