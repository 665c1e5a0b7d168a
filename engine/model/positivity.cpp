// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/positivity.hpp"

#include "model/sign_prover.hpp"

namespace resonform {

bool provably_positive(const GiNaC::ex& e, const System& system) {
    return SignProver(system).sign(e) == ProvedSign::positive;
}

bool provably_nonzero(const GiNaC::ex& e, const System& system) { return SignProver(system).nonzero(e); }

} // namespace resonform
