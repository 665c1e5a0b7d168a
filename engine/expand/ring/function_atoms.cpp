// SPDX-License-Identifier: GPL-3.0-or-later
#include "expand/ring/function_atoms.hpp"

#include "algebra/number/error.hpp"
#include "algebra/number/number.hpp"
#include "expand/ring/angle_terms.hpp"
#include "model/text/canonical.hpp"
#include "model/text/function_call.hpp"
#include "model/text/named_function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;

constexpr int largest_multiple = 200; // of an angle: powers of its sine and cosine

bool has_function(const ex& e) {
    return std::any_of(e.preorder_begin(), e.preorder_end(),
                       [](const ex& part) { return is_a<GiNaC::function>(part); });
}

bool has_atom(const ex& e) { return has_function(e) || e.has(GiNaC::Pi); }

} // namespace

// Rewrites one expression in atoms; learns new atoms if that is allowed.
class FunctionRewriter {
public:
    FunctionRewriter(const FunctionAtoms& atoms, FunctionAtoms* learner, const Place& place)
        : known_(atoms), learner_(learner), place_(place) {}

    ex operator()(const ex& e) {
        if (is_a<GiNaC::function>(e)) return function(e);
        if (is_a<GiNaC::add>(e)) {
            ex sum = 0;
            for (const ex& term : operands(e)) sum += (*this)(term);
            return sum;
        }
        if (is_a<GiNaC::mul>(e)) {
            ex product = 1;
            for (const ex& factor : operands(e)) product *= (*this)(factor);
            return product;
        }
        if (is_a<GiNaC::power>(e)) return GiNaC::pow((*this)(e.op(0)), e.op(1));
        return e.is_equal(GiNaC::Pi) ? pi() : e;
    }

private:
    ex pi() {
        if (learner_ != nullptr) learner_->has_pi_ = true;
        if (known_.pi() == nullptr) refuse_unlearned(GiNaC::Pi, false);
        return known_.pi_;
    }

    [[noreturn]] void refuse_unlearned(const ex& meaning, bool derivative) const {
        refuse({"a coefficient is built from what the equations hold", spell(meaning),
                derivative ? "ask for a lower order" : "write the equations with this function", place_});
    }

    ex function(const ex& e) {
        if (is_named(e)) {
            const ex u = argument(e.op(0));
            const NamedCall call = named_call(e);
            if (learner_ != nullptr)
                for (int k = 0; k <= call.derivative + learner_->derivatives_; ++k) named(call.name, k, u);
            return named(call.name, call.derivative, u);
        }
        const std::optional<Function> f = function_of(e);
        if (!f)
            refuse({"unknown function: neither an elementary one nor one under [functions]", spell(e),
                    "write it with these", place_});
        if (*f == Function::sine || *f == Function::cosine || *f == Function::tangent) {
            const CosineSine of = angle_with_arcs(e.op(0));
            const ex sine = domain().expanded(of.sine), cosine = domain().expanded(of.cosine);
            return *f == Function::sine ? sine : *f == Function::cosine ? cosine : sine / cosine;
        }
        const ex u = argument(e.op(0));
        switch (*f) {
        case Function::exponential: return exponential(u);
        case Function::hyperbolic_sine: return half_sum(exponential(u), -1);
        case Function::hyperbolic_cosine: return half_sum(exponential(u), 1);
        case Function::hyperbolic_tangent: {
            const ex square = GiNaC::pow(exponential(u), 2);
            return (square - 1) / (square + 1);
        }
        case Function::logarithm: return logarithm(u);
        case Function::arc_sine: return arc_sine(u);
        default: return plain(*f, u);
        }
    }

    // (E + sign/E)/2
    static ex half_sum(const ex& exponential, int sign) {
        return (exponential + GiNaC::numeric(sign) / exponential) / 2;
    }

    [[nodiscard]] const CoefficientDomain& domain() const { return known_.domain(); }

    // One form for one argument, as far as that is easy: a sum of products of powers of bases that are
    // always taken with the same sign.
    ex argument(const ex& e) {
        const ex inner = (*this)(e).normal();
        return domain().expanded(with_split_powers(domain().expanded(inner)));
    }

