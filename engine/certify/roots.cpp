// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/roots.hpp"

#include "algebra/number/number.hpp"
#include "certify/as_written.hpp"
#include "model/text/canonical.hpp"
#include "model/text/function_call.hpp"
#include "model/text/named_function.hpp"
#include "model/text/regular.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::is_a;

bool is_whole(const Rational& r) { return cln::denominator(r) == 1; }

int to_int(const Rational& r) { return cln::cl_I_to_int(cln::numerator(r)); }

// The total degree of a polynomial in its symbols.
int total_degree(const ex& e) {
    if (is_a<GiNaC::symbol>(e)) return 1;
    if (is_a<GiNaC::power>(e)) return total_degree(e.op(0)) * GiNaC::ex_to<GiNaC::numeric>(e.op(1)).to_int();
    int degree = 0;
    for (const ex& operand : e)
        degree =
            is_a<GiNaC::add>(e) ? std::max(degree, total_degree(operand)) : degree + total_degree(operand);
    return degree;
}

ex meaning_of(const FunctionOf& f, const ex& u) {
    return f.function == Function::named ? named_function(f.symbol, f.derivative, u) : call(f.function, u);
}

} // namespace

CertificateRoots::CertificateRoots(const GradedField& field) : field_(&field) {
    const System& system = field.system();
    const Ring& ring = *field.ring;
    std::vector<ex> symbols(static_cast<std::size_t>(ring.size()), 0);
    for (int id = 0; id < ring.size(); ++id) {
        const Generator& g = ring.generator(id);
        if (const Parameter* p = system.parameter(g.name); p != nullptr && g.kind == GeneratorKind::parameter)
            symbols[static_cast<std::size_t>(id)] = p->symbol;
    }
    if (const auto pi = ring.find("pi")) symbols[static_cast<std::size_t>(*pi)] = pi_;
    meanings_[pi_] = GiNaC::Pi;
    for (const SlowVariable& s : field.slow)
        symbols[static_cast<std::size_t>(s.generator)] = system.variables[s.variable].jet.front();
    for (int id = 0; id < ring.size(); ++id) {
        const Generator& g = ring.generator(id);
        if (g.kind != GeneratorKind::root && g.kind != GeneratorKind::function) continue;
        const GiNaC::symbol symbol(g.name);
        if (g.kind == GeneratorKind::root) {
            roots_.push_back({id, g.index, g.positive, expression_of(g.radicand, symbols), symbol});
            meanings_[symbol] =
                GiNaC::pow(roots_.back().radicand.subs(meanings_), GiNaC::numeric(1, g.index));
        } else {
            functions_.push_back({id, g.of, g.positive, expression_of(g.of.argument, symbols), symbol});
            meanings_[symbol] = meaning_of(g.of, functions_.back().argument.subs(meanings_));
        }
        symbols[static_cast<std::size_t>(id)] = symbol;
    }
    std::stable_sort(roots_.begin(), roots_.end(), [](const Root& a, const Root& b) {
        return total_degree(a.radicand) > total_degree(b.radicand);
    });
    origin_[system.eps] = 0;
    for (const Variable& v : system.variables)
        for (std::size_t k = v.role == Role::fast ? 0 : 1; k < v.jet.size(); ++k) origin_[v.jet[k]] = 0;
}

// Names the part of the equation in the message; `part` may hold symbols of generators.
void CertificateRoots::refuse_part(const std::string& rule, const ex& part, const Equation& equation) const {
    const std::string name = spell(part.subs(meanings_, GiNaC::subs_options::no_pattern));
    refuse_certificate(rule, equation, fmt::format("{} in ", name));
}

bool CertificateRoots::positive(const ex& e) const {
    return provably_positive(e.subs(meanings_, GiNaC::subs_options::no_pattern), field_->system());
}

