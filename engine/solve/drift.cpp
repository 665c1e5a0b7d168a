// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/drift.hpp"

#include "algebra/number/error.hpp"
#include "solve/quadrature.hpp"
#include "solve/substitution.hpp"

#include <fmt/format.h>

namespace resonform {

void solve_drift(Draft& draft) {
    const int through = draft.solution.truncation;
    const GradedField& field = *draft.normal_form().field;
    for (std::size_t d = 0; d < draft.solution.drift.size(); ++d) {
        const std::string& name = field.drift[d].name;
        const std::vector<RateTerm> rate = drift_rate(draft.normal_form(), d);
        draft.solution.drift[d].value.set(0, draft.ring().gen(draft.solution.drift[d].constant));
        for (int n = 0; n <= through; ++n) {
            const Polynomial part = Substitution(draft, through).rate_part(rate, n);
            if (part.empty()) continue;
            if (n == 0)
                refuse(Reason::too_fast, {"the drift variable does not move slowly: its rate is not O(eps)",
                                          name + " has a rate of weight 0",
                                          "multiply its rate by eps",
                                          {}});
            const GeneratorId eps = draft.solution.eps;
            const Polynomial over_slow_time = *quotient_in_ring(draft.ring(), part, draft.ring().gen(eps, n));
            const Polynomial integral = draft.integrate(over_slow_time, fmt::format("Q_{}{}", name, n - 1));
            Series& value = draft.solution.drift[d].value;
            value.set(n - 1,
                      value.part(n - 1) + draft.ring().multiply(draft.ring().gen(eps, n - 1), integral));
        }
    }
}

} // namespace resonform