    ex with_split_powers(const ex& e) const {
        if (is_a<GiNaC::add>(e)) {
            ex sum = 0;
            for (const ex& term : operands(e)) sum += with_split_powers(term);
            return sum;
        }
        if (is_a<GiNaC::mul>(e)) {
            ex product = 1;
            for (const ex& factor : operands(e)) product *= with_split_powers(factor);
            return product;
        }
        if (!is_a<GiNaC::power>(e) || e.op(1).info(GiNaC::info_flags::nonnegint)) return e;
        if (!is_rational_number(e.op(1)))
            refuse({"exponents are rational numbers", spell(e), "write exp(b*log(a)) for a^b", place_});
        const PowerProduct split = split_power(e.op(0), to_rational(e.op(1)), domain(), place_);
        ex product = to_ginac(split.number);
        for (const PowerFactor& f : split.factors) product *= GiNaC::pow(f.base, to_ginac(f.exponent));
        return product;
    }

    const FunctionAtom* find(Function function, const ex& u, const std::string& name = {},
                             int derivative = 0) const {
        const auto found =
            std::find_if(known_.atoms_.begin(), known_.atoms_.end(), [&](const FunctionAtom& a) {
                return a.function == function && a.argument.is_equal(u) && a.name == name &&
                       a.derivative == derivative;
            });
        return found == known_.atoms_.end() ? nullptr : &*found;
    }

    // The symbol of an atom; creates the atom if need be.
    ex atom(Function function, const ex& meaning, const ex& u, const std::string& name = {},
            int derivative = 0, std::size_t sine = 0) {
        if (const FunctionAtom* known = find(function, u, name, derivative)) return known->symbol;
        if (learner_ == nullptr) refuse_unlearned(meaning, derivative > 0);
        FunctionAtom made;
        made.function = function;
        made.symbol = GiNaC::symbol(spell(meaning));
        made.argument = u;
        made.sine = sine;
        made.name = name;
        made.derivative = derivative;
        made.place = place_;
        learner_->atoms_.push_back(made);
        learner_->domain_.add(made.symbol, meaning);
        return made.symbol;
    }

    ex named(const std::string& name, int derivative, const ex& u) {
        return atom(Function::named, named_function(name, derivative, domain().meaning(u)), u, name,
                    derivative);
    }

    // Atoms have arguments unit*part, where the unit is the largest of which all factors of this part are
    // multiples: cos(3*tau) by itself is an atom, and a polynomial in cos(tau) only beside functions of tau.
    std::pair<ex, int> whole_multiple(const std::string& family, const Multiple& m) {
        const std::string key = family + spell(m.part);
        const auto known = known_.units_.find(key);
        // Of numbers, cos(2) = 2*cos(1)^2 - 1: a negative atom would have no root. One such as cos(1.519) is
        // an atom by itself.
        const bool of_unit = m.part.is_equal(1) && cln::abs(cln::numerator(m.factor)) <= largest_multiple;
        const Rational first = of_unit ? Rational(1) / cln::denominator(m.factor) : cln::abs(m.factor);
        Rational unit = known == known_.units_.end() ? first : known->second;
        if (learner_ != nullptr) {
            const Rational common = common_measure(unit, m.factor);
            learner_->settled_ = learner_->settled_ && common == unit;
            learner_->units_[key] = unit = common;
        }
        const Rational count = m.factor / unit;
        if (cln::denominator(count) != 1)
            refuse_unlearned(domain().meaning(to_ginac(m.factor) * m.part), false);
        if (cln::abs(cln::numerator(count)) > largest_multiple)
            refuse(Reason::size,
                   {fmt::format("the arguments of one function are at most {} times a common part",
                                largest_multiple),
                    spell(domain().meaning(m.part)), "use simpler arguments", place_});
        return {m.part * to_ginac(unit), cln::cl_I_to_int(cln::numerator(count))};
    }

    ex exponential(const ex& u) {
        ex product = 1;
        for (const Multiple& m : multiples(u)) {
            if (const FunctionAtom* log = logarithm_atom(m.part)) { // exp(2 log x) = x^2
                product *= GiNaC::pow(log->argument, to_ginac(m.factor));
                continue;
            }
            const auto [part, count] = whole_multiple("exp ", m);
            product *=
                GiNaC::pow(atom(Function::exponential, GiNaC::exp(domain().meaning(part)), part), count);
        }
        return product;
    }

