// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/text/function_value.hpp"

namespace resonform {

GiNaC::ex FunctionValue::at(const GiNaC::ex& of) const {
    return value.subs(GiNaC::ex(argument) == of, GiNaC::subs_options::no_pattern);
}

FunctionValue FunctionValue::slope() const { return {argument, value.diff(argument)}; }

} // namespace resonform
