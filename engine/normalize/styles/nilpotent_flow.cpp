// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/styles/nilpotent_flow.hpp"

namespace resonform {

NilpotentFlow::NilpotentFlow(const GradedField& field) : field_(field) {
    for (std::size_t k = 0; k < field.modes.size(); ++k) {
        const Mode& mode = field.modes[k];
        modes_.push_back(mode.z);
        if (!mode.is_real()) modes_.push_back(mode.zbar);
        for (const ModeCoupling& c : field.couplings(k)) {
            const Mode& from = field.modes[c.mode];
            steps_.push_back({mode.z, from.z, c.factor});
            if (!mode.is_real()) steps_.push_back({mode.zbar, from.zbar, c.factor});
        }
    }
}

const std::vector<ModeCoupling>& NilpotentFlow::row(int mode) const {
    static const std::vector<ModeCoupling> none;
    return mode < 0 ? none : field_.couplings(static_cast<std::size_t>(mode));
}

auto NilpotentFlow::image(const VectorMonomial& v) const -> Image {
    const Ring& ring = *field_.ring;
    Image image;
    for (const Step& step : steps_)
        if (const int exponent = ring.exponent(v.monomial, step.to); exponent > 0)
            image.push_back({{v.mode, v.monomial - ring.monomial(step.to) + ring.monomial(step.from)},
                             exponent * step.factor});
    if (v.mode < 0) return image;
    for (std::size_t j = 0; j < field_.modes.size(); ++j)
        for (const ModeCoupling& c : field_.couplings(j))
            if (static_cast<int>(c.mode) == v.mode)
                image.push_back({{static_cast<int>(j), v.monomial}, -c.factor});
    return image;
}

std::vector<VectorMonomial> NilpotentFlow::sources(const VectorMonomial& v) const {
    const Ring& ring = *field_.ring;
    std::vector<VectorMonomial> sources;
    for (const Step& step : steps_)
        if (ring.exponent(v.monomial, step.from) > 0)
            sources.push_back({v.mode, v.monomial - ring.monomial(step.from) + ring.monomial(step.to)});
    for (const ModeCoupling& c : row(v.mode)) sources.push_back({static_cast<int>(c.mode), v.monomial});
    return sources;
}

Rational NilpotentFlow::square(const VectorMonomial& v) const {
    Rational product = 1;
    for (const GeneratorId id : modes_)
        for (int k = 2; k <= field_.ring->exponent(v.monomial, id); ++k) product = product * k;
    return product;
}

} // namespace resonform
