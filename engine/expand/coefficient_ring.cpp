// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/coefficient_ring.hpp"

#include "model/canonical.hpp"

#include <algorithm>
#include <fmt/format.h>

#include <exception>
#include <tuple>
#include <utility>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;

// While a ring is built its exponents have the narrowest fields.
int largest_root_index() { return Packing().largest(); }

int to_int(const Integer& i) { return cln::cl_I_to_int(i); }

// An exponent that is kept in a monomial.
int to_exponent(const Rational& value, const ex& base, const Place& place) {
    constexpr int largest = 16383; // of any ring
    if (cln::abs(cln::numerator(value)) > largest)
        refuse({fmt::format("exponents are at most {} once roots are taken out", largest), spell(base),
                "use simpler exponents", place});
    return to_int(cln::numerator(value));
}

bool is_rational_number(const ex& e) {
    return is_a<GiNaC::numeric>(e) && ex_to<GiNaC::numeric>(e).is_rational();
}

} // namespace

CoefficientRing::CoefficientRing(std::shared_ptr<const System> system) : system_(std::move(system)) {
    vanish(system_->eps);
}

void CoefficientRing::vanish(const ex& symbol) { zero_[symbol] = 0; }

void CoefficientRing::move(const ex& symbol) { moving_.push_back(symbol); }

ex CoefficientRing::at_origin(const ex& e, const Place& place) const {
    try {
        return e.subs(zero_, GiNaC::subs_options::no_pattern).normal();
    } catch (const std::exception&) { // GiNaC::pole_error, and division by zero in normal()
        bad_input({"nothing is divided by an expression that is zero", spell(e),
                   "remove the singularity, or expand about another point", place});
    }
}

bool CoefficientRing::has_weight(const ex& e) const {
    return std::any_of(zero_.begin(), zero_.end(), [&](const auto& entry) { return e.has(entry.first); }) ||
           std::any_of(moving_.begin(), moving_.end(), [&](const ex& symbol) { return e.has(symbol); });
}

void CoefficientRing::collect(const ex& e, const Place& place) {
    if (is_a<GiNaC::power>(e)) {
        const ex& base = e.op(0);
        if (!is_rational_number(e.op(1)))
            refuse({"exponents are rational numbers", spell(e), "write the power with a number", place});
        const Rational exponent = to_rational(e.op(1));
        collect(base, place);
        if (e.op(1).info(GiNaC::info_flags::nonnegint)) return;
        note(split_power(at_origin(base, place), exponent, *system_, place), place);
        return;
    }
    for (const ex& operand : operands(e)) collect(operand, place);
}

void CoefficientRing::note(const PowerProduct& product, const Place& place) {
    for (const auto& factor : product.factors) {
        const Integer denominator = cln::denominator(factor.exponent);
        const bool atom = is_a<GiNaC::symbol>(factor.base);
        if (atom && denominator == 1) continue;
        collect(factor.base, place);                                   // roots inside come first
        if (denominator == 1 && cln::plusp(factor.exponent)) continue; // a polynomial of what is known
        Base* known = find_base(factor.base);
        if (known == nullptr) {
            bases_.push_back({factor.base, 1, level_of(factor.base), key_of(factor.base), -1, place});
            known = &bases_.back();
        }
        const Integer index = cln::lcm(known->index, denominator);
        if (index > largest_root_index())
            refuse({fmt::format("the roots taken of one expression have a common index of at most {}",
                                largest_root_index()),
                    spell(factor.base), "use simpler exponents", place});
        known->index = to_int(index);
    }
}

int CoefficientRing::level_of(const ex& base) const {
    int level = 0;
    for (GiNaC::const_preorder_iterator it = base.preorder_begin(); it != base.preorder_end(); ++it)
        if (is_a<GiNaC::power>(*it) && !it->op(1).info(GiNaC::info_flags::nonnegint))
            if (const Base* inner = find_base(it->op(0))) level = std::max(level, inner->level + 1);
    return level;
}

std::string CoefficientRing::key_of(const ex& base) const {
    if (is_a<GiNaC::numeric>(base)) return fmt::format("0 {:>40}", spell(base));
    if (!is_a<GiNaC::symbol>(base)) return "2 " + spell(base);
    for (std::size_t k = 0; k < system_->parameters.size(); ++k)
        if (base.is_equal(system_->parameters[k].symbol)) return fmt::format("1 a {:>6}", k);
    for (std::size_t k = 0; k < system_->variables.size(); ++k)
        if (base.is_equal(system_->variables[k].jet.front())) return fmt::format("1 b {:>6}", k);
    return "1 c " + spell(base);
}

