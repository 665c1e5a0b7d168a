// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/recursion/centre_manifold.hpp"

#include "algebra/number/error.hpp"
#include "model/text/diagnostic.hpp"
#include "normalize/recursion/inverse_map.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace resonform {

namespace {

// The series with the slaved modes set to zero.
Series restricted(const Ring& ring, const Series& series, const std::vector<GeneratorId>& slaved) {
    Series result;
    for (int n = 0; n <= series.through(); ++n) {
        std::vector<Term> terms;
        for (const Term& t : series.part(n).terms())
            if (std::all_of(slaved.begin(), slaved.end(),
                            [&](GeneratorId id) { return ring.exponent(t.monomial, id) == 0; }))
                terms.push_back(t);
        result.set(n, Polynomial::from_terms(std::move(terms)));
    }
    return result;
}

void restrict_all(const Ring& ring, std::vector<Series>& list, const std::vector<GeneratorId>& slaved) {
    for (Series& series : list) series = restricted(ring, series, slaved);
}

void require_invariance(const GradedField& field, const Mode& mode, const Series& rate) {
    for (int n = 0; n <= rate.through(); ++n)
        if (!rate.part(n).empty())
            refuse(Reason::resonance,
                   {"a mode that is slaved is not driven by resonant terms of the others",
                    fmt::format("in the rate of {} at weight {}", mode.name,
                                to_string(field.system().weight(n))),
                    "take back the threshold [normal_form] near or the relation that keeps the term",
                    place_of(field.system().equations[mode.variable].source)});
}

} // namespace

void require_slaved_modes(const GradedField& field) {
    const auto& modes = field.modes;
    if (std::any_of(modes.begin(), modes.end(), [](const Mode& m) { return m.is_damped(); })) return;
    const System& system = field.system();
    refuse({"a centre manifold is for systems with modes that decay or grow at eps = 0",
            fmt::format("no mode of {} does", system.name),
            "damping with a factor eps belongs to the normal form: leave out --stage manifold",
            modes.empty() ? whole_file(system.file)
                          : place_of(system.equations[modes.front().variable].source)});
}

CentreManifold centre_manifold(const Normalization& normalization) {
    const GradedField& field = *normalization.normal_form.field;
    require_slaved_modes(field);
    CentreManifold result{{}, normalization.normal_form, normalization.map, {}};
    std::vector<GeneratorId> slaved;
    for (const Mode& mode : field.modes) {
        result.slaved.push_back(mode.is_damped());
        if (!mode.is_damped()) continue;
        slaved.push_back(mode.z);
        if (!mode.is_real()) slaved.push_back(mode.zbar);
    }
    for (auto* list :
         {&result.flow.mode, &result.flow.angle, &result.flow.slow, &result.flow.drift, &result.manifold.mode,
          &result.manifold.angle, &result.manifold.slow, &result.manifold.drift})
        restrict_all(*field.ring, *list, slaved);
    result.fibres = invert(normalization.normal_form, normalization.map);
    for (std::size_t m = 0; m < field.modes.size(); ++m) {
        if (!result.slaved[m]) continue;
        require_invariance(field, field.modes[m], result.flow.mode[m]);
        result.fibres.mode[m] = Series();
    }
    return result;
}

} // namespace resonform
