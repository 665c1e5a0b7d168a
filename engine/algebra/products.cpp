// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/products.hpp"

#include "algebra/accumulator.hpp"

#include <cstddef>

namespace resonform {
namespace {

// Below this number of products, rationals are multiplied as they are.
constexpr std::size_t few_products = 8;

Integer common_denominator(const Polynomial& p) {
    Integer common = 1;
    for (const Term& t : p.terms()) common = cln::lcm(common, cln::denominator(t.coefficient));
    return common;
}

std::vector<Term> scaled(const Polynomial& p, const Integer& factor) {
    std::vector<Term> terms = p.terms();
    for (Term& t : terms) t.coefficient = t.coefficient * factor;
    return terms;
}

void multiply_into(Accumulator& sum, const std::vector<Term>& a, const std::vector<Term>& b) {
    for (const Term& s : a) {
        for (const Term& t : b) sum.add(s.monomial + t.monomial, s.coefficient * t.coefficient);
    }
}

// sum_k (a_k D/B_k) (b_k B_k) / D with B_k the common denominator of b_k and D that of all products:
// the inner loop multiplies and adds integers, and fractions are cancelled once for each result.
std::vector<Term> over_common_denominator(const Pairs& pairs) {
    std::vector<Integer> right;
    Integer common = 1;
    for (const auto& pair : pairs) {
        right.push_back(common_denominator(*pair.second));
        common = cln::lcm(common, common_denominator(*pair.first) * right.back());
    }
    Accumulator sum;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        multiply_into(sum, scaled(*pairs[k].first, cln::exquo(common, right[k])),
                      scaled(*pairs[k].second, right[k]));
    }
    std::vector<Term> terms = sum.take();
    if (common == 1) return terms;
    for (Term& t : terms) t.coefficient = t.coefficient / common;
    return terms;
}

} // namespace

std::vector<Term> collect_products(const Packing& packing, const Pairs& pairs) {
    std::size_t products = 0;
    for (const auto& pair : pairs) {
        for (const Term& t : pair.first->terms()) packing.require_safe(t.monomial);
        for (const Term& t : pair.second->terms()) packing.require_safe(t.monomial);
        products += pair.first->size() * pair.second->size();
    }
    if (products > few_products) return over_common_denominator(pairs);
    Accumulator sum;
    for (const auto& pair : pairs) multiply_into(sum, pair.first->terms(), pair.second->terms());
    return sum.take();
}

} // namespace resonform
