// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/text/function_call.hpp"

#include <cmath>
#include <string>

namespace resonform {

namespace {

using GiNaC::ex;

ex value_of_erf(const ex& u);
ex double_of_erf(const ex& u);
ex slope_of_erf(const ex& u, unsigned parameter);

DECLARE_FUNCTION_1P(erf)
REGISTER_FUNCTION(erf, eval_func(value_of_erf).evalf_func(double_of_erf).derivative_func(slope_of_erf))

ex value_of_erf(const ex& u) {
    if (u.is_zero()) return 0;
    return u.info(GiNaC::info_flags::negative) ? ex(-erf(-u)) : ex(erf(u).hold());
}

ex double_of_erf(const ex& u) {
    const ex value = u.evalf();
    if (!GiNaC::is_a<GiNaC::numeric>(value) || !value.info(GiNaC::info_flags::real)) return erf(u).hold();
    return GiNaC::numeric(std::erf(GiNaC::ex_to<GiNaC::numeric>(value).to_double()));
}

ex slope_of_erf(const ex& u, unsigned) { return 2 * GiNaC::exp(-u * u) / GiNaC::sqrt(GiNaC::Pi); }

} // namespace

std::optional<Function> function_of(const ex& e) {
    if (!GiNaC::is_a<GiNaC::function>(e)) return std::nullopt;
    return function_called(GiNaC::ex_to<GiNaC::function>(e).get_name());
}

ex call(Function f, const ex& u) {
    if (f == Function::arc_cosine) return GiNaC::Pi / 2 - GiNaC::asin(u);
    return GiNaC::function(GiNaC::function::find_function(std::string(row_of(f).name), 1), u);
}

ex asked_of(const ex& u, Function f) {
    switch (row_of(f).argument) {
    case Argument::any: break;
    case Argument::not_a_pole: return GiNaC::pow(GiNaC::cos(u), 2);
    case Argument::positive: return u;
    case Argument::within_one:
    case Argument::inside_one: return (1 - u * u).expand();
    case Argument::at_least_one: return u - 1;
    }
    return 1;
}

} // namespace resonform
