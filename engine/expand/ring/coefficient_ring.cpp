// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/ring/coefficient_ring.hpp"

#include "algebra/number/error.hpp"
#include "expand/ring/power_product.hpp"
#include "model/text/canonical.hpp"
#include "model/text/function_call.hpp"
#include "model/text/function_slope.hpp"
#include "model/text/named_function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::is_a;

// A ring under construction stores exponents in the narrowest fields.
int largest_root_index() { return Packing().largest(); }

int to_int(const Integer& i) { return cln::cl_I_to_int(i); }

std::optional<ex> inverse_of_number(const ex& e, const Place& place) {
    CoefficientRing numbers(std::make_shared<const System>());
    numbers.collect(e, place);
    numbers.freeze();
    const auto inverse = numbers.ring()->inverse(numbers.convert(e, place));
    return inverse ? std::optional(numbers.expression(*inverse)) : std::nullopt;
}

} // namespace

CoefficientRing::CoefficientRing(std::shared_ptr<const System> system) : system_(std::move(system)) {
    vanish(system_->eps);
}

ex with_argument(const ex& e, const ex& u) {
    if (is_named(e)) return named_function(named_call(e).name, named_call(e).derivative, u);
    return GiNaC::ex_to<GiNaC::function>(e).thiscontainer({u}).eval();
}

void CoefficientRing::vanish(const ex& symbol) { zero_[symbol] = 0; }

void CoefficientRing::move(const ex& symbol) { moving_.push_back(symbol); }

void CoefficientRing::collect(const ex& e, const Place& place) {
    if (is_a<GiNaC::power>(e)) {
        const ex& base = e.op(0);
        if (!e.op(1).info(GiNaC::info_flags::rational))
            refuse({"exponents are rational numbers", spell(e), "write the power with a number", place});
        collect(base, place);
        if (e.op(1).info(GiNaC::info_flags::nonnegint)) return;
        const ex origin = at_origin(base, place);
        if (origin.is_zero() && e.op(1).info(GiNaC::info_flags::negative)) refuse_pole(base, place);
        needed_.push_back({GiNaC::pow(origin, e.op(1)), place});
        return;
    }
    if (is_a<GiNaC::function>(e)) {
        collect(e.op(0), place);
        collect_function(e, without_angles(at_origin(e.op(0), place)), place);
        return;
    }
    if (e.is_equal(GiNaC::Pi)) needed_.push_back({e, place});
    for (const ex& operand : operands(e)) collect(operand, place);
}

// The rest of an argument k phi + rest.
ex CoefficientRing::without_angles(const ex& argument) const {
    GiNaC::exmap zero;
    for (const Variable& v : system_->variables)
        if (v.role == Role::angle) zero[v.jet.front()] = 0;
    return zero.empty() ? argument : argument.subs(zero, GiNaC::subs_options::no_pattern);
}

// Notes what the expansion of f(u_0 + ...) needs: f(u_0) and, if f is expanded, its slope at u_0.
void CoefficientRing::collect_function(const ex& e, const ex& u, const Place& place) {
    const auto need = [&](const ex& expression) { needed_.push_back({expression, place}); };
    const std::optional<Function> f = function_of(e);
    const ex asked = f ? asked_of(u, *f).expand() : ex(1);
    const bool unreal = asked.info(GiNaC::info_flags::negative) && f != Function::logarithm;
    if (asked.is_zero() || unreal)
        refuse(Reason::singular, {"a function is regular at the origin", spell(e),
                                  "remove the singularity, or expand about another point", place});
    if (!u.is_zero() || is_named(e)) need(with_argument(e, u));
    expands_named_ = expands_named_ || (is_named(e) && has_weight(e));
    if (f && !row_of(*f).slope.empty()) need(slope_of(*f, u));
}

// The common parts of arguments, then the atoms with the powers inside, then all other powers.
void CoefficientRing::learn_functions(int derivatives) {
    functions_ = std::make_shared<FunctionAtoms>(system_, derivatives, inverse_of_number);
    do {
        for (const Needed& n : needed_) functions_->learn(n.expression, n.place);
    } while (!functions_->forget_unless_settled());
    functions_->judge_independence();
    for (const FunctionAtom& atom : functions_->atoms()) {
        note_powers(atom.argument, atom.place);
        levels_.push_back(level_of(atom.argument));
    }
    for (const Needed& n : needed_) note_powers(functions_->rewrite(n.expression, n.place), n.place);
    needed_.clear();
}

void CoefficientRing::note_powers(const ex& e, const Place& place) {
    for (const ex& operand : operands(e)) note_powers(operand, place);
    if (is_a<GiNaC::power>(e) && !e.op(1).info(GiNaC::info_flags::nonnegint))
        note(split_power(e.op(0), to_rational(e.op(1)), functions_->domain(), place), place);
}