std::optional<GeneratorId> CertificateRoots::generator_of(const ex& symbol) const {
    if (symbol.is_equal(pi_) || symbol.is_equal(GiNaC::Pi)) return field_->ring->find("pi");
    for (const Root& r : roots_)
        if (symbol.is_equal(r.symbol)) return r.id;
    for (const FunctionAtom& f : functions_)
        if (symbol.is_equal(f.symbol)) return f.id;
    return std::nullopt;
}

ex CertificateRoots::at_origin(const ex& e, const Equation& equation) {
    if (const auto known = origins_.find(e); known != origins_.end()) return known->second;
    const auto value = where_regular([&] {
        const ex at_zero = e.subs(origin_, GiNaC::subs_options::no_pattern);
        const ex found = lowered(with_symbols(at_zero, equation).normal());
        return without_whole_powers(found).is_zero() ? ex(0) : found;
    });
    if (!value) refuse_part("no denominator vanishes at the origin", e, equation);
    return origins_.emplace(e, *value).first->second;
}

// The ring may have written a variable by a root in it, a = sigma^4: whole powers of radicands are put back.
ex CertificateRoots::expression_of(const Polynomial& p, const std::vector<ex>& symbols) const {
    ex sum = 0;
    for (const Term& term : p.terms()) {
        ex product = GiNaC::numeric(term.coefficient);
        const std::vector<int> exponents = field_->ring->exponents(term.monomial);
        for (std::size_t k = 0; k < exponents.size(); ++k) {
            if (exponents[k] == 0) continue;
            const auto inner = std::find_if(roots_.begin(), roots_.end(), [&](const Root& r) {
                return r.id == static_cast<GeneratorId>(k);
            });
            if (inner == roots_.end()) {
                product *= GiNaC::pow(symbols[k], exponents[k]);
                continue;
            }
            const int whole = exponents[k] / inner->index, rest = exponents[k] % inner->index;
            if (whole != 0) product *= GiNaC::pow(inner->radicand, whole);
            if (rest != 0) product *= GiNaC::pow(symbols[k], rest);
        }
        sum += product;
    }
    return sum.expand();
}

const Radical& CertificateRoots::resolve(const ex& base, const Rational& exponent, const Equation& equation) {
    for (const Known& k : known_)
        if (k.exponent == exponent && k.base.is_equal(base)) return k.radical;
    Product product{GiNaC::pow(base, GiNaC::numeric(exponent)), {}, {}, {}};
    product.roots.resize(roots_.size());
    const auto regular = where_regular([&] {
        split(base.subs(origin_, GiNaC::subs_options::no_pattern), exponent, equation, product);
        return true;
    });
    if (!regular) refuse_part("no denominator vanishes at the origin", product.whole, equation);
    known_.push_back({base, exponent, collect(product, equation)});
    return known_.back().radical;
}

void CertificateRoots::split(const ex& e, const Rational& exponent, const Equation& equation,
                             Product& product) {
    if (is_a<GiNaC::numeric>(e)) return split_number(rational_of(e, equation), exponent, equation, product);
    if (const auto factors = positive_factors(e, equation); !factors.front().first.is_equal(e)) {
        for (const auto& [base, power] : factors) split(base, exponent * power, equation, product);
        return;
    }
    const auto [above, below] = rationalised(lowered(with_symbols(e, equation).normal()).normal());
    const bool turn = positive((-below).expand());
    split_polynomial(turn ? -above : above, exponent, equation, product);
    split_polynomial(turn ? -below : below, -exponent, equation, product);
}

// Numerator and denominator, without powers of roots as factors below: 4 - sqrt(3)/sqrt(2) is
// (8 - sqrt(2)*sqrt(3))/2, with the radicand above as the ring has it.
std::pair<ex, ex> CertificateRoots::rationalised(const ex& e) const {
    const ex fraction = e.numer_denom();
    ex above = fraction.op(0), below = fraction.op(1).expand();
    for (const Root& root : roots_) {
        const int degree = below.ldegree(root.symbol) % root.index;
        if (degree == 0) continue;
        const ex factor = GiNaC::pow(root.symbol, root.index - degree);
        above = without_whole_powers(above * factor).expand();
        below = without_whole_powers(below * factor).expand();
    }
    return {above, below};
}

