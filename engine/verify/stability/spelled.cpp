// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/stability/spelled.hpp"

#include "algebra/number/number.hpp"
#include "emit/display/quantity.hpp"
#include "emit/graph/graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace resonform {

namespace {

constexpr int deepest = 12; // levels of operands
constexpr std::size_t longest = 80;

enum class Binding { sum, product, power, atom }; // from the loosest

struct Phrase {
    std::string text;
    Binding binding;
};

std::string within(const Phrase& phrase, Binding least) {
    return phrase.binding < least ? "(" + phrase.text + ")" : phrase.text;
}

// "start xi" -> "xi_0", "cos theta" -> "cos(theta)", "slow time" -> "T"
Phrase named_symbol(const std::string& name) {
    const auto space = name.find(' ');
    if (space == std::string::npos) return {name, Binding::atom};
    const std::string kind = name.substr(0, space), rest = name.substr(space + 1);
    if (name == "slow time") return {"T", Binding::atom};
    if (kind == "start" || kind == "flow" || kind == "table") return {rest, Binding::atom};
    return {kind + "(" + rest + ")", Binding::atom};
}

class Speller {
public:
    // parts: named parts of outputs by their names, not written out.
    Speller(const Program& program, bool parts) : program_(program) {
        if (parts)
            for (const ProgramOutput& named : program.names) names_.emplace(named.value, named.name);
        for (const ProgramInput& input : program.start) names_.emplace(input.symbol, input.name);
    }

    // below: levels of operands that are written out.
    [[nodiscard]] Phrase phrase(Graph::Node n, int below, bool itself = false) const {
        const Graph::Entry& e = program_.graph.at(n);
        if (const auto name = names_.find(n); name != names_.end() && !itself)
            return {name->second, Binding::atom};
        if (e.op == Graph::Op::symbol) return named_symbol(e.name);
        if (e.op == Graph::Op::rational)
            return {to_string(e.value),
                    denominator(e.value) == 1 && e.value >= 0 ? Binding::atom : Binding::sum};
        if (below == 0) return {"...", Binding::atom};
        switch (e.op) {
        case Graph::Op::add: return sum(e, below - 1);
        case Graph::Op::multiply: return product(e, below - 1);
        case Graph::Op::power:
            if (e.exponent < 0) return quotient("1", {{e.operands.front(), -e.exponent}}, below - 1);
            return {power(e.operands.front(), e.exponent, below - 1), Binding::power};
        case Graph::Op::root:
            if (e.exponent == 2)
                return {"sqrt(" + phrase(e.operands.front(), below - 1).text + ")", Binding::atom};
            return {fmt::format("{}^(1/{})", within(phrase(e.operands.front(), below - 1), Binding::atom),
                                e.exponent),
                    Binding::power};
        case Graph::Op::doubled: return phrase(e.operands.front(), below, true);
        case Graph::Op::spline: return call(e.data->name + std::string(primes(e), '\''), e, below - 1);
        case Graph::Op::callable: return call(e.name + std::string(primes(e), '\''), e, below - 1);
        default: return call(function_name(e.op), e, below - 1);
        }
    }

private:
    using Factor = std::pair<Graph::Node, int>; // base, exponent > 0

    static std::size_t primes(const Graph::Entry& e) { return static_cast<std::size_t>(e.exponent); }

    [[nodiscard]] bool is_negative(Graph::Node n) const {
        const Graph::Entry& e = program_.graph.at(n);
        if (e.op == Graph::Op::multiply) return is_negative(e.operands.front());
        return e.op == Graph::Op::rational && e.value < 0;
    }

    // Positive terms first.
    [[nodiscard]] Phrase sum(const Graph::Entry& e, int below) const {
        std::vector<Graph::Node> terms = e.operands;
        std::stable_partition(terms.begin(), terms.end(), [&](Graph::Node n) { return !is_negative(n); });
        std::string text;
        for (const Graph::Node n : terms) {
            std::string term = phrase(n, std::max(below, 1)).text;
            const bool minus = !term.empty() && term.front() == '-';
            if (minus) term.erase(0, 1);
            text += (minus ? (text.empty() ? "-" : " - ") : (text.empty() ? "" : " + ")) + term;
        }
        return {text, Binding::sum};
    }

    [[nodiscard]] std::string power(Graph::Node base, int exponent, int below) const {
        if (exponent == 1) return within(phrase(base, below), Binding::product);
        const Graph::Entry& e = program_.graph.at(base);
        if (e.op == Graph::Op::root)
            return fmt::format("{}^({}/{})", within(phrase(e.operands.front(), below), Binding::atom),
                               exponent, e.exponent);
        return fmt::format("{}^{}", within(phrase(base, below), Binding::atom), exponent);
    }

    [[nodiscard]] Phrase quotient(const std::string& above, const std::vector<Factor>& under,
                                  int below) const {
        if (under.empty()) return {above, Binding::product};
        std::string text;
        for (const auto& [base, exponent] : under)
            text += (text.empty() ? "" : "*") + power(base, exponent, below);
        const bool bare = text.find_first_of("*/ ") == std::string::npos || text.front() == '(';
        return {above + "/" + (under.size() == 1 && bare ? text : "(" + text + ")"), Binding::product};
    }

    [[nodiscard]] Phrase product(const Graph::Entry& e, int below) const {
        std::string above, sign;
        std::vector<Factor> under;
        for (const Graph::Node n : e.operands) {
            const Graph::Entry& factor = program_.graph.at(n);
            if (factor.op == Graph::Op::power && factor.exponent < 0) {
                under.emplace_back(factor.operands.front(), -factor.exponent);
                continue;
            }
            if (program_.graph.is_rational(n, -1)) {
                sign = "-";
                continue;
            }
            const std::string text = factor.op == Graph::Op::rational
                                         ? to_string(factor.value)
                                         : within(phrase(n, below), Binding::product);
            above += (above.empty() ? "" : "*") + text;
        }
        return quotient(sign + (above.empty() ? "1" : above), under, below);
    }

    [[nodiscard]] Phrase call(const std::string& name, const Graph::Entry& e, int below) const {
        std::string arguments;
        for (const Graph::Node n : e.operands)
            arguments += (arguments.empty() ? "" : ", ") + phrase(n, below).text;
        return {name + "(" + arguments + ")", Binding::atom};
    }

    const Program& program_;
    std::map<Graph::Node, std::string> names_;
};

} // namespace

// Level by level, so that what is shared is not written out again and again before it is known to be too
// long.
std::string spelled(const Program& program, Graph::Node n) {
    std::string shortened;
    for (const bool parts : {false, true}) {
        const Speller speller(program, parts);
        for (int below = 1; below <= deepest; ++below) {
            std::string text = speller.phrase(n, below, true).text;
            const bool fits = text.size() <= longest, whole = text.find("...") == std::string::npos;
            if (fits && whole) return text;
            if (fits || below == 1) shortened = text;
            if (!fits || whole) break;
        }
    }
    return short_quantity(shortened);
}

} // namespace resonform
