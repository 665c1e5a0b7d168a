// SPDX-License-Identifier: GPL-3.0-or-later
// Functions of weight 0 in the equations of the file, by the generators of the ring: each argument is
// written as a sum of rational multiples of the generators' arguments. Angles are added as powers of
// c + i s, not by the formulas of the expansion.
#include "certify/as_written.hpp"
#include "certify/roots.hpp"
#include "model/text/canonical.hpp"
#include "model/text/function_call.hpp"
#include "model/text/named_function.hpp"

#include <algorithm>
#include <utility>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::is_a;

std::optional<Rational> ratio(const ex& a, const ex& b) {
    const ex quotient = (a / b).normal();
    if (!is_a<GiNaC::numeric>(quotient) || !GiNaC::ex_to<GiNaC::numeric>(quotient).is_rational())
        return std::nullopt;
    return to_rational(quotient);
}

// b = factor * a for a whole factor
std::optional<int> multiple(const ex& b, const ex& a) {
    const std::optional<Rational> factor = ratio(b, a);
    if (!factor || cln::denominator(*factor) != 1) return std::nullopt;
    return cln::cl_I_to_int(cln::numerator(*factor));
}

// The first asin or atan among the factors of a term; 0: none.
ex find_arc(const ex& term) {
    for (const ex& factor : factors_of(term))
        if (is_a<GiNaC::function>(factor))
            if (const auto f = function_of(factor); f == Function::arc_sine || f == Function::arc_tangent)
                return factor;
    return 0;
}

} // namespace

void CertificateRoots::refuse_function(const ex& function, const Equation& equation) const {
    refuse_part("every function of slow variables and parameters is one of the ring's generators", function,
                equation);
}

// nullptr: the ring does not hold it.
const CertificateRoots::FunctionAtom* CertificateRoots::find_named(const ex& e, const Equation& equation) {
    const NamedCall call = named_call(e);
    const ex u = lowered(with_symbols(e.op(0), equation).normal());
    const auto found = std::find_if(functions_.begin(), functions_.end(), [&](const FunctionAtom& f) {
        return f.of.function == Function::named && f.of.symbol == call.name &&
               f.of.derivative == call.derivative && (f.argument - u).normal().is_zero();
    });
    return found == functions_.end() ? nullptr : &*found;
}

bool CertificateRoots::knows(const ex& named, const Equation& equation) {
    return find_named(named.subs(origin_, GiNaC::subs_options::no_pattern), equation) != nullptr;
}

const CertificateRoots::FunctionAtom& CertificateRoots::atom(GeneratorId id) const {
    return *std::find_if(functions_.begin(), functions_.end(),
                         [id](const FunctionAtom& f) { return f.id == id; });
}

ex CertificateRoots::argument_of(GeneratorId function) const {
    return atom(function).argument.subs(meanings_, GiNaC::subs_options::no_pattern);
}

// Expanded, with s^2 = 1 - c^2.
ex CertificateRoots::lowered(const ex& e) const {
    ex result = e;
    for (const FunctionAtom& f : functions_) {
        if (f.of.function != Function::cosine || !result.has(atom(f.of.sine).symbol)) continue;
        const ex& sine = atom(f.of.sine).symbol;
        const ex fraction = result.normal().numer_denom();
        const ex circle = 1 - GiNaC::pow(f.symbol, 2);
        const auto lower = [&](const ex& part) {
            return part.expand().subs(GiNaC::pow(sine, 2) == circle, GiNaC::subs_options::algebraic).expand();
        };
        result = lower(fraction.op(0)) / lower(fraction.op(1));
    }
    return result.expand();
}