// The factors of a product or a power with their exponents. A factor b to a whole power is replaced by -b if
// that is proved positive: GiNaC may hold (1 - a)^2 as (-1 + a)^2, or (b - tau)^3*b as -(tau - b)^3*b.
// Anything else, and -tau where tau is negative, is its own only factor.
std::vector<std::pair<ex, Rational>> CertificateRoots::positive_factors(const ex& product,
                                                                        const Equation& equation) const {
    if (!is_a<GiNaC::mul>(product) && !is_a<GiNaC::power>(product)) return {{product, 1}};
    std::vector<std::pair<ex, Rational>> factors;
    Rational number = 1;
    for (const ex& factor : factors_of(product)) {
        if (is_a<GiNaC::numeric>(factor)) {
            number = number * rational_of(factor, equation);
            continue;
        }
        const bool power = is_a<GiNaC::power>(factor);
        const ex base = power ? factor.op(0) : factor;
        const Rational exponent = power ? rational_of(factor.op(1), equation) : Rational(1);
        const ex turned = (-base).expand();
        const bool turn = is_whole(exponent) && !positive(base) && positive(turned);
        if (turn && cln::oddp(cln::numerator(exponent))) number = -number;
        factors.emplace_back(turn ? turned : base, exponent);
    }
    if (number != 1 || factors.empty()) factors.emplace_back(GiNaC::numeric(number), 1);
    return factors;
}

// e divided by the radicands that divide it.
ex CertificateRoots::without_radicands(ex e, const Rational& exponent, Product& product) const {
    for (std::size_t k = 0; k < roots_.size(); ++k) {
        if (is_a<GiNaC::numeric>(roots_[k].radicand) || !roots_[k].positive) continue;
        ex quotient;
        while (!is_a<GiNaC::numeric>(e) && GiNaC::divide(e, roots_[k].radicand, quotient)) {
            product.roots[k] = product.roots[k] + exponent;
            e = quotient.expand();
        }
    }
    return e;
}

void CertificateRoots::split_polynomial(ex e, const Rational& exponent, const Equation& equation,
                                        Product& product) {
    e = without_radicands(without_whole_powers(e).expand(), exponent, product);
    // 4*sqrt(2) - sqrt(3) is (8 - sqrt(2)*sqrt(3))/sqrt(2).
    for (std::size_t k = 0; k < roots_.size() && !is_a<GiNaC::numeric>(e); ++k) {
        if (!is_a<GiNaC::numeric>(roots_[k].radicand) || !e.has(roots_[k].symbol)) continue;
        for (int power = 1; power < roots_[k].index; ++power) {
            Product turned = product;
            turned.roots[k] = turned.roots[k] - exponent * Rational(power) / roots_[k].index;
            const ex times = without_whole_powers(e * GiNaC::pow(roots_[k].symbol, power)).expand();
            const ex rest = without_radicands(times, exponent, turned);
            if (!is_a<GiNaC::numeric>(rest)) continue;
            product = turned;
            e = rest;
            break;
        }
    }
    if (is_a<GiNaC::numeric>(e)) return split_number(rational_of(e, equation), exponent, equation, product);
    split_rest(GiNaC::sqrfree(e), exponent, equation, product);
}

void CertificateRoots::split_rest(const ex& e, const Rational& exponent, const Equation& equation,
                                  Product& product) const {
    if (is_a<GiNaC::numeric>(e)) return split_number(rational_of(e, equation), exponent, equation, product);
    if (const auto factors = positive_factors(e, equation); !factors.front().first.is_equal(e)) {
        for (const auto& [base, power] : factors) split_rest(base, exponent * power, equation, product);
        return;
    }
    for (std::size_t k = 0; k < roots_.size(); ++k)
        if (roots_[k].positive && e.is_equal(roots_[k].symbol)) {
            product.roots[k] = product.roots[k] + exponent / roots_[k].index;
            return;
        }
    const bool has_root =
        std::any_of(roots_.begin(), roots_.end(), [&](const Root& r) { return e.has(r.symbol); });
    if ((has_root && !is_whole(exponent)) || !positive(e))
        refuse_part("the base of a fractional power is a product of factors proved positive", product.whole,
                    equation);
    product.rest.emplace_back(e, exponent);
}

