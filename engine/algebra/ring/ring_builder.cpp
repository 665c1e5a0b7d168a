// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/error.hpp"
#include "algebra/ring/choose_relation.hpp"
#include "algebra/ring/polynomial.hpp"
#include "algebra/ring/products.hpp"
#include "algebra/ring/ring.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace resonform {
namespace {

Polynomial repack(const Packing& from, const Packing& to, const Polynomial& p) {
    std::vector<Term> terms;
    for (const Term& t : p.terms()) {
        // Fields past the generators of the smaller ring are empty.
        std::vector<int> exponents = from.unpack(t.monomial, from.fields());
        while (!exponents.empty() && exponents.back() == 0) exponents.pop_back();
        terms.push_back({to.pack(exponents), t.coefficient});
    }
    return Polynomial::from_terms(std::move(terms));
}

[[noreturn]] void refuse_generator(const std::string& rule, const std::string& name) {
    refuse({.rule = rule, .value = name, .hint = "choose another name or another form", .place = {}});
}

// The kinds of generators that stand in p, and whether one stands in a denominator.
struct Contents {
    bool of_coefficients = true; // parameters, slow variables, roots, functions
    bool fractions = false;
};

Contents contents(const Packing& packing, const std::vector<Generator>& earlier, const Polynomial& p) {
    Contents result;
    for (const Term& t : p.terms()) {
        for (int id = 0; id < packing.fields(); ++id) {
            const int e = packing.exponent(t.monomial, id);
            if (e == 0) continue;
            const bool known = static_cast<std::size_t>(id) < earlier.size();
            const GeneratorKind kind =
                known ? earlier[static_cast<std::size_t>(id)].kind : GeneratorKind::imaginary;
            const bool allowed = kind == GeneratorKind::parameter || kind == GeneratorKind::slow ||
                                 kind == GeneratorKind::root || kind == GeneratorKind::function;
            result.of_coefficients = result.of_coefficients && allowed;
            result.fractions = result.fractions || e < 0;
        }
    }
    return result;
}

void check_radicand(const Packing& packing, const std::vector<Generator>& earlier, const Generator& root) {
    if (root.index < 1) refuse_generator("the index of a root is at least 1", root.name);
    if (root.radicand.empty()) refuse_generator("a root is not taken of zero", root.name);
    const Contents of_radicand = contents(packing, earlier, root.radicand);
    if (!of_radicand.of_coefficients || of_radicand.fractions)
        refuse_generator("a root is taken of a polynomial in parameters, slow variables, functions and "
                         "earlier roots",
                         root.name);
}

void check_argument(const Packing& packing, const std::vector<Generator>& earlier, const Generator& g) {
    if (!contents(packing, earlier, g.of.argument).of_coefficients)
        refuse_generator("the argument of a function holds parameters, slow variables and earlier roots "
                         "and functions",
                         g.name);
    if (g.of.function != Function::cosine) return;
    const bool known = g.of.sine > 0 && static_cast<std::size_t>(g.of.sine) < earlier.size();
    const FunctionOf& sine = earlier[known ? static_cast<std::size_t>(g.of.sine) : 0].of;
    if (!known || sine.function != Function::sine || !(sine.argument == g.of.argument))
        refuse_generator("a cosine is added after the sine of the same argument", g.name);
}

} // namespace

RingBuilder::RingBuilder(int most) : packing_(std::min(most, Packing::most_fields)) {
    Generator i;
    i.kind = GeneratorKind::imaginary;
    i.name = "I";
    i.invertible = true;
    generators_.push_back(i);
}

