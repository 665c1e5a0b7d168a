// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/certificate_equation.hpp"

#include <utility>

namespace resonform {

void refuse_certificate(const std::string& rule, const Equation& equation) {
    const SourceText& source = equation.source;
    refuse({"the certificate substitutes into the equation as written: " + rule,
            equation.text,
            "write the equation with what the expansion supports",
            {source.file, source.line, source.column, source.key, source.source_line}});
}

Rational rational_of(const GiNaC::ex& number, const Equation& equation) {
    if (!GiNaC::is_a<GiNaC::numeric>(number) || !GiNaC::ex_to<GiNaC::numeric>(number).is_rational())
        refuse_certificate("numbers and exponents are rational", equation);
    return cln::the<cln::cl_RA>(GiNaC::ex_to<GiNaC::numeric>(number).to_cl_N());
}

int take_out_harmonic(GiNaC::ex& argument, const GiNaC::symbol& angle, const Equation& equation) {
    constexpr int highest_harmonic = 1000;
    const GiNaC::ex k = argument.diff(angle).expand();
    if (k.is_zero()) return 0;
    if (!k.info(GiNaC::info_flags::integer) || GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(k)) > highest_harmonic)
        refuse_certificate("angles occur in integer combinations", equation);
    argument = (argument - k * angle).expand();
    return GiNaC::ex_to<GiNaC::numeric>(k).to_int();
}

Elementary elementary_of(const GiNaC::ex& function, const Equation& equation) {
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
