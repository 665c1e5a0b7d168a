// SPDX-License-Identifier: GPL-3.0-or-later
// Writes an equation of the file, as the user wrote it, into the program of a certificate.
#pragma once

#include "certify/as_written.hpp"
#include "certify/roots.hpp"
#include "model/text/named_function.hpp"

#include <map>
#include <string>
#include <vector>

namespace resonform {

// The slots put in for the symbols of an equation; an angle is given by e^{i phi} and e^{-i phi}.
struct Substituted {
    struct Angle {
        GiNaC::symbol symbol;
        Slot forward, backward;
    };
    std::map<GiNaC::ex, Slot, GiNaC::ex_is_less> symbols; // look-up only
    std::vector<Angle> angles;
};

// An expression of `equation`, substituted.
Slot substitute(CertificateProgram& program, CertificateRoots& roots, const Substituted& values,
                const Equation& equation, const GiNaC::ex& e);

} // namespace resonform