ex CertificateRoots::function_with_symbols(const ex& e, const Equation& equation) {
    if (is_named(e)) {
        if (const FunctionAtom* f = find_named(e, equation)) return f->symbol;
        refuse_function(e, equation);
    }
    const Function name = elementary_of(e, equation);
    if (name == Function::sine) return circular(e.op(0), false, equation);
    if (name == Function::cosine) return circular(e.op(0), true, equation);
    if (name == Function::tangent)
        return circular(e.op(0), false, equation) / circular(e.op(0), true, equation);
    const ex u = lowered(with_symbols(e.op(0), equation).normal());
    const auto half_sum = [&](int sign) {
        const ex up = exponential(u, equation);
        return ex((up + sign / up) / 2);
    };
    switch (name) {
    case Function::exponential: return exponential(u, equation);
    case Function::hyperbolic_sine: return half_sum(-1);
    case Function::hyperbolic_cosine: return half_sum(1);
    case Function::hyperbolic_tangent: return half_sum(-1) / half_sum(1);
    case Function::logarithm: return logarithm(u, equation);
    case Function::arc_sine: break;
    default: return plain(name, u, equation);
    }
    if (u.is_zero()) return 0;
    const ex cosine = radical_with_symbols((1 - u * u).expand(), Rational(1) / 2, equation);
    return plain(Function::arc_tangent, lowered((u / cosine).normal()), equation);
}

// With radicands in place of whole powers of their roots.
ex CertificateRoots::without_whole_powers(const ex& e) const {
    ex result = e.normal();
    for (const Root& root : roots_) {
        if (!result.has(root.symbol)) continue;
        const ex fraction = result.numer_denom();
        const auto lower = [&](const ex& part) {
            return part.expand()
                .subs(GiNaC::pow(root.symbol, root.index) == root.radicand, GiNaC::subs_options::algebraic)
                .expand();
        };
        result = (lower(fraction.op(0)) / lower(fraction.op(1))).normal();
    }
    return result;
}

// f(u) by the generator of the same function with the argument u or, if f is odd, -u.
ex CertificateRoots::plain(Function name, const ex& u, const Equation& equation) const {
    const bool odd = row_of(name).parity == Parity::odd;
    if (odd && u.is_zero()) return 0;
    for (const FunctionAtom& f : functions_) {
        if (f.of.function != name) continue;
        const ex sign = without_whole_powers(u / f.argument);
        if (sign.is_equal(1) || (odd && sign.is_equal(-1))) return sign * f.symbol;
    }
    refuse_function(call(name, u), equation);
}

ex CertificateRoots::exponential(const ex& u, const Equation& equation) {
    ex product = 1;
    for (const ex& term : terms_of(u)) {
        if (term.is_zero()) continue;
        const auto factor = [&]() -> ex {
            for (const FunctionAtom& f : functions_) {
                if (f.of.function == Function::exponential)
                    if (const auto n = multiple(term, f.argument)) return GiNaC::pow(f.symbol, *n);
                if (f.of.function == Function::logarithm) // exp(q log x) = x^q
                    if (const auto q = ratio(term, f.symbol))
                        return cln::denominator(*q) == 1 ? ex(GiNaC::pow(f.argument, GiNaC::numeric(*q)))
                                                         : radical_with_symbols(f.argument, *q, equation);
            }
            refuse_function(GiNaC::exp(term), equation);
        };
        product *= factor();
    }
    return product;
}

// Cosine and sine of asin(u) or atan(u).
std::pair<ex, ex> CertificateRoots::of_arc(Function name, const ex& argument, const Equation& equation) {
    const ex u = lowered(with_symbols(argument, equation).normal());
    const auto root = [&](int sign) {
        return radical_with_symbols((1 + sign * u * u).expand(), Rational(1) / 2, equation);
    };
    if (name == Function::arc_sine) return {root(-1), u};
    const ex hypotenuse = root(1);
    return {1 / hypotenuse, u / hypotenuse};
}

