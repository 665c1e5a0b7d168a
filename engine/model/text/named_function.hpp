// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that are known by their names only, [functions] omega = { of = ["tau"] }: omega(tau), its
// derivatives omega'(tau), ... as expressions of the library, which differentiates them by the chain rule.
#pragma once

#include <ginac/ginac.h>

#include <string>

namespace resonform {

struct NamedCall {
    std::string name;
    int derivative = 0;
    GiNaC::ex argument;
};

// The derivative-th derivative of the function `name` at `argument`; its operand 0 is the argument.
GiNaC::ex named_function(const std::string& name, int derivative, const GiNaC::ex& argument);

bool is_named(const GiNaC::ex& e);
NamedCall named_call(const GiNaC::ex& e); // precondition: is_named(e)
bool has_named(const GiNaC::ex& e);       // anywhere in e

} // namespace resonform