void CoefficientRing::note(const PowerProduct& product, const Place& place) {
    for (const auto& factor : product.factors) {
        const Integer denominator = cln::denominator(factor.exponent);
        const bool atom = is_a<GiNaC::symbol>(factor.base);
        if (atom && denominator == 1) continue;
        note_powers(factor.base, place);                               // roots inside come first
        if (denominator == 1 && cln::plusp(factor.exponent)) continue; // a polynomial of known bases
        Base* known = find_base(factor.base);
        if (known == nullptr) {
            bases_.push_back({factor.base, 1, level_of(factor.base), key_of(factor.base), -1, place});
            known = &bases_.back();
        }
        const Integer index = cln::lcm(known->index, denominator);
        if (index > largest_root_index())
            refuse(Reason::size,
                   {fmt::format("the roots taken of one expression have a common index of at most {}",
                                largest_root_index()),
                    spell(factor.base), "use simpler exponents", place});
        known->index = to_int(index);
    }
}

int CoefficientRing::level_of(const ex& base) const {
    int level = 0;
    for (GiNaC::const_preorder_iterator it = base.preorder_begin(); it != base.preorder_end(); ++it) {
        if (is_a<GiNaC::power>(*it) && !it->op(1).info(GiNaC::info_flags::nonnegint))
            for (const ex& held : {it->op(0), (-it->op(0)).expand()}) // of either sign, as below
                if (const Base* inner = find_base(held)) level = std::max(level, inner->level + 1);
        for (std::size_t k = 0; k < levels_.size(); ++k)
            if (it->is_equal(functions_->atoms()[k].symbol)) level = std::max(level, levels_[k] + 1);
    }
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
    derivatives_ = divisors.derivatives;
    learn_functions(derivatives_);
    RingBuilder builder;
    builder.round_to(system_->digits);
    add_symbols(builder);
    std::stable_sort(bases_.begin(), bases_.end(), [](const Base& a, const Base& b) {
        return std::tie(a.level, a.key) < std::tie(b.level, b.key);
    });
    add_roots_and_functions(builder);
    for (const Polynomial& divisor : divisors.values) {
        Generator g;
        g.kind = GeneratorKind::root;
        g.name = fmt::format("divisor {}", builder.next());
        g.index = 1;
        g.radicand = builder.import(*divisors.ring, divisor);
        divisors_.push_back(builder.add(std::move(g)));
    }
    ring_ = builder.freeze();
    if (set_slopes(builder)) ring_ = builder.freeze();
}

// Sets the slopes of functions that the ring does not know, as elements of the ring.
bool CoefficientRing::set_slopes(RingBuilder& builder) const {
    bool any = false;
    for (const FunctionAtom& atom : functions_->atoms()) {
        const bool found = atom.function == Function::logarithm || atom.function == Function::arc_tangent;
        if (found || atom.function == Function::named || row_of(atom.function).slope.empty()) continue;
        const ex slope = slope_of(atom.function, functions_->domain().meaning(atom.argument));
        builder.set_slope(*ring_->find(atom.symbol.get_name()), *ring_, convert(slope, atom.place));
        any = true;
    }
    return any;
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
        g.index = kind == GeneratorKind::small ? system_->eps_root : 0;
        g.invertible = invertible;
        g.positive = positive;
        symbols_.emplace_back(symbol, builder.add(std::move(g)));
    };
    add(GeneratorKind::small, "eps", false, true, system_->eps);
    if (const GiNaC::symbol* pi = functions_->pi()) add(GeneratorKind::parameter, "pi", true, true, *pi);
    for (const auto& p : system_->parameters)
        add(GeneratorKind::parameter, p.name, p.nonzero || p.positive, p.positive, p.symbol);
    for (const Number& n : numbers_) add(GeneratorKind::parameter, n.name, false, false, n.symbol);
    for (const auto& v : system_->variables)
        if (v.role == Role::slow)
            add(GeneratorKind::slow, v.name, v.nonzero || v.positive, v.positive, v.jet.front());
}

// Inner roots and functions before outer ones; on one level, roots before functions.
void CoefficientRing::add_roots_and_functions(RingBuilder& builder) {
    const auto& atoms = functions_->atoms();
    std::vector<std::size_t> order(atoms.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const auto key = [&](std::size_t k) {
            return std::make_tuple(levels_[k], spell(atoms[k].argument), atoms[k].function, atoms[k].name,
                                   atoms[k].derivative);
        };
        return key(a) < key(b);
    });
    std::vector<GeneratorId> ids(atoms.size(), -1);
    std::size_t base = 0, atom = 0;
    while (base < bases_.size() || atom < order.size()) {
        const bool root =
            base < bases_.size() && (atom == order.size() || bases_[base].level <= levels_[order[atom]]);
        if (root) {
            add_root(bases_[base], builder);
            ++base;
        } else {
            const std::size_t k = order[atom++];
            add_function(atoms[k], ids, builder);
            ids[k] = symbols_.back().second;
        }
    }
}

