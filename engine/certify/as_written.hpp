// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and functions of an equation of the file, as the user wrote it.
#pragma once

#include "algebra/number/error.hpp"
#include "certify/points/program.hpp"
#include "model/system/system_file.hpp"
#include "model/text/canonical.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/function_call.hpp"

#include <ginac/ginac.h>

#include <optional>
#include <string>

namespace resonform {

// Ends the certificate with an error that quotes the equation; `part` comes before the quotation and names
// the offending part, "log(s) in ".
[[noreturn]] inline void refuse_certificate(const std::string& rule, const Equation& equation,
                                            const std::string& part = {}) {
    refuse({"the certificate substitutes into the equation as written: " + rule, part + equation.text,
            "write the equation with what the expansion supports", place_of(equation.source)});
}

// A GiNaC number as a Rational. Error (refused): it is not rational.
inline Rational rational_of(const GiNaC::ex& number, const Equation& equation) {
    if (!GiNaC::is_a<GiNaC::numeric>(number) || !GiNaC::ex_to<GiNaC::numeric>(number).is_rational())
        refuse_certificate("numbers and exponents are rational", equation);
    return to_rational(number);
}

// The function of a GiNaC call. Error (refused): it is not in the table of functions.
inline Function elementary_of(const GiNaC::ex& function, const Equation& equation) {
    const std::optional<Function> known = function_of(function);
    if (!known) refuse_certificate("functions are the elementary ones", equation);
    return *known;
}

// f'(u) as GiNaC differentiates, independently of the expansion.
inline GiNaC::ex known_slope(Function f, const GiNaC::ex& u) {
    if (f == Function::inverse_hyperbolic_cosine) // one root, as in the ring
        return GiNaC::pow(u * u - 1, GiNaC::numeric(-1, 2));
    const GiNaC::symbol x("x");
    return call(f, x).diff(x).subs(x == u, GiNaC::subs_options::no_pattern);
}

} // namespace resonform
