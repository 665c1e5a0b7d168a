// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/exact/positivity.hpp"

#include "model/exact/question.hpp"
#include "model/signs/sign_prover.hpp"

namespace resonform {

bool provably_positive(const GiNaC::ex& e, const System& system) {
    if (SignProver(system).sign(e) == ProvedSign::positive) return true;
    const auto exact = exact_question(e, system);
    return exact && SignProver(exact->domain).sign(exact->asked) == ProvedSign::positive;
}

bool provably_nonzero(const GiNaC::ex& e, const System& system) {
    if (SignProver(system).nonzero(e)) return true;
    const auto exact = exact_question(e, system);
    return exact && SignProver(exact->domain).nonzero(exact->asked);
}

} // namespace resonform
