// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/signs/polynomial_signs.hpp"
#include "model/signs/atoms.hpp"
#include "model/signs/polynomial_quotients.hpp"
#include "model/signs/sign_prover.hpp"
#include "model/text/growth.hpp"
#include "model/text/named_function.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace resonform {

namespace {

using GiNaC::ex;

constexpr double most_uncollected = 20000; // before they are collected, by an upper bound
constexpr double highest_power = 24;
constexpr std::size_t most_angles = 4;

bool is_moderate(const ex& e) {
    const Growth growth = of_expression(e);
    return growth.terms <= most_uncollected && growth.degree <= highest_power;
}

// Empty: the conditions contradict each other.
SignSet signs_in(const Atoms& atoms, const ex& asked, const std::vector<ex>& declared) {
    const std::vector<GiNaC::symbol> symbols = atoms.symbols();
    const PolynomialContext context(symbols.size() + 1);
    std::vector<PowerRelation> relations;
    const auto packed = [&](const ex& e) {
        PackedQuotient q = packed_quotient(e, symbols, relations, context);
        if (q.below.is_zero()) throw NoQuotient{};
        return q;
    };
    std::vector<PolynomialSigns::SquareRoot> roots;
    for (const auto& [root, square] : atoms.roots()) {
        auto [above, below] = packed(square);
        if (below.is_one()) relations.push_back({root, 2, square});
        const auto at = std::find(symbols.begin(), symbols.end(), root);
        roots.push_back({at - symbols.begin(), std::move(above), std::move(below)});
    }
    const auto of_equal_sign = [&](const ex& e) {
        const PackedQuotient q = packed(e);
        return q.above * q.below;
    };
    std::vector<Packed> positive;
    for (const ex& condition : atoms.positive()) positive.push_back(of_equal_sign(condition));
    for (const ex& d : declared) {
        try {
            positive.push_back(of_equal_sign(atoms.rational(d)));
        } catch (const NoQuotient&) { // too large: proofs do without it
        }
    }
    return PolynomialSigns(positive, roots).of(of_equal_sign(atoms.rational(asked)));
}

} // namespace

// The sign at odd multiples of pi, which have no tangent of their half, is that nearby if it is not zero.
SignSet SignProver::in_atoms(const ex& e) const {
    const bool structure_tells_all = !GiNaC::is_a<GiNaC::add>(e) && system_.positive.empty();
    if (structure_tells_all || !is_moderate(e)) return SignSet::all();
    const auto own = [&](const ex& key) {
        if (GiNaC::is_a<GiNaC::symbol>(key) || is_named(key)) return declared(key);
        return GiNaC::is_a<GiNaC::function>(key) ? by_structure(key) : signs(key);
    };
    const auto of_declarations = [&](const ex& key) { return declared(key); };
    Atoms atoms;
    if (!atoms.collect(e, own)) return SignSet::all();
    std::vector<ex> declarations;
    for (const Declaration& d : system_.positive)
        if (is_moderate(d.value) && atoms.collect(d.value, of_declarations)) declarations.push_back(d.value);
    if (atoms.angles() > most_angles) return SignSet::all();
    SignSet signs = SignSet::all();
    try {
        signs = signs_in(atoms, e, declarations);
        for (std::size_t set = 1; set >> atoms.angles() == 0 && !signs.zero; ++set) {
            atoms.set_odd_multiples_of_pi(set);
            signs.zero = signs_in(atoms, e, declarations).zero;
        }
        return signs;
    } catch (const NoQuotient&) {
        return SignSet::all();
    }
}

} // namespace resonform
