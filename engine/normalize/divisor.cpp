// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/divisor.hpp"

#include <fmt/format.h>

namespace resonform {

const char* to_string(DivisorVerdict verdict) {
    switch (verdict) {
    case DivisorVerdict::removed: return "removed";
    case DivisorVerdict::kept_exact: return "kept exact";
    case DivisorVerdict::kept_near: return "kept near";
    case DivisorVerdict::ambiguous: return "ambiguous";
    }
    return "ambiguous";
}

DivisorTable::DivisorTable(const GradedField& field, int mode) : field_(field), mode_(mode) {}

const Divisor& DivisorTable::of(const Monomial& monomial) {
    std::vector<int> harmonics;
    for (const Mode& m : field_.modes)
        harmonics.push_back(field_.ring->exponent(monomial, m.z) - field_.ring->exponent(monomial, m.zbar));
    const auto known = known_.find(harmonics);
    if (known != known_.end()) return known->second;
    return known_.emplace(harmonics, make(harmonics)).first->second;
}

Divisor DivisorTable::make(const std::vector<int>& harmonics) {
    const Ring& ring = *field_.ring;
    Polynomial frequency;
    std::string spelled;
    for (std::size_t m = 0; m < harmonics.size(); ++m) {
        const int k = harmonics[m] - (static_cast<int>(m) == mode_ ? 1 : 0);
        frequency = frequency + Rational(k) * field_.modes[m].omega;
        spelled += fmt::format("{}{}*omega_{}", spelled.empty() ? "" : " + ", k,
                               field_.system().variables[field_.modes[m].variable].name);
    }
    const Polynomial value = ring.multiply(ring.imaginary(), frequency);
    if (ring.vanishes(value)) return {{}, DivisorVerdict::kept_exact, {}};
    if (const auto inverse = ring.inverse(value)) return {value, DivisorVerdict::removed, *inverse};
    if (ring.is_zero(value) == Zero::no) {
        missing_.push_back(frequency);
        return {value, DivisorVerdict::removed, {}};
    }
    refuse({"a divisor is proved to be zero or to be non-zero before anything is divided by it",
            "i*(" + spelled + ")",
            "write the frequencies so that their relation is plain, or give parameters numeric values",
            {}});
}

} // namespace resonform