    const FunctionAtom* logarithm_atom(const ex& part) const {
        const auto found =
            std::find_if(known_.atoms_.begin(), known_.atoms_.end(), [&](const FunctionAtom& a) {
                return a.function == Function::logarithm && part.is_equal(a.symbol);
            });
        return found == known_.atoms_.end() ? nullptr : &*found;
    }

    // Multiples of asin(u) and atan(u) in a sum need no atoms: cos(asin(u)) = sqrt(1 - u^2).
    CosineSine angle_with_arcs(const ex& e) {
        ex rest = 0;
        CosineSine arcs{1, 0};
        for (const ex& term : is_a<GiNaC::add>(e) ? operands(e) : std::vector<ex>{e}) {
            const Multiple m = one_multiple(term);
            const std::optional<Function> f =
                is_a<GiNaC::function>(m.part) ? function_of(m.part) : std::nullopt;
            const bool is_arc = f == Function::arc_sine || f == Function::arc_tangent;
            if (is_arc && cln::denominator(m.factor) == 1 && cln::abs(m.factor) <= largest_multiple)
                arcs = sum_of(arcs, repeated(arc(*f, argument(m.part.op(0))), cln::numerator(m.factor)));
            else
                rest += term;
        }
        return sum_of(angle(argument(rest)), arcs);
    }

    CosineSine arc(Function f, const ex& u) {
        if (f == Function::arc_sine) {
            require_slope(f, u);
            return {argument(GiNaC::sqrt(1 - u * u)), u};
        }
        const ex cosine = argument(1 / GiNaC::sqrt(1 + u * u));
        return {cosine, argument(u * cosine)};
    }

    CosineSine repeated(const CosineSine& one, const Integer& count) const {
        CosineSine multiple{1, 0};
        for (Integer k = 0; k < cln::abs(count); k = k + 1) {
            multiple = sum_of(multiple, one);
            multiple = {domain().expanded(multiple.cosine), domain().expanded(multiple.sine)};
        }
        if (count < 0) multiple.sine = -multiple.sine;
        return multiple;
    }

    CosineSine angle(const ex& u) {
        CosineSine total{1, 0};
        for (const Multiple& m : multiples(u)) {
            if (m.part.is_equal(known_.pi_)) {
                total = sum_of(total, fraction_of_turn(m.factor));
                continue;
            }
            const auto [part, count] = whole_multiple("sin ", m);
            total = sum_of(total, repeated(circle(part), count));
        }
        return total;
    }

    // Fractions of pi whose sine and cosine are expressions in roots.
    [[nodiscard]] CosineSine fraction_of_turn(const Rational& factor) const {
        const ex angle = to_ginac(factor) * GiNaC::Pi;
        CosineSine turn{GiNaC::cos(angle), GiNaC::sin(angle)};
        if (has_function(turn.cosine) || has_function(turn.sine))
            refuse({"sines and cosines of multiples of pi are those of multiples of pi/12 and pi/10",
                    spell(GiNaC::sin(angle)), "write the angle, or its sine and cosine, as a parameter",
                    place_});
        return turn;
    }

    CosineSine circle(const ex& part) {
        const ex meaning = domain().meaning(part);
        const bool known = find(Function::cosine, part) != nullptr;
        const ex sine = atom(Function::sine, GiNaC::sin(meaning), part);
        const ex cosine = atom(Function::cosine, GiNaC::cos(meaning), part, {}, 0, known_.atoms_.size() - 1);
        if (!known && learner_ != nullptr) learner_->domain_.add_circle(sine, cosine);
        return {cosine, sine};
    }

