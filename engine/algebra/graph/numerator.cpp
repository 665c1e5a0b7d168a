// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/graph/numerator.hpp"

#include <algorithm>
#include <stdexcept>

namespace resonform {

std::vector<Residue> NumeratorValues::at(const std::vector<std::vector<Residue>>& points,
                                         const DivisorPowers& denominator) {
    constexpr std::size_t block = ModularReplay::block;
    std::vector<Residue> result;
    std::vector<ModularReplay::Block> leaves(replay_->leaves().size());
    for (std::size_t begin = 0; begin < points.size(); begin += block) {
        const std::size_t count = std::min(block, points.size() - begin);
        for (std::size_t k = 0; k < leaves.size(); ++k)
            for (std::size_t b = 0; b < block; ++b) leaves[k][b] = points[begin + std::min(b, count - 1)][k];
        auto values = modular_.evaluate(leaves);
        if (!values) throw std::domain_error("NumeratorValues: a divisor is zero at a random point");
        for (const auto& [divisor, exponent] : denominator) multiply(values->front(), divisor, exponent);
        result.insert(result.end(), values->front().begin(),
                      values->front().begin() + static_cast<std::ptrdiff_t>(count));
    }
    return result;
}

// The product of a plain residue and one in Montgomery's form is plain.
void NumeratorValues::multiply(ModularReplay::Block& values, std::size_t divisor, int exponent) const {
    const auto found = std::find_if(replay_->inverses().begin(), replay_->inverses().end(),
                                    [&](const auto& inverse) { return inverse.second == divisor; });
    const GraphReplay::Step& step = replay_->steps()[found->first];
    const ModularReplay::Block& base = modular_.value(step.index);
    const Montgomery& form = modular_.form();
    for (std::size_t b = 0; b < values.size(); ++b) {
        Residue power = base[b];
        for (int rest = exponent; rest != 0; rest /= 2) {
            if (rest % 2 != 0) values[b] = form.multiply(power, values[b]);
            power = form.multiply(power, power);
        }
        if (step.minus && exponent % 2 != 0) values[b] = form.negate(values[b]);
    }
}

Residue evaluate(const LeafPolynomial& p, const PrimeField& field, const std::vector<LeafId>& leaves,
                 const std::vector<Residue>& point) {
    Residue total = 0;
    for (const auto& [powers, coefficient] : p.terms()) {
        const auto number = field.from(coefficient);
        if (!number) throw std::domain_error("evaluate: the prime divides a denominator");
        Residue product = *number;
        for (const auto& [leaf, exponent] : powers) {
            const auto place = std::lower_bound(leaves.begin(), leaves.end(), leaf) - leaves.begin();
            product = field.multiply(product, field.power(point[static_cast<std::size_t>(place)], exponent));
        }
        total = field.add(total, product);
    }
    return total;
}

} // namespace resonform