CoefficientRing::Base* CoefficientRing::find_base(const ex& e) {
    return const_cast<Base*>(std::as_const(*this).find_base(e)); // the object itself is not const here
}

const CoefficientRing::Base* CoefficientRing::find_base(const ex& e) const {
    const auto found =
        std::find_if(bases_.begin(), bases_.end(), [&](const Base& b) { return b.expression.is_equal(e); });
    return found == bases_.end() ? nullptr : &*found;
}

void CoefficientRing::freeze(const Divisors& divisors) {
    RingBuilder builder;
    add_symbols(builder);
    std::stable_sort(bases_.begin(), bases_.end(), [](const Base& a, const Base& b) {
        return std::tie(a.level, a.key) < std::tie(b.level, b.key);
    });
    add_roots(builder);
    for (const Polynomial& divisor : divisors.values) {
        Generator g;
        g.kind = GeneratorKind::root;
        g.name = fmt::format("divisor {}", builder.next());
        g.index = 1;
        g.radicand = builder.import(*divisors.ring, divisor);
        divisors_.push_back(builder.add(std::move(g)));
    }
    ring_ = builder.freeze();
}

void CoefficientRing::add_symbols(RingBuilder& builder) {
    const GeneratorId first = 1; // after the imaginary unit
    for (const FastGenerator& fast : fast_) {
        Generator g;
        g.kind = GeneratorKind::fast;
        g.name = fast.name;
        g.weight = fast.weight;
        g.conjugate = fast.conjugate < 0 ? -1 : first + fast.conjugate;
        builder.add(std::move(g));
    }
    for (const std::string& angle : angles_) {
        Generator g;
        g.kind = GeneratorKind::phase;
        g.name = angle;
        g.invertible = true;
        builder.add(std::move(g));
    }
    const auto add = [&](GeneratorKind kind, const std::string& name, bool invertible, bool positive,
                         const ex& symbol) {
        Generator g;
        g.kind = kind;
        g.name = name;
        g.weight = kind == GeneratorKind::small ? 1 : 0;
        g.invertible = invertible;
        g.positive = positive;
        symbols_.emplace_back(symbol, builder.add(std::move(g)));
    };
    add(GeneratorKind::small, "eps", false, true, system_->eps);
    for (const auto& p : system_->parameters)
        add(GeneratorKind::parameter, p.name, p.nonzero || p.positive, p.positive, p.symbol);
    for (const auto& v : system_->variables)
        if (v.role == Role::slow)
            add(GeneratorKind::slow, v.name, v.nonzero || v.positive, v.positive, v.jet.front());
}

void CoefficientRing::add_roots(RingBuilder& builder) {
    int number = 0;
    for (Base& base : bases_) {
        const bool positive = provably_positive(base.expression, *system_);
        if (base.index == 1 && positive) base.index = 2; // only inverted: its root will do as well
        Generator g;
        g.kind = GeneratorKind::root;
        g.name = fmt::format("root {}", ++number); // no name of a user has a space
        g.invertible = true;
        g.positive = positive;
        g.index = base.index;
        g.radicand = radicand(base, builder);
        base.id = at_place(base.place, [&] { return builder.add(std::move(g)); });
    }
}

Polynomial CoefficientRing::radicand(const Base& root, const RingBuilder& builder) const {
    const ex& e = root.expression;
    std::vector<Term> terms;
    const auto add_term = [&](const ex& term) {
        Term product{Monomial{}, 1};
        const auto put = [&](const ex& factor) {
            const Term t = radicand_factor(factor, builder, root.place);
            product = {product.monomial + t.monomial, product.coefficient * t.coefficient};
        };
        if (is_a<GiNaC::mul>(term)) {
            for (const ex& factor : operands(term)) put(factor);
        } else {
            put(term);
        }
        terms.push_back(product);
    };
    if (is_a<GiNaC::add>(e)) {
        for (const ex& term : operands(e)) add_term(term);
    } else {
        add_term(e);
    }
    return Polynomial::from_terms(std::move(terms));
}

