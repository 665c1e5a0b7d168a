// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/certificate_lie.hpp"

#include <algorithm>

namespace resonform {

namespace {

bool is_zero(const PointAlgebra::Value& v) {
    return std::all_of(v.begin(), v.end(), [](Residue r) { return r == 0; });
}

} // namespace

FlowAtPoint::FlowAtPoint(const PointAlgebra& algebra, const Ring& ring, const HamiltonianForm& form,
                         int orders)
    : algebra_(algebra), form_(form) {
    for (const HamiltonianForm::Bracket& b : form.brackets)
        for (const GeneratorId id : {b.left, b.right}) y_[id] = {algebra_.generator(id, 1)};
    read(ring, form.generator);
    for (std::size_t k = 0; k < static_cast<std::size_t>(orders); ++k) {
        const std::map<GeneratorId, TauSeries> rates = velocity(k);
        const Value factor = algebra_.number(Rational(1) / Rational(static_cast<int>(k) + 1));
        for (auto& [id, y] : y_) y.push_back(algebra_.multiply(factor, rates.at(id)[k]));
    }
}

FlowAtPoint::Value FlowAtPoint::at_one(GeneratorId coordinate) const {
    Value sum = algebra_.number(0);
    for (const Value& part : y_.at(coordinate)) sum = algebra_.add(sum, part);
    return sum;
}

void FlowAtPoint::read(const Ring& ring, const Series& generator) {
    for (int n = 0; n <= generator.through(); ++n)
        for (const auto& [monomial, coefficient] : generator.part(n).terms()) {
            Term term{algebra_.number(coefficient), {}};
            for (GeneratorId id = 0; id < ring.size(); ++id) {
                const int e = ring.exponent(monomial, id);
                if (e == 0) continue;
                if (y_.count(id) != 0)
                    term.powers.emplace_back(id, e);
                else
                    term.coefficient = algebra_.multiply(term.coefficient, algebra_.generator(id, e));
            }
            terms_.push_back(std::move(term));
        }
}

std::map<GeneratorId, FlowAtPoint::TauSeries> FlowAtPoint::velocity(std::size_t k) const {
    std::map<GeneratorId, std::vector<TauSeries>> powers; // 1, y, y^2, ... as far as they are asked for
    const auto power = [&](GeneratorId id, int e) -> const TauSeries& {
        std::vector<TauSeries>& known = powers[id];
        if (known.empty()) {
            known.push_back({algebra_.number(1)});
            known.front().resize(k + 1, algebra_.number(0));
        }
        while (known.size() <= static_cast<std::size_t>(e))
            known.push_back(multiply(known.back(), y_.at(id)));
        return known[static_cast<std::size_t>(e)];
    };
    std::map<GeneratorId, TauSeries> slopes; // d chi/dy_a
    const TauSeries zero(k + 1, algebra_.number(0));
    for (const auto& [id, y] : y_) slopes[id] = zero;
    for (const Term& term : terms_)
        for (std::size_t by = 0; by < term.powers.size(); ++by) {
            TauSeries product =
                scaled(power(term.powers[by].first, term.powers[by].second - 1),
                       algebra_.multiply(algebra_.number(term.powers[by].second), term.coefficient));
            for (std::size_t other = 0; other < term.powers.size(); ++other)
                if (other != by)
                    product = multiply(product, power(term.powers[other].first, term.powers[other].second));
            add(slopes[term.powers[by].first], product);
        }
    std::map<GeneratorId, TauSeries> rates;
    for (const HamiltonianForm::Bracket& b : form_.brackets) {
        const Value value = algebra_.gradient(Series({b.value}), Side::itself).value;
        rates[b.left] = scaled(slopes.at(b.right), value);
        rates[b.right] = scaled(slopes.at(b.left), algebra_.multiply(algebra_.number(-1), value));
    }
    return rates;
}

FlowAtPoint::TauSeries FlowAtPoint::multiply(const TauSeries& a, const TauSeries& b) const {
    TauSeries product(a.size(), algebra_.number(0));
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (is_zero(a[i])) continue;
        for (std::size_t j = 0; i + j < a.size() && j < b.size(); ++j)
            product[i + j] = algebra_.add(product[i + j], algebra_.multiply(a[i], b[j]));
    }
    return product;
}

void FlowAtPoint::add(TauSeries& sum, const TauSeries& addend) const {
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] = algebra_.add(sum[k], addend[k]);
}

FlowAtPoint::TauSeries FlowAtPoint::scaled(const TauSeries& a, const Value& factor) const {
    TauSeries result;
    for (const Value& part : a) result.push_back(algebra_.multiply(factor, part));
    return result;
}

} // namespace resonform
