// SPDX-License-Identifier: GPL-3.0-or-later
// Normal forms on the planes that circular orbits of two equal frequencies lie in.
#pragma once

#include "algebra/ring/ring.hpp"
#include "algebra/series/series.hpp"
#include "literature/rational_series.hpp"

namespace resonform::test {

// On the plane w3 = c w1, a power of i: the coefficients of (w1 wbar1)^k, divided by i^phase.
class OnPlane {
public:
    OnPlane(const Ring& ring, int c) : ring_(ring), c_(c) {}

    RationalSeries operator()(const Series& series, int phase, int through) const {
        RationalSeries s(through);
        for (int n = 0; n <= series.through(); ++n)
            for (const Term& t : series.part(n).terms()) {
                const auto e = [&](const char* name) {
                    return ring_.exponent(t.monomial, *ring_.find(name));
                };
                const bool two = ring_.find("z3").has_value();
                const int z3 = two ? e("z3") : 0, z4 = two ? e("z4") : 0;
                const int turns = ring_.exponent(t.monomial, Ring::imaginary_unit) + c_ * (z3 - z4) - phase;
                const int k = e("z2") + z4;
                if (k > through) continue;
                const int quarter = ((turns % 4) + 4) % 4;
                if (quarter % 2 == 0) s[k] = s[k] + (quarter == 0 ? t.coefficient : -t.coefficient);
            }
        return s;
    }

private:
    const Ring& ring_;
    int c_;
};

} // namespace resonform::test
