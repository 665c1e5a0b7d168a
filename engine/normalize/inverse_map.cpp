// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/inverse_map.hpp"

#include "algebra/series_program.hpp"

#include <utility>

namespace resonform {

namespace {

// Series of the modes into which shifted modes are put, weight by weight.
class Substitution {
public:
    Substitution(const GradedField& field, const std::vector<Series>& series, int through)
        : field_(field), program_(field.ring) {
        for (const Mode& m : field.modes) {
            bases_.emplace_back(m.z, program_.input(m.name));
            bases_.emplace_back(m.zbar, program_.input(m.conjugate_name));
        }
        for (const Series& s : series) outputs_.push_back(translate(s.total(through)));
    }

    // Part `weight` of what stands for mode k, and of its conjugate.
    void set_mode(SeriesRun& run, std::size_t k, int weight, const Polynomial& shift) const {
        const Ring& ring = *field_.ring;
        const GeneratorId z = field_.modes[k].z;
        const Polynomial value = ring.generator(z).weight == weight ? ring.gen(z) + shift : shift;
        run.set_input(bases_[2 * k + 1].second, weight, ring.conjugate(value));
        run.set_input(bases_[2 * k].second, weight, value);
    }

    [[nodiscard]] SeriesRun run() const { return SeriesRun(program_); }
    [[nodiscard]] SeriesProgram::Node output(std::size_t k) const { return outputs_[k]; }

private:
    // Sum over the monomials of the modes: coefficient * product of powers.
    SeriesProgram::Node translate(const Polynomial& p) {
        const Ring& ring = *field_.ring;
        std::vector<GeneratorId> outer;
        for (const auto& base : bases_) outer.push_back(base.first);
        std::vector<std::pair<Rational, SeriesProgram::Node>> addends;
        for (const auto& [monomial, coefficient] : ring.collect(p, outer)) {
            // The powers first: equal products of powers are shared between all series.
            SeriesProgram::Node product = program_.constant(ring.one());
            for (const auto& [id, input] : bases_)
                if (const int exponent = ring.exponent(monomial, id); exponent != 0)
                    product = program_.product(product, power(input, exponent));
            product = program_.product(program_.constant(coefficient), product);
            addends.emplace_back(1, product);
        }
        return program_.sum(addends);
    }

    // By one factor after the other: all lower powers occur anyway, and equal nodes are shared.
    SeriesProgram::Node power(SeriesProgram::Node base, int exponent) {
        SeriesProgram::Node result = base;
        for (int k = 1; k < exponent; ++k) result = program_.product(result, base);
        return result;
    }

    const GradedField& field_;
    SeriesProgram program_;
    std::vector<std::pair<GeneratorId, SeriesProgram::Node>> bases_; // z, zbar of each mode
    std::vector<SeriesProgram::Node> outputs_;
};

} // namespace

NearIdentityMap invert(const NormalForm& normal_form, const NearIdentityMap& map) {
    const GradedField& field = *normal_form.field;
    const std::size_t modes = field.modes.size();
    std::vector<Series> series = map.mode;
    series.insert(series.end(), map.drift.begin(), map.drift.end());
    const Substitution substitution(field, series, map.through);

    NearIdentityMap inverse;
    inverse.through = map.through;
    inverse.mode.resize(modes);
    inverse.drift.resize(map.drift.size());
    SeriesRun run = substitution.run();
    for (int n = 0; n <= map.through; ++n) {
        for (std::size_t k = 0; k < modes; ++k) substitution.set_mode(run, k, n, {});
        run.advance(n);
        for (std::size_t k = 0; k < modes; ++k) {
            inverse.mode[k].set(n, -run.part(substitution.output(k), n));
            substitution.set_mode(run, k, n, inverse.mode[k].part(n));
        }
        run.correct(n);
        for (std::size_t k = 0; k < map.drift.size(); ++k)
            inverse.drift[k].set(n, -run.part(substitution.output(modes + k), n));
    }
    return inverse;
}

Series compose(const GradedField& field, const Series& p, const std::vector<Series>& shift, int through) {
    const Substitution substitution(field, {p}, through);
    SeriesRun run = substitution.run();
    Series result;
    for (int n = 0; n <= through; ++n) {
        for (std::size_t k = 0; k < shift.size(); ++k) substitution.set_mode(run, k, n, shift[k].part(n));
        run.advance(n);
        result.set(n, run.part(substitution.output(0), n));
    }
    return result;
}

} // namespace resonform
