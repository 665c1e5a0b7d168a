// SPDX-License-Identifier: GPL-3.0-or-later
// A spelling of expressions that is the same in every run. GiNaC's own order of operands changes from run to
// run, and with it more than the order: (a - b)^3 becomes -(b - a)^3 where b comes first. So an expression is
// spelled up to its sign, which is that of the first term of a sum, and the product of those of factors.
#pragma once

#include <ginac/ginac.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace resonform {

class SignedSpelling {
public:
    // name: what a symbol is spelled by; names alone need not differ.
    using Name = std::function<std::string(const GiNaC::symbol&)>;
    explicit SignedSpelling(Name name) : name_(std::move(name)) {}

    struct Form {
        bool negative = false;
        std::string text; // of the expression with this sign taken out
    };
    const Form& of(const GiNaC::ex& e);
    std::string with_sign(const GiNaC::ex& e);
    // Operands of a sum or product, in the order of their texts.
    std::vector<GiNaC::ex> sorted_operands(const GiNaC::ex& e);

private:
    Form form(const GiNaC::ex& e);
    Form of_sum(const GiNaC::ex& e);
    Form of_product(const GiNaC::ex& e);
    Form of_power(const GiNaC::ex& e);

    Name name_;
    std::map<GiNaC::ex, Form, GiNaC::ex_is_less> forms_;
};

} // namespace resonform