Term CoefficientRing::radicand_factor(const ex& factor, const RingBuilder& builder,
                                      const Place& place) const {
    if (is_a<GiNaC::numeric>(factor)) return {Monomial{}, to_rational(factor)};
    const bool is_power = is_a<GiNaC::power>(factor);
    const ex base = is_power ? factor.op(0) : factor;
    const Rational exponent = is_power ? to_rational(factor.op(1)) : Rational(1);
    const auto power_of = [&](GeneratorId id, const Rational& power) {
        if (cln::abs(cln::numerator(power)) > largest_root_index())
            refuse({fmt::format("exponents under a root are at most {}", largest_root_index()), spell(factor),
                    "use smaller exponents", place});
        return builder.gen(id, to_int(cln::numerator(power))).terms().front();
    };
    if (const Base* root = find_base(base); root != nullptr && root->id >= 0)
        return power_of(root->id, exponent * root->index);
    for (const auto& [symbol, id] : symbols_)
        if (base.is_equal(symbol)) return power_of(id, exponent);
    refuse({"the expression under a root is a polynomial in parameters, slow variables and simpler roots",
            spell(factor), "rewrite the coefficient", place});
}

GeneratorId CoefficientRing::fast(std::size_t k) const { return static_cast<GeneratorId>(k) + 1; }

GeneratorId CoefficientRing::angle(std::size_t k) const { return fast(fast_.size() + k); }

GeneratorId CoefficientRing::eps() const { return symbols_.front().second; }

GeneratorId CoefficientRing::slow(std::size_t variable) const {
    for (const auto& [symbol, id] : symbols_)
        if (symbol.is_equal(system_->variables[variable].jet.front())) return id;
    return -1;
}

Polynomial CoefficientRing::convert(const ex& e, const Place& place) const {
    if (is_a<GiNaC::add>(e)) {
        std::vector<Polynomial> summands;
        for (const ex& term : operands(e)) summands.push_back(convert(term, place));
        return sum(summands);
    }
    if (is_a<GiNaC::mul>(e)) {
        Polynomial product = ring_->one();
        for (const ex& factor : operands(e)) product = ring_->multiply(product, convert(factor, place));
        return product;
    }
    if (is_rational_number(e)) return Polynomial(to_rational(e));
    if (is_a<GiNaC::symbol>(e)) return convert_symbol(e, 1, place);
    if (is_a<GiNaC::power>(e) && is_rational_number(e.op(1))) {
        if (e.op(1).info(GiNaC::info_flags::nonnegint))
            return ring_->power(convert(e.op(0), place), to_int(cln::numerator(to_rational(e.op(1)))));
        return convert_power(e.op(0), to_rational(e.op(1)), place);
    }
    refuse({"coefficients are built from numbers, parameters, slow variables, powers and roots", spell(e),
            "functions of slow variables and irrational constants are not supported yet", place});
}

Polynomial CoefficientRing::convert(const Complex& e, const Place& place) const {
    const Polynomial re = convert(e.re, place);
    return e.im.is_zero() ? re : re + ring_->multiply(ring_->imaginary(), convert(e.im, place));
}

Polynomial CoefficientRing::convert_symbol(const ex& symbol, int exponent, const Place& place) const {
    for (const auto& [known, id] : symbols_)
        if (symbol.is_equal(known)) return ring_->gen(id, exponent);
    bad_input({"coefficients depend on parameters and slow variables only", spell(symbol),
               "declare the variable as slow if its equation of motion says so", place});
}

Polynomial CoefficientRing::convert_power(const ex& base, const Rational& exponent,
                                          const Place& place) const {
    const PowerProduct product = split_power(base, exponent, *system_, place);
    Polynomial result(product.number);
    for (const auto& factor : product.factors) {
        if (const Base* root = find_base(factor.base)) {
            const int power = to_exponent(factor.exponent * root->index, factor.base, place);
            result = ring_->multiply(result, ring_->gen(root->id, power));
        } else {
            const int power = to_exponent(factor.exponent, factor.base, place);
            result = ring_->multiply(result, is_a<GiNaC::symbol>(factor.base)
                                                 ? convert_symbol(factor.base, power, place)
                                                 : ring_->power(convert(factor.base, place), power));
        }
    }
    return result;
}

} // namespace resonform
