// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/text/eps_powers.hpp"

#include "algebra/number/error.hpp"
#include "model/text/toml_values.hpp"

#include <fmt/format.h>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::is_a;

constexpr int largest_weight = 9;
constexpr int largest_denominator = 12;
constexpr const char* root_prefix = "eps^(1/";

Rational rational_of(const GiNaC::numeric& number) { return cln::the<cln::cl_RA>(number.to_cl_N()); }

bool is_rational_power(const ex& e) {
    return is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::rational);
}

// eps > 0: (a eps^k)^r = a^r eps^(k r).
class TakeOut : public GiNaC::map_function {
public:
    explicit TakeOut(const ex& eps) : eps_(eps) {}

    ex operator()(const ex& e) override {
        ex mapped = e.map(*this);
        if (!is_rational_power(mapped) || !is_a<GiNaC::mul>(mapped.op(0)) || !mapped.has(eps_)) return mapped;
        ex outside = 1, inside = 1;
        for (const ex& factor : mapped.op(0)) {
            const bool power = is_rational_power(factor) && factor.op(0).is_equal(eps_);
            if (power || factor.is_equal(eps_))
                outside *= GiNaC::pow(eps_, (power ? factor.op(1) : ex(1)) * mapped.op(1));
            else
                inside *= factor;
        }
        return outside * GiNaC::pow(inside, mapped.op(1));
    }

private:
    ex eps_;
};

class Hold : public GiNaC::map_function {
public:
    Hold(const ex& eps, const ex& root, int q) : eps_(eps), root_(root), q_(q) {}

    ex operator()(const ex& e) override {
        if (e.is_equal(eps_)) return GiNaC::pow(root_, q_);
        if (is_rational_power(e) && e.op(0).is_equal(eps_)) return GiNaC::pow(root_, e.op(1) * q_);
        return e.map(*this);
    }

private:
    ex eps_, root_;
    int q_;
};

} // namespace

Rational weight_of(const TomlNode& node) {
    const Rational weight = number_of(node);
    if (cln::minusp(weight) || weight > largest_weight || cln::denominator(weight) > largest_denominator)
        bad_value(node,
                  fmt::format("'{}' is a rational number in 0 ... {}, its denominator at most {}",
                              node.source.key, largest_weight, largest_denominator),
                  "write a number such as 2, 0.5 or \"1/3\"");
    return weight;
}

int held_weight_of(const TomlNode& node, int root, int lowest, int highest) {
    if (root == 1) return integer_of(node, lowest, highest);
    const std::string range = fmt::format("{} ... {}", to_string(Rational(lowest) / root), highest);
    const Rational held = number_of(node) * root;
    if (cln::denominator(held) != 1 || held < lowest || held > highest * root)
        bad_value(node,
                  fmt::format("'{}' is a multiple of 1/{}, as weights and powers of eps are, in {}",
                              node.source.key, root, range),
                  fmt::format("write a number such as 2 or \"{}/{}\"", 2 * root + 1, root));
    return cln::cl_I_to_int(cln::numerator(held));
}

void EpsPowers::note(const Rational& weight, const Place& place) {
    const Integer common = cln::lcm(Integer(root_), cln::denominator(weight));
    if (common > largest_denominator)
        refuse(Reason::size, {fmt::format("weights and powers of eps have a common denominator of at most {}",
                                          largest_denominator),
                              fmt::format("{} beside multiples of 1/{}", to_string(weight), root_),
                              "scale eps so that its powers are simpler", place});
    root_ = cln::cl_I_to_int(common);
}

ex EpsPowers::taken_out(const ex& e, const Place& place) {
    ex result = TakeOut(eps_)(e);
    for (GiNaC::const_preorder_iterator it = result.preorder_begin(); it != result.preorder_end(); ++it)
        if (is_rational_power(*it) && it->op(0).is_equal(eps_))
            note(rational_of(GiNaC::ex_to<GiNaC::numeric>(it->op(1))), place);
    return result;
}

ex EpsPowers::held(const ex& e, const GiNaC::symbol& root) const { return Hold(eps_, root, root_)(e); }

GiNaC::symbol symbol_of_eps_root(int root) { return GiNaC::symbol(fmt::format("{}{})", root_prefix, root)); }

std::optional<std::string> spell_eps_power(const GiNaC::symbol& symbol, const GiNaC::numeric& exponent) {
    const std::string name = symbol.get_name();
    const std::string prefix = root_prefix;
    if (name.rfind(prefix, 0) != 0) return std::nullopt;
    const GiNaC::numeric power = exponent / std::stoi(name.substr(prefix.size()));
    return power == 1 ? "eps" : spell_eps_power(rational_of(power));
}

std::string quoted_weight(const Rational& weight) {
    return cln::denominator(weight) == 1 ? to_string(weight) : "\"" + to_string(weight) + "\"";
}

std::string spell_eps_power(const Rational& power) {
    const std::string text = to_string(power);
    return "eps^" + (cln::denominator(power) == 1 && !cln::minusp(power) ? text : "(" + text + ")");
}

} // namespace resonform