// The cosine of a sum of angles n_k a_k is (p + 1/p)/2 for p = prod (c_k + i s_k)^n_k.
ex CertificateRoots::circular(const ex& argument, bool cosine, const Equation& equation) {
    ex turned = 1, back = 1, others = 0;
    for (const ex& term : terms_of(argument)) {
        const ex arc = find_arc(term);
        const auto n = arc.is_zero() ? std::nullopt : multiple(term, arc);
        if (!n) {
            others += term;
            continue;
        }
        const auto [c, s] = of_arc(elementary_of(arc, equation), arc.op(0), equation);
        const ex direction = GiNaC::I * (*n < 0 ? -1 : 1) * s;
        turned *= GiNaC::pow(c + direction, std::abs(*n));
        back *= GiNaC::pow(c - direction, std::abs(*n));
    }
    for (const ex& term : terms_of(lowered(with_symbols(others, equation).normal()))) {
        if (term.is_zero()) continue;
        bool found = false;
        if (const auto q = ratio(term, pi_)) { // with roots for values
            const ex angle = GiNaC::numeric(*q) * GiNaC::Pi;
            const ex c = with_symbols(GiNaC::cos(angle), equation),
                     s = with_symbols(GiNaC::sin(angle), equation);
            turned *= c + GiNaC::I * s;
            back *= c - GiNaC::I * s;
            continue;
        }
        for (const FunctionAtom& f : functions_) {
            if (found || f.of.function != Function::cosine) continue;
            const auto n = multiple(term, f.argument);
            if (!n) continue;
            found = true;
            const ex direction = GiNaC::I * (*n < 0 ? -1 : 1) * atom(f.of.sine).symbol;
            turned *= GiNaC::pow(f.symbol + direction, std::abs(*n));
            back *= GiNaC::pow(f.symbol - direction, std::abs(*n));
        }
        if (!found) refuse_function(GiNaC::sin(term), equation);
    }
    const ex sum = cosine ? turned + back : (turned - back) / GiNaC::I;
    return (sum.expand() / 2).expand();
}

// u is a product of powers of the arguments of logarithms, of exponentials, of roots and of numbers.
ex CertificateRoots::logarithm(const ex& u, const Equation& equation) const {
    auto [above, below] = rationalised(without_whole_powers(u));
    above = above.expand();
    ex sum = logarithm_of_factors(above) - logarithm_of_factors(below);
    if (!above.is_equal(below)) refuse_function(GiNaC::log(u), equation);
    return sum;
}

// Takes out of `rest` the factors whose logarithms are known; returns the sum of these logarithms.
ex CertificateRoots::logarithm_of_factors(ex& rest) const {
    ex sum = 0;
    const auto take_powers = [&](const ex& symbol, const ex& logarithm) {
        const int power = rest.ldegree(symbol);
        if (power == 0) return;
        rest = (rest / GiNaC::pow(symbol, power)).expand();
        sum += power * logarithm;
    };
    for (const Root& root : roots_) {
        if (!root.positive || !rest.has(root.symbol)) continue;
        ex radicand = root.radicand;
        const ex logarithm = logarithm_of_factors(radicand);
        if (radicand.is_equal(1)) take_powers(root.symbol, logarithm / root.index);
    }
    for (const FunctionAtom& f : functions_) {
        if (f.of.function == Function::exponential) take_powers(f.symbol, f.argument);
        ex quotient;
        if (f.of.function != Function::logarithm || is_a<GiNaC::numeric>(f.argument)) continue;
        while (!is_a<GiNaC::numeric>(rest) && GiNaC::divide(rest, f.argument, quotient)) {
            rest = quotient.expand();
            sum += f.symbol;
        }
    }
    return is_a<GiNaC::numeric>(rest) ? ex(sum + logarithm_of_number(rest)) : sum;
}

// The same for a rational number, with the numbers of which the ring has logarithms.
ex CertificateRoots::logarithm_of_number(ex& rest) const {
    ex sum = 0, above = rest.numer(), below = rest.denom();
    for (const FunctionAtom& f : functions_) {
        if (f.of.function != Function::logarithm || !is_a<GiNaC::numeric>(f.argument)) continue;
        const auto take = [&](ex& part, int sign) {
            while (!part.is_zero() && GiNaC::irem(GiNaC::ex_to<GiNaC::numeric>(part),
                                                  GiNaC::ex_to<GiNaC::numeric>(f.argument)) == 0) {
                part /= f.argument;
                sum += sign * f.symbol;
            }
        };
        take(above, 1);
        take(below, -1);
    }
    rest = above / below;
    return sum;
}

} // namespace resonform