    // The logarithm of a product of powers of positive bases.
    ex logarithm(const ex& u) {
        if (!domain().positive(u))
            refuse(Reason::undecided,
                   {"a logarithm is taken only of what is proved to be positive", spell(domain().meaning(u)),
                    how_to_make_positive(domain().meaning(u)), place_});
        const PowerProduct root = split_power(u, Rational(1) / 2, domain(), place_);
        ex sum = 2 * logarithm_of_number(root.number);
        for (const PowerFactor& f : root.factors) {
            const Rational exponent = 2 * f.exponent;
            sum +=
                to_ginac(exponent) * (is_a<GiNaC::numeric>(f.base) ? logarithm_of_number(to_rational(f.base))
                                                                   : logarithm_of_base(f.base));
        }
        return sum;
    }

    ex logarithm_of_base(const ex& base) {
        for (const FunctionAtom& a : known_.atoms_)
            if (a.function == Function::exponential && base.is_equal(a.symbol)) return a.argument;
        return atom(Function::logarithm, GiNaC::log(domain().meaning(base)), base);
    }

    ex logarithm_of_number(const Rational& value) {
        ex sum = 0;
        const auto add = [&](Integer rest, int sign) {
            for (Integer p = 2; rest > 1; p = p + 1) {
                if (p * p > rest) p = rest;
                if (p > 10000) p = rest; // perhaps not prime, which costs canonical forms only
                for (; cln::zerop(cln::mod(rest, p)); rest = cln::exquo(rest, p))
                    sum += sign * atom(Function::logarithm, GiNaC::log(to_ginac(Rational(p))),
                                       to_ginac(Rational(p)));
            }
        };
        add(cln::numerator(value), 1);
        add(cln::denominator(value), -1);
        return sum;
    }

    // f(u) as an atom; for an odd f the sign of the argument is normalised: f(-u) = -f(u).
    ex plain(Function f, const ex& u) {
        const bool odd = row_of(f).parity == Parity::odd;
        if (odd && u.is_zero()) return 0;
        require_slope(f, u);
        const bool turned = odd && !is_a<GiNaC::add>(u) && spell(u).front() == '-';
        const ex chosen = odd && is_a<GiNaC::add>(u) ? canonical_sign(u) : turned ? ex(-u) : u;
        const ex value = atom(f, call(f, domain().meaning(chosen)), chosen);
        return chosen.is_equal(u) ? value : -value;
    }

    // asin(u) = atan(u/sqrt(1 - u^2)) for -1 < u < 1
    ex arc_sine(const ex& u) {
        if (u.is_zero()) return 0;
        require_slope(Function::arc_sine, u);
        const ex square = domain().expanded(asked_of(u, Function::arc_sine));
        return plain(Function::arc_tangent, argument(u * GiNaC::pow(square, GiNaC::numeric(-1, 2))));
    }

    void require_slope(Function f, const ex& u) const {
        const ex asked = domain().expanded(asked_of(u, f));
        if (asked.is_equal(1) || domain().positive(asked)) return;
        const bool above = row_of(f).argument == Argument::at_least_one;
        refuse(Reason::undecided,
               {fmt::format("{} is taken only of what is proved to {}",
                            f == Function::arc_sine ? "an arcsine or arccosine" : row_of(f).name,
                            above ? "be greater than 1" : "lie between -1 and 1"),
                spell(domain().meaning(u)), how_to_make_positive(domain().meaning(asked)), place_});
    }

    const FunctionAtoms& known_;
    FunctionAtoms* learner_; // null: nothing is learned
    const Place& place_;
};

FunctionAtoms::FunctionAtoms(std::shared_ptr<const System> system, int derivatives, InverseOfNumber inverse)
    : system_(std::move(system)), derivatives_(derivatives), inverse_(std::move(inverse)),
      domain_(new_domain()) {}

CoefficientDomain FunctionAtoms::new_domain() const {
    CoefficientDomain domain(*system_, inverse_);
    domain.add(pi_, GiNaC::Pi);
    return domain;
}

void FunctionAtoms::learn(const ex& e, const Place& place) {
    if (has_atom(e)) FunctionRewriter(*this, this, place)(e);
}

bool FunctionAtoms::forget_unless_settled() {
    if (settled_) return true;
    settled_ = true;
    atoms_.clear();
    domain_ = new_domain();
    return false;
}

ex FunctionAtoms::rewrite(const ex& e, const Place& place) const {
    return has_atom(e) ? FunctionRewriter(*this, nullptr, place)(e) : e;
}

} // namespace resonform
