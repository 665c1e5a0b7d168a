// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/recursion/substitutions.hpp"

#include <algorithm>

namespace resonform {

namespace {

constexpr int never = 1 << 20; // no weight is so large

// Follows the weight from which on each variable is wrong. A term of weight n in which a mode u of weight w
// occurs turns an error of weight e in u into one of weight n - w + e.
class ErrorWeights {
public:
    ErrorWeights(const GradedField& field, const NearIdentityMap& map, int through,
                 const SubstitutionFor& wanted)
        : field_(field), wanted_(wanted), through_(through), modes_(field.modes.size()) {
        for (const auto* list : {&map.mode, &map.angle, &map.slow})
            for (const Series& series : *list) add(series);
        angles_ = map.angle.size();
        for (std::size_t v = 0; v < lowest_.size(); ++v)
            error_.push_back(v < modes_ && !wanted_.modes ? never : lowest_[v]);
        if (wanted_.mode_at_zero) measured_ = lowest_[*wanted_.mode_at_zero];
    }

    [[nodiscard]] bool are_left() const {
        return measured_ <= through_ ||
               std::any_of(error_.begin(), error_.end(), [&](int e) { return e <= through_; });
    }

    SubstitutionStep substitute() {
        std::vector<int> taken(lowest_.size(), -1), weights{0};
        if (wanted_.modes && modes_ > 0) weights = field_.mode_weights();
        std::reverse(weights.begin(), weights.end());
        for (const int weight : weights) {
            std::vector<int> next = error_;
            if (wanted_.mode_at_zero && weight_of(*wanted_.mode_at_zero) == weight)
                measured_ = behind(*wanted_.mode_at_zero);
            for (std::size_t v = 0; v < lowest_.size(); ++v) {
                const bool now =
                    v < modes_ ? wanted_.modes && weight_of(v) == weight : weight == weights.front();
                if (!now) continue;
                next[v] = behind(v);
                taken[v] = std::min(through_, next[v] - 1);
                if (v < modes_) next[v] = std::min(next[v], measured_);
            }
            error_ = next;
        }
        const auto modes = taken.begin() + static_cast<std::ptrdiff_t>(modes_);
        const auto angles = modes + static_cast<std::ptrdiff_t>(angles_);
        return {{taken.begin(), modes}, {modes, angles}, {angles, taken.end()}};
    }

private:
    [[nodiscard]] int weight_of(std::size_t mode) const {
        return field_.ring->generator(field_.modes[mode].z).weight;
    }

    // Angles and slow variables stand in coefficients, too: every term may depend on them.
    void add(const Series& series) {
        std::vector<int> gain(modes_, never);
        int lowest = never;
        for (int n = std::min(through_, series.through()); n >= 0; --n) {
            if (series.part(n).empty()) continue;
            lowest = n;
            for (std::size_t u = 0; u < modes_; ++u)
                if (has(series.part(n), field_.modes[u])) gain[u] = n - weight_of(u);
        }
        lowest_.push_back(lowest);
        gain_.push_back(std::move(gain));
    }
    [[nodiscard]] bool has(const Polynomial& p, const Mode& mode) const {
        return std::any_of(p.terms().begin(), p.terms().end(), [&](const Term& t) {
            return field_.ring->exponent(t.monomial, mode.z) != 0 ||
                   field_.ring->exponent(t.monomial, mode.zbar) != 0;
        });
    }

    // The weight of the error of c_v where the variables are wrong as they are.
    [[nodiscard]] int behind(std::size_t v) const {
        int weight = never;
        for (std::size_t u = 0; u < error_.size(); ++u)
            weight = std::min(weight, error_[u] + (u < modes_ ? gain_[v][u] : lowest_[v]));
        return weight;
    }

    const GradedField& field_;
    const SubstitutionFor& wanted_;
    int through_;
    std::size_t modes_, angles_ = 0;
    std::vector<int> lowest_;            // weight of each series: modes, angles, slow variables
    std::vector<std::vector<int>> gain_; // of each series by each mode
    std::vector<int> error_;             // of each variable
    int measured_ = never;               // of what follows from the mode that is 0
};

} // namespace

std::vector<SubstitutionStep> substitutions(const GradedField& field, const NearIdentityMap& map, int through,
                                            const SubstitutionFor& wanted) {
    ErrorWeights errors(field, map, through, wanted);
    std::vector<SubstitutionStep> list;
    // Terms that gain nothing lead from heavier modes to lighter ones, or from modes to angles and slow
    // variables, never in a circle: so many substitutions are enough.
    const std::size_t most =
        static_cast<std::size_t>(through + 1) * (map.mode.size() + map.angle.size() + map.slow.size() + 1);
    while (errors.are_left() && list.size() < most) list.push_back(errors.substitute());
    return list;
}

} // namespace resonform
