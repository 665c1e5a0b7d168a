// SPDX-License-Identifier: GPL-3.0-or-later
// Multiples of e^u - 1 in sums of products: where u is small, a sum of powers of e^u loses their digits.
#include "emit/graph/lower.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace resonform {

namespace {

constexpr int most_powers = 64; // of e^u in a quotient

struct Power {
    int exponent; // of e^u
    Rational coefficient;
};

// (c_m e^mu + ... + c_n e^nu)/(e^u - 1) = b_m e^mu + ... + b_{n-1} e^(n-1)u,  b_j = -(c_m + ... + c_j), if
// the sum of all c is 0; ascending, without zeros.
std::vector<Power> divided_by_less_one(const std::vector<Power>& sum) {
    std::vector<Power> quotient;
    if (sum.back().exponent - sum.front().exponent > most_powers) return quotient;
    Rational b = 0;
    auto next = sum.begin();
    for (int j = sum.front().exponent; j < sum.back().exponent; ++j) {
        for (; next->exponent == j; ++next) b = b - next->coefficient;
        if (b != 0) quotient.push_back({j, b});
    }
    for (; next != sum.end(); ++next) b = b - next->coefficient;
    if (b != 0) quotient.clear();
    return quotient;
}

} // namespace

std::optional<Lowering::Divided> Lowering::without_exponential(Terms& terms) const {
    for (std::size_t id = 0; id < nodes_.size(); ++id) {
        if (!is_exponential(id)) continue;
        std::map<std::vector<int>, std::vector<Power>> sums; // by the powers of all others
        for (std::size_t k = 0; k < terms.coefficients.size(); ++k) {
            std::vector<int> others(terms.row(k), terms.row(k) + terms.width);
            const int exponent = std::exchange(others[id], 0);
            sums[std::move(others)].push_back({exponent, terms.coefficients[k]});
        }
        Terms rest, quotient;
        rest.width = quotient.width = terms.width;
        const auto append = [&](Terms& to, std::vector<int> row, const std::vector<Power>& powers) {
            for (const Power& p : powers) {
                row[id] = p.exponent;
                to.exponents.insert(to.exponents.end(), row.begin(), row.end());
                to.coefficients.push_back(p.coefficient);
            }
        };
        for (auto& [others, sum] : sums) {
            std::sort(sum.begin(), sum.end(),
                      [](const Power& a, const Power& b) { return a.exponent < b.exponent; });
            const std::vector<Power> divided = divided_by_less_one(sum);
            append(divided.empty() ? rest : quotient, others, divided.empty() ? sum : divided);
        }
        if (quotient.coefficients.empty()) continue;
        terms = std::move(rest);
        return Divided{graph_->at(nodes_[id]).operands.front(), std::move(quotient)};
    }
    return std::nullopt;
}

} // namespace resonform