GeneratorId RingBuilder::add(Generator g) {
    if (g.name.empty() || id(g.name) >= 0) refuse_generator("the name of a generator is its own", g.name);
    if (generators_.size() >= static_cast<std::size_t>(packing_.fields())) {
        refuse(Reason::size,
               {.rule = "a system has at most 32 of these together: i, eps, parameters, slow variables, two "
                        "modes for each oscillator, roots that occur; constants and integrals of a solution",
                .value = g.name + " would be one more",
                .hint =
                    std::any_of(generators_.begin(), generators_.end(),
                                [](const Generator& known) { return known.kind == GeneratorKind::parameter; })
                        ? "write numbers in the place of some parameters"
                        : "use fewer variables and roots",
                .place = {}});
    }
    if (g.kind == GeneratorKind::root) {
        check_radicand(packing_, generators_, g);
        g.positive = g.positive || g.index > 1;
        g.invertible = true;
    }
    if (g.kind == GeneratorKind::function) {
        check_argument(packing_, generators_, g);
        g.positive = g.positive || g.of.function == Function::exponential;
    }
    if (g.kind == GeneratorKind::phase || g.positive) g.invertible = true;
    generators_.push_back(std::move(g));
    return static_cast<GeneratorId>(generators_.size()) - 1;
}

GeneratorId RingBuilder::id(const std::string& name) const {
    for (std::size_t k = 0; k < generators_.size(); ++k) {
        if (generators_[k].name == name) return static_cast<GeneratorId>(k);
    }
    return -1;
}

Polynomial RingBuilder::gen(GeneratorId id, int exponent) const {
    return Polynomial(packing_.power(id, exponent), Rational(1));
}

Polynomial RingBuilder::multiply(const Polynomial& a, const Polynomial& b) const {
    return plain_product(packing_, a, b);
}

Polynomial RingBuilder::import(const Ring& from, const Polynomial& p) const {
    std::vector<Term> terms;
    for (const Term& t : p.terms()) {
        Monomial m;
        for (GeneratorId g = 0; g < from.size(); ++g) {
            const int e = from.exponent(t.monomial, g);
            if (e == 0) continue;
            const GeneratorId here = id(from.generator(g).name);
            if (here < 0)
                refuse_generator("a polynomial uses generators of its ring", from.generator(g).name);
            m = m + packing_.power(here, e);
        }
        terms.push_back({m, t.coefficient});
    }
    return Polynomial::from_terms(std::move(terms));
}

void RingBuilder::set_slope(GeneratorId id, const Ring& frozen, const Polynomial& slope) {
    generators_[static_cast<std::size_t>(id)].of.slope = import(frozen, slope);
}

RingPtr RingBuilder::freeze() const {
    const int size = static_cast<int>(generators_.size());
    const std::shared_ptr<Ring> ring(new Ring(size));
    ring->generators_ = generators_;
    ring->digits_ = digits_;
    for (Generator& g : ring->generators_) {
        g.radicand = repack(packing_, ring->packing_, g.radicand);
        g.of.argument = repack(packing_, ring->packing_, g.of.argument);
        if (g.of.slope) g.of.slope = repack(packing_, ring->packing_, *g.of.slope);
        for (auto& entry : g.derivatives) entry.second = repack(packing_, ring->packing_, entry.second);
        const bool pair = g.kind == GeneratorKind::fast && g.conjugate >= 0;
        if (pair &&
            (g.conjugate >= size || generators_[static_cast<std::size_t>(g.conjugate)].kind != g.kind)) {
            refuse_generator("the conjugate of a fast variable is a fast variable", g.name);
        }
    }
    Relation i_squared;
    i_squared.lead = Ring::imaginary_unit;
    i_squared.degree = 2;
    i_squared.value = Polynomial(Rational(-1));
    i_squared.total = true;
    ring->relations_.push_back(i_squared);

    // Radicands of one term first: the others no longer hold the generators that these eliminate.
    for (const bool several_terms : {false, true}) {
        for (GeneratorId id = 0; id < size; ++id) {
            if (ring->generator(id).kind != GeneratorKind::root) continue;
            if ((ring->generator(id).radicand.size() > 1) != several_terms) continue;
            std::optional<Relation> relation = choose_relation(*ring, ring->relations_, id);
            ring->related_ = ring->related_ && relation.has_value();
            if (relation) ring->relations_.push_back(std::move(*relation));
        }
    }
    for (GeneratorId id = 0; id < size; ++id) {
        const Generator& g = ring->generator(id);
        if (g.kind == GeneratorKind::function && g.of.function == Function::cosine) ring->relate_circle(id);
    }
    for (GeneratorId id = 0; id < size; ++id) ring->derive(id);
    return ring;
}

} // namespace resonform
