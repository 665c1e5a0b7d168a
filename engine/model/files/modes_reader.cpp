// SPDX-License-Identifier: GPL-3.0-or-later
// [modes]: the modal matrix as a user gives it, mode by mode. Whether it fits the equations is checked after
// these have been solved for their highest derivatives.
#include "algebra/number/error.hpp"
#include "model/files/system_reader.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/nearest.hpp"
#include "model/text/toml_values.hpp"

#include <algorithm>

namespace resonform {

namespace {

using GiNaC::ex;

// a + I*b for real a and b, from an expression in a symbol that stands for I.
class Parts {
public:
    explicit Parts(const TomlNode& node) : node_(node) {}

    GiNaC::symbol i{"I"};

    [[nodiscard]] std::pair<ex, ex> of(const ex& e) const {
        if (!e.has(i)) return {e, 0};
        if (e.is_equal(i)) return {0, 1};
        if (GiNaC::is_a<GiNaC::add>(e)) {
            std::pair<ex, ex> sum{0, 0};
            for (const ex& part : operands(e)) {
                const auto [re, im] = of(part);
                sum = {sum.first + re, sum.second + im};
            }
            return sum;
        }
        if (GiNaC::is_a<GiNaC::mul>(e)) {
            std::pair<ex, ex> product{1, 0};
            for (const ex& part : operands(e)) product = times(product, of(part));
            return product;
        }
        if (GiNaC::is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::integer))
            return power(of(e.op(0)), GiNaC::ex_to<GiNaC::numeric>(e.op(1)).to_int());
        bad_value(node_, "I stands outside of roots and functions", "write real and imaginary part");
    }

private:
    static std::pair<ex, ex> times(const std::pair<ex, ex>& a, const std::pair<ex, ex>& b) {
        return {a.first * b.first - a.second * b.second, a.first * b.second + a.second * b.first};
    }

    [[nodiscard]] std::pair<ex, ex> power(std::pair<ex, ex> base, int exponent) const {
        constexpr int largest = 16;
        if (exponent > largest || exponent < -largest)
            bad_value(node_, "what contains I has an exponent of at most " + std::to_string(largest),
                      "write real and imaginary part");
        if (exponent < 0) {
            const ex norm = (base.first * base.first + base.second * base.second).normal();
            if (norm.is_zero())
                bad_value(node_, "nothing is divided by an expression that is zero",
                          "correct the expression");
            base = {base.first / norm, -base.second / norm};
            exponent = -exponent;
        }
        std::pair<ex, ex> result{1, 0};
        for (int k = 0; k < exponent; ++k) {
            result = times(result, base);
            result = {result.first.expand(), result.second.expand()};
        }
        return result;
    }

    const TomlNode& node_;
};

// x'' -> x and 2.
std::pair<std::string, std::size_t> without_primes(const std::string& key) {
    const std::size_t primes =
        key.size() - static_cast<std::size_t>(key.find_last_not_of('\'') + 1); // npos + 1 = 0
    return {key.substr(0, key.size() - primes), primes};
}

class ModesReader {
public:
    ModesReader(const TomlNode& table, const System& system) : table_(table), system_(system) {
        for (const Parameter& p : system.parameters) scope_.define(p.name, p.symbol);
        system.define_functions(scope_);
        for (const Variable& v : system.variables) {
            if (v.role == Role::slow) scope_.define(v.name, v.jet.front());
            if (v.role != Role::fast) continue;
            for (int k = 0; k < v.order; ++k)
                states_.push_back(v.name + std::string(static_cast<std::size_t>(k), '\''));
        }
    }

    std::vector<GivenMode> read() {
        std::vector<GivenMode> modes;
        std::size_t next = 1; // the number of the next mode: one on after a real mode, two on after a pair
        for (const TomlEntry& entry : table_.entries) {
            check_name(entry, next);
            modes.push_back(mode_of(entry));
            next += modes.back().eigenvalue.im.is_zero() ? 1 : 2;
        }
        if (next - 1 != states_.size())
            bad_input({"there are as many modes as fast variables and derivatives below the highest, a pair "
                       "counting twice",
                       "modes for " + std::to_string(next - 1) + " of " + std::to_string(states_.size()),
                       "give all of them, of a conjugate pair the first", place_of(table_.source)});
        return modes;
    }

private:
    static void check_name(const TomlEntry& entry, std::size_t number) {
        const std::string name = "z" + std::to_string(number);
        if (entry.key != name)
            bad_input(
                {"modes are called z1, z2, ... in their order; a pair counts twice, and its first is given",
                 in_quotes(entry.key), "call it " + name, entry.place});
    }

    GivenMode mode_of(const TomlEntry& entry) {
        check_keys(entry.value, {"eigenvalue", "u"});
        const TomlNode* eigenvalue = entry.value.find("eigenvalue");
        const TomlNode* column = entry.value.find("u");
        if (eigenvalue == nullptr || column == nullptr)
            bad_input(
                {"a mode has an eigenvalue and the column u of the modal matrix",
                 eigenvalue == nullptr ? "no eigenvalue" : "no u",
                 "write " + entry.key + R"( = { eigenvalue = "I*w", u = { x = "1/2", "x'" = "I*w/2" } })",
                 entry.place});
        check_table(*column);
        GivenMode mode{entry.key, number_of_parts(*eigenvalue), {}, entry.place};
        for (const TomlEntry& given : column->entries) mode.column.push_back(entry_of(given));
        const auto complex = std::find_if(mode.column.begin(), mode.column.end(),
                                          [](const auto& e) { return !e.value.im.is_zero(); });
        if (mode.eigenvalue.im.is_zero() && complex != mode.column.end())
            bad_input({"a real mode has a real column", in_quotes(complex->value.text),
                       "divide the column by what makes it complex", place_of(complex->value.source)});
        return mode;
    }

    GivenMode::Entry entry_of(const TomlEntry& given) {
        if (std::find(states_.begin(), states_.end(), given.key) == states_.end())
            bad_input(Reason::name,
                      {"a column has entries for fast variables and their derivatives below the highest",
                       in_quotes(given.key), suggest(given.key, states_), given.place});
        const auto [name, primes] = without_primes(given.key);
        const auto variable = std::find_if(system_.variables.begin(), system_.variables.end(),
                                           [n = name](const Variable& v) { return v.name == n; });
        return {static_cast<std::size_t>(variable - system_.variables.begin()), primes,
                number_of_parts(given.value)};
    }

    GivenNumber number_of_parts(const TomlNode& node) {
        const Parts parts(node);
        Scope scope = scope_;
        scope.define("I", parts.i);
        const auto [re, im] = parts.of(expression_of(node, scope));
        return {re.normal(), im.normal(), node.text, node.source};
    }

    const TomlNode& table_;
    const System& system_;
    Scope scope_;
    std::vector<std::string> states_; // "x", "x'"
};

} // namespace

void SystemReader::read_modes() {
    const TomlNode* modes = root_.find("modes");
    if (modes == nullptr) return;
    check_table(*modes);
    system_.modes = ModesReader(*modes, system_).read();
}

} // namespace resonform
