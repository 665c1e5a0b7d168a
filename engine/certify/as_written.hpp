// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and functions of an equation of the file, as the user wrote it.
#pragma once

#include "algebra/number/error.hpp"
#include "certify/program.hpp"
#include "model/system/system_file.hpp"
#include "model/text/diagnostic.hpp"

#include <ginac/ginac.h>

#include <string>
#include <utility>

namespace resonform {

// Ends the certificate with an error that quotes the equation; `part` comes before the quotation and names
// the offending part, "log(s) in ".
[[noreturn]] inline void refuse_certificate(const std::string& rule, const Equation& equation,
                                            const std::string& part = {}) {
    refuse({"the certificate substitutes into the equation as written: " + rule, part + equation.text,
            "write the equation with what the expansion supports", place_of(equation.source)});
}

// A GiNaC number as an exact one. Error (refused): it is not rational.
inline Rational rational_of(const GiNaC::ex& number, const Equation& equation) {
    if (!GiNaC::is_a<GiNaC::numeric>(number) || !GiNaC::ex_to<GiNaC::numeric>(number).is_rational())
        refuse_certificate("numbers and exponents are rational", equation);
    return cln::the<cln::cl_RA>(GiNaC::ex_to<GiNaC::numeric>(number).to_cl_N());
}

// Which function a GiNaC call is. Error (refused): one that certificates do not know.
inline Elementary elementary_of(const GiNaC::ex& function, const Equation& equation) {
    static const std::pair<const char*, Elementary> names[] = {
        {"exp", Elementary::exponential},
        {"log", Elementary::logarithm},
        {"sin", Elementary::sine},
        {"cos", Elementary::cosine},
        {"tan", Elementary::tangent},
        {"sinh", Elementary::hyperbolic_sine},
        {"cosh", Elementary::hyperbolic_cosine},
        {"tanh", Elementary::hyperbolic_tangent},
        {"asin", Elementary::arc_sine},
        {"atan", Elementary::arc_tangent},
    };
    const std::string name = GiNaC::ex_to<GiNaC::function>(function).get_name();
    for (const auto& [known, elementary] : names)
        if (name == known) return elementary;
    refuse_certificate("functions are sin cos tan exp log sinh cosh tanh asin atan", equation);
}

} // namespace resonform
