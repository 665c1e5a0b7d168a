// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/text/named_function.hpp"

#include <map>

namespace resonform {

namespace {

using GiNaC::ex;

// One symbol for each name, the same in all expressions.
const GiNaC::symbol& symbol_of(const std::string& name) {
    static std::map<std::string, GiNaC::symbol> symbols;
    return symbols.try_emplace(name, GiNaC::symbol(name)).first->second;
}

ex slope(const ex& argument, const ex& name, const ex& derivative, unsigned parameter);

DECLARE_FUNCTION_3P(called)
REGISTER_FUNCTION(called, derivative_func(slope))

// Name and number of derivatives never depend on anything.
ex slope(const ex& argument, const ex& name, const ex& derivative, unsigned parameter) {
    return parameter == 0 ? ex(called(argument, name, derivative + 1)) : ex(0);
}

} // namespace

ex named_function(const std::string& name, int derivative, const ex& argument) {
    return called(argument, symbol_of(name), derivative);
}

bool is_named(const ex& e) { return is_ex_the_function(e, called); }

NamedCall named_call(const ex& e) {
    return {GiNaC::ex_to<GiNaC::symbol>(e.op(1)).get_name(), GiNaC::ex_to<GiNaC::numeric>(e.op(2)).to_int(),
            e.op(0)};
}

bool has_named(const ex& e) {
    for (auto it = e.preorder_begin(); it != e.preorder_end(); ++it)
        if (is_named(*it)) return true;
    return false;
}

} // namespace resonform