void CertificateRoots::split_number(const Rational& value, const Rational& exponent, const Equation& equation,
                                    Product& product) const {
    if (!cln::plusp(value))
        refuse_part("the base of a fractional power is a product of factors proved positive", product.whole,
                    equation);
    Integer numerator = cln::numerator(value), denominator = cln::denominator(value);
    for (std::size_t k = 0; k < roots_.size(); ++k) {
        if (!is_a<GiNaC::numeric>(roots_[k].radicand)) continue;
        const Rational radicand = rational_of(roots_[k].radicand, equation);
        if (!is_whole(radicand) || radicand <= 1) continue;
        const Integer whole = cln::numerator(radicand);
        for (; cln::zerop(cln::mod(numerator, whole)); numerator = cln::exquo(numerator, whole))
            product.roots[k] = product.roots[k] + exponent;
        for (; cln::zerop(cln::mod(denominator, whole)); denominator = cln::exquo(denominator, whole))
            product.roots[k] = product.roots[k] - exponent;
    }
    product.numbers.emplace_back(numerator / denominator, exponent);
}

Radical CertificateRoots::collect(const Product& product, const Equation& equation) const {
    Radical radical;
    for (std::size_t k = 0; k < roots_.size(); ++k) {
        const Rational power = roots_[k].index * product.roots[k];
        if (!is_whole(power))
            refuse_part("every fractional power in an equation is one of the ring's roots", product.whole,
                        equation);
        if (!cln::zerop(power)) radical.roots.emplace_back(roots_[k].id, to_int(power));
    }
    for (const auto& [value, exponent] : product.numbers) {
        Rational root;
        if (!exact_root(value, cln::cl_I_to_int(cln::denominator(exponent)), root))
            refuse_part("every root of a number in an equation is one of the ring's roots", product.whole,
                        equation);
        radical.number = radical.number * cln::expt(root, cln::numerator(exponent));
    }
    for (const auto& [factor, exponent] : product.rest) {
        if (!is_whole(exponent))
            refuse_part("every fractional power in an equation is one of the ring's roots", product.whole,
                        equation);
        radical.rest *= GiNaC::pow(factor, to_int(exponent));
    }
    return radical;
}

ex CertificateRoots::with_symbols(const ex& e, const Equation& equation) {
    if (is_a<GiNaC::numeric>(e) || is_a<GiNaC::symbol>(e)) return e;
    if (e.is_equal(GiNaC::Pi)) return pi_;
    if (is_a<GiNaC::add>(e)) {
        ex result = 0;
        for (const ex& term : operands(e)) result += with_symbols(term, equation);
        return result;
    }
    if (is_a<GiNaC::mul>(e)) {
        ex result = 1;
        for (const ex& factor : operands(e)) result *= with_symbols(factor, equation);
        return result;
    }
    if (is_a<GiNaC::function>(e)) return function_with_symbols(e, equation);
    if (!is_a<GiNaC::power>(e))
        refuse_part("weight 0 is built from numbers, names, powers and elementary functions", e, equation);
    const Rational exponent = rational_of(e.op(1), equation);
    if (is_whole(exponent)) return GiNaC::pow(with_symbols(e.op(0), equation), e.op(1));
    return radical_with_symbols(e.op(0), exponent, equation);
}

ex CertificateRoots::radical_with_symbols(const ex& base, const Rational& exponent,
                                          const Equation& equation) {
    const Radical radical = resolve(base, exponent, equation);
    ex result = GiNaC::numeric(radical.number) * radical.rest;
    for (const Root& root : roots_)
        for (const auto& [id, power] : radical.roots)
            if (root.id == id) result *= GiNaC::pow(root.symbol, power);
    return result;
}

} // namespace resonform
