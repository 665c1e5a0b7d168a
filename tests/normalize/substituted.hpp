// SPDX-License-Identifier: GPL-3.0-or-later
// Substitutions in the map, done with series, against the inverse map.
#pragma once

#include "normalize/recursion/inverse_map.hpp"
#include "normalize/recursion/substitutions.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace resonform::test {

class Substituted {
public:
    explicit Substituted(const Normalization& n) : map_(n.map), field_(*n.normal_form.field) {
        shift_.through = map_.through;
        shift_.mode.resize(map_.mode.size());
        shift_.angle.resize(map_.angle.size());
        shift_.slow.resize(map_.slow.size());
        shift_.drift.resize(map_.drift.size());
        for (const SubstitutionStep& step : substitutions(field_, map_, map_.through, {})) substitute(step);
    }

    void expect(const NearIdentityMap& inverse) const {
        expect(inverse.mode, shift_.mode);
        expect(inverse.angle, shift_.angle);
        expect(inverse.slow, shift_.slow);
    }

private:
    // y - Y where c_k is taken through a weight
    [[nodiscard]] Series shifted(const Series& c, int through) const {
        Series cut, result;
        for (int w = 0; w <= std::min(through, c.through()); ++w) cut.set(w, c.part(w));
        const Series composed = compose(field_, cut, shift_, map_.through);
        for (int w = 0; w <= map_.through; ++w) result.set(w, -composed.part(w));
        return result;
    }
    void substitute(const SubstitutionStep& step) {
        std::vector<int> weights = field_.mode_weights();
        if (weights.empty()) weights = {0};
        std::reverse(weights.begin(), weights.end());
        for (const int weight : weights) {
            NearIdentityMap next = shift_;
            for (std::size_t k = 0; k < map_.mode.size(); ++k)
                if (field_.ring->generator(field_.modes[k].z).weight == weight)
                    next.mode[k] = shifted(map_.mode[k], step.mode[k]);
            for (std::size_t k = 0; weight == weights.front() && k < map_.angle.size(); ++k)
                next.angle[k] = shifted(map_.angle[k], step.angle[k]);
            for (std::size_t k = 0; weight == weights.front() && k < map_.slow.size(); ++k)
                next.slow[k] = shifted(map_.slow[k], step.slow[k]);
            shift_ = std::move(next);
        }
    }
    void expect(const std::vector<Series>& inverse, const std::vector<Series>& found) const {
        for (std::size_t k = 0; k < inverse.size(); ++k)
            for (int w = 0; w <= map_.through; ++w)
                EXPECT_TRUE(field_.ring->vanishes(inverse[k].part(w) - found[k].part(w)))
                    << "series " << k << ", weight " << w;
    }

    const NearIdentityMap& map_;
    const GradedField& field_;
    NearIdentityMap shift_;
};

} // namespace resonform::test
