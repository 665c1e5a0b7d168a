// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/recursion/inverse_map.hpp"

#include "normalize/recursion/shifted_series.hpp"

namespace resonform {

NearIdentityMap invert(const NormalForm& normal_form, const NearIdentityMap& map) {
    const GradedField& field = *normal_form.field;
    ShiftedSeries shifted(field);
    const auto add = [&](const std::vector<Series>& list) {
        std::vector<SeriesProgram::Node> nodes;
        for (const Series& s : list) nodes.push_back(shifted.add(s.total(map.through)));
        return nodes;
    };
    const auto modes = add(map.mode), angles = add(map.angle), slow = add(map.slow), drift = add(map.drift);

    NearIdentityMap inverse;
    inverse.through = map.through;
    inverse.mode.resize(modes.size());
    inverse.angle.resize(angles.size());
    inverse.slow.resize(slow.size());
    inverse.drift.resize(drift.size());
    SeriesRun run = shifted.run();
    const auto take = [&](std::vector<Series>& to, const std::vector<SeriesProgram::Node>& nodes, int n) {
        for (std::size_t k = 0; k < nodes.size(); ++k) to[k].set(n, -run.part(nodes[k], n));
    };
    const std::vector<int> weights = field.mode_weights();
    for (int n = 0; n <= map.through; ++n) {
        shifted.set(run, inverse, n);
        run.advance(n);
        for (const int weight : weights) {
            for (std::size_t k = 0; k < modes.size(); ++k)
                if (field.ring->generator(field.modes[k].z).weight == weight)
                    inverse.mode[k].set(n, -run.part(modes[k], n));
            shifted.set(run, inverse, n);
            run.correct(n);
        }
        take(inverse.angle, angles, n);
        take(inverse.slow, slow, n);
        take(inverse.drift, drift, n);
        shifted.set(run, inverse, n);
        run.correct(n);
    }
    return inverse;
}

Series compose(const GradedField& field, const Series& p, const NearIdentityMap& shift, int through) {
    ShiftedSeries shifted(field);
    const SeriesProgram::Node node = shifted.add(p.total(through));
    SeriesRun run = shifted.run();
    Series result;
    for (int n = 0; n <= through; ++n) {
        shifted.set(run, shift, n);
        run.advance(n);
        result.set(n, run.part(node, n));
    }
    return result;
}

} // namespace resonform