// sqrt(2) is named 2^(1/2), the base of 1/(b - a) is named (b - a): no name of a user looks like these.
std::string CoefficientRing::name_of(const Base& base) {
    const bool sum = is_a<GiNaC::add>(base.expression);
    const std::string text = spell(base.expression), inside = sum ? "(" + text + ")" : text;
    return base.index == 1 ? inside : fmt::format("{}^(1/{})", inside, base.index);
}

void CoefficientRing::add_root(Base& base, RingBuilder& builder) {
    const bool positive = functions_->domain().positive(base.expression);
    if (base.index == 1 && positive) base.index = 2; // only inverted: its root will do as well
    Generator g;
    g.kind = GeneratorKind::root;
    g.name = name_of(base);
    g.invertible = true;
    g.positive = positive;
    g.index = base.index;
    g.radicand = polynomial(base.expression, builder, base.place);
    base.id = at_place(base.place, [&] { return builder.add(std::move(g)); });
}

void CoefficientRing::add_function(const FunctionAtom& atom, std::vector<GeneratorId>& ids,
                                   RingBuilder& builder) {
    Generator g;
    g.kind = GeneratorKind::function;
    g.name = atom.symbol.get_name(); // no name of a user has a parenthesis
    g.positive = functions_->domain().positive(atom.symbol);
    g.invertible = functions_->domain().nonzero(atom.symbol);
    g.independent = atom.independent;
    g.of = {atom.function, polynomial(atom.argument, builder, atom.place),
            atom.function == Function::cosine ? ids[atom.sine] : -1, atom.name, atom.derivative};
    symbols_.emplace_back(atom.symbol, at_place(atom.place, [&] { return builder.add(std::move(g)); }));
}

// An expression in generators of the builder, a sum of products of powers, as a polynomial.
Polynomial CoefficientRing::polynomial(const ex& e, const RingBuilder& builder, const Place& place) const {
    std::vector<Term> terms;
    for (const ex& term : terms_of(e)) {
        Term product{Monomial{}, 1};
        for (const ex& f : factors_of(term)) {
            const Term t = factor(f, builder, place);
            product = {product.monomial + t.monomial, product.coefficient * t.coefficient};
        }
        terms.push_back(product);
    }
    return Polynomial::from_terms(std::move(terms));
}

Term CoefficientRing::factor(const ex& e, const RingBuilder& builder, const Place& place) const {
    if (is_a<GiNaC::numeric>(e)) return {Monomial{}, to_rational(e)};
    const bool is_power = is_a<GiNaC::power>(e);
    const ex base = is_power ? e.op(0) : e;
    const Rational exponent = is_power ? to_rational(e.op(1)) : Rational(1);
    const auto power_of = [&](GeneratorId id, const Rational& power) {
        if (cln::abs(cln::numerator(power)) > largest_root_index())
            refuse(Reason::size, {fmt::format("exponents under a root are at most {}", largest_root_index()),
                                  spell(e), "use smaller exponents", place});
        return builder.gen(id, to_int(cln::numerator(power))).terms().front();
    };
    if (const Base* root = find_base(base); root != nullptr && root->id >= 0)
        return power_of(root->id, exponent * root->index);
    // GiNaC may hold 1/(a - b) as -1/(b - a).
    if (is_a<GiNaC::add>(base) && cln::denominator(exponent) == 1)
        if (const Base* root = find_base((-base).expand()); root != nullptr && root->id >= 0) {
            Term turned = power_of(root->id, exponent * root->index);
            if (cln::oddp(cln::numerator(exponent))) turned.coefficient = -turned.coefficient;
            return turned;
        }
    for (const auto& [symbol, id] : symbols_)
        if (base.is_equal(symbol)) return power_of(id, exponent);
    refuse({"the expression under a root or in a function is a polynomial in parameters, slow variables and "
            "simpler roots and functions",
            spell(e), "rewrite the coefficient", place});
}

GeneratorId CoefficientRing::fast(std::size_t k) const { return static_cast<GeneratorId>(k) + 1; }

GeneratorId CoefficientRing::angle(std::size_t k) const { return fast(fast_.size() + k); }

GeneratorId CoefficientRing::eps() const { return symbols_.front().second; }

GeneratorId CoefficientRing::number(std::size_t k) const {
    for (const auto& [symbol, id] : symbols_)
        if (symbol.is_equal(numbers_[k].symbol)) return id;
    return -1;
}

GeneratorId CoefficientRing::slow(std::size_t variable) const {
    for (const auto& [symbol, id] : symbols_)
        if (symbol.is_equal(system_->variables[variable].jet.front())) return id;
    return -1;
}

Place CoefficientRing::place_of(GeneratorId id) const {
    for (const Base& base : bases_)
        if (base.id == id) return base.place;
    for (const FunctionAtom& atom : functions_->atoms())
        for (const auto& [symbol, known] : symbols_)
            if (known == id && symbol.is_equal(atom.symbol)) return atom.place;
    return {};
}

} // namespace resonform
